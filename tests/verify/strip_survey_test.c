/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random transient strips: rolling and sliding dents, waves, scratches and
 * roughness, M = 2 to 400, L = 2 to 20. */
#include "support/strip_cases.h"
#include "support/test.h"

TEST(random_films_are_solved)
{
    strip_survey found = {0};
    for (unsigned seed = 1; seed <= 40; seed++)
        strip_survey_add(&found, seed, 257);
    strip_survey_check(&found);
}
