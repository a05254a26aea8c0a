/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Heat in time: a step of the temperatures of film and surfaces (cross_film.h,
 * solids.h), and their effect on the Reynolds equation.
 *
 * Layer j of the film was at X - u_j dT one step ago, where its temperature was
 * T_j'. A surface was at X - int u_k dT, with its q and Psi_m (departures.h).
 * The energy equation across the film is solved at each node with H of the
 * initial guess of the step. P of the guess is limited to
 *
 *     |P - P'| <= 0.05 (P' + 0.01) + 0.7 max |P' - P''| there and
 *                                           beside it
 *     P_T = (P - P')/dT, 0 in the first step and where an unpredicted jump
 *                                           occurs
 *
 * Without the limit, errors of the guess heat the lubricant, the viscosities
 * change, and the next guess has a larger error: a smooth film at 300 K with u1
 * - u2 = um reached 1e5 K, with 10 cycles per step instead of 4. Features that
 * move by D per step do not reach the limit.
 *
 * Viscosities are those of the temperatures `used`. These are extrapolated from
 * the preceding step and then changed by half of the difference to the new
 * ones,
 *
 *     T_used += (T' - T'') dT/dT' + (T - T_used)/2,
 *
 * where the first term is limited to gamma |dT| = 0.15, because the edge of a
 * feature passes a node only once. The remaining difference is of second order:
 * T_used lags by O(dT^2). (With half of the new change alone it would lag by
 * O(dT); with the full change the iteration would oscillate.) The heat source
 * is computed with the flow at T_used before the step. It decreases with the
 * temperature:
 *
 *     tau u_z <- tau u_z (1 - gamma (T - T_used)),
 *     gamma = -(d ln eta/dT) tanh(a)/a,  a = |t|/Sigma0
 *
 * so that the temperature rises by at most 1/gamma in one solve, also in
 * Newtonian films. In the equation this term acts as a faster exchange with the
 * departure point, at temperature T_used. At the edge of a feature that moves
 * by D per step, the lubricant can become 100 K hotter in one step. If T_used
 * remains too low by dT, the viscosity is too high by e^(gamma dT), the
 * pressure does not decrease, and the next spike is higher.  Therefore, if
 * gamma |T - T_used| exceeds 0.15 under pressure, T_used changes by half the
 * difference, and the temperatures are solved again with the film after a
 * cycle, at most six times. The criterion is not in kelvins, because Eyring
 * films tolerate larger differences. (The film itself is stable: the velocities
 * of the surfaces are given, not the stresses, and the heat source decreases
 * with temperature.) If the film of the guess were used in these passes, rough
 * films and long steps would diverge: 2,100 K in place of 410 K. A film thinner
 * than half of the previous film thickness is replaced by half.
 *
 * The temperatures are also solved again, at most twice, if a cycle has changed
 * P by more than 3e-4 p_h since the last temperature solve. The skewed flow q
 * D, D = (V/2) m_1/m_0, uses the content q after each cycle. Otherwise waves of
 * P with four or five mesh sizes, which decay slowly in a stiff film, would be
 * treated explicitly and grow: the extrapolated guess triples an alternating
 * error, D was up to 0.5 at a slide-to-roll ratio of 1.77, and the error of a
 * steady contact of 1.65 GPa grew by a factor of 2 to 5 per step, up to 2.4
 * GPa. With these passes the contact remains steady within 1e-4, and all of 500
 * random runs are completed (2 failed before). Smooth films, whose guess is
 * accurate, need one solve per step. Steps with load jumps need half as many
 * cycles as before, rough hot films a quarter more. (With up to six passes
 * rough films would need half as many again; with one, waves grow.)
 *
 * If the power of compression heating of the final film differs from that of
 * the guess by more than 2 % of the total power, the temperatures are solved
 * again with the final film. (Otherwise films with curvature jumps would be
 * heated by the pressure of the guess.)
 *
 * A step is flagged if gamma |T - T_used| remains above 1, that is, the heat
 * source is wrong by a factor of e (0.5 to 1 in some steps caused a friction
 * error of 0.6 %), or if the error of the energy balance exceeds a tenth of the
 * maximum power of the run and the load has not just jumped.
 *
 * Further attempts of a step start from the temperatures of the last completed
 * time. (With the viscosities of that time, 24,000 K were computed after a load
 * jump by a quarter; with those of the step, 550 K.) Heat fluxes, memories of
 * the surfaces and `used` are updated when a step is accepted.
 *
 * The temperature of a stationary surface rises as ln(T), up to the length of
 * its memory (surfaces.h).
 */
#ifndef OVR_PHYSICS_HEAT_IN_TIME_H
#define OVR_PHYSICS_HEAT_IN_TIME_H

#include "physics/heat/heated.h"
#include "physics/heat/surfaces.h"

/* The temperatures used, th, shift, drag, skewed, swell, skew, skew_by_P. */
enum { OVR_HEAT_KEPT = OVR_CROSS_FILM_MAX + 7 };

typedef struct ovr_heat_steps {
    double dT;
    bool trying; /* T and q of ovr_heated belong to a step that is not yet
                  * accepted */
    /* T and q one step ago, in this case */
    double *T_before[OVR_CROSS_FILM_MAX], *q_before[2];
    double *change[OVR_CROSS_FILM_MAX]; /* change of T in the last accepted step
                                         */
    double *kept[OVR_HEAT_KEPT];        /* values of the last completed time */
    ovr_heat_surface surface[2];
    double *F;           /* history term of Reynolds' equation */
    double *P_T;         /* P_T used in the temperature solve */
    double *heated_P;    /* P used in the last temperature solve */
    double lag;          /* maximum of gamma |T - T_used| */
    int passes;          /* further passes permitted in this attempt */
    double max_balanced; /* maximum of ovr_heated.balanced in this run */
    double stored;       /* power stored in the lubricant during the step */
} ovr_heat_steps;

/* Allocates the arrays, and sets the rates of the surfaces' memories. */
ovr_status ovr_heat_steps_take(ovr_simulation *sim, ovr_error *err);

/* The following are functions of a physical model (physics.h) with `own` the
 * ovr_heated. They make the steady solution, or the step just made, the last
 * completed time. */
void ovr_heat_begin(ovr_simulation *sim, void *own);
void ovr_heat_accepted(ovr_simulation *sim, void *own, double dT);

/* Called with the history term of a step dT in place; with the guess of an
 * attempt in place: computes temperatures and the film with them; after a
 * cycle: the same if the temperatures lag. */
void ovr_heat_step(ovr_simulation *sim, void *own, double dT);
void ovr_heat_try(ovr_simulation *sim, void *own, bool corrected);
void ovr_heat_update(ovr_simulation *sim, void *own);

/* True if the temperatures of the last observed step are inconsistent with its
 * film. */
bool ovr_heat_is_stale(ovr_simulation *sim, void *own);

/* Restores the last completed time. */
void ovr_heat_step_back(ovr_simulation *sim, void *own);

/* Visits the arrays and numbers of the state between two steps; computes
 * dependent values after they have been read. */
void ovr_heat_visit(ovr_simulation *sim, void *own, ovr_pieces *state);
void ovr_heat_restored(ovr_simulation *sim, void *own);

#endif
