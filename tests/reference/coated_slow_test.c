/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random contacts with layers (tests/support/coated.h). */
#include "support/coated.h"
#include "support/test.h"

TEST(steady)
{
    test_coated_steady(test_draws(30, 200));
}

TEST(dents)
{
    if (test_draws(0, 60) > 0)
        test_coated_dents(test_draws(0, 60), 2);
    test_coated_dents(test_draws(4, 60), 4);
}
