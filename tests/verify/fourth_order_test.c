/* SPDX-License-Identifier: GPL-3.0-or-later */
/* 2,300 random contacts at order = auto (support/orders.h). */
#include <stdlib.h>

#include "support/orders.h"
#include "support/test.h"

static void none_falls_back_by_accident(void **state)
{
    const char *told = getenv("OVERROLL_RUNS");
    int contacts = told ? atoi(told) : 1000;
    (void)state;
    test_order_survey(1, contacts);
    test_order_survey(2, contacts);
    test_order_survey_eyring(3, 3 * contacts / 10);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(none_falls_back_by_accident)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
