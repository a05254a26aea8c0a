/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Cycles per step of sliding rough surfaces: at most three (3.6 for steps of 2
 * D), with one repeated step in 1,000; at most one in these short runs. */
#include "support/sliding.h"
#include "support/test.h"

static void costs(const test_rough_slide *one, double maximum)
{
    test_slides all = {0};
    test_slides_rough(&all, one);
    assert_true(all.mean <= maximum);
    assert_true(1000 * (all.retries - 1) <= all.steps);
}

TEST(both_ground)
{
    costs(
        &(test_rough_slide){
            {"ground", "ground"}, 1, 9, 1, "characteristic", 2.2},
        3);
    costs(&(test_rough_slide){{"ground", "ground"}, 1, 9, 1, "upstream2", 2.2},
          3);
}

TEST(scratches)
{
    costs(
        &(test_rough_slide){
            {"scratch", "scratch"}, 1, 9, 2, "characteristic", 2.2},
        3.6);
}

TEST(two_kinds)
{
    costs(
        &(test_rough_slide){
            {"ground", "honed"}, 2, 9, 2, "characteristic", 2.2},
        3.6);
}
