/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Heat in time: a step of the temperatures of film and surfaces (cross_film.h,
 * solids.h), and what Reynolds' equation gets of them.
 *
 * A layer j of the film was at X - u_j dT, T_j' is what is there a step
 * ago; a surface comes from X - int u_k dT with its q and Psi_m (departures.h).
 * A solve across the film at each node with H of the guess that the cycles
 * begin from, and its P no further from the P' before than
 *
 *     |P - P'| <= 0.05 (P' + 0.01) + 0.7 max |P' - P''| there and
 *                                           beside it
 *     P_T = (P - P')/dT, 0 in the first step and where nothing foretold a jump
 *
 * A guess goes wrong by some of P where viscosities change, pressures of such
 * a guess heat the oil, and its viscosities change: a smooth film at 300 K and
 * a slip of um went to 1e5 K so, and in 10 cycles a step instead of 4.  What
 * passes in steps of D does not come near the limit.
 *
 * Viscosities are those of the temperatures `used`. These are extrapolated from
 * the preceding step and then changed by half of the difference to the new
 * ones,
 *
 *     T_used += (T' - T'') dT/dT' + (T - T_used)/2,
 *
 * where the first term makes no more than gamma |dT| = 0.15, for an edge that
 * has passed a node comes not again.  What is left to relax is a second
 * difference: T_used lags by O(dT^2).  (Half of the new change alone leaves it
 * behind by a step, O(dT); all of the new change is a loop that swings.)  The
 * flow that heats is that by T_used before the step.  What is made falls as
 * the film gets hotter:
 *
 *     tau u_z <- tau u_z (1 - gamma (T - T_used)),
 *     gamma = -(d ln eta/dT) tanh(a)/a,  a = |t|/Sigma0
 *
 * so that no film gets hotter by more than 1/gamma in one solve, be it
 * Newtonian.  It counts as a faster exchange with the departure point, which is
 * moved to T_used.  At the edge of a feature that moves a mesh a step oil may
 * get 100 K hotter at once; left colder by dT it is too viscous by e^(gamma
 * dT), powers of ten, does not let the pressure there go, and the next spike is
 * higher.  Therefore, if gamma |T - T_used| exceeds 0.15 under pressure, T_used
 * changes by half the difference, and heat is solved again with the film of a
 * cycle, six times at most: not by kelvins, of which a film of Eyring's law
 * bears many more. (The film knows no instability of its own: speeds are given
 * across it, not stresses, and what is made falls as it gets hotter.)  With the
 * film of the guess instead, whose pressures do not yet know the temperatures,
 * the same passes drive rough films, and long steps, apart: 2,100 K for 410.  A
 * film that is thinner than half of what was there, or none, heats as one of
 * half.
 *
 * So it is, twice at most, where a cycle has moved P by more than 3e-4 ph from
 * the P of the film that was heated.  And the flow q D that temperatures skew,
 * D = (V/2) m_1/m_0, is that of the content q as it is after each cycle.  Waves
 * of four or five mesh sizes in P, which hardly flow where the film is stiff,
 * see an explicit step in both otherwise: the guess, extrapolated, is off by
 * three times what alternates from step to step, D was up to a half at a slip
 * of
 * 1.77, and a steady contact of 1.65 GPa left its pressure by a factor of 2 to
 * 5 a step until it had 2.4 GPa.  It stays now to 1e-4, and of 500 runs at
 * random none breaks off (2 did).  What is extrapolated well, as smooth films
 * are, costs one solve a step; steps where the load jumps take half of the
 * cycles, rough hot films a quarter more.  (Six times, rough films take half as
 * many again, once, waves grow after all.)
 *
 * Where the film ends so far from the guess that the oil was pressed by 2 % of
 * all power more, or less, temperatures are found once more by that film: films
 * whose curvature jumps were heated by a pressure that they never had.
 *
 * A step is marked where gamma |T - T_used| stays above 1, where what is made
 * is off by a factor of e (0.5 to 1 in some steps left friction 0.6 % off), or
 * where energy does not close to a tenth of the most that was made in the run,
 * though the load did not jump just before.
 *
 * A step that is tried again begins from the temperatures of the last time
 * reached.  (With the viscosities of that time, as a steadier try, 24,000 K
 * came out where the load had jumped by a quarter, 550 K with those of the
 * step.)  Fluxes, memories of the surfaces and `used` move on when a step is
 * taken.
 *
 * A surface that stands still gets hotter as ln(T), for as long as its memory
 * reaches (heat_surfaces.h).
 */
#ifndef OVR_PHYSICS_HEAT_IN_TIME_H
#define OVR_PHYSICS_HEAT_IN_TIME_H

#include "physics/heat/heated.h"
#include "physics/heat/surfaces.h"

/* The temperatures used, th, shift, drag, skewed, swell, skew, skew_by_P. */
enum { OVR_HEAT_KEPT = OVR_CROSS_FILM_MAX + 7 };

typedef struct ovr_heat_steps {
    double dT;
    bool trying; /* T and q of ovr_heated are of a step not yet taken */
    double *T_before[OVR_CROSS_FILM_MAX], *q_before[2]; /* then: a step ago */
    double *change[OVR_CROSS_FILM_MAX]; /* of T, in the last step taken */
    double *kept[OVR_HEAT_KEPT];        /* of the last time reached */
    ovr_heat_surface surface[2];
    double *F;           /* history term of Reynolds' equation */
    double *P_T;         /* that the step was heated by */
    double *heated_P;    /* the P whose film was heated last */
    double lag;          /* gamma |T - T_used|, at most */
    int passes;          /* that this try may still make after the first */
    double max_balanced; /* of ovr_heated in this run */
    double stored;       /* power that the oil took up in the step */
} ovr_heat_steps;

/* Memory for them, with the rates of the surfaces' memories. */
ovr_status ovr_heat_steps_take(ovr_simulation *sim, ovr_error *err);

/* Those that follow are functions of a physics (physics.h), whose own is the
 * ovr_heated.  The steady solution, or a step just made, is the last time
 * reached. */
void ovr_heat_begin(ovr_simulation *sim, void *own);
void ovr_heat_taken(ovr_simulation *sim, void *own, double dT);

/* A step of dT from there, with its history term in place; a try of it, with
 * the guess in place: temperatures, and the film by them; the same after a
 * cycle, where they lag. */
void ovr_heat_step(ovr_simulation *sim, void *own, double dT);
void ovr_heat_try(ovr_simulation *sim, void *own, bool first);
void ovr_heat_anew(ovr_simulation *sim, void *own);

/* True if the step that was observed last has temperatures that are not those
 * of its film. */
bool ovr_heat_is_stale(ovr_simulation *sim, void *own);

/* Back to the last time reached. */
void ovr_heat_step_back(ovr_simulation *sim, void *own);

/* Arrays and numbers of the state between two steps; what follows from them,
 * once they are there. */
void ovr_heat_visit(ovr_simulation *sim, void *own, ovr_pieces *state);
void ovr_heat_restored(ovr_simulation *sim, void *own);

#endif
