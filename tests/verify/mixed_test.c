/* SPDX-License-Identifier: GPL-3.0-or-later */
/* 500 random runs with heat, flow laws and supply in the mix (support/mixed.h).
 */
#include <stdlib.h>

#include "support/mixed.h"
#include "support/test.h"

static void random_runs_go_through(void **state)
{
    const char *told = getenv("OVERROLL_RUNS");
    (void)state;
    test_mixed_survey(22000, told ? atoi(told) : 500, 6);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_runs_go_through)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
