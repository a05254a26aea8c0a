/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Kernels of the strip: the loops that take most of the time, compiled once for
 * each instruction set (*.kernel.c), with vectors across lines. Whole vectors
 * extend beyond the last line into the halo, which ovr_strip_kernels.wrap
 * restores.
 *
 * Kernels work on a part of the rows, lines or columns, so that threads can
 * share a grid (passes.c).  They write to that part only.  Sums are stored for
 * each row.
 */
#ifndef OVR_STRIP_KERNELS_H
#define OVR_STRIP_KERNELS_H

#include "strip/strip.h"

/* Rows, groups or columns from .. to - 1. */
typedef struct ovr_part {
    size_t from, to;
} ovr_part;

/* clang-format off */
#define OVR_STRIP_EACH_KERNEL(K) \
    /* Copies the period beyond both ends of every row */ \
    K(void, wrap, (const ovr_strip_grid *g, ovr_part rows, double *x)) \
    /* Computes the flow at half nodes. */ \
    K(void, faces, (const ovr_strip_grid *g, ovr_part rows, \
                    const ovr_fluid *fluid, bool logarithmic, \
                    const ovr_strip_fields *f, double *work)) \
    K(void, residual, (const ovr_strip_grid *g, ovr_part rows, \
                       const ovr_strip_weights *w, \
                       const ovr_strip_fields *f)) \
    /* Computes the residual, `moves` and `share`. */ \
    K(void, choose, (const ovr_strip_grid *g, ovr_part rows, \
                     const ovr_strip_weights *w, \
                     const ovr_strip_smoothing *how, double k, \
                     const ovr_strip_fields *f)) \
    K(void, imbalance, (const ovr_strip_grid *g, ovr_part rows, \
                        const ovr_strip_fields *f, double *sums)) \
    /* Solves groups of OVR_STRIP_GROUP lines. */ \
    K(void, solve_lines, (const ovr_strip_grid *g, ovr_part groups, \
                          const ovr_strip_weights *w, \
                          const ovr_strip_smoothing *how, \
                          const double *near, \
                          const ovr_strip_fields *f, double *work)) \
    /* Damps delta.  Colours 0 and 1 are even and odd lines. */ \
    K(void, damp, (const ovr_strip_grid *g, ovr_part rows, \
                   const ovr_strip_smoothing *how, int colour, \
                   const ovr_strip_fields *f)) \
    K(void, distribute, (const ovr_strip_grid *g, ovr_part rows, \
                         const ovr_strip_smoothing *how, \
                         const ovr_strip_fields *f)) \
    K(void, sweep_ends, (const ovr_strip_grid *g, const ovr_strip_weights *w, \
                         const ovr_strip_smoothing *how, double k, \
                         const ovr_strip_fields *f, double *work)) \
    K(void, sum, (const ovr_strip_grid *g, ovr_part rows, const double *x, \
                  double *sums)) \
    K(void, restrict_fields, (const ovr_strip_grid *coarse, ovr_part rows, \
                              const ovr_strip_grid *fine, \
                              const ovr_strip_fields *f, double H0, \
                              const ovr_strip_fields *to)) \
    /* Computes gap += w, and F = residual - N. */ \
    K(void, coarse_gap, (const ovr_strip_grid *g, ovr_part rows, \
                         const double *w, double *gap)) \
    K(void, coarse_side, (const ovr_strip_grid *g, ovr_part rows, \
                          const double *residual, const double *minus_N, \
                          double *F)) \
    /* Rows of the fine grid. */ \
    K(void, correct, (const ovr_strip_grid *coarse, \
                      const ovr_strip_grid *fine, ovr_part rows, \
                      double factor, const ovr_strip_fields *from, \
                      double *P)) \
    /* Computes to_j = sum of c k_j, P >= 0 where P_0 > 0, sums |a - b|. */ \
    K(void, blend, (size_t n, size_t count, const double *c, \
                    const double *const *from, double *to)) \
    K(void, hold, (size_t n, const double *P_0, double *P)) \
    K(void, distance, (const ovr_strip_grid *g, ovr_part rows, \
                       const double *a, const double *b, double *sums)) \
    K(void, multiply_modes, (size_t n, size_t length, size_t modes, \
                             ovr_part columns, const double *table, \
                             double *spectrum))
/* NOLINTNEXTLINE(bugprone-macro-parentheses) */
#define OVR_STRIP_POINTER(type, name, arguments) type(*name) arguments;
/* clang-format on */

typedef struct ovr_strip_kernels {
    const char *name;
    OVR_STRIP_EACH_KERNEL(OVR_STRIP_POINTER)
} ovr_strip_kernels;

/* Returns the strip kernels for a kernel table of the line contact; those of
 * the base instruction set for the plain table. */
const ovr_strip_kernels *ovr_strip_kernels_of(const ovr_kernels *kernels);

enum { OVR_STRIP_GROUP = 16 };

static inline size_t ovr_strip_groups(const ovr_strip_grid *g)
{
    return (g->lines + OVR_STRIP_GROUP - 1) / OVR_STRIP_GROUP;
}

/* Size of the array `work` of kernels in doubles, in whole cache lines. */
static inline size_t ovr_strip_work(const ovr_strip_grid *g)
{
    size_t solve = g->n * 2 * OVR_STRIP_GROUP, faces = 8 * g->stride;
    return solve > faces ? solve : faces;
}

/* Influence dH/dP of a node on line j on the lines 0.. of a row at a distance
 * of d rows, on the coarsest grid (elastic.c). */
static inline const double *ovr_strip_influence_of(const ovr_strip *strip,
                                                   size_t d, size_t j)
{
    const size_t lines = strip->level[0].grid.lines;
    return strip->influence + d * (2 * lines + 8) + (lines - j);
}

/* Maximum number of unknowns of a patch (spots.c). */
enum { OVR_STRIP_SPOT = 49 };

/* ------------------------------------------------------------------ passes.c
 */

/* Runs a loop of `count` items on a grid, in one thread if the grid is small.
 */
void ovr_strip_share(ovr_strip *strip, const ovr_strip_grid *g, size_t count,
                     ovr_team_work *work, void *data);
double *ovr_strip_work_of(const ovr_strip *strip, int member);

/* Copies the period of a field beyond both ends of all rows. */
void ovr_strip_wrap(ovr_strip *strip, ovr_strip_level *level, double *x);
/* Computes the residual, with its halos if `wrapped`. */
void ovr_strip_residual(ovr_strip *strip, ovr_strip_level *level, bool wrapped);
/* Computes the residual and sums it as the kernel does. */
double ovr_strip_imbalance(ovr_strip *strip, ovr_strip_level *level);
double ovr_strip_sum(ovr_strip *strip, ovr_strip_level *level, const double *x);
double ovr_strip_distance(ovr_strip *strip, ovr_strip_level *level,
                          const double *a, const double *b);

/* Computes residual, `moves` and `share`; then changes P by line solves of one
 * colour, or of all lines if the colour is -1. */
void ovr_strip_choose_nodes(ovr_strip *strip, ovr_strip_level *level,
                            const ovr_strip_smoothing *how);
void ovr_strip_relax_lines(ovr_strip *strip, ovr_strip_level *level,
                           const ovr_strip_smoothing *how, int colour);

/* Parts of the transfer between a grid and the next one (cycle.c). */
void ovr_strip_restrict(ovr_strip *strip, ovr_strip_level *coarse);
void ovr_strip_coarse_gap(ovr_strip *strip, ovr_strip_level *coarse);
void ovr_strip_coarse_side(ovr_strip *strip, ovr_strip_level *coarse);
void ovr_strip_correct(ovr_strip *strip, ovr_strip_level *fine, double factor);

#ifdef OVR_ISA
#define OVR_STRIP_KERNEL(name) OVR_KERNEL_NAME(strip_##name, OVR_ISA)
#endif

#endif
