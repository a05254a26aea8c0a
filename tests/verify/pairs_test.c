/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What goes with what: all pairs are refused as the table says, or accepted,
 * and all of those march. */
#include "support/pairs.h"
#include "support/test.h"

static void pairs_work_or_are_refused(void **state)
{
    test_walk_pairs(*state, 1);
}

static void elements_work_or_refuse(void **state)
{
    test_walk_elements(*state, 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(pairs_work_or_are_refused,
                                        test_make_folder, test_remove_folder),
        cmocka_unit_test_setup_teardown(elements_work_or_refuse,
                                        test_make_folder, test_remove_folder)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
