/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Steady solutions against the exact solution of the same discrete equations
 * (M = 20, L = 10), and against grid-converged values. */
#include <math.h>

#include "contact/film_formula.h"
#include "simulation/simulation.h"
#include "support/contact.h"
#include "support/test.h"
#include "truth.h"

static void check_row(const truth_row *row, ovr_scheme scheme)
{
    ovr_error err;
    ovr_options o = test_options();
    o.level = row->level;
    o.scheme = scheme;
    ovr_simulation *sim = test_simulation(20, 10, &o);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    const ovr_observation *seen = ovr_simulation_observation(sim);
    double D = ovr_simulation_state(sim)->D;
    assert_true(seen->converged);
    CHECK_CLOSE(seen->H_min, row->H_m, 2e-5);
    CHECK_CLOSE(seen->H_cen, row->H_cen, 2e-5);
    CHECK_CLOSE(seen->H0, row->H0, 2e-5);
    CHECK_CLOSE(seen->P_spike, row->P_s, 1e-3);
    CHECK_NEAR(seen->X_spike, row->X_s, 0.01 * D);
    CHECK_NEAR(seen->X_min, row->X_m, 0.01 * D);
    ovr_simulation_free(sim);
}

TEST(upstream1_levels_6_to_14)
{
    for (size_t k = 0; k < sizeof truth_wedge_1 / sizeof *truth_wedge_1; k++)
        check_row(&truth_wedge_1[k], OVR_UPSTREAM1);
}

TEST(upstream2_levels_6_to_14)
{
    for (size_t k = 0; k < sizeof truth_wedge_2 / sizeof *truth_wedge_2; k++)
        check_row(&truth_wedge_2[k], OVR_UPSTREAM2);
}

/* Level 12 is within 1e-4 (centre) and 5e-4 (minimum) of the limit. */
TEST(other_loads_at_level_12)
{
    size_t rows = sizeof truth_steady_rows / sizeof *truth_steady_rows;
    for (size_t k = 0; k < rows; k++) {
        const truth_steady *row = &truth_steady_rows[k];
        ovr_error err;
        ovr_options o = test_options();
        o.level = 12;
        ovr_simulation *sim = test_simulation(row->M, row->L, &o);
        CHECK_OK(ovr_simulation_steady(sim, &err), &err);
        const ovr_observation *seen = ovr_simulation_observation(sim);
        CHECK_CLOSE(seen->H_cen, row->H_cen, 1e-4);
        CHECK_CLOSE(seen->H_min, row->H_m, 5e-4);
        CHECK_CLOSE(seen->mass_flow, row->flow, 1e-4);
        ovr_simulation_free(sim);
    }
}

/* Film of levels 6, 7, 8 against the limit: error ratios near 2 and 4. */
TEST(converges_at_the_schemes_order)
{
    const double limit = 0.08419667638;
    const ovr_scheme scheme[] = {OVR_UPSTREAM1, OVR_UPSTREAM2};
    const double ratio[] = {2, 4};
    for (int s = 0; s < 2; s++) {
        double error[3];
        for (int k = 0; k < 3; k++) {
            ovr_error err;
            ovr_options o = test_options();
            o.level = 7 + k;
            o.scheme = scheme[s];
            ovr_simulation *sim = test_simulation(20, 10, &o);
            CHECK_OK(ovr_simulation_steady(sim, &err), &err);
            error[k] = fabs(ovr_simulation_observation(sim)->H_cen - limit);
            ovr_simulation_free(sim);
        }
        CHECK_CLOSE(error[0] / error[1], ratio[s], 0.15);
        CHECK_CLOSE(error[1] / error[2], ratio[s], 0.15);
    }
}

/* stop = truncation leaves a tenth of the distance between the exact solution
 * of the level and the limit, with one cycle on each level on the way. */
TEST(truncation_is_below_the_discretization_error)
{
    const double limit = 0.08419667638;
    for (size_t k = 0; truth_wedge_2[k].level <= 8; k++) {
        ovr_error err;
        ovr_options o = test_options();
        const truth_row *row = &truth_wedge_2[k];
        o.level = row->level;
        o.stop = OVR_STOP_TRUNCATION;
        ovr_simulation *sim = test_simulation(20, 10, &o);
        CHECK_OK(ovr_simulation_steady(sim, &err), &err);
        const ovr_observation *seen = ovr_simulation_observation(sim);
        int on_the_way = o.level - ovr_simulation_options(sim)->coarsest_level;
        CHECK_NEAR(seen->H_cen, row->H_cen, 0.1 * fabs(row->H_cen - limit));
        assert_true(seen->cycles <= on_the_way + 1);
        ovr_simulation_free(sim);
    }
}

/* rho H - eps dP/dX is the same at every half node of a steady film. */
TEST(mass_flow_is_constant)
{
    ovr_error err;
    ovr_options o = test_options();
    static double flow[1793];
    ovr_simulation *sim = test_simulation(20, 10, &o);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    const ovr_state *now = ovr_simulation_state(sim);
    ovr_observable_field("mass_flow")->field(sim, flow);
    for (size_t i = 1; now->P[i] > 0 && now->P[i + 1] > 0; i++)
        CHECK_CLOSE(flow[i], ovr_simulation_observation(sim)->mass_flow, 1e-7);
    ovr_simulation_free(sim);
}

/* A high load has nearly the Hertzian pressure; the film in the contact is a
 * thousandth of the deformation. */
TEST(high_load_is_hertzian)
{
    ovr_error err;
    ovr_options o = test_options();
    o.level = 10;
    ovr_simulation *sim = test_simulation(500, 8, &o);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    const ovr_state *now = ovr_simulation_state(sim);
    for (size_t i = 0; i < now->n; i++)
        if (fabs(now->X[i]) < 0.9)
            CHECK_NEAR(now->P[i], sqrt(1 - now->X[i] * now->X[i]), 0.01);
    CHECK_CLOSE(ovr_simulation_observation(sim)->load, acos(0), 1e-6);
    ovr_simulation_free(sim);
}

/* Central film thickness within the error of the formula (equations.md: mass
 * flow rate within 3 %). */
TEST(film_follows_moes)
{
    size_t rows = sizeof truth_steady_rows / sizeof *truth_steady_rows;
    for (size_t k = 0; k < rows; k++)
        CHECK_CLOSE(ovr_film_central_moes(truth_steady_rows[k].M,
                                          truth_steady_rows[k].L),
                    truth_steady_rows[k].flow, 0.03);
}
