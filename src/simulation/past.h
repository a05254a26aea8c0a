/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The past of a run, and the guess of the next state by it (guess.c). */
#ifndef OVR_SIMULATION_PAST_H
#define OVR_SIMULATION_PAST_H

#include "simulation/simulation.h"
#include "simulation/solution.h"

#define OVR_FIELD_AGES(name, ...) double *name[OVR_PAST];

/* Formulas to extrapolate what moves with the features (guess.c). */
enum { OVR_GUESSES = 8 };

/* The past that the time derivative and the extrapolation need: fields of
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
    double dT;      /* length of the last step */
    int steps;      /* how many steps lie behind P[0], 3 at most */
    int still;      /* steps in a row that changed nothing */
    double dT_next; /* adaptive: the step asked for next */
    double change;  /* largest change of P, or of S, in the last step */
    bool backward;  /* um < 0, or had been when it stopped (mirror.h) */
    /* of P, of late, by each formula of guess.c; 0: not known */
    double guess_error[OVR_GUESSES];
} ovr_past;

/* P and H0 at T + dT before the step is solved: extrapolated, or those of the
 * last time.  Whether it is close: not just the trend, but what moves has
 * been moved on. */
bool ovr_guess(ovr_simulation *sim, double dT, bool extrapolated);

/* What each formula would have guessed for the step of dT that was solved just
 * now, before it becomes the past. */
void ovr_guess_update(ovr_simulation *sim, double dT);

/* The errors of steps like this one of h add this to the film on its way
 * through the contact, relative to H_cen; 0 when there is no past to judge
 * by. */
double ovr_step_error(ovr_simulation *sim, double h);

#endif
