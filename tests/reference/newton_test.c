/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Multigrid solver compared with the dense Newton solution of the same discrete
 * equations: steady, with a feature, and some time steps, with logarithmic, gap
 * and arithmetic means between nodes. */
#include "support/contact.h"
#include "support/newton.h"

#include <math.h>
#include <string.h>

#include "contact/contact.h"
#include "contact/laws/law.h"
#include "simulation/internal.h"
#include "support/test.h"

enum { LEVEL = 4 };

static ovr_simulation *solver(double M, double L, ovr_scheme scheme,
                              ovr_faces faces)
{
    ovr_options o = test_options();
    o.faces = faces;
    o.level = LEVEL;
    o.coarsest_level = 3;
    o.scheme = scheme;
    o.tolerance = 1e-10;
    o.mlmi_order = 12;
    o.mlmi_range = 24;
    return test_simulation(M, L, &o);
}

static dense *reference(double M, double L, ovr_scheme scheme, ovr_faces faces)
{
    dense *d = dense_make(M, L, LEVEL, scheme);
    d->in_line = faces == OVR_FACES_GAP;
    d->logarithmic = faces == OVR_FACES_LOGARITHMIC;
    return d;
}

enum { MEANS = 3 };
static const ovr_faces means[MEANS] = {OVR_FACES_LOGARITHMIC, OVR_FACES_GAP,
                                       OVR_FACES_ARITHMETIC};

static void compare(const ovr_simulation *sim, const dense *d)
{
    const ovr_state *now = ovr_simulation_state(sim);
    assert_int_equal(now->n, d->n);
    CHECK_NEAR(now->H0, d->H0, 1e-8);
    for (size_t i = 0; i < d->n; i++) {
        CHECK_NEAR(now->P[i], d->P[i], 1e-7);
        CHECK_NEAR(now->H[i], d->H[i], 1e-8);
    }
}

/* Full Newton steps have a small basin: start from the solution with every
 * pressure disturbed by up to 1 %. */
static void start_near(dense *d, const ovr_simulation *sim)
{
    const ovr_state *now = ovr_simulation_state(sim);
    uint64_t seed = 5;
    for (size_t i = 0; i < d->n; i++)
        d->P[i] = now->P[i] * test_random(&seed, 0.99, 1.01);
    d->H0 = now->H0;
}

TEST(steady_smooth)
{
    const double loads[][2] = {{5, 10}, {10, 2.5}, {20, 10}, {5, 0}};
    for (int c = 0; c < 4; c++)
        for (int s = 0; s < 2 * MEANS; s++) {
            ovr_error err;
            ovr_scheme scheme = s % 2 ? OVR_UPSTREAM2 : OVR_UPSTREAM1;
            double M = loads[c][0], L = loads[c][1];
            dense *d = reference(M, L, scheme, means[s / 2]);
            ovr_simulation *sim = solver(M, L, scheme, means[s / 2]);
            CHECK_OK(ovr_simulation_steady(sim, &err), &err);
            start_near(d, sim);
            dense_solve(d);
            compare(sim, d);
            ovr_simulation_free(sim);
            dense_free(d);
        }
}

/* A law of no oil, eta ~ sqrt(H) and so eps ~ H^2.5, that the library does not
 * know. */
static double thickening(double H)
{
    return sqrt(fmax(H, 1e-3) / 0.1);
}

typedef struct thick_oil {
    ovr_law law;
    const ovr_lubricant *oil;
} thick_oil;

static void thick_at(const ovr_law *law, const ovr_law_nodes *nodes)
{
    const ovr_lubricant *oil = ((const thick_oil *)law)->oil;
    for (size_t k = 0; k < nodes->count; k++) {
        double P = nodes->P[k], H = nodes->H[k];
        double eta = ovr_viscosity(oil, P) * thickening(H);
        nodes->log2_fluidity[k] = -log2(eta);
        nodes->by_pressure[k] = oil->alphabar *
                                pow(1 + P / oil->P0, oil->z - 1);
        nodes->by_film[k] = H > 1e-3 ? 0.5 / H : 0;
    }
}

static void oil_of_its_own(ovr_faces faces)
{
    ovr_error err;
    dense *d = reference(5, 5, OVR_UPSTREAM2, faces);
    ovr_simulation *sim = solver(5, 5, OVR_UPSTREAM2, faces);
    thick_oil thick = {{thick_at}, &d->contact.lubricant};
    sim->target.fluid.law = sim->grids.fluid.law = &thick.law;
    d->thickening = thickening;
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    start_near(d, sim);
    dense_solve(d);
    compare(sim, d);
    dense_free(d);
    ovr_simulation_free(sim);
}

TEST(a_law_of_its_own)
{
    for (int k = 0; k < MEANS; k++)
        oil_of_its_own(means[k]);
}

static void steady_dent(ovr_faces faces)
{
    ovr_error err;
    test_feature dent = {'l', -0.05, 0.8, -0.2, 0, 0};
    double S[128];
    dense *d = reference(10, 10, OVR_UPSTREAM2, faces);
    ovr_simulation *sim = solver(10, 10, OVR_UPSTREAM2, faces);
    ovr_simulation_surface(sim, test_feature_heights, &dent);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    test_feature_heights(&dent, 0, d->n, d->X, S);
    dense_surface(d, S);
    dense_solve(d);
    compare(sim, d);
    ovr_simulation_free(sim);
    dense_free(d);
}

TEST(steady_with_a_dent)
{
    for (int k = 0; k < MEANS; k++)
        steady_dent(means[k]);
}

/* Coefficients of q^k and q^{k-1} in F, times dT, and cT dT. */
static void history(dense *d, ovr_scheme scheme, double dT, const double *q1,
                    const double *q2)
{
    bool first = scheme == OVR_UPSTREAM1;
    d->cT = (first ? 1 : 1.5) / dT;
    for (size_t i = 0; i < d->n; i++) {
        size_t a = i ? i - 1 : 0, b = i > 1 ? i - 2 : 0;
        if (scheme == OVR_CHARACTERISTIC)
            d->F[i] = (-2 * q1[a] + 0.5 * q2[b]) / dT;
        else
            d->F[i] = (first ? -q1[i] : -2 * q1[i] + 0.5 * q2[i]) / dT;
    }
    if (scheme == OVR_CHARACTERISTIC)
        memset(d->w, 0, sizeof d->w), memset(d->first, 0, sizeof d->first);
}

/* q beyond the inlet: film with P = 0 there, at X_a - g D */
static double ghost(const dense *d, int g)
{
    double X = d->X_a - g * d->D, w = 0;
    for (size_t j = 0; j < d->n; j++) {
        double a = ((double)j + g + 0.5) * d->D, b = a - d->D;
        w += (a * (log(a) - 1) - b * (log(b) - 1)) / acos(-1) * d->P[j];
    }
    return d->H0 + 0.5 * X * X - w;
}

static void steps_of(ovr_scheme scheme, ovr_faces faces)
{
    enum { STEPS = 4 };
    ovr_error err;
    double S[128], q1[128], q2[128], in1, in2[2];
    test_feature dent = {'l', -0.08, 0.8, -1.3, 1, 0};
    ovr_scheme steady = scheme == OVR_UPSTREAM1 ? scheme : OVR_UPSTREAM2;
    dense *d = reference(10, 10, steady, faces);
    ovr_simulation *sim = solver(10, 10, scheme, faces);
    ovr_simulation_surface(sim, test_feature_heights, &dent);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    test_feature_heights(&dent, 0, d->n, d->X, S);
    dense_surface(d, S);
    dense_solve(d);
    memcpy(q1, d->q, d->n * sizeof *q1);
    memcpy(q2, d->q, d->n * sizeof *q2);
    in1 = in2[0] = ghost(d, 1);
    in2[1] = ghost(d, 2);
    for (int k = 1; k <= STEPS; k++) {
        CHECK_OK(ovr_simulation_step(sim, d->D, &err), &err);
        test_feature_heights(&dent, k * d->D, d->n, d->X, S);
        dense_surface(d, S);
        history(d, scheme, d->D, q1, q2);
        if (scheme == OVR_CHARACTERISTIC)
            d->F[1] = (-2 * q1[0] + 0.5 * in2[0]) / d->D;
        dense_solve(d);
        compare(sim, d);
        assert_false(ovr_simulation_observation(sim)->marked);
        memcpy(q2, q1, d->n * sizeof *q1);
        memcpy(q1, d->q, d->n * sizeof *q1);
        in2[0] = in1;
        in1 = ghost(d, 1);
    }
    ovr_simulation_free(sim);
    dense_free(d);
}

static void time_steps(ovr_scheme scheme)
{
    for (int k = 0; k < MEANS; k++)
        steps_of(scheme, means[k]);
}

TEST(backward_euler)
{
    time_steps(OVR_UPSTREAM1);
}

TEST(bdf2)
{
    time_steps(OVR_UPSTREAM2);
}

TEST(along_the_characteristic)
{
    time_steps(OVR_CHARACTERISTIC);
}
