/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Ground surfaces that touch under a law of what the mesh has not: a tenth of
 * the pairs of verify/touching_ground_test, a level below, and a share that
 * does not hang on the level, of two levels where that has three. */
#include "support/ground.h"
#include "support/test.h"

TEST(ground_pairs_go_through)
{
    test_ground_tally thick = test_ground_survey(33100, 10, 0.7, 3, 6, 3),
                      thin = test_ground_survey(33100, 5, 0.3, 0.7, 6, 3);
    assert_int_equal(thick.broken, 0);
    assert_int_equal(thin.broken, 0);
}

/* exp((60 nm - h)/20 nm) falls by e over more than a mesh changes the film. */
TEST(share_is_that_of_any_level)
{
    double coarse = test_ground_share(20.0855, 20, 7),
           fine = test_ground_share(20.0855, 20, 8);
    print_message("60/20 nm: %.5f %.5f on levels 7, 8\n", coarse, fine);
    assert_true(fine > 1e-3);
    CHECK_CLOSE(coarse, fine, 0.05);
}
