/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Steady starts of 10 hot contacts with high sliding speed, 100 in make verify
 * (support/hot_starts.h). */
#include "support/hot_starts.h"
#include "support/test.h"

TEST(hot_contacts_that_slide_fast_have_a_start)
{
    test_hot_starts_survey(540000, test_draws(10, 100));
}
