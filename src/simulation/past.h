/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Stored previous time levels, and the extrapolated guess of the next state
 * (guess.c). */
#ifndef OVR_SIMULATION_PAST_H
#define OVR_SIMULATION_PAST_H

#include "simulation/simulation.h"
#include "simulation/solution.h"

#define OVR_FIELD_AGES(name, ...) double *name[OVR_PAST];

/* Number of formulas for extrapolating moving features (guess.c). */
enum { OVR_GUESSES = 8 };

/* Previous time levels for the time derivative and the extrapolation: fields of
 * multigrid/fields.h one, two, ... steps ago. */
typedef struct ovr_past {
    union {
        struct {
            OVR_LEVEL_FIELDS(OVR_FIELD_AGES)
        };
        double *all[OVR_FIELD_COUNT][OVR_PAST];
    };
    double H0[OVR_PAST];
    double T[OVR_PAST];
    double dT;       /* length of the last step */
    int steps;       /* number of steps before P[0], at most 3 */
    int still;       /* number of consecutive steps without change */
    double dT_next;  /* adaptive: length requested for the next step */
    double failures; /* failures of long steps, decreasing with time (step.c) */
    double change;   /* maximum change of P, or of S, in the last step */
    bool backward;   /* um < 0, or um = 0 after um < 0 (mirror.h) */
    /* recent error of P for each formula of guess.c; 0: unknown */
    double guess_error[OVR_GUESSES];
} ovr_past;

/* Sets P and H0 at T + dT before the step is solved: extrapolated, or those of
 * the last time. Returns true if the guess is close, because moving features
 * have been followed and not only the trend. */
bool ovr_guess(ovr_simulation *sim, double dT, bool extrapolated);

/* Updates the errors of all formulas from the step dT that has just been
 * solved, before it becomes the past. */
void ovr_guess_update(ovr_simulation *sim, double dT);

/* Estimated error of the film on its way through the contact due to steps of
 * length h, relative to H_cen; 0 without sufficient past. */
double ovr_step_error(ovr_simulation *sim, double h);

#endif
