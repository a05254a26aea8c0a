/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Mass-conserving cavitation: random runs and steady starved contacts, none of
 * which may fail; the work is printed. */
#include <math.h>
#include <stdio.h>

#include "support/starved.h"
#include "support/test.h"

/* Asperity contact is not a failure of the solver. */
static void survey(int runs, int level, uint64_t seed, ovr_scheme scheme,
                   int order)
{
    long retries = 0;
    int plain = 0, retried = 0, halved = 0, touching = 0;
    double cycles = 0;
    for (int k = 0; k < runs; k++) {
        test_starved_run r = test_starved(seed + (uint64_t)k, level, scheme,
                                          order);
        cycles += r.cycles / runs;
        touching += r.status == OVR_IMPOSSIBLE;
        if (r.status && r.status != OVR_IMPOSSIBLE)
            printf("seed %d: M %g L %g: %s\n", (int)seed + k, r.M, r.L,
                   r.err.message);
        assert_true(!r.status || r.status == OVR_IMPOSSIBLE);
        assert_true(r.marked == 0);
        retries += r.retries;
        plain += r.retries == 0;
        retried += r.retries > 0 && r.substeps == 0;
        halved += r.substeps > 0;
    }
    printf(
        "level %d, %s, order %d, seeds %d on: %d runs, %d without retries, %d "
        "retried (%ld), %d with halved steps, %d touching; %.2f cycles a "
        "step\n",
        level, ovr_scheme_name(scheme), order, (int)seed, runs, plain, retried,
        retries, halved, touching, cycles);
}

TEST(random_runs)
{
    survey(200, 7, 1000, OVR_UPSTREAM2, 2);
    survey(200, 7, 1000, OVR_CHARACTERISTIC, 2);
    survey(200, 7, 1000, OVR_CHARACTERISTIC, 4);
}

TEST(random_runs_finer)
{
    survey(40, 8, 2000, OVR_UPSTREAM2, 2);
    survey(40, 8, 2000, OVR_CHARACTERISTIC, 4);
}

/* Each M and L at these shares of its flooded flow: all are solved. */
static void survey_steady(int level, size_t count, const double *share)
{
    static const double M[] = {5, 20, 50, 100, 200}, L[] = {2.5, 5, 10, 14};
    int ways[5] = {0}, failed = 0;
    for (size_t i = 0; i < 20 * count; i++) {
        ovr_error err = {0};
        double m = M[i / count / 4], l = L[i / count % 4], r = share[i % count];
        int way = 0;
        ovr_status status = test_starve(m, l, level, r, &way, &err);
        if (status)
            printf("M %g L %g share %g: %s\n", m, l, r, err.message);
        failed += status != OVR_OK;
        ways[way]++;
    }
    printf("level %d, %d steady contacts: %d by the first way, %d by the "
           "second, %d by the third\n",
           level, (int)(20 * count), ways[1], ways[2], ways[3]);
    assert_true(failed == 0);
}

TEST(steady_contacts)
{
    static const double share[] = {0.1, 0.3, 0.5, 0.7, 0.9, 0.99};
    survey_steady(8, 6, share);
}

/* Menisci far out. */
TEST(nearly_flooded)
{
    static const double share[] = {0.97, 0.995, 0.999};
    survey_steady(7, 3, share);
}
