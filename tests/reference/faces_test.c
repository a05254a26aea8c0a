/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Means between two nodes: errors of the gap and the arithmetic mean at second
 * order on levels 6 to 9, relative to the limit of the arithmetic mean on fine
 * levels, and of the logarithmic mean at fourth order. */
#include <math.h>
#include <stdio.h>

#include "support/contact.h"
#include "support/test.h"

typedef struct films {
    double H_cen, H_min;
    int cycles;
} films;

static films steady(double M, double L, int level, ovr_faces faces)
{
    ovr_error err = {0};
    ovr_options o = test_options();
    o.level = level;
    o.faces = faces;
    ovr_simulation *sim = test_simulation(M, L, &o);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    const ovr_observation *seen = ovr_simulation_observation(sim);
    assert_true(seen->converged);
    films f = {seen->H_cen, seen->H_min, seen->cycles};
    ovr_simulation_free(sim);
    return f;
}

/* The same with H_min by the parabola through three nodes. */
static films located(double M, double L, int level, const ovr_options *like)
{
    ovr_error err = {0};
    ovr_options o = *like;
    o.level = level;
    ovr_simulation *sim = test_simulation(M, L, &o);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    const ovr_observation *seen = ovr_simulation_observation(sim);
    assert_true(seen->converged);
    films f = {seen->H_cen, seen->H_min_located, seen->cycles};
    ovr_simulation_free(sim);
    return f;
}

/* Beyond levels l and l + 1, of errors that fall by four. */
static double beyond(double coarse, double fine)
{
    return fine + (fine - coarse) / 3;
}

/* Smooth contacts: H_cen four times as exact as by the arithmetic mean, in
 * fewer cycles.  What is allowed are the errors of a first program, whose limit
 * was level 11 of the arithmetic mean: known to 5e-7 M.  H_min is that of a
 * node. */
TEST(smooth_films_are_more_exact)
{
    static const struct {
        double M, L, H_cen[4], H_min[4];
    } of[] = {{20,
               10,
               {8.3e-4, 2.1e-4, 5.0e-5, 1.3e-5},
               {2.8e-3, 1.0e-3, 4.2e-4, 2e-4}},
              {100,
               10,
               {8.8e-3, 2.3e-3, 5.5e-4, 1.4e-4},
               {2e-2, 7.4e-3, 3.4e-3, 1.7e-3}},
              {200,
               14,
               {2.3e-2, 5.8e-3, 1.4e-3, 3.5e-4},
               {4.3e-2, 2.4e-2, 1.1e-2, 6e-3}}};
    for (size_t c = 0; c < sizeof of / sizeof *of; c++) {
        double M = of[c].M, L = of[c].L;
        films a[2];
        for (int k = 0; k < 2; k++)
            a[k] = steady(M, L, 11 + k, OVR_FACES_ARITHMETIC);
        double known = 5e-7 * M;
        double H_cen = beyond(a[0].H_cen, a[1].H_cen), H_min = a[1].H_min;
        for (int k = 0; k < 4; k++) {
            films by_gap = steady(M, L, 6 + k, OVR_FACES_GAP);
            films both = steady(M, L, 6 + k, OVR_FACES_ARITHMETIC);
            double e = by_gap.H_cen / H_cen - 1, m = by_gap.H_min / H_min - 1;
            double before = both.H_cen / H_cen - 1;
            print_message(
                "M %g L %g level %d: H_cen %+.1e (%+.1e), H_min %+.1e "
                "(%+.1e), cycles %d (%d)\n",
                M, L, 6 + k, e, before, m, both.H_min / H_min - 1,
                by_gap.cycles, both.cycles);
            assert_true(fabs(e) < 1.05 * of[c].H_cen[k] + known);
            assert_true(fabs(m) < 1.05 * of[c].H_min[k] + 2 * known);
            assert_true(fabs(e) < fabs(before) / 3);
            assert_true(by_gap.cycles < both.cycles);
        }
    }
}

/* The minimum film thickness by the logarithmic mean, with corrections of
 * fourth order, against the limit of the arithmetic mean's levels 11 and 12 at
 * second order: a tenth to a half of the errors by the gap, in about as many
 * cycles. */
TEST(minimum_films_by_the_logarithmic_mean)
{
    static const struct {
        double M, L, maximum[3]; /* at levels 6 to 8 */
    } of[] = {{20, 10, {2e-4, 1e-4, 4e-5}}, {100, 10, {4e-3, 6e-4, 6e-4}}};
    for (size_t c = 0; c < sizeof of / sizeof *of; c++) {
        ovr_options o = test_options();
        double limit[2], M = of[c].M, L = of[c].L;
        for (int k = 0; k < 2; k++)
            limit[k] = located(M, L, 11 + k, &o).H_min;
        double H_min = beyond(limit[0], limit[1]);
        o.order = 4;
        for (int k = 0; k < 3; k++) {
            o.faces = OVR_FACES_LOGARITHMIC;
            films now = located(M, L, 6 + k, &o);
            o.faces = OVR_FACES_GAP;
            films gap = located(M, L, 6 + k, &o);
            double e = now.H_min / H_min - 1, before = gap.H_min / H_min - 1;
            print_message("M %g L %g level %d: H_min %+.1e (%+.1e by the gap), "
                          "cycles %d (%d)\n",
                          M, L, 6 + k, e, before, now.cycles, gap.cycles);
            assert_true(fabs(e) < of[c].maximum[k]);
            assert_true(fabs(e) < fabs(before) / 2);
            assert_true(now.cycles <= gap.cycles + 5);
        }
    }
}

/* Minimum film thickness while a dent rolls in, up to X = -0.36. */
static double dent(int level, ovr_faces faces)
{
    ovr_error err = {0};
    test_feature rolls = {'l', -0.1, 0.5, -4.36, 1, 0};
    ovr_options o = test_options();
    double minimum = INFINITY;
    o.level = level;
    o.faces = faces;
    o.scheme = OVR_CHARACTERISTIC;
    ovr_simulation *sim = test_simulation(20, 10, &o);
    ovr_simulation_surface(sim, test_feature_heights, &rolls);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    for (double T = 0; T < 4;) {
        double D = ovr_simulation_state(sim)->D;
        CHECK_OK(ovr_simulation_step(sim, D, &err), &err);
        assert_false(ovr_simulation_observation(sim)->marked);
        minimum = fmin(minimum, ovr_simulation_observation(sim)->H_min);
        T += D;
    }
    ovr_simulation_free(sim);
    return minimum;
}

/* Ten times as exact at least; the limit is known to some 1e-5. */
TEST(rolling_dents_are_more_exact)
{
    const double maximum[] = {1e-4, 5e-5, 2e-5};
    double a[3];
    for (int k = 0; k < 3; k++)
        a[k] = dent(7 + k, OVR_FACES_ARITHMETIC);
    double limit = beyond(a[1], a[2]);
    for (int k = 0; k < 3; k++) {
        double f = dent(7 + k, OVR_FACES_GAP) / limit - 1;
        a[k] = a[k] / limit - 1;
        print_message("dent, level %d: %+.1e (%+.1e)\n", 7 + k, f, a[k]);
        assert_true(fabs(f) < maximum[k] && fabs(f) < fabs(a[k]) / 10);
    }
}
