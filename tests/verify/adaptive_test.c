/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Accuracy of adaptive steps for dents: the error of H_cen over the run,
 * relative to dT = D/8 on the same level, is below 10 times the requested
 * error. At the error of dT = D adaptive steps need no more cycles. */
#include <stdio.h>

#include "../support/adaptive.h"
#include "../support/test.h"

TEST(dents)
{
    test_adaptive all = test_adaptive_cases(1, 40, 6, "upstream2");
    assert_true(all.worst < 10);
    assert_true(all.compared >= 20);
    assert_true(all.cycles > 0 && all.cycles <= all.cycles_of_mesh);
}

/* The characteristic scheme errs less at dT = D than at any other step, and by
 * fourth order all the more: what rolls moves by whole nodes then.  Other steps
 * do it within twice the cycles. */
TEST(dents_by_characteristics)
{
    test_adaptive all = test_adaptive_cases(1, 40, 6, "characteristic");
    assert_true(all.worst < 10);
    assert_true(all.compared >= 20);
    assert_true(all.cycles > 0 && all.cycles <= 2 * all.cycles_of_mesh);
}
