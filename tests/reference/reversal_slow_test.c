/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Sample of verify/reversal_test with shorter runs. */
#include "support/reversal.h"
#include "support/test.h"

TEST(no_step_fails)
{
    test_reversals all = test_reversals_run(7, 8, 3);
    assert_true(all.reversals > 10);
    assert_int_equal(all.failed, 0);
    assert_int_equal(all.marked, 0);
}
