/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random cases from the table of keys: 25, in make verify 1,000; OVERROLL_SEED
 * and OVERROLL_RUNS select others. */
#include <stdlib.h>

#include "../support/any_case.h"
#include "../support/test.h"

TEST(any_case_is_solved_or_fails_in_a_sentence)
{
    const char *from = getenv("OVERROLL_SEED");
    test_any_case_survey(from ? strtoul(from, NULL, 10) : 280000,
                         test_draws(25, 1000));
}
