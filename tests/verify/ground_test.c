/* SPDX-License-Identifier: GPL-3.0-or-later */
/* 100 random pairs of ground surfaces (support/ground.h) at lambda ratios of 1
 * to 3 and of 0.3 to 1. Half of them are Newtonian, half Eyring films, of which
 * one in five is thermal; levels 7 and 8. With the arithmetic mean 12 and 56 of
 * 100 end early on level 7. With the gap mean one thermal film of the first and
 * 12 of the second group end early: cycles do not converge if ridges seal a
 * film.
 *
 * Of the first group, 31059 and 31077 end early on level 7, the former also on
 * level 8. Ridges of 0.5 um leave the contact with films of 2 nm, 7e-4 b^2/R.
 * Both runs are complete on level 9; on level 7 a node cannot distinguish this
 * film thickness from zero. */
#include "support/ground.h"
#include "support/test.h"

static int broken(uint64_t seed, double from, double to, int level)
{
    int ended = 0;
    for (uint64_t k = seed; k < seed + 100; k++) {
        test_ground g = test_ground_run(k, from, to, level);
        ended += g.status != OVR_OK;
        print_message(
            "# seed %d level %d lambda %.2f tau0 %.1f MPa%s ph %.2f SRR %+.2f "
            "Rq %.2f %.2f slopes %.3f %.3f: to T %.2f, %d steps, %d cycles, "
            "%d retries, H_min %.1e, P %.1f%s%s\n",
            (int)k, level, g.lambda, g.stress, g.hot ? ", hot" : "", g.ph,
            g.slide, g.Rq[0], g.Rq[1], g.slope[0], g.slope[1], g.T, g.steps,
            g.cycles, g.retries, g.H_min, g.P_max, g.status ? "\n#    " : "",
            g.status ? g.err.message : "");
    }
    print_message("# lambda %g to %g, level %d: %d of 100 end\n", from, to,
                  level, ended);
    return ended;
}

static void goes_through(uint64_t seed, double from, double to,
                         const int maximum[2])
{
    int coarse = broken(seed, from, to, 7), fine = broken(seed, from, to, 8);
    assert_true(coarse <= maximum[0]);
    assert_true(fine <= maximum[1]);
}

TEST(thick_films_go_through)
{
    static const int maximum[] = {2, 1};
    goes_through(31000, 1, 3, maximum);
}

TEST(thin_films_are_solved)
{
    static const int maximum[] = {15, 15};
    goes_through(32000, 0.3, 1, maximum);
}
