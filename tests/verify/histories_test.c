/* SPDX-License-Identifier: GPL-3.0-or-later */
/* No step fails that has a solution: 500 runs whose loads and speeds jump,
 * swing and ramp. */
#include <stdlib.h>

#include "support/histories.h"
#include "support/test.h"

TEST(no_step_fails)
{
    const char *told = getenv("OVERROLL_RUNS");
    test_histories all = test_histories_run(
        20261122, told ? strtol(told, NULL, 10) : 500, true);
    assert_int_equal(all.missed, 0);
}
