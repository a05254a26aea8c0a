/* SPDX-License-Identifier: GPL-3.0-or-later */
/* 500 smooth contacts under constant conditions (support/stays.h). */
#include <stdlib.h>

#include "support/stays.h"
#include "support/test.h"

TEST(steady_contacts_stay)
{
    const char *told = getenv("OVERROLL_RUNS");
    test_stays_survey(370000, told ? atoi(told) : 500);
}
