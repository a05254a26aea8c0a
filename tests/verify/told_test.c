/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Estimated errors of 100 random cases of mixed physics at levels 5 and 6
 * (support/told.h). In one run of five an estimate is by overroll(1)
 * below half of the true error, mostly of a pressure peak. A sample of n
 * may exceed n/5 by two standard deviations, 2 sqrt(n/5 4/5).
 * These limits are 10 of 30 and 20 of 70. */
#include "support/test.h"
#include "support/told.h"

TEST(errors_at_level_6_are_not_told_too_small)
{
    test_told_survey(41000, 30, 6, 2, 10);
}

TEST(nor_at_level_5)
{
    test_told_survey(31000, 70, 5, 3, 20);
}
