/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Errors that are to be expected of a mesh, before anything is solved. */
#ifndef OVR_CASE_ACCURACY_H
#define OVR_CASE_ACCURACY_H

#include "overroll/case.h"

/* Relative, of setup->accuracy_of: by the mesh alone; with the features on it,
 * which must have been made, and the step; `arriving` is the film that arrives
 * on the surfaces, infinite where they are flooded. */
double ovr_expected_of_mesh(const ovr_setup *setup);
double ovr_expected(const ovr_setup *setup, double arriving);

/* The error that nine of ten cases do not exceed. */
double ovr_expected_at_most(const ovr_setup *setup);

#endif
