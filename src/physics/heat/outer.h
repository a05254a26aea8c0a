/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Temperatures and film of a steady contact in turn.  An outer iteration takes
 * the temperatures u by which the film flows to those T(u) that it is heated
 * to; sought is u with the rest r = T(u) - u = 0.  By relaxing alone,
 *
 *     u <- u + w r
 *
 * films that slide fast need a hundred outer iterations and more, in which the
 * rest falls by a tenth an iteration: it heats less where it is hotter, and
 * each place heats what comes after it.  Where the rest is small (0.1 of the
 * rise, 0.03 where surfaces move in opposite directions) the last iterations,
 * u_j and r_j, help, with the g_j that make r + sum g_j (r_j - r) the smallest
 * (Anderson's method, for a linear T the same as GMRES):
 *
 *     u <- u + sum g_j (u_j - u) + w (r + sum g_j (r_j - r))
 *
 * w begins at 0.6, or 0.35 where the slip is at least um; it is lowered where
 * rests grow without that help, and the iterations before are forgotten where
 * they double with it.  No temperature moves on by more than half of itself and
 * 10 K an iteration: the first are those of an isothermal film, which may be
 * absurd.
 *
 * Rests count where the film is pressed: its last node may be wet in one turn
 * and dry in the next, for ever, which at 1e-5 of p_h held the rest at 1e-3 of
 * the rise: one in eight contacts whose surfaces move against each other had no
 * solution so.
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

/* The iterations before, the last first. */
typedef struct ovr_heat_outer {
    double *u[OVR_OUTER_KEPT][OVR_CROSS_FILM_MAX];
    double *r[OVR_OUTER_KEPT][OVR_CROSS_FILM_MAX];
    int kept;         /* of them */
    bool helped;      /* the last iteration used those before it */
    double small;     /* change below which they are used */
    double w, change; /* the rest of the last over the largest rise */
} ovr_heat_outer;

ovr_status ovr_heat_outer_take(ovr_simulation *sim, ovr_error *err);

/* Begins without iterations. */
void ovr_heat_outer_begin(ovr_simulation *sim);

/* Discards the iterations kept, after a change of the equations. */
void ovr_heat_outer_forget(ovr_heat_outer *outer);

/* Moves `used` on by the T that was found by it; the largest rest over the
 * largest rise. */
double ovr_heat_iterate(ovr_simulation *sim);

#endif
