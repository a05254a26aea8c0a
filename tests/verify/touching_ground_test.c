/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * 100 random pairs of ground surfaces (support/ground.h) by Eyring's law, one
 * in five hot, that touch through a layer of 3 nm, at each of lambda 0.7 to 3
 * and 0.3 to 0.7, level 7.  Of the former none breaks off, of the latter five
 * at most.
 */
#include "support/ground.h"
#include "support/test.h"

static void thick_films_go_through(void **state)
{
    (void)state;
    test_ground_tally t = test_ground_survey(33100, 100, 0.7, 3, 7, 3);
    assert_int_equal(t.broken, 0);
    assert_true(t.cycles <= 4);
}

static void thin_films_go_through(void **state)
{
    (void)state;
    test_ground_tally t = test_ground_survey(33100, 100, 0.3, 0.7, 7, 3);
    assert_true(t.broken <= 5);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(thick_films_go_through),
                                       cmocka_unit_test(thin_films_go_through)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
