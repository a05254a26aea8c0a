/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * 100 random pairs of ground surfaces (support/ground.h): at lambda 1 to 3 none
 * ends its run before its end, at 0.3 to 1 at most 5 of 100; half of them
 * Newtonian, half by Eyring's law, of these one in five hot; levels 7 and 8.
 */
#include <math.h>
#include <stdlib.h>

#include "support/ground.h"
#include "support/test.h"

static int broken(uint64_t seed, int count, double from, double to, int level)
{
    int ended = 0;
    for (int k = 0; k < count; k++) {
        uint64_t state = seed + (uint64_t)k;
        double lambda = from * pow(to / from, test_random(&state, 0, 1));
        bool eyring = k % 2, hot = k % 10 == 9;
        test_ground g = test_ground_run(seed + (uint64_t)k, lambda, eyring, hot,
                                        level);
        ended += g.status != OVR_OK;
        print_message(
            "# seed %d level %d lambda %.2f %s%s: ph %.2f SRR %+.2f "
            "Rq %.2f %.2f slopes %.3f %.3f (%.0f, %.0f um): to T %.2f, "
            "%d steps, %d cycles, %d retries, H_min %.1e, P %.1f%s%s\n",
            (int)seed + k, level, lambda, eyring ? "Eyring" : "Newton",
            hot ? ", hot" : "", g.ph, g.slide, g.Rq[0], g.Rq[1], g.slope[0],
            g.slope[1], g.longest[0], g.longest[1], g.T, g.steps, g.cycles,
            g.retries, g.H_min, g.P_max, g.status ? "\n#    " : "",
            g.status ? g.err.message : "");
    }
    print_message("# seeds %d on, lambda %g to %g, level %d: %d of %d end\n",
                  (int)seed, from, to, level, ended, count);
    return ended;
}

static void thick_films_go_through(void **state)
{
    const char *count = getenv("GROUND");
    int n = count ? atoi(count) : 100;
    (void)state;
    for (int level = 7; level <= 8; level++)
        assert_int_equal(broken(31000, n, 1, 3, level), 0);
}

static void thin_films_go_through(void **state)
{
    const char *count = getenv("GROUND");
    int n = count ? atoi(count) : 100;
    (void)state;
    for (int level = 7; level <= 8; level++)
        assert_true(20 * broken(32000, n, 0.3, 1, level) <= n);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(thick_films_go_through),
                                       cmocka_unit_test(thin_films_go_through)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
