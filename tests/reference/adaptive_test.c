/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Sample of verify/adaptive_test on a coarser grid. */
#include <stdio.h>

#include "../support/adaptive.h"
#include "../support/test.h"

TEST(dents)
{
    test_adaptive all = test_adaptive_cases(20261122, 3, 5, "upstream2");
    assert_true(all.worst < 10);
    all = test_adaptive_cases(20261122, 2, 5, "characteristic");
    assert_true(all.worst < 10);
}
