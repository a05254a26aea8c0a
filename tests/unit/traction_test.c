/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Pressure and traction together: the sliding dry contact, Q = mu P, compared
 * with its closed form, known values and invariants. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "stress/stress.h"
#include "support/test.h"

enum { NODES = 1793 };
static const double D = 5.5 / (NODES - 1);
static double P[NODES], Q[NODES], P_back[NODES], Q_back[NODES];

static ovr_stress_options level8(double inlet)
{
    ovr_stress_options o = ovr_stress_options_default();
    o.mesh = D;
    o.inlet = inlet;
    o.nodes = NODES;
    o.traction = true;
    return o;
}

static void hertz(double inlet, double mu)
{
    for (size_t i = 0; i < NODES; i++) {
        double X = inlet + (double)i * D;
        P[i] = fabs(X) < 1 ? sqrt(1 - X * X) : 0;
        Q[i] = mu * P[i];
    }
}

static ovr_stress *made(const ovr_stress_options *o)
{
    ovr_error err;
    ovr_stress *s = ovr_stress_create(o, NULL, &err);
    if (!s)
        fail_msg("%s", err.message);
    return s;
}

static ovr_in_plane value(const ovr_stress_row *row, size_t i)
{
    return (ovr_in_plane){(double)row->mean[2 * i], (double)row->shear[2 * i],
                          (double)row->shear[2 * i + 1]};
}

/* Its edges, square roots, converge slowly: at this level 1e-3 near the surface
 * and 4e-5 at z = 0.2 for the pressure alone. */
TEST(sliding_contacts_have_their_closed_form)
{
    const double mu[] = {0.05, -0.3};
    ovr_stress_options o = level8(-4);
    ovr_stress *s = made(&o);
    for (size_t m = 0; m < 2; m++) {
        hertz(-4, mu[m]);
        ovr_stress_solve(s, P, Q, 0, OVR_STRESS_ALL_LEVELS);
        for (size_t j = 0; j < ovr_stress_depths(s, NULL); j++) {
            ovr_stress_row row = ovr_stress_at(s, j);
            double tolerance = row.z < 0.2 ? 1e-3 : 1e-4;
            for (size_t i = 0; row.z >= 0.05 && i < row.count; i += 5) {
                double X = row.start + (double)i * row.step;
                ovr_in_plane a = value(&row, i);
                ovr_in_plane b = ovr_hertz_stress(1, mu[m], X, row.z);
                CHECK_NEAR(a.h, b.h, tolerance);
                CHECK_NEAR(a.d, b.d, tolerance);
                CHECK_NEAR(a.tau, b.tau, tolerance);
            }
        }
    }
    ovr_stress_free(s);
}

/* The largest Tresca stress and where, from half a mesh down. */
static double largest(ovr_stress *s, double mu, double *z)
{
    double maximum = 0;
    hertz(-4, mu);
    ovr_stress_solve(s, P, Q, 0, OVR_STRESS_ALL_LEVELS);
    for (size_t j = 0; j < ovr_stress_depths(s, NULL); j++) {
        ovr_stress_row row = ovr_stress_at(s, j);
        for (size_t i = 0; i < row.count; i++) {
            double v = ovr_stress_value(OVR_STRESS_TRESCA, value(&row, i), 0.3,
                                        0, 0);
            double X = row.start + (double)i * row.step;
            if (fabs(X) < 0.9 && v > maximum)
                maximum = v, *z = row.z;
        }
    }
    return maximum;
}

/* The largest shear stress comes to the surface where the friction exceeds a
 * quarter of the load (K. L. Johnson, Contact Mechanics, 1985, section 7.1),
 * and there, in the plane, it is mu everywhere under the pressure. */
TEST(strong_friction_yields_at_the_surface)
{
    ovr_stress_options o = level8(-4);
    double z;
    o.depth_min = D / 2;
    ovr_stress *s = made(&o);
    largest(s, 0.22, &z);
    assert_true(z > 0.3);
    largest(s, 0.28, &z);
    assert_true(z < 2 * D);
    ovr_stress_row row = ovr_stress_at(s, 0);
    for (size_t i = 0; i < row.count; i++) {
        double X = row.start + (double)i * row.step;
        ovr_in_plane a = value(&row, i);
        if (fabs(X) < 0.9) {
            CHECK_NEAR(hypot(a.d, a.tau), 0.28, 5e-3);
            CHECK_NEAR(a.tau, -0.28 * sqrt(1 - X * X), 5e-3);
        }
    }
    ovr_stress_free(s);
}

/* A ragged pressure and traction, and both seen from behind the paper: X and
 * Q change their signs. */
static void ragged(double inlet)
{
    uint64_t seed = 7;
    for (size_t i = 0; i < NODES; i++) {
        double X = inlet + (double)i * D;
        P[i] = X * X < 1 ? sqrt(1 - X * X) * (1 + 0.3 * sin(9 * X + 1)) : 0;
        Q[i] = P[i] * (0.1 + 0.05 * test_random(&seed, -1, 1));
        P_back[NODES - 1 - i] = P[i];
        Q_back[NODES - 1 - i] = -Q[i];
    }
}

TEST(a_mirrored_load_mirrors_the_field)
{
    ovr_stress_options o = level8(-2.75);
    o.from = -2.75 + 32 * D, o.to = 2.75 - 32 * D;
    ovr_stress *a = made(&o), *b = made(&o);
    ragged(-2.75);
    ovr_stress_solve(a, P, Q, 0, OVR_STRESS_ALL_LEVELS);
    ovr_stress_solve(b, P_back, Q_back, 0, OVR_STRESS_ALL_LEVELS);
    for (size_t j = 0; j < ovr_stress_depths(a, NULL); j++) {
        ovr_stress_row r = ovr_stress_at(a, j), t = ovr_stress_at(b, j);
        size_t count = (size_t)lround((o.to - o.from) / r.step) + 1;
        for (size_t i = 0; i < count; i++) {
            ovr_in_plane u = value(&r, i), v = value(&t, count - 1 - i);
            CHECK_NEAR(u.h, v.h, 3e-6);
            CHECK_NEAR(u.d, v.d, 3e-6);
            CHECK_NEAR(u.tau, -v.tau, 3e-6);
        }
    }
    ovr_stress_free(a);
    ovr_stress_free(b);
}

/* (P, Q) is (P, 0) and (0, Q); a solve without Q is one with zeros. */
TEST(loads_superpose)
{
    static const double none[NODES];
    ovr_stress_options o = level8(-4);
    const double *p[] = {P, none, P, P}, *q[] = {NULL, Q, Q, none};
    ovr_stress *s[4];
    ragged(-4);
    for (int k = 0; k < 4; k++) {
        s[k] = made(&o);
        ovr_stress_solve(s[k], p[k], q[k], 5.3, OVR_STRESS_ALL_LEVELS);
    }
    for (size_t j = 0; j < ovr_stress_depths(s[0], NULL); j++) {
        ovr_stress_row r[4];
        for (int k = 0; k < 4; k++)
            r[k] = ovr_stress_at(s[k], j);
        for (size_t i = 0; i < r[0].count; i++) {
            ovr_in_plane a = value(&r[0], i), b = value(&r[1], i);
            ovr_in_plane c = value(&r[2], i), e = value(&r[3], i);
            CHECK_NEAR(a.h + b.h, c.h, 2e-6);
            CHECK_NEAR(a.d + b.d, c.d, 2e-6);
            CHECK_NEAR(a.tau + b.tau, c.tau, 2e-6);
            CHECK_NEAR(a.tau, e.tau, 1e-7);
        }
    }
    for (int k = 0; k < 4; k++)
        ovr_stress_free(s[k]);
}

/* --------------------------------------------------------------- material
 * histories */

static ovr_material_history *rolled(const ovr_stress_options *o,
                                    double reference, double way, long steps)
{
    ovr_error err;
    ovr_material_range range = ovr_material_range_default();
    ovr_moment m = {.direction = way < 0 ? -1 : 1, .dU = fabs(way)};
    range.reference = reference;
    range.from = -0.5, range.to = 0.5;
    ovr_material_history *p = ovr_material_history_create(o, &range, NULL,
                                                          &err);
    if (!p)
        fail_msg("%s", err.message);
    ovr_material_history_begin(p, P, Q, &m);
    for (long k = 1; k <= steps; k++) {
        m.T = m.U = (double)k * way;
        ovr_material_history_step(p, P, Q, &m);
    }
    ovr_material_history_end(p, P, Q, &m);
    return p;
}

/* Circle and orthogonal amplitude of the closed form's own path, the circle
 * from all its points. */
static void of_path(double mu, double z, double *radius, double *orthogonal)
{
    enum { N = 8001 };
    float *s = calloc((size_t)2 * N + 2, sizeof *s); /* and (0, 0) */
    double high = 0, low = 0;
    assert_non_null(s);
    for (size_t i = 0; i < N; i++) {
        double x = -2.5 + 5 * (double)i / (N - 1);
        ovr_in_plane in = ovr_hertz_stress(1, mu, x, z);
        s[2 * i] = (float)in.d;
        s[2 * i + 1] = (float)in.tau;
        high = fmax(high, in.tau);
        low = fmin(low, in.tau);
    }
    *radius = ovr_minimum_circle(N + 1, s).radius;
    *orthogonal = (high - low) / 2;
    free(s);
}

TEST(sliding_histories_have_their_amplitudes)
{
    const double mu[] = {0.1, -0.25}, z[] = {0.2, 0.5, 1};
    ovr_stress_options o = level8(-4);
    for (size_t k = 0; k < 6; k++) {
        double R, tau, radius, orthogonal;
        o.depth_min = o.depth_max = z[k / 2];
        hertz(-4, mu[k % 2]);
        ovr_material_history *p = rolled(&o, 0, D, 0);
        ovr_material_history_measure(p, OVR_MEASURE_CIRCLE, NULL, &R);
        ovr_material_history_measure(p, OVR_MEASURE_ORTHOGONAL, NULL, &tau);
        of_path(mu[k % 2], z[k / 2], &radius, &orthogonal);
        CHECK_CLOSE(tau, orthogonal, 3e-4);
        assert_true(R < radius * (1 + 3e-4));
        assert_true(R > radius * (cos(3.14159265 / 32) - 3e-4));
        ovr_material_history_free(p);
    }
}

/* A steady sliding contact adds no risk. */
TEST(a_steady_contact_adds_no_risk)
{
    const double ways[] = {1.15, -0.85};
    ovr_stress_options o = level8(-4);
    hertz(-4, 0.1);
    for (size_t k = 0; k < 2; k++) {
        ovr_error err;
        ovr_life_options life = ovr_life_options_default();
        ovr_life_result result;
        ovr_material_history *p = rolled(&o, ways[k] > 0 ? -3 : 3, ways[k] * D,
                                         lround(6 / fabs(ways[k]) / D));
        ovr_material m = ovr_material_history_points(p);
        float *A = calloc(m.points * m.depths, sizeof *A);
        double *smooth = calloc(m.depths, sizeof *smooth);
        assert_true(A && smooth);
        life.least_depth = 8 * D;
        CHECK_OK(ovr_material_history_amplitude(p, OVR_CRITERION_CIRCLE, 0.3, A,
                                                smooth, &err),
                 &err);
        CHECK_OK(ovr_life(&life, &(ovr_amplitudes){&m, A, smooth}, NULL, NULL,
                          &result, &err),
                 &err);
        CHECK_NEAR(result.equivalent_length, 0, 1e-3);
        free(A);
        free(smooth);
        ovr_material_history_free(p);
    }
}

/* Downstream of a sliding contact traction causes tension below the surface,
 * which pressure alone does not. */
TEST(traction_pulls)
{
    ovr_stress_options o = level8(-4);
    double pulled, pressed;
    o.depth_min = o.depth_max = 0.2;
    hertz(-4, 0.2);
    ovr_material_history *p = rolled(&o, 0, D, 0);
    ovr_material_history_measure(p, OVR_MEASURE_HYDRO_MAX, NULL, &pulled);
    ovr_material_history_free(p);
    memset(Q, 0, sizeof Q);
    p = rolled(&o, 0, D, 0);
    ovr_material_history_measure(p, OVR_MEASURE_HYDRO_MAX, NULL, &pressed);
    ovr_material_history_free(p);
    assert_true(pulled > 0.02);
    CHECK_NEAR(pressed, 0, 1e-6);
}
