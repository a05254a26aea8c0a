/* SPDX-License-Identifier: GPL-3.0-or-later */
/* 100 steady contacts whose surfaces touch (support/touches.h). */
#include "support/test.h"
#include "support/touches.h"

static void surfaces_that_touch_have_a_film(void **state)
{
    (void)state;
    test_touches_survey(33000, 100);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(surfaces_that_touch_have_a_film)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
