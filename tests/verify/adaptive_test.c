/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Adaptive steps are honest about dents: the error of H_cen over the run,
 * beside dT = D/8 on the same level, is below 10 times the asked for one; and
 * where they are no worse than dT = D they take no more cycles in all. */
#include <stdio.h>

#include "../support/adaptive.h"
#include "../support/test.h"

TEST(dents)
{
    test_adaptive all = test_adaptive_cases(1, 40, 6, "upstream2");
    assert_true(all.worst < 10);
    assert_true(all.cycles > 0 && all.cycles <= all.cycles_of_mesh);
}

/* The characteristic scheme errs less at dT = D than at any other step: what
 * rolls moves by whole nodes then. */
TEST(dents_by_characteristics)
{
    test_adaptive all = test_adaptive_cases(1, 40, 6, "characteristic");
    assert_true(all.worst < 10);
    assert_true(all.cycles <= 1.5 * all.cycles_of_mesh);
}
