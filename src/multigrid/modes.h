/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Fields Psi_m of a moving surface, one for each mode m of its thermal memory
 * (physics/heat/solids.h), and their change in a time step. The modes of node i
 * are stored from index i OVR_MODES on, so that a vector contains modes.
 *
 * The fields are convected with the surface (departures.h). If heat conduction
 * along the surface is included, all of them also diffuse: v_T = kappa v_XX. In
 * a step, a wave with wave number k is multiplied by e^(-x), x = kappa k^2 dT.
 * With E the shift by a node, kappa k^2 is that of (2 - E - 1/E)/D^2, and
 * e^(-x) is replaced by
 *
 *     1/(1 + x + x^2/2),  positive, at most 0.07 off, of second order in dT
 *
 * which is evaluated by two sweeps, with complex a, |a| < 1, rho = a/(1 - a)^2
 * = (1 + i) kappa dT/(2 D^2),
 *
 *     y_i = c v_i + b0 y_i-1 - b1 y_i-2,  z_i = c y_i + b0 z_i+1 - b1 z_i+2
 *     b0 = 2 Re a,  b1 = |a|^2,  c = |1 - a|^2
 *
 * Heat absorbed during the step diffuses too. With q linear between q' (before)
 * and q (now),
 *
 *     int_0^dT e^(-kappa k^2 t) q(T - t)/sqrt(t) dt
 *         = (4/3) sqrt(dT) w_1(x) q + (2/3) sqrt(dT) w_2(x) q'
 *     w_1 = sum c_l/(1 + d_l x),  w_2 = 1/(1 + 0.6 x + 0.168 x^2)
 *
 * with errors of 0.03 and 0.005 of the total for x up to 1e4 (exact to first
 * order in x). Because q is unknown before the film is solved, (w_1 - 1) q is
 * evaluated with the previous step's q at the same node.
 *
 * Outside the domain, a mode with decay rate s decreases as on a steadily
 * moving surface without heat source, u v_X = kappa v_XX - s v:
 *
 *     e^(-mu |X|),  mu = (root + |u|)/(2 kappa)  upstream
 *                   mu = 2 s/(root + |u|)        downstream
 *     root = sqrt(u^2 + 4 kappa s)
 *
 * that is, by f = e^(-mu D) per node. This determines the initial values of the
 * sweeps: on the left y_-l = A f^l, A = c v_0/(1 - b0 f + b1 f^2), on the right
 * z for y = A' f^j + Re(B a^j). At a departure point outside the domain, v is
 * the end value times e^(-mu |X|). With v = 0 outside, the surface would be too
 * cold: by 16 % at a Peclet number of 0.1. No heat may be absorbed within the
 * diffusion length of a step from the ends.
 *
 * Steady fields, with q linear between the nodes and zero outside, are
 *
 *     u Psi_X = q - s Psi + kappa Psi_XX
 *     Psi = (1/root) (int_(X' upstream) q e^(-mu_d |X - X'|) dX'
 *                     + int_(X' downstream) q e^(-mu_u |X - X'|) dX')
 *
 * with mu_d downstream of the heat source and mu_u upstream of it.
 *
 * Source: Carslaw & Jaeger, Conduction of Heat in Solids, 1959, 1.7 and 4.2 (a
 * moving medium, and one that loses heat).
 */
#ifndef OVR_MULTIGRID_MODES_H
#define OVR_MULTIGRID_MODES_H

#include <stdbool.h>

#include "multigrid/departures.h"

enum { OVR_MODES = 16 };

/* Two sweeps; end: coefficients of y_n-1 and y_n-2 in z_n and z_n+1. */
typedef struct ovr_sweeps {
    double c, b[2], end[2][2];
} ovr_sweeps;

enum { OVR_OWN_POLES = 3 };

/* Diffusion of the heat along surfaces in a step. */
typedef struct ovr_spread {
    bool on;
    ovr_sweeps past, before;        /* for e^-x; for w_2 */
    double own[OVR_OWN_POLES];      /* a of the poles of w_1 */
    double logarithm[2][OVR_MODES]; /* -mu D upstream of node 0, and downstream
                                     * of node n - 1 */
    double left[2][OVR_MODES];      /* y_-1 and y_-2 relative to v_0 */
    double right[2][OVR_MODES];     /* contribution of v_n-1 to z_n and z_n+1 */
} ovr_spread;

/* Prepares diffusion with kappa and u, for steps dT, mesh size D and rates s_m.
 */
ovr_spread ovr_spread_of(double kappa, double u, double dT, double D,
                         const double *rate);

/* Computes e^-x, x = s dT, and the coefficients of int e^(-s t) q(dT - t) dt =
 * a q + b q' for q linear in time from q' to q, for all rates s. */
void ovr_modes_integrals(double dT, const double *rate, double *fade, double *a,
                         double *b);

/* Computes the steady fields of a surface with speed u that absorbs q. */
void ovr_modes_steady(size_t n, double D, double kappa, double u,
                      const double *rate, const double *q, double *psi);

/* Psi_m at the departure point of node i (also outside the domain), by
 * convection only. */
double ovr_mode_at(const ovr_departures *departures, const ovr_spread *spread,
                   const double *psi, int m, size_t i);

/* Several fields stored side by side, each with its own sweeps: coefficients;
 * y_-1 and y_-2; contributions to z_n and z_n+1. */
enum { OVR_SWEPT = 8 };
typedef struct ovr_swept {
    double c[OVR_SWEPT], b[2][OVR_SWEPT], end[2][2][OVR_SWEPT];
    double begin[2][OVR_SWEPT], after[2][OVR_SWEPT];
} ovr_swept;

/* Returns the contribution of the past in a step of dT, without the q of now,
 * from Psi_m and q before: (h - T_bulk)/N of solids.h; and q before, carried
 * along and spread. `workspace` is of n, `fields` of n OVR_SWEPT. */
struct ovr_kernels;
typedef struct ovr_modes_look {
    const struct ovr_kernels *run;
    const ovr_departures *departures;
    const ovr_spread *spread;
    double dT;
    double more[2]; /* coefficients with a separate time step below layers
                     * (physics/heat/solids.h) */
    const double *weight, *psi, *q;
    double *workspace, *fields, *past, *before;
} ovr_modes_look;
void ovr_modes_past(const ovr_modes_look *look);

/* A time step: Psi_m <- fade Psi_m + now q + before q', where Psi_m and q' are
 * convected and diffused, and q is the present value. */
typedef struct ovr_modes_step {
    const ovr_departures *departures;
    const ovr_spread *spread;
    const double *fade, *now, *before; /* coefficients of each mode */
    const double *q, *q_before; /* present and previous values at the nodes */
} ovr_modes_step;

#endif
