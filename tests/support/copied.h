/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Copies the state of a simulation to another, as a checkpoint does. */
#ifndef TESTS_SUPPORT_COPIED_H
#define TESTS_SUPPORT_COPIED_H

#include "overroll/simulation.h"

/* Copies all data of the past that steps need to a simulation created with the
 * same options, or fails the test. */
void test_copy_state(ovr_simulation *from, ovr_simulation *to);

#endif
