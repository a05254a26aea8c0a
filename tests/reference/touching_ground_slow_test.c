/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Ground surfaces with asperity contact for roughness finer than the grid: a
 * twentieth of the pairs of verify/touching_ground_test, one level coarser. */
#include "support/ground.h"
#include "support/test.h"

TEST(ground_pairs_go_through)
{
    test_ground_tally thick = test_ground_survey(33100, 5, 0.7, 3, 6, 3),
                      thin = test_ground_survey(33100, 3, 0.3, 0.7, 6, 3);
    assert_int_equal(thick.failed, 0);
    assert_int_equal(thin.failed, 0);
}
