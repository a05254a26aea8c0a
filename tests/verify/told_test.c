/* SPDX-License-Identifier: GPL-3.0-or-later */
/* 100 random cases of mixed physics at levels 5 and 6: at most 3 of them tell
 * less than half of their true error (support/told.h). */
#include "support/test.h"
#include "support/told.h"

TEST(errors_are_not_told_too_small)
{
    int low = test_told_survey(31000, 70, 5, 3, 3);
    low += test_told_survey(41000, 30, 6, 2, 3);
    assert_true(low <= 3);
}
