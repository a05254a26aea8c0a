/* SPDX-License-Identifier: GPL-3.0-or-later */
/* 200 loads that jump where cavitation is mass-conserving (support/jumps.h). */
#include <stdlib.h>

#include "support/jumps.h"
#include "support/test.h"

static void random_jumps_go_through(void **state)
{
    const char *told = getenv("OVERROLL_RUNS");
    (void)state;
    test_jumps_survey(30000, told ? atoi(told) : 200);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_jumps_go_through)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
