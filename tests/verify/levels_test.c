/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The errors reached by level = auto, on many cases. */
#include "../support/levels.h"
#include "../support/test.h"

TEST(steady)
{
    test_levels_steady(1, 100);
}

TEST(in_time)
{
    test_levels_in_time(2, 12);
}

TEST(usual)
{
    test_levels_usual(3, 60);
    test_levels_touching(5, 40);
}
