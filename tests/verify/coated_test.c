/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random contacts with layers (tests/support/coated.h). */
#include "support/coated.h"
#include "support/test.h"

TEST(steady)
{
    test_coated_steady(200);
}

TEST(dents)
{
    test_coated_dents(60, 2);
    test_coated_dents(60, 4);
}
