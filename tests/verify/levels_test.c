/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The errors reached by level = auto, on many cases. */
#include "../support/levels.h"
#include "../support/test.h"

static void steady(void **state)
{
    (void)state;
    test_levels_steady(1, 100);
}

static void in_time(void **state)
{
    (void)state;
    test_levels_in_time(2, 12);
}

static void usual(void **state)
{
    (void)state;
    test_levels_usual(3, 60);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(steady),
        cmocka_unit_test(in_time),
        cmocka_unit_test(usual),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
