/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Corrections of fourth order (fourth.c). */
#ifndef OVR_SIMULATION_FOURTH_H
#define OVR_SIMULATION_FOURTH_H

#include "simulation/internal.h"

/* The steady film where cavitation is mass-conserving, corrected where that
 * applies; one without corrections again. */
ovr_defect ovr_fourth_conserved(ovr_simulation *sim, const ovr_full *how,
                                ovr_defect solved, int *cycles);
void ovr_fourth_leave(ovr_simulation *sim);

/* Computes the corrections again of a steady film that another physics has
 * changed; leaves them out where that did not converge, true if there were any.
 */
void ovr_fourth_renew(ovr_simulation *sim);
bool ovr_fourth_give_up(ovr_simulation *sim);

/* Adds them to the right-hand side and to the discrete gap at the nodes. */
void ovr_fourth_sides(const ovr_simulation *sim, double *F);
void ovr_fourth_gap(const ovr_simulation *sim, double *gap);

#endif
