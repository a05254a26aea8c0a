/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Fields Psi_m of a moving surface, one for each mode m of its memory
 * (physics/heat/solids.h), and their change in a step. They are stored side by
 * side, those of node i from i OVR_MODES on, so that vectors hold modes.
 *
 * A surface carries them along (departures.h), and where heat flows along it
 * too they spread, each alike: v_T = kappa v_XX, in a step by e^(-x) for the
 * wave number k of x = kappa k^2 dT.  With E the shift by a node, kappa k^2 is
 * that of (2 - E - 1/E)/D^2, and e^(-x) is replaced by
 *
 *     1/(1 + x + x^2/2),  positive, at most 0.07 off, of second order in dT
 *
 * whose inverse are two sweeps, with the complex a that has |a| < 1 and rho =
 * a/(1 - a)^2 = (1 + i) kappa dT/(2 D^2),
 *
 *     y_i = c v_i + b0 y_i-1 - b1 y_i-2,  z_i = c y_i + b0 z_i+1 - b1 z_i+2
 *     b0 = 2 Re a,  b1 = |a|^2,  c = |1 - a|^2
 *
 * What is taken up within the step spreads too: with q' before and q now, both
 * linear in it,
 *
 *     int_0^dT e^(-kappa k^2 t) q(T - t)/sqrt(t) dt
 *         = (4/3) sqrt(dT) w_1(x) q + (2/3) sqrt(dT) w_2(x) q'
 *     w_1 = sum c_l/(1 + d_l x),  w_2 = 1/(1 + 0.6 x + 0.168 x^2)
 *
 * within 0.03 and 0.005 of the whole to x = 1e4 (and right to first order in
 * x).  q is not known before the film is: (w_1 - 1) q is taken of the last
 * step's q at the same node.
 *
 * Beyond the domain a mode of the rate s falls as where nothing heats a surface
 * that moves at u steadily, u v_X = kappa v_XX - s v:
 *
 *     e^(-mu |X|),  mu = (root + |u|)/(2 kappa)  upstream
 *                   mu = 2 s/(root + |u|)        downstream
 *     root = sqrt(u^2 + 4 kappa s)
 *
 * by f = e^(-mu D) from node to node, so that the sweeps start with their
 * values from outside: on the left y_-l = A f^l, A = c v_0/(1 - b0 f + b1 f^2),
 * on the right z of y that is A' f^j + Re(B a^j) there.  A departure point
 * beyond an end finds v there times e^(-mu |X|).  Cut off instead, the domain
 * would cool the surface: by 16 % at a Peclet number of 0.1.  Nothing may be
 * taken up near the ends, within what spreads in a step.
 *
 * Steady ones, with q linear between the nodes and nothing beyond them, are
 *
 *     u Psi_X = q - s Psi + kappa Psi_XX
 *     Psi = (1/root) (int_(X' upstream) q e^(-mu_d |X - X'|) dX'
 *                     + int_(X' downstream) q e^(-mu_u |X - X'|) dX')
 *
 * with the mu downstream of what heats it, and upstream.
 *
 * Source: Carslaw & Jaeger, Conduction of Heat in Solids, 1959, 1.7 and 4.2 (a
 * moving medium, and one that loses heat).
 */
#ifndef OVR_MULTIGRID_MODES_H
#define OVR_MULTIGRID_MODES_H

#include <stdbool.h>

#include "multigrid/departures.h"

enum { OVR_MODES = 16 };

/* Two sweeps; end: z_n and z_n+1 by y_n-1 and y_n-2. */
typedef struct ovr_sweeps {
    double c, b[2], end[2][2];
} ovr_sweeps;

enum { OVR_OWN_POLES = 3 };

/* The way in which the heat of surfaces spreads in a step. */
typedef struct ovr_spread {
    bool on;
    ovr_sweeps past, before;        /* e^-x; w_2 */
    double own[OVR_OWN_POLES];      /* a of the poles of w_1 */
    double logarithm[2][OVR_MODES]; /* -mu D before node 0, after n - 1 */
    double left[2][OVR_MODES];      /* y_-1, y_-2 over v_0 */
    double right[2][OVR_MODES];     /* what v_n-1 adds to z_n, z_n+1 */
} ovr_spread;

/* Prepares kappa and u, steps of dT on a mesh size D, and rates s_m. */
ovr_spread ovr_spread_of(double kappa, double u, double dT, double D,
                         const double *rate);

/* e^-x, x = s dT, and int e^(-s t) q(dT - t) dt = a q + b q' of a q that is
 * linear over dT, from q' to q: at all rates s. */
void ovr_modes_integrals(double dT, const double *rate, double *fade, double *a,
                         double *b);

/* The steady ones of a surface that takes up q, at u. */
void ovr_modes_steady(size_t n, double D, double kappa, double u,
                      const double *rate, const double *q, double *psi);

/* Psi_m at the departure point of node i, wherever that is, carried along
 * alone. */
double ovr_mode_at(const ovr_departures *departures, const ovr_spread *spread,
                   const double *psi, int m, size_t i);

/* Fields side by side, each with sweeps of its own: coefficients; y_-1 and
 * y_-2; what is added to z_n and z_n+1. */
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
    double more[2]; /* of an own step under layers (physics/heat/solids.h) */
    const double *weight, *psi, *q;
    double *workspace, *fields, *past, *before;
} ovr_modes_look;
void ovr_modes_past(const ovr_modes_look *look);

/* A step: Psi_m <- fade Psi_m + now q + before q', Psi_m and q' carried along
 * and spread, q of now. */
typedef struct ovr_modes_step {
    const ovr_departures *departures;
    const ovr_spread *spread;
    const double *fade, *now, *before; /* by modes */
    const double *q, *q_before;        /* at the nodes */
} ovr_modes_step;

#endif
