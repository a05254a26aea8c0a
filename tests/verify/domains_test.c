/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The domain follows load, speed and radius: 100 random histories. */
#include <stdlib.h>

#include "../support/domains.h"
#include "../support/test.h"

TEST(chosen_domains_are_wide_enough)
{
    const char *told = getenv("OVERROLL_RUNS");
    test_domains_survey(28000, told ? atoi(told) : 100, false);
}

TEST(and_where_loads_jump)
{
    const char *told = getenv("OVERROLL_RUNS");
    test_domains_survey(281000, told ? atoi(told) : 100, true);
}
