/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Asperity contact model: pressure against mean gap. */
#include <math.h>

#include "support/test.h"

#include "contact/flow_factor.h"
#include "contact/touch_law.h"

static ovr_arena arena;

static ovr_asperity_law greenwood_tripp(double sigma)
{
    ovr_error err = {0};
    ovr_asperity_law law = {0};
    arena = ovr_arena_make(NULL);
    /* 113 GPa in GPa: A is in GPa */
    CHECK_OK(ovr_asperity_greenwood_tripp(&law.table, sigma, 0.05, 0.01, 113,
                                          &arena, &err),
             &err);
    return law;
}

/* F_5/2 as Greenwood & Tripp's table has it, to its five decimals; 83 MPa at no
 * gap with n beta sigma 0.05, sigma/beta 0.01 and E* 113 GPa. */
TEST(summits_agree_with_their_table)
{
    static const double of[][2] = {
        {0, 0.61664}, {0.5, 0.24040}, {1, 0.08056}, {1.5, 0.02286},
        {2, 0.00542}, {2.5, 0.00106}, {3, 0.00017}};
    const double sigma = 0.02, pi = acos(-1.0);
    double scale = 16 * sqrt(2) * pi / 15 * 0.05 * 0.05 * 0.1 * 113, A, slope;
    ovr_asperity_law law = greenwood_tripp(sigma);
    for (size_t k = 0; k < sizeof of / sizeof *of; k++) {
        ovr_asperity_law_at(&law, sigma * of[k][0], &A, &slope);
        CHECK_NEAR(A / scale, of[k][1], 6e-6);
    }
    ovr_asperity_law_at(&law, 0, &A, &slope);
    CHECK_NEAR(A, 0.083, 5e-4);
    /* F_2(0) = 1/2 */
    CHECK_CLOSE(ovr_asperity_law_area(&law, 0), pi * pi * 0.0025 / 2, 1e-9);
    ovr_arena_release(&arena);
}

/* p_h at the film of the layer, whatever its decay. */
TEST(layer_carries_hertz_pressure)
{
    const double decays[] = {0.02, 0.1, 0.3, 1};
    for (size_t k = 0; k < sizeof decays / sizeof *decays; k++) {
        ovr_asperity_law law = {.layer = 0.3, .layer_decay = decays[k]};
        double A, slope;
        ovr_asperity_law_at(&law, 0.3, &A, &slope);
        CHECK_CLOSE(A, 1, 1e-12);
        CHECK_CLOSE(slope, 1 / decays[k] / -expm1(-0.3 / decays[k]), 1e-12);
    }
}

/* Between the points and beyond them, by differences. */
TEST(slopes_are_those_of_the_pressures)
{
    const double step = 1e-6;
    ovr_asperity_law law = greenwood_tripp(1);
    law.layer = 0.3;
    law.layer_decay = 0.1;
    for (double H = -3.51; H < 8; H += 0.037) {
        double one, other, slope, A;
        if (fabs(H - 1e-4) < 2 * step) /* the layer's tangent begins */
            continue;
        ovr_asperity_law_at(&law, H - step, &one, &slope);
        ovr_asperity_law_at(&law, H + step, &other, &slope);
        ovr_asperity_law_at(&law, H, &A, &slope);
        CHECK_CLOSE(slope, (one - other) / (2 * step), 1e-5);
        assert_true(A > 0 && slope > 0);
    }
    ovr_arena_release(&arena);
}

/* Points of exp(-H): the slopes are -1, and so it goes on everywhere, until
 * exp(-60), below which there is nothing; points of exp(-H^3/2) are met, and
 * nowhere does it rise. */
TEST(tables_go_through_their_points)
{
    ovr_asperity_law law = {0};
    ovr_error err = {0};
    double A, slope, last = INFINITY;
    arena = ovr_arena_make(NULL);
    CHECK_OK(ovr_asperity_table_take(&law.table, 5, &arena, &err), &err);
    for (size_t k = 0; k < 5; k++) {
        law.table.H[k] = 0.3 * (double)(k * k);
        law.table.ln_A[k] = -law.table.H[k];
    }
    ovr_asperity_table_slopes(&law.table);
    for (double H = -2; H < 9; H += 0.1) {
        ovr_asperity_law_at(&law, H, &A, &slope);
        CHECK_CLOSE(A, exp(-H), 1e-12);
    }
    ovr_asperity_law_at(&law, 59, &A, &slope);
    CHECK_CLOSE(A, exp(-59), 1e-12);
    ovr_asperity_law_at(&law, 61, &A, &slope);
    assert_true(A == 0 && slope == 0);
    for (size_t k = 0; k < 5; k++)
        law.table.ln_A[k] = -pow(law.table.H[k], 3) / 2;
    ovr_asperity_table_slopes(&law.table);
    for (size_t k = 0; k < 5; k++) {
        ovr_asperity_law_at(&law, law.table.H[k], &A, &slope);
        CHECK_CLOSE(A, exp(law.table.ln_A[k]), 1e-12);
    }
    for (double H = -1; H < 6; H += 0.01, last = A) {
        ovr_asperity_law_at(&law, H, &A, &slope);
        assert_true(A <= last && slope >= 0);
    }
    ovr_arena_release(&arena);
}

/* Patir and Cheng's at lambda 3, by hand; slopes by differences; films of thick
 * gaps are those of smooth surfaces. */
TEST(flow_factors_and_their_slopes)
{
    const double step = 1e-6;
    ovr_flow_factor f = {OVR_RIDGES_ISOTROPIC, 0.5};
    double slope, one, other;
    CHECK_NEAR(ovr_flow_factor_at(&f, 1.5, &slope), 0.8323, 5e-5);
    f.ridges = OVR_RIDGES_TRANSVERSE;
    CHECK_NEAR(ovr_flow_factor_at(&f, 1.5, &slope), 0.5802, 5e-5);
    f.ridges = OVR_RIDGES_LONGITUDINAL;
    CHECK_NEAR(ovr_flow_factor_at(&f, 1.5, &slope), 1.1674, 5e-5);
    for (int k = OVR_RIDGES_NONE; k <= OVR_RIDGES_LONGITUDINAL; k++) {
        f.ridges = (ovr_ridges)k;
        for (double h = 0.013; h < 4; h += 0.11) {
            one = ovr_flow_factor_at(&f, h + step, &slope);
            other = ovr_flow_factor_at(&f, h - step, &slope);
            assert_true(ovr_flow_factor_at(&f, h, &slope) > 0);
            CHECK_NEAR(slope, (one - other) / (2 * step), 1e-8);
        }
        CHECK_NEAR(ovr_flow_factor_film(&f, 100), 1, 1e-3);
    }
}
