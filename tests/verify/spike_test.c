/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Patches around the pressure spike: comparison with uniform grids, heights at
 * high loads, and a survey. */
#include <math.h>
#include <stdio.h>

#include "support/spike.h"
#include "support/test.h"

TEST(as_on_uniform_grids)
{
    test_spike_and_uniform(14);
    test_spike_and_uniform(16);
}

/* Heights over two or three grids of the whole domain, and their scatter. */
TEST(heights_at_high_loads)
{
    const struct {
        double M, L, inlet;
        int first, last, to;
        double scatter;
    } at[] = {{100, 10, -4, 9, 10, 20, 1e-3},
              {200, 14, -4, 9, 10, 22, 2e-3},
              {1000, 10, -2, 9, 11, 21, 1e-2}};
    for (size_t k = 0; k < sizeof at / sizeof *at; k++) {
        double low = INFINITY, high = -INFINITY;
        for (int level = at[k].first; level <= at[k].last; level++)
            for (int to = at[k].to - 1; to <= at[k].to; to++) {
                ovr_observation o = test_spike(at[k].M, at[k].L, at[k].inlet,
                                               level, to, 0);
                printf("M = %g, L = %g: over level %d to %d: P_spike %.6f, "
                       "H_min %.9f, H_cen %.9f, last change %.1e\n",
                       at[k].M, at[k].L, level, to, o.P_spike, o.H_min, o.H_cen,
                       o.spike_change);
                assert_true(o.converged);
                low = fmin(low, o.P_spike);
                high = fmax(high, o.P_spike);
            }
        printf("  scatter %.1e\n", high / low - 1);
        assert_true(high / low - 1 < at[k].scatter);
    }
}

TEST(survey)
{
    test_spike_survey(169, 80);
}
