/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Every step that has a solution converges: 10 runs with jumps, oscillations
 * and ramps of load and speed, 500 in make verify. */
#include "support/histories.h"
#include "support/test.h"

TEST(no_step_fails)
{
    test_histories all = test_histories_run(20261122, test_draws(10, 500),
                                            true);
    assert_int_equal(all.missed, 0);
}
