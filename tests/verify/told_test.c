/* SPDX-License-Identifier: GPL-3.0-or-later */
/* 100 random cases of mixed physics at levels 5 and 6: at most 3 of them tell
 * less than half of their true error (support/told.h). */
#include "support/test.h"
#include "support/told.h"

static void errors_are_not_told_too_small(void **state)
{
    (void)state;
    int low = test_told_survey(31000, 70, 5, 3, 3);
    low += test_told_survey(41000, 30, 6, 2, 3);
    assert_true(low <= 3);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(errors_are_not_told_too_small)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
