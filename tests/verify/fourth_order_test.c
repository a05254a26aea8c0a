/* SPDX-License-Identifier: GPL-3.0-or-later */
/* 2,300 random contacts at order = auto (support/orders.h). */
#include <stdlib.h>

#include "support/orders.h"
#include "support/test.h"

TEST(none_falls_back_by_accident)
{
    const char *told = getenv("OVERROLL_RUNS");
    int contacts = told ? atoi(told) : 1000;
    test_order_survey(1, contacts);
    test_order_survey(2, contacts);
    test_order_survey_eyring(3, 3 * contacts / 10);
}
