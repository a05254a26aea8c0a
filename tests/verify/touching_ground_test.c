/* SPDX-License-Identifier: GPL-3.0-or-later */
/* 100 random pairs of ground surfaces (support/ground.h) with Eyring films, one
 * in five thermal, with a boundary layer of 3 nm, at lambda ratios of 0.7 to 3
 * and of 0.3 to 0.7, level 7. None of the former ends early, of the latter at
 * most five. Load share of one pair on three levels. */
#include "support/ground.h"
#include "support/test.h"

TEST(thick_films_go_through)
{
    test_ground_tally t = test_ground_survey(33100, 100, 0.7, 3, 7, 3);
    assert_int_equal(t.failed, 0);
    assert_true(t.cycles <= 4);
}

TEST(thin_films_are_solved)
{
    test_ground_tally t = test_ground_survey(33100, 100, 0.3, 0.7, 7, 3);
    assert_true(t.failed <= 5);
}

/* The asperity pressure exp((60 nm - h)/20 nm) changes by less than a factor e
 * from node to node. Results for 20 nm and 5 nm are printed for comparison. */
TEST(share_is_that_of_any_level)
{
    double share[3], thin[2];
    for (int k = 0; k < 3; k++)
        share[k] = test_ground_share(20.0855, 20, 7 + k);
    for (int k = 0; k < 2; k++)
        thin[k] = test_ground_share(54.6, 5, 7 + k);
    print_message("60/20 nm: %.5f %.5f %.5f on levels 7, 8, 9; 20/5 nm: %.3g "
                  "%.3g on levels 7, 8\n",
                  share[0], share[1], share[2], thin[0], thin[1]);
    assert_true(share[2] > 1e-3);
    CHECK_CLOSE(share[0], share[2], 0.05);
    CHECK_CLOSE(share[1], share[2], 0.05);
}
