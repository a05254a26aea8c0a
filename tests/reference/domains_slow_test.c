/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Domain chosen for the load, speed and radius of random histories. */
#include "../support/domains.h"
#include "../support/test.h"

TEST(chosen_domains_are_wide_enough)
{
    test_domains_survey(28000, test_draws(10, 100), false);
}

TEST(and_where_loads_jump)
{
    test_domains_survey(281000, test_draws(10, 100), true);
}
