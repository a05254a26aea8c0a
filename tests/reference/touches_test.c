/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A tenth of the contacts of verify/touches_test. */
#include "../support/test.h"
#include "../support/touches.h"

TEST(surfaces_that_touch_have_a_film)
{
    test_touches_survey(33000, 10);
}
