/* SPDX-License-Identifier: GPL-3.0-or-later */
/* 1,000 cases drawn from the table of keys; with SAN=1, instrumented; with
 * OVERROLL_SEED and OVERROLL_RUNS others, or a part of them. */
#include <stdlib.h>

#include "../support/any_case.h"
#include "../support/test.h"

TEST(any_case_is_solved_or_fails_in_a_sentence)
{
    const char *told = getenv("OVERROLL_RUNS");
    const char *from = getenv("OVERROLL_SEED");
    test_any_case_survey(from ? strtoul(from, NULL, 10) : 280000,
                         told ? atoi(told) : 1000);
}
