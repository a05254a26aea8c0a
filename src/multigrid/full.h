/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Full multigrid (FMG): Newton on the coarsest grid from the Hertzian pressure,
 * then on each finer grid cubic interpolation and cycles.
 *
 * If the film is too thin for the mesh size of the coarsest grid, the load is
 * increased in steps: Newton's method at the largest fraction of the load that
 * converges, nested iteration to a grid that resolves the film, and
 * continuation in the load there.
 */
#ifndef OVR_MULTIGRID_FULL_H
#define OVR_MULTIGRID_FULL_H

#include "multigrid/cycle.h"

/* The steady contact to be solved: load, speed and curvature relative to the
 * reference values of M and L. */
typedef struct ovr_target {
    double M, L;
    double Cw, Cu; /* load, speed */
    double c;      /* R0/R */
    double force;  /* required value of D sum P */
    ovr_fluid fluid;
} ovr_target;

/* Film thickness by formula, and the fluid, at this fraction of the load. */
double ovr_target_film(const ovr_target *target, double fraction);
/* Events reported for each level that carries the full load. */
typedef enum ovr_full_event {
    OVR_FULL_BEGINS, /* the level below is solved */
    OVR_FULL_CYCLES, /* another cycle follows */
    OVR_FULL_ENDS
} ovr_full_event;

typedef struct ovr_full_status {
    int cycles;    /* on this level */
    double factor; /* reduction factor of the residual in the last cycle */
    ovr_defect defect;
} ovr_full_status;

/* Options of full multigrid, with callbacks that report progress and test
 * convergence. */
typedef struct ovr_full {
    ovr_cycling cycling;
    double load_factor; /* largest step of the continuation in load */
    double mesh;        /* continuation on the first level with a smaller
                         * D/H^(2/3) */
    bool fixed;         /* exactly max_cycles on every level */
    bool thin_last;     /* Newtonian on coarser levels; on the finest level the
                         * Eyring stress decreases in steps to that of the
                         * rheological model */
    int max_cycles;     /* on the finest level */
    int min_cycles;     /* minimum number of cycles on a level */
    int trial; /* number of cycles after which the largest R must be below 2/3
                * of that of the same number of cycles before; 0: no such test
                */
    /* tolerance of a level with film thickness H at X = 0 */
    double (*tolerance)(const void *data, const ovr_level *level, double H);
    void (*watch)(void *data, const ovr_level *level, ovr_full_event event,
                  const ovr_full_status *status);
    void *data;
    double *saved; /* space for a field of the finest size */
} ovr_full;

/* Performs cycles on a level, whose film and residual are up to date, until its
 * tolerance is reached. Adds to the number of cycles. */
ovr_defect ovr_full_cycles(ovr_hierarchy *grids, ovr_level *level,
                           const ovr_full *how, int *cycles);

/* Sets gap, F and force of every level as if it were the finest. */
void ovr_full_prepare(ovr_hierarchy *grids, double force);

/* Computes the solution on the finest level, whose gap X^2/2 - S must be set.
 * Adds to the number of cycles. */
ovr_defect ovr_full_multigrid(ovr_hierarchy *grids, const ovr_target *target,
                              ovr_full how, int *cycles);

#endif
