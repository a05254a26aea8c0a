/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Smooth contacts under constant conditions (support/stays.h). */
#include "support/stays.h"
#include "support/test.h"

TEST(steady_contacts_stay)
{
    test_stays_survey(370000, test_draws(20, 500));
}
