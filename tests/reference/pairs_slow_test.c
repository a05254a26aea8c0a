/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What goes with what: all pairs are refused as the table says, or accepted; a
 * tenth of those marches (all of them: tests/verify/pairs_test.c). */
#include "support/pairs.h"
#include "support/test.h"

TEST_IN_FOLDER(pairs_work_or_are_refused)
{
    test_walk_pairs(*state, 10);
}

TEST_IN_FOLDER(elements_work_or_refuse)
{
    test_walk_elements(*state, 10);
}
