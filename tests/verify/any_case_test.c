/* SPDX-License-Identifier: GPL-3.0-or-later */
/* 1,000 cases drawn from the table of keys; with SAN=1, instrumented. */
#include <stdlib.h>

#include "../support/any_case.h"
#include "../support/test.h"

static void any_case_is_solved_or_fails_in_a_sentence(void **state)
{
    const char *told = getenv("OVERROLL_RUNS");
    (void)state;
    test_any_case_survey(280000, told ? atoi(told) : 1000);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(any_case_is_solved_or_fails_in_a_sentence)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
