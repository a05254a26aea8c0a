/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random cases over wide ranges, half of them strips: 40, in make verify 2,000;
 * OVERROLL_SEED and OVERROLL_RUNS select others. */
#include <stdlib.h>

#include "../support/any_case.h"
#include "../support/test.h"

TEST(wide_case_is_solved_or_fails_in_a_sentence)
{
    const char *from = getenv("OVERROLL_SEED");
    test_wide_case_survey(from ? strtoul(from, NULL, 10) : 640000,
                          test_draws(40, 2000));
}
