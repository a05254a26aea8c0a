/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Outer iteration of temperatures and film of a steady contact. An iteration
 * computes from the temperatures u used in the film the new temperatures T(u).
 * The solution has zero residual r = T(u) - u. With relaxation alone,
 *
 *     u <- u + w r
 *
 * films with high sliding speed need a hundred or more outer iterations,
 * because the residual falls by only a tenth per iteration. If the residual is
 * small (0.1 of the temperature rise, 0.03 with opposite sliding), Anderson
 * acceleration uses the previous iterations u_j, r_j, with g_j that minimize r
 * + sum g_j (r_j - r) (equivalent to GMRES if T is linear):
 *
 *     u <- u + sum g_j (u_j - u) + w (r + sum g_j (r_j - r))
 *
 * Initially w = 0.6, or 0.35 if |u1 - u2| >= um. If the residual grows without
 * acceleration, w is reduced; if it doubles with acceleration, the stored
 * iterations are discarded. A temperature rise changes by at most half of
 * itself plus 10 K per iteration, because the first temperatures, those of the
 * isothermal film, may be extremely high.
 *
 * The norm of the residual excludes the film end, whose last node may alternate
 * between pressurized and cavitated. With a threshold of 1e-5 p_h this kept the
 * residual at 1e-3 of the rise, and one in eight contacts with opposite sliding
 * had no solution.
 *
 * Two iterations kept are as good as five: 12 Newtonian contacts of up to 1 GPa
 * took 1695 and 1671 cycles, and without them 2 did not end in 100 iterations.
 *
 * Source: Anderson, J. ACM 12 (1965); Walker & Ni, SIAM J. Numer. Anal. 49
 * (2011).
 */
#ifndef OVR_PHYSICS_HEAT_OUTER_H
#define OVR_PHYSICS_HEAT_OUTER_H

#include "multigrid/cross_film.h"
#include "simulation/internal.h"

enum { OVR_OUTER_KEPT = 2 };

/* The previous iterations, the most recent first. */
typedef struct ovr_heat_outer {
    double *u[OVR_OUTER_KEPT][OVR_CROSS_FILM_MAX];
    double *r[OVR_OUTER_KEPT][OVR_CROSS_FILM_MAX];
    int kept;         /* number of stored iterations */
    bool helped;      /* the last iteration was accelerated */
    double small;     /* residual below which acceleration is used */
    double w, change; /* relaxation factor; last residual relative to the
                       * maximum rise */
} ovr_heat_outer;

ovr_status ovr_heat_outer_take(ovr_simulation *sim, ovr_error *err);

/* Starts without stored iterations. */
void ovr_heat_outer_begin(ovr_simulation *sim);

/* Discards the iterations kept, after a change of the equations. */
void ovr_heat_outer_forget(ovr_heat_outer *outer);

/* Updates `used` from the computed T. Returns the maximum residual relative to
 * the maximum rise. */
double ovr_heat_iterate(ovr_simulation *sim);

#endif
