/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Steady starts with ground surfaces under the whole film, a sample of
 * verify/rough_start_test.c, also with rheological models and heat. */
#include "support/ground.h"
#include "support/test.h"

static void start(uint64_t seed, int level)
{
    test_ground g = test_ground_start(seed, 1, 5, level);
    print_message("seed %d level %d lambda %.2f tau0 %.1f MPa%s: H_min %.1e\n",
                  (int)seed, level, g.lambda, g.stress, g.hot ? ", hot" : "",
                  g.H_min);
    CHECK_OK(g.status, &g.err);
    assert_true(g.H_min > 0);
}

TEST(rough_starts_are_found)
{
    for (uint64_t seed = 33050; seed < 33060; seed++)
        start(seed, 8);
    start(33001, 8); /* a film that no cycles find, by Newton's method */
    start(33069, 8); /* with heat, of second order: not found with order 4 */
    start(33060, 9);
    start(33065, 9);
}
