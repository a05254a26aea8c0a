/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The strip's kernels: its hot loops, compiled once for each instruction set
 * (*.kernel.c), with vectors across lines.  Whole vectors reach past the last
 * line into the halo, which ovr_strip_kernels.wrap fills again.
 */
#ifndef OVR_STRIP_KERNELS_H
#define OVR_STRIP_KERNELS_H

#include "strip/strip.h"

/* clang-format off */
#define OVR_STRIP_EACH_KERNEL(K) \
    /* Repeats the period beyond both ends of every row. */ \
    K(void, wrap, (const ovr_strip_grid *g, double *x)) \
    /* Computes the flow at half nodes. */ \
    K(void, faces, (const ovr_strip_grid *g, const ovr_fluid *fluid, \
                    bool logarithmic, const ovr_strip_fields *f, \
                    double *work)) \
    K(void, residual, (const ovr_strip_grid *g, const ovr_strip_weights *w, \
                       const ovr_strip_fields *f)) \
    /* Computes the residual, `moves` and `share`. */ \
    K(void, choose, (const ovr_strip_grid *g, const ovr_strip_weights *w, \
                     const ovr_strip_smoothing *how, double k, \
                     const ovr_strip_fields *f)) \
    K(double, imbalance, (const ovr_strip_grid *g, const ovr_strip_fields *f)) \
    K(void, solve_lines, (const ovr_strip_grid *g, const ovr_strip_weights *w, \
                          const ovr_strip_smoothing *how, \
                          const double *near, \
                          const ovr_strip_fields *f, double *work)) \
    /* Damps delta.  Colours 0 and 1 are even and odd lines. */ \
    K(void, damp, (const ovr_strip_grid *g, const ovr_strip_smoothing *how, \
                   int colour, const ovr_strip_fields *f)) \
    K(void, distribute, (const ovr_strip_grid *g, \
                         const ovr_strip_smoothing *how, \
                         const ovr_strip_fields *f)) \
    K(void, sweep_ends, (const ovr_strip_grid *g, const ovr_strip_weights *w, \
                         const ovr_strip_smoothing *how, double k, \
                         const ovr_strip_fields *f, double *work)) \
    K(double, sum, (const ovr_strip_grid *g, const double *x)) \
    K(void, restrict_fields, (const ovr_strip_grid *coarse, \
                              const ovr_strip_grid *fine, \
                              const ovr_strip_fields *f, double H0, \
                              const ovr_strip_fields *to)) \
    /* Computes gap += w, and F = residual - N. */ \
    K(void, coarse_gap, (const ovr_strip_grid *g, const double *w, \
                         double *gap)) \
    K(void, coarse_side, (const ovr_strip_grid *g, const double *residual, \
                          const double *minus_N, double *F)) \
    K(void, correct, (const ovr_strip_grid *coarse, \
                      const ovr_strip_grid *fine, double factor, \
                      const ovr_strip_fields *from, double *P)) \
    /* Computes to_j = sum of c k_j, P >= 0 where P_0 > 0, sum |a - b|. */ \
    K(void, blend, (size_t n, size_t count, const double *c, \
                    const double *const *from, double *to)) \
    K(void, hold, (size_t n, const double *P_0, double *P)) \
    K(double, distance, (const ovr_strip_grid *g, const double *a, \
                         const double *b)) \
    K(void, multiply_modes, (size_t n, size_t length, size_t modes, \
                             const double *table, double *spectrum))
/* NOLINTNEXTLINE(bugprone-macro-parentheses) */
#define OVR_STRIP_POINTER(type, name, arguments) type(*name) arguments;
/* clang-format on */

typedef struct ovr_strip_kernels {
    const char *name;
    OVR_STRIP_EACH_KERNEL(OVR_STRIP_POINTER)
} ovr_strip_kernels;

/* The strip's kernels of a table of the line contact's; those of the base for
 * the plain one. */
const ovr_strip_kernels *ovr_strip_kernels_of(const ovr_kernels *kernels);

/* Doubles that kernels take as `work`. */
static inline size_t ovr_strip_work(const ovr_strip_grid *g)
{
    size_t solve = g->n * 2 * 16, faces = 8 * g->stride;
    return solve > faces ? solve : faces;
}

#ifdef OVR_ISA
#define OVR_STRIP_KERNEL(name) OVR_KERNEL_NAME(strip_##name, OVR_ISA)
#endif

#endif
