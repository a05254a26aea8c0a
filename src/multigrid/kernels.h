/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The machine room: the hot loops, compiled once for each instruction set
 * (*.kernel.c) and reached through one table that is chosen when a hierarchy
 * is created.  Each kernel is described above its code.
 *
 * Notation: n nodes i = 0..n-1, P = 0 at i = 0 and n-1; q = rho H.
 */
#ifndef OVR_MULTIGRID_KERNELS_H
#define OVR_MULTIGRID_KERNELS_H

#include <stdbool.h>
#include <stddef.h>

#include "overroll/contact.h"

struct ovr_mlmi;

/* The lubricant with the Reynolds equation's lambda. */
typedef struct ovr_fluid {
    ovr_lubricant lubricant;
    double lambda;
} ovr_fluid;

/* Coefficients of one grid's discrete Reynolds equation, see reynolds.h. */
typedef struct ovr_weights {
    double a0, a1, a2;         /* of q_i, q_{i-1}, q_{i-2} */
    double a0_first, a1_first; /* in row 1 */
    double half;               /* 1/(2 D^2) */
} ovr_weights;

/* The arrays of one grid that the kernels share; n values each. */
typedef struct ovr_fields {
    double *restrict P;    /* pressure */
    double *restrict H;    /* film thickness */
    double *restrict rho;  /* density */
    double *restrict dq;   /* d q/dP at fixed H */
    double *restrict eps;  /* rho H^3/(eta lambda) */
    double *restrict deps; /* d eps/dP at fixed H */
    double *restrict q;    /* rho H */
    double *restrict F;    /* right-hand side of the Reynolds equation */
    double *restrict r;    /* residual F - N */
} ovr_fields;

/* A dry node is held while r_i/A_ii is below this.  Not below zero: on coarse
 * grids its residual is rounding, whose sign would pick wet or dry at random
 * (1e-12 to 1e-8 all work). */
#define OVR_DRY_TOLERANCE 1e-10

/* Work arrays of the line relaxation, n + OVR_BAND_PAD values each: the
 * solver cuts them into equal parts. */
enum { OVR_BAND_PAD = 128 };
typedef struct ovr_band {
    double *b[5];  /* rows of the pentadiagonal system, b[d + 2] */
    double *delta; /* right-hand side, then solution */
    double *minus; /* share of delta_j that goes to P_{j-1}, and ... */
    double *plus;  /* ... to P_{j+1} */
    double *moves; /* 0 where P is held at zero, else 1 */
} ovr_band;

typedef struct ovr_kernels {
    const char *name;

    void (*film)(const ovr_fluid *fluid, double H0, size_t n, const double *gap,
                 const double *w, const ovr_fields *f);
    void (*residual)(size_t n, const ovr_weights *w, const ovr_fields *f);
    double (*imbalance)(size_t n, const ovr_weights *w, const ovr_fields *f);
    void (*deformation)(const struct ovr_mlmi *plan, const double *P,
                        double *w);
    void (*band_assemble)(size_t n, const ovr_weights *w, const double k[6],
                          double minus, double plus, bool transient,
                          const ovr_fields *f, const ovr_band *band);
    void (*band_solve)(size_t n, const ovr_band *band);
    void (*distribute)(size_t n, double limit, const ovr_band *band, double *P);
    double (*sum)(size_t n, const double *x);
    void (*combine)(size_t n, double a, const double *x, double b,
                    const double *y, double *result);
    void (*coarse_gap)(size_t n, double H0, const double *w, double *gap);
    void (*restrict_fields)(size_t nc, const double *P, const double *H,
                            const double *r, double *Pc, double *entry,
                            double *Hc, double *rc);
    void (*coarse_side)(size_t n, const double *residual, double *F, double *r);
    void (*correct)(size_t nc, double factor, const double *Pc,
                    const double *entry, double *P);
    void (*extrapolate)(size_t n, const double e[3], const double *a,
                        const double *b, const double *c, double *P);
    void (*dense_row)(size_t n, const double c[4], const double *k,
                      double *row);
    bool (*dense_solve)(size_t m, size_t stride, double *A, double *x);
} ovr_kernels;

/* The best table for this machine, or the named one ("base", "avx2",
 * "avx512"); NULL if there is no such table here. */
const ovr_kernels *ovr_kernels_choose(const char *name);

#define OVR_KERNEL_JOIN(name, isa) ovr_##name##_##isa
#define OVR_KERNEL_NAME(name, isa) OVR_KERNEL_JOIN(name, isa)
#ifdef OVR_ISA
#define OVR_KERNEL(name) OVR_KERNEL_NAME(name, OVR_ISA)
#endif

#endif
