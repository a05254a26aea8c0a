/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Combinations of model features: all pairs are rejected as listed in the
 * table, or accepted, and all accepted ones run. */
#include "support/pairs.h"
#include "support/test.h"

TEST_IN_FOLDER(pairs_work_or_are_refused)
{
    test_walk_pairs(*state, 1);
}

TEST_IN_FOLDER(elements_work_or_refuse)
{
    test_walk_elements(*state, 1);
}
