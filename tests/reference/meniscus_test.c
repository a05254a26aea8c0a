/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Properties of starved contacts: the meniscus position converges with second
 * order to that of Ertel and Grubin's inlet, the film thickness is the supplied
 * share of the flooded one, and waves of the supply are transported without
 * change. */
#include <math.h>

#include "physics/supply/supply.h"
#include "simulation/simulation.h"
#include "support/contact.h"
#include "support/test.h"

typedef struct starved {
    double meniscus, H_cen, flooded, flow; /* of the flooded contact */
} starved;

static double constant(void *data, double T)
{
    (void)T;
    return *(double *)data;
}

static ovr_simulation *make(double M, double L, int level)
{
    ovr_options o = test_options();
    o.level = level;
    o.cavitation = OVR_CAVITATION_CONSERVING;
    return test_simulation(M, L, &o);
}

static double flow_of(double M, double L, int level, double *film)
{
    ovr_error err = {0};
    ovr_simulation *sim = make(M, L, level);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    double flow = ovr_simulation_observation(sim)->outflow;
    *film = ovr_simulation_observation(sim)->H_cen;
    ovr_simulation_free(sim);
    return flow;
}

static starved starve(double M, double L, int level, double q)
{
    ovr_error err = {0};
    starved s;
    s.flow = flow_of(M, L, level, &s.flooded);
    ovr_simulation *sim = make(M, L, level);
    ovr_simulation_supply(sim, constant, &q, 0);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    s.meniscus = ovr_simulation_observation(sim)->meniscus;
    s.H_cen = ovr_simulation_observation(sim)->H_cen;
    ovr_simulation_free(sim);
    return s;
}

/* Where the mesh is halved the meniscus moves by a quarter of what it did. */
TEST(second_order)
{
    double X[4];
    for (int l = 0; l < 4; l++)
        X[l] = starve(20, 10, 5 + l, 0.0504192).meniscus;
    for (int l = 0; l < 2; l++)
        CHECK_NEAR((X[l] - X[l + 1]) / (X[l + 1] - X[l + 2]), 4, 0.7);
}

/* An infinitely long contact passes all that arrives: within 1e-3, by the
 * density at a pressure that hardly changes. */
TEST(film_equals_the_supply)
{
    for (int k = 1; k < 10; k += 2) {
        double film, share = 0.1 * k, flow = flow_of(20, 10, 7, &film);
        starved s = starve(20, 10, 7, share * flow);
        CHECK_NEAR(s.H_cen / s.flooded, share, 1e-3);
    }
}

/* The gap before a Hertzian contact, and what builds up in it:
 *     lambda alphabar int_1^x g/(g + H)^3 dx = 1 */
static double gap_at(double x)
{
    double root = sqrt(x * x - 1);
    return 0.5 * (x * root - log(x + root));
}

/* By x = 1 + t^2, in which g is smooth. */
static double build_up(double H, double x, double lambda_alphabar)
{
    enum { STEPS = 4000 };
    double end = sqrt(x - 1), sum = 0;
    for (int k = 0; k < STEPS; k++) {
        double t = end * (k + 0.5) / STEPS, g = gap_at(1 + t * t);
        sum += 2 * t * g / pow(g + H, 3);
    }
    return lambda_alphabar * sum * end / STEPS;
}

static double grubin_film(double lambda_alphabar)
{
    double low = 1e-4, high = 10;
    for (int k = 0; k < 60; k++) {
        double H = sqrt(low * high);
        *(build_up(H, 30, lambda_alphabar) > 1 ? &low : &high) = H;
    }
    return low;
}

static double grubin_inlet(double H, double lambda_alphabar)
{
    double low = 1, high = 30;
    for (int k = 0; k < 60; k++) {
        double x = 0.5 * (low + high);
        *(build_up(H, x, lambda_alphabar) < 1 ? &low : &high) = x;
    }
    return low - 1;
}

TEST(inlet_of_ertel_and_grubin)
{
    static const double M[] = {20, 50}, share[] = {0.3, 0.5, 0.7};
    const double pi = acos(-1.0), L = 10;
    for (int i = 0; i < 6; i++) {
        double m = M[i / 3], film, flow = flow_of(m, L, 9, &film);
        double both = 3 * pi * pi / (8 * m * m) * L * sqrt(m / (2 * pi));
        starved s = starve(m, L, 9, share[i % 3] * flow);
        double H = s.H_cen / s.flooded * grubin_film(both);
        CHECK_CLOSE(-1 - s.meniscus, grubin_inlet(H, both), 0.05);
    }
}

/* ----------------------------------------------------------- waves of supply
 */

static const double period = 0.5;

static double waves(void *data, double T)
{
    const double *q = data;
    return *q * (1 + 0.3 * sin(2 * acos(-1.0) * T / period));
}

/* The share of the amplitude that is left one b behind the inlet, by its
 * Fourier sum over the last two periods. */
static double amplitude_left(int level)
{
    double q = 0.05, c = 0, s = 0, steps = 0, w = 2 * acos(-1.0) / period;
    ovr_error err = {0};
    ovr_simulation *sim = make(20, 10, level);
    const ovr_state *at = ovr_simulation_state(sim);
    ovr_simulation_supply(sim, waves, &q, 0);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    double D = at->D;
    size_t node = (size_t)lround(1 / D);
    int each = (int)lround(period / D), before = (int)(1.2 / D);
    double dT = period / each;
    for (int k = 0; k < before + 2 * each; k++) {
        CHECK_OK(ovr_simulation_step(sim, dT, &err), &err);
        if (k < before)
            continue;
        c += at->q[node] * cos(w * at->T);
        s += at->q[node] * sin(w * at->T);
        steps++;
    }
    ovr_simulation_free(sim);
    return 2 * sqrt(c * c + s * s) / steps / (0.3 * q);
}

/* What the upstream wedge damps falls eightfold with the mesh. */
TEST(waves_of_supply_are_convected)
{
    double lost[2];
    for (int l = 0; l < 2; l++)
        lost[l] = 1 - amplitude_left(6 + l);
    CHECK_NEAR(lost[0], 0.03, 0.01);
    assert_true(lost[1] < lost[0] / 4 && lost[1] > 0);
}
