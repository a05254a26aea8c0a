/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Some of the runs of verify/histories_test. */
#include "support/histories.h"
#include "support/test.h"

TEST(no_step_fails)
{
    test_histories all = test_histories_run(5, 10, false);
    /* One run of M = 957, L = 8.8 on a mesh of 1.1 H^(2/3), which has no
     * accurate film by any mean, ends at T = 0.58 since rows have the exact
     * derivatives of the flow. */
    assert_true(all.refused <= 1);
}
