/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Means over a run: film thickness in |X| < 3/4 by the arrays of each step,
 * friction and power by observed values, each weighted by the preceding step.
 */
#include <math.h>

#include "overroll/simulation.h"
#include "support/hot.h"
#include "support/test.h"

static double film(const ovr_simulation *sim)
{
    const ovr_state *s = ovr_simulation_state(sim);
    double sum = 0, width = 0;
    for (size_t i = 0; i < s->n; i++)
        if (fabs(s->X[i]) < 0.75) {
            sum += s->H[i];
            width++;
        }
    return sum / width;
}

static void dent(void *data, double T, size_t n, const double *X, double *S)
{
    (void)data;
    for (size_t i = 0; i < n; i++)
        S[i] = -0.1 * exp(-pow((X[i] + 1 - T) / 0.3, 2));
}

TEST(means_by_hand)
{
    static const double steps[] = {0.02, 0.05, 0.03, 0.04};
    test_hot hot = test_hot_make(20, 10, 0.4, 5e6, NULL);
    ovr_simulation *sim = test_hot_simulation(&hot, 5);
    const ovr_statistics *s = ovr_simulation_statistics(sim);
    const ovr_observation *o = ovr_simulation_observation(sim);
    double H = 0, mu = 0, power = 0, rise = 0, T = 0;
    ovr_error err = {0};
    ovr_simulation_surface(sim, dent, NULL);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    CHECK_CLOSE(s->mean.H_mean, film(sim), 1e-12);
    assert_true(s->mean.mu_slide == o->mu_slide);
    for (size_t k = 0; k < sizeof steps / sizeof *steps; k++) {
        CHECK_OK(ovr_simulation_step(sim, steps[k], &err), &err);
        H += steps[k] * film(sim);
        mu += steps[k] * o->mu_slide;
        power += steps[k] * o->power_in;
        rise += steps[k] * o->T_1_max_rise;
        T += steps[k];
        CHECK_CLOSE(s->mean.H_mean, H / T, 1e-12);
        CHECK_CLOSE(s->mean.mu_slide, mu / T, 1e-12);
        CHECK_CLOSE(s->mean.power_in, power / T, 1e-12);
        CHECK_CLOSE(s->mean.T_1_max_rise, rise / T, 1e-12);
    }
    ovr_simulation_free(sim);
}
