/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Every step converges while the entrainment speed passes through zero: 80
 * random runs, and runs longer than those of the quick test compared with the
 * dense Newton solution. */
#include <math.h>
#include <stdlib.h>

#include "support/reversal.h"
#include "support/test.h"

TEST(no_step_fails)
{
    const char *told = getenv("OVERROLL_RUNS");
    test_reversals all = test_reversals_run(
        20261122, told ? strtol(told, NULL, 10) : 80, 20);
    assert_int_equal(all.failed, 0);
    assert_int_equal(all.marked, 0);
}

/* (M, L), features and levels of an independent solution's own check. */
TEST(agrees_with_dense_newton)
{
    const test_reversal cases[] = {
        {.M = 20, .L = 10, .level = 5},
        {.M = 20, .L = 10, .level = 6},
        {.M = 50, .L = 5, .level = 5},
        {.M = 5, .L = 2.5, .level = 5},
        {.M = 20, .L = 10, .level = 6, .feature = {'l', -0.05, 0.5, -1, 1, 0}},
        {.M = 20, .L = 10, .level = 5, .feature = {'l', 0.02, 0.5, -1, 1, 0}}};
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        test_reversal r = cases[k];
        r.scheme = OVR_UPSTREAM2;
        r.swing = 1;
        r.period = 2;
        r.end = 2;
        r.tolerance = 1e-10;
        test_apart apart = test_reversal_against_dense(&r);
        print_message("    M %g L %g level %d, %d turns: P within %.1e, H_cen "
                      "%.1e\n",
                      r.M, r.L, r.level, apart.reversals, apart.P, apart.H);
        assert_true(apart.reversals >= 2);
        assert_true(apart.P < 1e-6 && apart.H < 1e-6);
    }
}
