/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The strip: a line contact whose film also varies across rolling, periodic in
 * Y over the width W.
 *
 *     d/dX(eps dP/dX) + d/dY(eps dP/dY) - d(rho H)/dX - d(rho H)/dT = 0
 *     H = H0 + gap - w,   w = -(1/2 pi) int int P/r dX' dY'
 *     (1/W) int int P dX dY = force,   P >= 0
 *
 * The scales are those of the line contact (reynolds.h).  Lengths are in b,
 * films in b^2/R and pressures in p_h.  The nominal load has force = pi/2.
 * Rolling and sliding are along X only.  Without variation across the rolling
 * direction the strip is a line contact.
 *
 * Grid: nodes X_i = X_a + i D, i = 0..n-1, and lines Y_j = j Dy, j =
 * 0..lines-1. Dy = W/lines.  There is no pressure at i = 0 and n-1.  Nodes of a
 * row have the same X, nodes of a line the same Y coordinate.
 *
 * Memory: element (i, j) of a field is at i stride + j.  The lines of a row are
 * contiguous, so that vectors extend across lines and stencils along X are
 * whole vectors.  OVR_STRIP_HALO elements on both sides of a row repeat the
 * period.  The boundary across rolling is defined in across.h.
 *
 * Solver: FAS multigrid (cycle.c) with distributive relaxation of lines
 * (relax.kernel.c) and projected sweeps at the ends of the film
 * (ends.kernel.c). The deformation is computed by FFT (elastic.c).  The
 * coarsest grid is solved by Newton's method (coarsest.c).  Steady films are
 * found by nested iteration (full.c).  march.c computes time steps.
 */
#ifndef OVR_STRIP_STRIP_H
#define OVR_STRIP_STRIP_H

#include <fftw3.h>

#include "base/arena.h"
#include "base/team.h"
#include "multigrid/kernels.h"
#include "overroll/error.h"
#include "overroll/memory.h"

enum { OVR_STRIP_HALO = 8, OVR_STRIP_LEVELS = 12 };

/* Number of rows and lines of the near-field influence. */
enum { OVR_STRIP_NEAR = 16, OVR_STRIP_NEAR_LINES = 8 };

typedef struct ovr_strip_grid {
    size_t n;      /* nodes along X */
    size_t lines;  /* nodes along Y in a period */
    size_t stride; /* elements from a row to the next */
    double X_a, D, Dy;
} ovr_strip_grid;

/* Index of the first element of a row. */
static inline size_t ovr_strip_row(const ovr_strip_grid *g, size_t i)
{
    return i * g->stride;
}

/* Number of elements of a field from the first element to the end of the last
 * row. */
static inline size_t ovr_strip_size(const ovr_strip_grid *g)
{
    return g->n * g->stride;
}

/* Allocates an array of n values with halos; returns NULL with *err filled if
 * this fails. */
double *ovr_strip_field(size_t n, ovr_arena *arena, ovr_error *err);

/*
 * Fields of a level.  Flow through the half nodes i + 1/2 and j + 1/2, divided
 * by the square of the mesh size:
 *     flow = E (P_{i+1} - P_i),  d flow/dP_i = -before,  d flow/dP_{i+1} =
 * after
 */
#define OVR_STRIP_FIELDS(FIELD)                                                \
    FIELD(P)     /* pressure */                                                \
    FIELD(H)     /* film thickness */                                          \
    FIELD(gap)   /* undeformed gap; on coarse grids H - H0 + w at entry */     \
    FIELD(w)     /* deformation, H = H0 + gap - w */                           \
    FIELD(rho)   /* density */                                                 \
    FIELD(q)     /* rho H */                                                   \
    FIELD(dq)    /* dq/dP at fixed H */                                        \
    FIELD(eps)   /* rho H^3/(eta lambda) */                                    \
    FIELD(deps)  /* d eps/dP at fixed H */                                     \
    FIELD(F)     /* right-hand side */                                         \
    FIELD(r)     /* residual F - N */                                          \
    FIELD(entry) /* P at the start of the cycle on this level */               \
    FIELD(along) /* E at i + 1/2 */                                            \
    FIELD(along_before)                                                        \
    FIELD(along_after)                                                         \
    FIELD(across) /* E at j + 1/2 */                                           \
    FIELD(across_before)                                                       \
    FIELD(across_after)                                                        \
    FIELD(                                                                     \
        moves) /* 1 for unknowns of a sweep, 0 for nodes constrained to P = 0  \
                */                                                             \
    FIELD(share)  /* s of relax.kernel.c, 0..1 */                              \
    FIELD(delta)  /* change of the line solve */                               \
    FIELD(spread) /* s delta */
#define OVR_STRIP_FIELD_POINTER(name) double *restrict name;
#define OVR_STRIP_FIELD_NUMBER(name) ovr_strip_field_##name,

enum { OVR_STRIP_FIELDS(OVR_STRIP_FIELD_NUMBER) OVR_STRIP_FIELD_COUNT };

typedef struct ovr_strip_fields {
    union {
        struct {
            OVR_STRIP_FIELDS(OVR_STRIP_FIELD_POINTER)
        };
        double *all[OVR_STRIP_FIELD_COUNT];
    };
    /* Derivatives with respect to both film thicknesses, on the coarsest grid
     * only; otherwise NULL */
    double *along_by_film[2], *across_by_film[2];
} ovr_strip_fields;

/* Weights of q_i, q_{i-1}, q_{i-2} in a row of the equation; those of row 1. */
typedef struct ovr_strip_weights {
    double a[3], first[3];
} ovr_strip_weights;

/* Elastic sums of one grid (elastic.c). */
typedef struct ovr_strip_elastic {
    size_t n, lines, stride;
    size_t modes;  /* lines/2 + 1 */
    size_t length; /* length of the transforms along X, 2 (n - 1) */
    double *table; /* n x modes: transform of the influence, an even function */
    fftw_complex *spectrum; /* length x modes; shared between the grids */
    /* For a block of rows or columns, and for the remaining ones */
    fftw_plan to_modes[2], to_waves[2], from_waves[2], from_modes[2];
} ovr_strip_elastic;

typedef struct ovr_strip_level {
    int number; /* 0: the coarsest */
    ovr_strip_grid grid;
    ovr_strip_fields f;
    ovr_strip_weights weights;
    double force; /* required value of D/lines sum P */
    ovr_strip_elastic elastic;
    /* dH/dP at distances of 0.. lines and rows */
    double near[OVR_STRIP_NEAR_LINES][OVR_STRIP_NEAR];
} ovr_strip_level;

/* Parameters of the relaxation (relax.kernel.c, ends.kernel.c). */
typedef struct ovr_strip_smoothing {
    double to_left, to_right, to_side; /* fractions of a distributed change */
    double whole, plain;               /* damping where s is 1, and where s is 0
                                        */
    double limit;                      /* maximum change of P */
    double tau, along, across;         /* threshold at which s changes from 1 to
                                        * 0 */
    bool zebra;
    int end_sweeps;   /* double sweeps at the film ends */
    double end_share; /* nodes whose flow exceeds this multiple of a0 rho k(0,0)
                       */
} ovr_strip_smoothing;

typedef struct ovr_strip_cycling {
    ovr_strip_smoothing smoothing;
    int sweeps_before, sweeps_after;
    int newton_steps;
    double correction; /* factor of the corrections of the finest grid */
} ovr_strip_cycling;

struct ovr_strip_kernels;

/* Dimensions of a strip. */
typedef struct ovr_strip_shape {
    size_t n, lines; /* nodes along X and lines of the finest grid */
    size_t coarsest; /* maximum number of nodes along X of the coarsest grid */
    double X_a, X_b, width;
    int threads; /* threads of the solver, including the caller's; 0: 1 */
} ovr_strip_shape;

/* Interruption of long solves. Once it has returned true, it always does. */
typedef bool ovr_strip_stop(void *data);

typedef struct ovr_strip {
    int finest;
    ovr_strip_level level[OVR_STRIP_LEVELS];
    const ovr_kernels *kernels;
    const struct ovr_strip_kernels *run;
    ovr_fluid fluid;
    bool logarithmic; /* mean of phi at half nodes (faces.kernel.c) */
    double H0;
    ovr_strip_stop *stop; /* called before each cycle and each Newton step of
                           * the coarsest grid; NULL: never end */
    void *stop_data;
    int threads;
    ovr_team team;     /* team of `threads` threads */
    double cycled;     /* cycles so far, times the nodes of the finest grid */
    double *work;      /* work arrays of kernels for all threads, see
                        * ovr_strip_work() */
    size_t work_size;  /* doubles in `work` per thread */
    double *sums;      /* one sum per row of a grid */
    double *influence; /* elastic influence on the coarsest grid (coarsest.c) */
    double *deps_dH;
    double *matrix, *solution; /* linear system of the coarsest grid */
    int *unknown;
    fftw_complex *spectrum;
} ovr_strip;

/* Error of a solution.  The imbalance R is the mean over all lines of D sum
 * |residual|/H_cen.  The load is relative to the target.  The centre is the
 * mean film thickness at X = 0. */
typedef struct ovr_strip_defect {
    double imbalance, load, centre;
} ovr_strip_defect;

/*
 * Allocates all levels of a zeroed strip in the arena.  Mesh sizes and lines
 * are halved from grid to grid.  The coarsest grid has n <= coarsest, or lines
 * that are odd or 4.  Fails with OVR_NO_MEMORY or OVR_BAD_INPUT. The arena may
 * be one that only counts.
 */
ovr_status ovr_strip_allocate(ovr_strip *strip, const ovr_strip_shape *shape,
                              const ovr_kernels *kernels, ovr_arena *arena,
                              ovr_error *err);

/* Plans the transforms of an allocated strip and computes the elastic
 * influence. The transforms must be released, also after a failure. */
ovr_status ovr_strip_plan(ovr_strip *strip, ovr_error *err);

/* Allocates and plans a strip. */
ovr_status ovr_strip_create(ovr_strip *strip, const ovr_strip_shape *shape,
                            const ovr_kernels *kernels, ovr_arena *arena,
                            ovr_error *err);
void ovr_strip_release(ovr_strip *strip);

/* Returns the default cycle parameters of steady films and of time steps with a
 * fluid. */
ovr_strip_cycling ovr_strip_steady(const ovr_fluid *fluid);
ovr_strip_cycling ovr_strip_transient(const ovr_fluid *fluid);

/* Sets the weights of the second-order wedge (upstream2) for an entrainment
 * speed; the first row is of first order. `time` is the weight of q_i in d/dT.
 */
void ovr_strip_wedge(ovr_strip *strip, double speed, double time);
/* Sets the weights of the characteristic scheme: only a0 is nonzero. */
void ovr_strip_characteristic(ovr_strip *strip, double time);

/* Computes film thickness, properties and flow from P and H0. */
void ovr_strip_refresh(ovr_strip *strip, ovr_strip_level *level);
void ovr_strip_deform(ovr_strip *strip, ovr_strip_level *level, double *P,
                      double *w);
void ovr_strip_properties(ovr_strip *strip, ovr_strip_level *level);
double ovr_strip_load(ovr_strip *strip, ovr_strip_level *level);
double ovr_strip_centre(const ovr_strip_level *level, const double *H);
ovr_strip_defect ovr_strip_defect_of(ovr_strip *strip, ovr_strip_level *level);
bool ovr_strip_below(ovr_strip_defect d, double tolerance);

/* A Newton step on the coarsest grid. Returns the largest change of P before
 * limiting, or -1 if the matrix is singular. Changes of P are limited to 0.3,
 * by shortening the step if `shortened`. */
double ovr_strip_newton(ovr_strip *strip, bool shortened);

/* Newton steps on small patches around the nodes whose contributions to R
 * exceed `least` (spots.c). Returns the number of patches. Film and flow must
 * be up to date before, and are up to date after it. */
size_t ovr_strip_spots(ovr_strip *strip, ovr_strip_level *level,
                       const ovr_strip_smoothing *how, double least);

/* True if solves are to end. */
static inline bool ovr_strip_stops(const ovr_strip *strip)
{
    return strip->stop && strip->stop(strip->stop_data);
}

/* One FAS cycle that starts on the given level. */
void ovr_strip_cycle(ovr_strip *strip, int number,
                     const ovr_strip_cycling *how);

/* Writes the gap at rows i = from..from + n - 1 of a grid to `gap`, row after
 * row. */
typedef void ovr_strip_gap(void *data, double T, const ovr_strip_grid *grid,
                           ptrdiff_t from, size_t n, double *gap);

typedef struct ovr_strip_full {
    ovr_strip_gap *gap;
    void *data;
    double T, force;
    double speed; /* entrainment speed in the wedge */
    /* Initial guess: a semi-ellipse of this half-width, whose integral is the
     * force, and this film thickness at the centre */
    double half_width, film;
    ovr_strip_cycling cycling;
    int cycles;       /* on each level below the finest */
    int max_cycles;   /* on the finest */
    double tolerance; /* tolerance of R on the finest level */
} ovr_strip_full;

/* Steady solution by nested iteration with the weights of ovr_strip_wedge.
 * Returns the remaining error; *cycles is the number of cycles on the finest
 * grid. */
ovr_strip_defect ovr_strip_solve(ovr_strip *strip, const ovr_strip_full *how,
                                 int *cycles);

/* Steady cycles on the finest grid from its pressure. */
ovr_strip_defect ovr_strip_continue(ovr_strip *strip, const ovr_strip_full *how,
                                    int *cycles);

/* ------------------------------------------------------------------- Parts */

ovr_status ovr_strip_elastic_allocate(ovr_strip_elastic *e,
                                      const ovr_strip_grid *grid,
                                      fftw_complex *spectrum, ovr_arena *arena,
                                      ovr_error *err);
ovr_status ovr_strip_elastic_plan(ovr_strip_elastic *e,
                                  const ovr_strip_grid *grid,
                                  ovr_strip_level *near, double *real_space,
                                  ovr_error *err);
void ovr_strip_elastic_release(ovr_strip_elastic *e);

/* Computes k_q(d), d = 0..n-1, for wave number k; k = 0 is the kernel of the
 * line contact. */
void ovr_strip_influence(double k, double D, size_t n, size_t step, double *to);

/* Halves n and lines of the finest grid down to the coarsest grid; returns the
 * number of halvings. */
int ovr_strip_halvings(size_t coarsest, size_t *n, size_t *lines);

/* Number of complex elements of the spectrum that all grids of a shape share.
 */
size_t ovr_strip_spectrum_size(const ovr_strip_grid *g);

#endif
