/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random contacts with layers (tests/support/coated.h). */
#include "support/coated.h"
#include "support/test.h"

static void steady(void **state)
{
    (void)state;
    test_coated_steady(200);
}

static void dents(void **state)
{
    (void)state;
    test_coated_dents(60, 2);
    test_coated_dents(60, 4);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(steady),
                                       cmocka_unit_test(dents)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
