/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "spike.h"

#include <math.h>
#include <stdio.h>

#include "contact.h"
#include "simulation/internal.h"
#include "test.h"

ovr_observation test_spike(double M, double L, double inlet, int level, int to,
                           double change)
{
    ovr_error err = {0};
    ovr_options o = test_options();
    o.inlet = inlet;
    o.level = level;
    o.order = 4;
    o.refine = OVR_REFINE_SPIKE;
    o.refine_level = to;
    o.refine_change = change;
    ovr_simulation *sim = test_simulation(M, L, &o);
    ovr_status status = ovr_simulation_steady(sim, &err);
    ovr_observation seen = *ovr_simulation_observation(sim);
    if (status) {
        printf("M = %g, L = %g: %s\n", M, L, err.message);
        seen.P_spike = NAN;
        seen.converged = false;
    }
    ovr_simulation_free(sim);
    return seen;
}

/* Solves on a uniform grid with a pressure that is linear between nodes. */
static ovr_observation uniform(double M, double L, int level)
{
    ovr_error err = {0};
    ovr_options o = test_options();
    o.level = level;
    ovr_simulation *sim = test_simulation(M, L, &o);
    ovr_hierarchy *grids = &sim->grids;
    grids->influence.linear = true;
    for (int l = grids->coarsest; l <= grids->finest; l++)
        grids->level[l].mlmi.linear = true;
    ovr_hierarchy_fill(grids);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    ovr_observation seen = *ovr_simulation_observation(sim);
    ovr_simulation_free(sim);
    return seen;
}

void test_spike_and_uniform(int to)
{
    ovr_observation fine = uniform(20, 10, to);
    ovr_observation patches = test_spike(20, 10, -4, 8, to, 0);
    printf("level %d: P_spike %.7f and %.7f, H_min %.10f and %.10f\n", to,
           fine.P_spike, patches.P_spike, fine.H_min, patches.H_min);
    assert_true(patches.converged);
    assert_int_equal(patches.refined_level, to);
    CHECK_CLOSE(patches.P_spike, fine.P_spike, 1e-4);
    CHECK_NEAR(patches.X_spike, fine.X_spike, 2e-6);
    CHECK_CLOSE(patches.H_min, fine.H_min, 2e-6);
    CHECK_CLOSE(patches.H_cen, fine.H_cen, 5e-7);
    CHECK_CLOSE(patches.mass_flow, fine.mass_flow, 2e-5);
}

void test_spike_survey(uint64_t seed, int cases)
{
    uint64_t state = seed;
    int missed = 0;
    printf("seed %llu\n", (unsigned long long)seed);
    for (int k = 0; k < cases; k++) {
        double M = 5 * pow(200, test_random(&state, 0, 1));
        double L = test_random(&state, 1, 16);
        ovr_observation a = test_spike(M, L, -4, 8, 0, 1e-3);
        ovr_observation b = test_spike(M, L, -4, 9, 0, 1e-3);
        double H = fabs(a.H_min / b.H_min - 1);
        printf("M = %-7.5g L = %-7.5g P_spike %.5f %.5f to %d %d, H_min diff "
               "%.1e, cycles %d %d%s%s\n",
               M, L, a.P_spike, b.P_spike, a.refined_level, b.refined_level, H,
               a.cycles, b.cycles, a.converged ? "" : " failed on level 8",
               b.converged ? "" : " failed on level 9");
        missed += !(a.converged && b.converged && H < 2e-3);
    }
    assert_true(10 * missed <= cases);
}
