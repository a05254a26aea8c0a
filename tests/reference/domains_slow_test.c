/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A tenth of the histories of verify/domains_test. */
#include "../support/domains.h"
#include "../support/test.h"

static void chosen_domains_are_wide_enough(void **state)
{
    (void)state;
    test_domains_survey(28000, 10, false);
    test_domains_survey(281000, 10, true);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(chosen_domains_are_wide_enough)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
