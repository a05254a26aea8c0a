/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Fourth-order corrections (fourth.c). */
#ifndef OVR_SIMULATION_FOURTH_H
#define OVR_SIMULATION_FOURTH_H

#include "simulation/internal.h"

/* Corrects the steady film with mass-conserving cavitation, if corrections
 * apply; if they do not converge, returns the film without corrections. */
ovr_defect ovr_fourth_conserved(ovr_simulation *sim, const ovr_full *how,
                                ovr_defect solved, int *cycles);
void ovr_fourth_leave(ovr_simulation *sim);

/* Recomputes the corrections of a steady film that another physical model has
 * changed. give_up: removes corrections that did not converge; returns true if
 * there were any. */
void ovr_fourth_renew(ovr_simulation *sim);
bool ovr_fourth_give_up(ovr_simulation *sim);

/* True if the corrections of a run are recomputed after each step. */
bool ovr_fourth_follows(const ovr_simulation *sim);

/* Adds the corrections to the right-hand side, and to the discrete gap at the
 * nodes. */
void ovr_fourth_sides(const ovr_simulation *sim, double *F);
void ovr_fourth_gap(const ovr_simulation *sim, double *gap);

#endif
