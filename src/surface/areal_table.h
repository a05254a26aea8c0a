/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Heights of an areal surface on a regular grid, prepared for a strip, and
 * evaluated anywhere by tensor-product cubic B-splines through them.
 */
#ifndef OVR_SURFACE_AREAL_TABLE_H
#define OVR_SURFACE_AREAL_TABLE_H

#include <stdbool.h>
#include <stddef.h>

#include "base/arena.h"
#include "overroll/areal.h"

/* One direction of a table. */
typedef struct ovr_areal_axis {
    size_t n;     /* entries of the length, or of one period */
    double h;     /* distance between entries, b */
    bool endless; /* periodic; otherwise smooth outside */
    double taper; /* length blended at each end, b */
} ovr_areal_axis;

typedef struct ovr_areal_table {
    ovr_areal_axis x, y;
    double *c;         /* spline coefficients, c[i y.n + j] */
    bool both;         /* periodic also ahead of the leading end */
    double Sq;         /* root mean square height, b^2/R */
    double largest;    /* maximum magnitude of the heights, b^2/R */
    double wavelength; /* 2 pi Sq/Sdq, b */
    double lost; /* fraction of the variance removed with wavelengths too short
                  * for the grid */
    double work; /* multiplications to make it, about */
} ovr_areal_table;

/* Grid and ends of a table. */
typedef struct ovr_areal_fit {
    double mesh[2];  /* mesh sizes of the strip along x and y, b */
    double taper[2]; /* blended length at each end, b; NAN: 5 % of the length */
    int extend[2];   /* ovr_extension */
    bool both;       /* extended to both sides along x */
    bool closed;     /* the last row and column equal the first */
} ovr_areal_fit;

/* Creates the table of a map in b and b^2/R without missing heights. */
ovr_status ovr_areal_tabulate(const ovr_areal *map, const ovr_areal_fit *fit,
                              ovr_areal_table *table, ovr_arena *arena,
                              ovr_error *err);

/* Returns the length along x, or the width across, of the table; the period if
 * it is periodic. */
double ovr_areal_extent(const ovr_areal_axis *axis);

/* Adds factor times the heights at s along x and at t0 + Y[j] across to S[j];
 * both coordinates start at the first entry. */
void ovr_areal_add(const ovr_areal_table *table, double factor, double s,
                   double t0, size_t lines, const double *Y, double *S);

#endif
