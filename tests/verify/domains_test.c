/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The domain follows load, speed and radius: 100 random histories. */
#include <stdlib.h>

#include "../support/domains.h"
#include "../support/test.h"

static void chosen_domains_are_wide_enough(void **state)
{
    const char *told = getenv("OVERROLL_RUNS");
    (void)state;
    test_domains_survey(28000, told ? atoi(told) : 100, false);
}

static void and_where_loads_jump(void **state)
{
    const char *told = getenv("OVERROLL_RUNS");
    (void)state;
    test_domains_survey(281000, told ? atoi(told) : 100, true);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(chosen_domains_are_wide_enough),
        cmocka_unit_test(and_where_loads_jump)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
