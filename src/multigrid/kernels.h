/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The kernels: the hot loops, compiled once for each instruction set
 * (*.kernel.c) and reached through one table that is chosen when a hierarchy is
 * created.  Each kernel is described above its code. The neighbouring file
 * *.plain.c contains the same computation in plain C (plain.h).
 *
 * Notation: n nodes i = 0..n-1, P = 0 at i = 0 and n-1; q = rho H.  Arrays are
 * in lanes (lanes.h) unless a kernel takes n instead of an ovr_lanes.
 */
#ifndef OVR_MULTIGRID_KERNELS_H
#define OVR_MULTIGRID_KERNELS_H

#include <stdbool.h>
#include <stddef.h>

#include "multigrid/fields.h"
#include "multigrid/friction.h"
#include "multigrid/lanes.h"
#include "overroll/contact.h"

struct ovr_mlmi;

struct ovr_law;
struct ovr_columns;
struct ovr_modes_step;
struct ovr_swept;

/* The lubricant, lambda of the Reynolds equation, and the kind of mean at half
 * nodes. */
typedef struct ovr_fluid {
    ovr_lubricant lubricant;
    double lambda;
    const struct ovr_law *law; /* viscosity-pressure relation that replaces the
                                * lubricant's */
    double sliding;            /* V = (u1 - u2)/um */
    bool by_gap;               /* means harmonic in H^3 (faces.h) */
    bool logarithmic;          /* means also logarithmic in 1/eta */
    bool secants;              /* secants as lower bounds of the derivatives */
    const struct ovr_flow_factor *factor; /* NULL: smooth, factor 1 */
} ovr_fluid;

/* eps for film thickness H and pressure P. */
double ovr_flow(const ovr_fluid *fluid, double P, double H);

/* Coefficients of the discrete Reynolds equation on one grid, see reynolds.h.
 */
typedef struct ovr_weights {
    double a[3];     /* coefficients of q_i, q_{i-1}, q_{i-2} */
    double first[3]; /* coefficients in row 1 */
    double half;     /* 1/(2 D^2) */
    double hold;     /* threshold of r relative to q below which a cavitated
                      * node stays cavitated */
    /* B of reynolds_row.h, and in row 1 */
    double skew[3], skew_first[3];
    /* with mass-conserving cavitation (content.h): limiters, inflow */
    double closed[3]; /* in row 1 of a closed inlet */
    double out, time, source;
} ovr_weights;

/* Work arrays of the line relaxation. */
typedef struct ovr_band {
    double *b[5];  /* rows of the pentadiagonal system, b[d + 2] */
    double *delta; /* right-hand side, then solution */
    double reach;  /* (X/4)^2 at the further end, at least 1: band.kernel.c */
} ovr_band;

/* Sets the row to delta = 0, for the end nodes of the grid. */
static inline void ovr_band_hold(const ovr_band *band, size_t place)
{
    for (size_t d = 0; d < 5; d++)
        band->b[d][place] = d == 2;
    band->delta[place] = 0;
}

/* Fractions of a change delta_j of the line relaxation that are added to
 * P_{j-1} and P_{j+1}; in transient steps also next to cavitated nodes. */
typedef struct ovr_shares {
    double minus, plus;
    bool transient;
} ovr_shares;

/* The correction to fourth order of one grid (fourth_order.h). */
typedef struct ovr_fourth {
    const ovr_fluid *fluid; /* lubricant; its rheological model is used if the
                               fields have tangents */
    double D, Cu;
    ptrdiff_t first, end; /* half nodes on the inlet side: first <= i < end */
    double *log_eps, *flux, *rise; /* work arrays */
    double *mask;    /* 1 where the equation is corrected, else 0 */
    double *F, *gap; /* corrections of the right-hand sides */
    bool linear;     /* pressure between nodes, else constant */
    bool reduced;    /* Poiseuille flow for X > 0 from reduced pressures */
    double local;    /* C of fourth_order.h */
} ovr_fourth;

/* MARGIN: number of nodes at each end without correction. LOCAL: C of
 * fourth_order.h for constant pressures, eta(3)/(2 pi^3). LINEAR: C for linear
 * pressures, zeta(3)/(4 pi^3). */
enum { OVR_FOURTH_MARGIN = 8 };

/* Second differences of ln eps above which fluxes upstream of X = 0 change to
 * the reduced pressure (fourth_order.h). */
#define OVR_REDUCED_FROM 1.
#define OVR_FOURTH_LOCAL 0.014538067351
#define OVR_FOURTH_LINEAR 0.009692044901

/* List of all kernels: return type, name, arguments. The kernel table and the
 * declarations and entries of each instruction set are generated from it. */
/* clang-format off */
#define OVR_EACH_KERNEL(K) \
    /* to lanes, with halos, and back to the order of the nodes */ \
    K(void, pack, (const ovr_lanes *g, const double *from, double *to)) \
    K(void, unpack, (const ovr_lanes *g, const double *from, double *to)) \
    /* updates P's halo for all following kernels */ \
    K(void, deformation, (const struct ovr_mlmi *plan, double *P, double *w)) \
    K(void, film, (const ovr_fluid *fluid, double H0, const ovr_lanes *g, \
                   const double *gap, const double *w, const ovr_fields *f)) \
    /* values stored at half nodes: with a rheological model, and without */ \
    K(void, flow, (const ovr_fluid *fluid, double D, const ovr_lanes *g, \
                   const ovr_fields *f)) \
    K(void, faces, \
      (const ovr_fluid *fluid, const ovr_lanes *g, const ovr_fields *f)) \
    /* and the phase from the residual */ \
    K(void, residual, (const ovr_lanes *g, const ovr_weights *w, \
                       const ovr_fields *f)) \
    /* wet and held, from P and the present residual */ \
    K(void, phase, (const ovr_lanes *g, const ovr_weights *w, \
                    const ovr_fields *f)) \
    K(double, imbalance, (const ovr_lanes *g, const ovr_weights *w, \
                          const ovr_fields *f)) \
    K(void, fourth_mask, (const ovr_lanes *g, double *P, double *mask)) \
    K(void, fourth_order, (const ovr_lanes *g, const ovr_fourth *c, \
                           const ovr_fields *f, const double *w)) \
    K(void, band_assemble, (const ovr_lanes *g, const ovr_weights *w, \
                            const double k[6], const ovr_shares *shares, \
                            const ovr_fields *f, const ovr_band *band)) \
    K(void, band_solve, (const ovr_lanes *g, const ovr_band *band)) \
    K(void, distribute, (const ovr_lanes *g, double limit, \
                         const ovr_shares *shares, const ovr_band *band, \
                         const ovr_fields *f)) \
    K(double, sum, (const ovr_lanes *g, const double *x)) \
    K(void, coarse_gap, (const ovr_lanes *g, double H0, const double *w, \
                         double *gap)) \
    K(void, restrict_fields, (const ovr_lanes *coarse, const ovr_lanes *fine, \
                              const ovr_fields *f, double *Pc, \
                              double *entry, double *Hc, double *rc)) \
    K(void, coarse_side, (const ovr_lanes *g, const double *residual, \
                          double *F, double *r)) \
    K(void, correct, (const ovr_lanes *coarse, const ovr_lanes *fine, \
                      double factor, const double *Pc, const double *entry, \
                      const ovr_fields *f)) \
    /* mass-conserving cavitation, see content.h */ \
    K(void, content_settle, (const ovr_lanes *g, const ovr_weights *w, \
                             bool limits, const ovr_fields *f)) \
    K(void, content_residual, (const ovr_lanes *g, const ovr_weights *w, \
                               const ovr_fields *f)) \
    K(double, content_imbalance, (const ovr_lanes *g, const ovr_fields *f)) \
    K(void, content_choose, (const ovr_lanes *g, const ovr_weights *w, \
                             const ovr_fields *f)) \
    K(void, content_assemble, (const ovr_lanes *g, const ovr_weights *w, \
                               const double k[6], const ovr_shares *shares, \
                               const ovr_fields *f, const ovr_band *band)) \
    K(void, content_advance, (const ovr_lanes *g, double limit, \
                              const ovr_shares *shares, const ovr_band *band, \
                              const ovr_fields *f)) \
    K(void, content_restrict, (const ovr_lanes *coarse, const ovr_lanes *fine, \
                               const ovr_fields *f, const ovr_fields *to, \
                               double *rc)) \
    /* in the order of the nodes, see scan.kernel.c */ \
    K(void, combine, (size_t n, double a, const double *x, double b, \
                      const double *y, double *result)) \
    K(void, extrapolate, (size_t n, size_t count, const double weight[], \
                          const double *const from[], double *P)) \
    K(void, carry, (size_t n, const double c[4], const double *const from[3], \
                    double *P)) \
    K(size_t, extreme, (size_t n, double sign, const double *x)) \
    K(bool, positive, (size_t n, const double *x)) \
    K(double, difference, (size_t n, const double *a, const double *b)) \
    K(double, gain, (size_t n, const double *weights, const double *a, \
                     const double *b)) \
    K(int, peaks, (size_t n, const double *x, size_t *last)) \
    K(void, film_sums, (size_t n, const double *weights, const double *q, \
                        const double *H, double sums[5])) \
    K(double, mean_flow, (size_t n, const double u[2], const double *X, \
                          const double *P, const double *q, \
                          const double *eps, const double *flow)) \
    K(double, flow_size, (size_t n, double Cu, const double *X, \
                          const double *P, const double *q, \
                          const double *eps, const double *flow)) \
    K(void, mean_stress, (const ovr_sheared *f, const ovr_fluid *fluid, \
                          double *t)) \
    K(double, limit_stress, (const ovr_sheared *f, double limit, double *t)) \
    K(ovr_friction, friction, (const ovr_sheared *f, const double *t)) \
    /* ln(eta/eta0) at T0; columns across the film, see cross_film.h */ \
    K(void, log_viscosity, (size_t n, const ovr_fluid *fluid, const double *P, \
                            const double *H, double *log_eta)) \
    K(void, flow_cross_film, (const struct ovr_columns *c)) \
    K(void, heat_cross_film, (const struct ovr_columns *c)) \
    /* thermal memory of surfaces, see modes.h */ \
    K(void, sum_modes, (size_t n, const double *weight, const double *psi, \
                        double q_weight, const double *q, double *sum)) \
    K(void, sweep_fields, (size_t n, const struct ovr_swept *set, double *v)) \
    K(void, step_modes, (const struct ovr_modes_step *w, const double *psi, \
                         double *to)) \
    K(double, deviation, (size_t n, const double e[3], double maximum, \
                          const double *weights, const double *P, \
                          const double *q, double *const past[3])) \
    K(void, dense_row, (size_t n, const double c[4], const double *k, \
                        double *row)) \
    K(bool, dense_solve, (size_t m, size_t stride, double *A, double *x))
/* NOLINTNEXTLINE(bugprone-macro-parentheses) */
#define OVR_KERNEL_POINTER(type, name, arguments) type(*name) arguments;
/* clang-format on */

typedef struct ovr_kernels {
    const char *name;
    size_t lanes;
    OVR_EACH_KERNEL(OVR_KERNEL_POINTER)
} ovr_kernels;

/* Returns the best table for this machine or the named one ("plain", "base",
 * "avx2", "avx512"), or NULL if there is no such table. */
const ovr_kernels *ovr_kernels_choose(const char *name);

#define OVR_KERNEL_JOIN(name, isa) ovr_##name##_##isa
#define OVR_KERNEL_NAME(name, isa) OVR_KERNEL_JOIN(name, isa)
#ifdef OVR_ISA
#define OVR_KERNEL(name) OVR_KERNEL_NAME(name, OVR_ISA)
#endif

#endif
