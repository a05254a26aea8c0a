/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Pairs of ground surfaces of verify/ground_test.c, at lambda ratios of 0.3 to
 * 3, some thermal. With the arithmetic mean their films drain below zero; with
 * the gap mean these runs are complete. */
#include "support/ground.h"
#include "support/test.h"

static void goes_through(uint64_t seed, double from, double to)
{
    test_ground g = test_ground_run(seed, from, to, 7);
    print_message("seed %d, lambda %.2f: %d cycles, %d retries, H_min %.1e\n",
                  (int)seed, g.lambda, g.cycles, g.retries, g.H_min);
    CHECK_OK(g.status, &g.err);
    assert_true(g.H_min > 0);
}

TEST(ground_pairs_go_through)
{
    static const uint64_t thick[] = {31003, 31019, 31027, 31036};
    static const uint64_t thin[] = {32000, 32005, 32019, 32022};
    for (int k = 0; k < 4; k++) {
        goes_through(thick[k], 1, 3);
        goes_through(thin[k], 0.3, 1);
    }
}

/* A film by Eyring's law that cycles do not find, and Newton's method with
 * films of their own does. */
TEST(newton_converges)
{
    goes_through(32003, 0.3, 1);
}
