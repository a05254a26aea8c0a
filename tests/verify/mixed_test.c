/* SPDX-License-Identifier: GPL-3.0-or-later */
/* 500 random runs with combinations of heat, rheological models and supply
 * (support/mixed.h). */
#include <stdlib.h>

#include "support/mixed.h"
#include "support/test.h"

TEST(random_runs_go_through)
{
    const char *told = getenv("OVERROLL_RUNS");
    test_mixed_survey(22000, told ? atoi(told) : 500, 6);
}
