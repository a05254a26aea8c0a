/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Predicts discretization errors before the solution. */
#ifndef OVR_CASE_ACCURACY_H
#define OVR_CASE_ACCURACY_H

#include "overroll/case.h"

/* Expected relative discretization error of setup->accuracy_of. The first
 * function considers the grid only. The second also considers time step and
 * features, which must have been created. `arriving` is the supplied film
 * thickness, INFINITY for flooded surfaces. */
double ovr_expected_of_mesh(const ovr_setup *setup);
double ovr_expected(const ovr_setup *setup, double arriving);

/* Returns an error that nine of ten cases do not exceed. */
double ovr_expected_at_most(const ovr_setup *setup);

/* False if the expected error leaves out the friction: that of a Newtonian film
 * depends on the pressure spike, which grids do not resolve. */
bool ovr_expects_friction(const ovr_setup *s);

#endif
