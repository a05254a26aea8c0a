/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A tenth of the random runs of verify/rheology_test, a level coarser. */
#include "support/test.h"
#include "support/thinning.h"

static void random_runs_go_through(void **state)
{
    (void)state;
    test_thinning_survey(20261122, 20, 6);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_runs_go_through)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
