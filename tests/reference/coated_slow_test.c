/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random contacts with layers (tests/support/coated.h): a tenth of
 * tests/verify/coated_test.c.. */
#include "support/coated.h"
#include "support/test.h"

TEST(steady)
{
    test_coated_steady(30);
}

TEST(dents)
{
    test_coated_dents(4, 4);
}
