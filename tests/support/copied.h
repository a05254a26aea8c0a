/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A simulation continued by another one, as from a checkpoint. */
#ifndef TESTS_SUPPORT_COPIED_H
#define TESTS_SUPPORT_COPIED_H

#include "overroll/simulation.h"

/* All that steps need from the past, into a simulation created alike; or the
 * test fails. */
void test_copy_state(ovr_simulation *from, ovr_simulation *to);

#endif
