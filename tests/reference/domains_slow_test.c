/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A tenth of the histories of verify/domains_test. */
#include "../support/domains.h"
#include "../support/test.h"

TEST(chosen_domains_are_wide_enough)
{
    test_domains_survey(28000, 10, false);
    test_domains_survey(281000, 10, true);
}
