/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Cycles per step and repeated steps of rough surfaces and of sliding dents, at
 * levels 7 to 9 and a fifth of them at level 10, with both schemes of second
 * order. */
#include <stdio.h>

#include "../support/sliding.h"
#include "../support/test.h"

/* Steps of a mesh on levels 9 and 10 take 2.0 cycles on the mean, and one in
 * 1,000 a retry at most.  Others and coarser levels, where the narrowest dents
 * are 3 to 6 nodes wide, are counted and printed alone: means of 2.0 to 2.6 at
 * 2 D, 2.7 to 5.2 at 4 D, 3.4 to 7.0 at 8 D; but 24 there by upstream2 at level
 * 10, two steps of three with a retry. */
static void grid(const char *scheme)
{
    static const double meshes[] = {1, 2, 4, 8};
    for (int level = 7; level <= 10; level++)
        for (int k = 0; k < 4; k++) {
            test_slides all = test_slides_grid(scheme, level, meshes[k],
                                               level < 10 ? 1 : 5);
            if (level < 9 || k > 0)
                continue;
            assert_true(all.mean <= 2);
            assert_true(1000 * all.retries <= all.steps);
        }
}

/* Rough surfaces: a mean of 3 cycles a step, 3.6 for steps of 2 D and 4.5 on
 * level 11, over profiles, one surface and both, slips and both schemes; a
 * retry in 1,000 steps.  All pairs on levels 8 and 9, a third on level 10, a
 * tenth on 11. */
TEST(rough)
{
    static const char *const on[][2] = {
        {"ground"},           {"honed"},          {"scratch"},
        {"ground", "ground"}, {"honed", "honed"}, {"scratch", "scratch"},
        {"ground", "honed"}};
    static const double slips[] = {0.3, 1, 2};
    static const char *const schemes[] = {"upstream2", "characteristic"};
    static const int every[] = {1, 1, 3, 10};
    for (int level = 8; level <= 11; level++)
        for (int meshes = 1; meshes <= 2; meshes++) {
            test_slides all = {0};
            for (int k = 0; k < 42; k++)
                if (k % every[level - 8] == 0)
                    test_slides_rough(
                        &all, &(test_rough_slide){{on[k % 7][0], on[k % 7][1]},
                                                  slips[k / 7 % 3],
                                                  level,
                                                  meshes,
                                                  schemes[k / 21],
                                                  2.6});
            printf("# rough, level %d, dT = %d D: %.2f cycles a step, at most "
                   "%.2f; %ld retries in %ld steps\n",
                   level, meshes, all.mean, all.largest, all.retries,
                   all.steps);
            fflush(stdout);
            assert_true(all.mean <= (level == 11 ? 4.5 : meshes > 1 ? 3.6 : 3));
            assert_true(1000 * all.retries <= all.steps);
        }
}

TEST(upstream2)
{
    grid("upstream2");
}

TEST(characteristic)
{
    grid("characteristic");
}
