/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Some of the runs of verify/histories_test. */
#include "support/histories.h"
#include "support/test.h"

static void no_step_fails(void **state)
{
    test_histories all = test_histories_run(5, 10, false);
    (void)state;
    assert_int_equal(all.refused, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(no_step_fails)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
