/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Some of the runs of verify/reversal_test, shorter. */
#include "support/reversal.h"
#include "support/test.h"

static void no_step_fails(void **state)
{
    test_reversals all = test_reversals_run(7, 8, 3);
    (void)state;
    assert_true(all.turns > 10);
    assert_int_equal(all.failed, 0);
    assert_int_equal(all.marked, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(no_step_fails)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
