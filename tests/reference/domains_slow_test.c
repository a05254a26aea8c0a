/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Domain chosen for the load, speed and radius of random histories;
 * OVERROLL_SEED and OVERROLL_RUNS select others. */
#include <stdlib.h>

#include "../support/domains.h"
#include "../support/test.h"

static uint64_t seed_of(uint64_t usual)
{
    const char *from = getenv("OVERROLL_SEED");
    return from ? strtoul(from, NULL, 10) : usual;
}

TEST(chosen_domains_are_wide_enough)
{
    test_domains_survey(seed_of(28000), test_draws(10, 100), false);
}

TEST(and_where_loads_jump)
{
    test_domains_survey(seed_of(281000), test_draws(10, 100), true);
}
