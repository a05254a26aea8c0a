/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A tenth of the cases of verify/any_case_test. */
#include "../support/any_case.h"
#include "../support/test.h"

TEST(any_case_is_solved_or_fails_in_a_sentence)
{
    test_any_case_survey(280000, 100);
}
