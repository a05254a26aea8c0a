/* SPDX-License-Identifier: GPL-3.0-or-later */
/* 200 loads that jump where cavitation is mass-conserving (support/jumps.h). */
#include <stdlib.h>

#include "support/jumps.h"
#include "support/test.h"

TEST(random_jumps_go_through)
{
    const char *told = getenv("OVERROLL_RUNS");
    test_jumps_survey(30000, told ? atoi(told) : 200);
}
