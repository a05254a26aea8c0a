/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Some of the runs of verify/histories_test. */
#include "support/histories.h"
#include "support/test.h"

TEST(no_step_fails)
{
    test_histories all = test_histories_run(5, 10, false);
    assert_int_equal(all.refused, 0);
}
