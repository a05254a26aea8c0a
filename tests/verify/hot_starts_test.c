/* SPDX-License-Identifier: GPL-3.0-or-later */
/* 100 hot contacts that slide fast (support/hot_starts.h). */
#include <stdlib.h>

#include "support/hot_starts.h"
#include "support/test.h"

TEST(hot_contacts_that_slide_fast_have_a_start)
{
    const char *told = getenv("OVERROLL_RUNS");
    test_hot_starts_survey(540000, told ? atoi(told) : 100);
}
