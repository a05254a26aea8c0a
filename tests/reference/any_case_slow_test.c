/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A tenth of the cases of verify/any_case_test. */
#include "../support/any_case.h"
#include "../support/test.h"

static void any_case_is_solved_or_fails_in_a_sentence(void **state)
{
    (void)state;
    test_any_case_survey(280000, 100);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(any_case_is_solved_or_fails_in_a_sentence)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
