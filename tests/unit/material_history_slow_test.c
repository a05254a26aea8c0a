/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Stress histories of the material and fatigue life: Hertzian contact, circles,
 * identities. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "reference/stress_truth.h"
#include "stress/circle.h"
#include "stress/stress.h"
#include "support/test.h"

#define ROWS(table) (sizeof(table) / sizeof(table)[0])
static const double pi = 3.14159265358979323846;

/* ------------------------------------------------------------------ circles */

/* The smallest circle by trying all pairs and triples. */
static double brute(size_t n, const float *p)
{
    double best = INFINITY;
    for (size_t a = 0; a < n; a++)
        for (size_t b = a + 1; b < n; b++)
            for (size_t c = b; c < n; c++) {
                float three[] = {p[2 * a],     p[2 * a + 1], p[2 * b],
                                 p[2 * b + 1], p[2 * c],     p[2 * c + 1]};
                ovr_circle k = ovr_minimum_circle(c > b ? 3 : 2, three);
                bool all = true;
                for (size_t i = 0; all && i < n; i++)
                    all = hypot((double)p[2 * i] - k.d,
                                (double)p[2 * i + 1] - k.tau) <=
                          k.radius * (1 + 1e-9);
                if (all)
                    best = fmin(best, k.radius);
            }
    return best;
}

TEST(circles_are_the_smallest)
{
    enum { N = 24 };
    uint64_t seed = 5;
    for (int round = 0; round < 40; round++) {
        float p[2 * N];
        for (size_t k = 0; k < sizeof p / sizeof *p; k++)
            p[k] = (float)test_random(&seed, -1, 1);
        ovr_circle c = ovr_minimum_circle(N, p);
        CHECK_NEAR(c.radius, brute(N, p), 1e-9);
        for (size_t k = 0; k < N; k++)
            assert_true(
                hypot((double)p[2 * k] - c.d, (double)p[2 * k + 1] - c.tau) <=
                c.radius * (1 + 1e-9));
    }
}

/* Right, obtuse, on one line, one point, all the same. */
TEST(circles_of_few_points)
{
    const float right[] = {0, 0, 4, 0, 0, 3}, line[] = {0, 0, 1, 1, 3, 3};
    const float flat[] = {0, 0, 4, 0, 2, 0.5F}, one[] = {2, 3, 2, 3, 2, 3};
    CHECK_NEAR(ovr_minimum_circle(3, right).radius, 2.5, 1e-12);
    CHECK_NEAR(ovr_minimum_circle(3, line).radius, 1.5 * sqrt(2), 1e-12);
    CHECK_NEAR(ovr_minimum_circle(3, flat).radius, 2, 1e-12);
    CHECK_NEAR(ovr_minimum_circle(3, one).radius, 0, 0);
    CHECK_NEAR(ovr_minimum_circle(3, one).tau, 3, 0);
    CHECK_NEAR(ovr_minimum_circle(0, one).radius, 0, 0);
}

/* From extents the radius is low by no more than 1 - cos(pi/32). */
TEST(circles_of_extents_bound_from_below)
{
    enum { N = 60 };
    uint64_t seed = 9;
    for (int round = 0; round < 100; round++) {
        float p[2 * N];
        double high[OVR_HALF_DIRECTIONS], low[OVR_HALF_DIRECTIONS];
        double phase = test_random(&seed, 0, 6), a = test_random(&seed, 0, 1);
        for (size_t k = 0; k < N; k++) {
            double t = 2 * pi * (double)k / N;
            p[2 * k] = (float)(cos(t) + a * cos(2 * t + phase));
            p[2 * k + 1] = (float)(a * sin(t) + 0.3 * sin(3 * t));
        }
        for (int m = 0; m < OVR_HALF_DIRECTIONS; m++) {
            high[m] = -INFINITY, low[m] = INFINITY;
            for (size_t k = 0; k < N; k++) {
                double v = (double)p[2 * k] * ovr_direction_cos(m) +
                           (double)p[2 * k + 1] * ovr_direction_sin(m);
                high[m] = fmax(high[m], v);
                low[m] = fmin(low[m], v);
            }
        }
        double exact = ovr_minimum_circle(N, p).radius;
        double R = ovr_circle_of_extents(high, low);
        assert_true(R <= exact * (1 + 1e-6));
        assert_true(R >= exact * cos(pi / 32) * (1 - 1e-6));
    }
}

/* ------------------------------------------------- the smooth dry contact */

TEST(hertz_of_every_criterion)
{
    double z;
    CHECK_NEAR(ovr_hertz_criterion(OVR_CRITERION_CIRCLE, 0, 0.3, &z), 0.25,
               1e-9);
    CHECK_NEAR(z, 0.5, 1e-4);
    for (size_t k = 0; k < ROWS(truth_von_mises); k++) {
        const double *r = truth_von_mises[k];
        CHECK_NEAR(ovr_hertz_criterion(OVR_CRITERION_VON_MISES, 0, r[0], &z),
                   r[1], 1e-9);
        CHECK_NEAR(z, r[2], 1e-4);
    }
    CHECK_NEAR(ovr_hertz_criterion(OVR_CRITERION_TRESCA, 0, 0.3, &z),
               0.30028310600077757, 1e-9);
    CHECK_NEAR(z, 0.7861513777574233, 1e-4);
    for (size_t k = 0; k < ROWS(truth_dang_van); k++) {
        const double *r = truth_dang_van[k];
        CHECK_NEAR(ovr_hertz_criterion(OVR_CRITERION_DANG_VAN, r[0], 0.3, &z),
                   r[1], 1e-6);
        CHECK_NEAR(z, r[2], 1e-3);
    }
}

/* A whole path of it, to the exact circle: d of its centre is that of the
 * sample next to the largest tau, 1e-4 apart, hence 5e-6. */
TEST(dang_van_of_a_path)
{
    enum { N = 40001 };
    float *s = calloc((size_t)2 * N, sizeof *s), *hydro = calloc(N, sizeof *s);
    assert_true(s && hydro);
    for (size_t k = 0; k < ROWS(truth_dang_van_at); k++) {
        const double *r = truth_dang_van_at[k];
        for (size_t i = 0; i < N; i++) {
            double x = -2 + 4 * (double)i / (N - 1);
            ovr_in_plane in = ovr_hertz_stress(1, 0, x, r[0]);
            s[2 * i] = (float)in.d;
            s[2 * i + 1] = (float)in.tau;
            hydro[i] = (float)(-2. / 3 * 1.3 * in.h);
        }
        CHECK_NEAR(ovr_dang_van(N, s, hydro, r[1]), r[2], 5e-6);
    }
    free(s);
    free(hydro);
}

/* ----------------------------------------------------------------- material
 * histories */

enum { NODES = 1793 };
static const double D = 5.5 / (NODES - 1);

static ovr_stress_options level8(void)
{
    ovr_stress_options o = ovr_stress_options_default();
    o.mesh = D;
    o.inlet = -4;
    o.nodes = NODES;
    return o;
}

static void hertz(double scale, double *P)
{
    for (size_t i = 0; i < NODES; i++) {
        double X = -4 + (double)i * D;
        P[i] = fabs(X) < 1 ? scale * sqrt(1 - X * X) : 0;
    }
}

/* A hump that stands still on the material: a made-up feature. */
static void hump(double at, double *P)
{
    hertz(1, P);
    for (size_t i = 0; i < NODES; i++) {
        double X = -4 + (double)i * D;
        P[i] *= 1 + 0.4 * exp(-pow((X - at) / 0.1, 2));
    }
}

static ovr_material_history *made(const ovr_stress_options *o,
                                  const ovr_material_range *range)
{
    ovr_error err;
    ovr_material_history *p = ovr_material_history_create(o, range, NULL, &err);
    if (!p)
        fail_msg("%s", err.message);
    return p;
}

/* So many steps of `way` each; the hump, if any, starts at xi = 0. */
static void roll(ovr_material_history *p, double reference, double way,
                 long steps, bool feature)
{
    static double P[NODES];
    ovr_moment m = {.direction = way < 0 ? -1 : 1, .dU = fabs(way)};
    hump(feature ? reference : -100, P);
    ovr_material_history_begin(p, P, NULL, &m);
    for (long k = 1; k <= steps; k++) {
        m.T = m.U = (double)k * way;
        hump(feature ? reference + m.U : -100, P);
        ovr_material_history_step(p, P, NULL, &m);
    }
    ovr_material_history_end(p, P, NULL, &m);
}

static ovr_material_range about(double reference)
{
    ovr_material_range range = ovr_material_range_default();
    range.reference = reference;
    return range;
}

static ovr_life_result life_of(const ovr_material_history *p,
                               ovr_life_options *life, double *length)
{
    ovr_error err;
    ovr_life_result result;
    ovr_material m = ovr_material_history_points(p);
    float *A = calloc(m.points * m.depths, sizeof *A);
    double *smooth = calloc(m.depths, sizeof *smooth);
    assert_true(A && smooth);
    CHECK_OK(ovr_material_history_amplitude(p, OVR_CRITERION_CIRCLE, 0.3, A,
                                            smooth, &err),
             &err);
    CHECK_OK(ovr_life(life, &(ovr_amplitudes){&m, A, smooth}, NULL, length,
                      &result, &err),
             &err);
    free(A);
    free(smooth);
    return result;
}

/* Amplitudes of a steady material history: orthogonal, circle, and what they
 * are by closed form; Hertz' own edges converge slowly (1e-3 at z = 0.05). */
TEST(smooth_rolling_has_its_amplitudes)
{
    ovr_stress_options o = level8();
    for (size_t k = 0; k < ROWS(truth_orthogonal); k++) {
        const double *r = truth_orthogonal[k];
        static double P[NODES];
        double orthogonal, circle, critical, angle;
        ovr_material_range range = about(0);
        ovr_moment m = {.direction = 1};
        o.depth_min = o.depth_max = r[0];
        ovr_material_history *p = made(&o, &range);
        hertz(1, P);
        ovr_material_history_begin(p, P, NULL, &m);
        ovr_material_history_measure(p, OVR_MEASURE_ORTHOGONAL, NULL,
                                     &orthogonal);
        ovr_material_history_measure(p, OVR_MEASURE_CIRCLE, NULL, &circle);
        ovr_material_history_measure(p, OVR_MEASURE_CRITICAL, NULL, &critical);
        ovr_material_history_measure(p, OVR_MEASURE_ANGLE, NULL, &angle);
        CHECK_CLOSE(orthogonal, r[1], r[0] < 0.1 ? 2e-3 : 3e-4);
        CHECK_CLOSE(circle, r[1], r[0] < 0.1 ? 2e-3 : 3e-4);
        CHECK_CLOSE(critical, r[1], r[0] < 0.1 ? 2e-3 : 3e-4);
        CHECK_NEAR(angle, 0, 0);
        ovr_material_history_free(p);
    }
}

/* A steady contact does no more harm than itself, rolled or slid through; the
 * ways of sliding hit the nodes nowhere twice. */
TEST(a_steady_contact_adds_no_risk)
{
    const double ways[] = {1, 1.15, -0.85};
    ovr_stress_options o = level8();
    for (size_t k = 0; k < sizeof ways / sizeof *ways; k++) {
        ovr_life_options life = ovr_life_options_default();
        ovr_material_range range = about(ways[k] > 0 ? -3 : 3);
        range.from = -1, range.to = 1;
        ovr_material_history *p = made(&o, &range);
        life.least_depth = 8 * D;
        roll(p, range.reference, ways[k] * D, lround(6 / fabs(ways[k]) / D),
             false);
        CHECK_NEAR(life_of(p, &life, NULL).equivalent_length, 0, 1e-3);
        ovr_material_history_free(p);
    }
}

/* The same material history, another window: risk does not depend on it. */
TEST(the_window_does_not_matter)
{
    ovr_stress_options o = level8();
    ovr_life_options life = ovr_life_options_default();
    double length[2];
    life.least_depth = 8 * D;
    for (int k = 0; k < 2; k++) {
        ovr_material_range range = about(-3);
        range.from = k ? -4 : -2, range.to = k ? 4 : 2;
        ovr_material_history *p = made(&o, &range);
        roll(p, -3, 1.07 * D, lround(6.5 / 1.07 / D), true);
        length[k] = life_of(p, &life, NULL).equivalent_length;
        ovr_material_history_free(p);
    }
    assert_true(length[0] > 0.1);
    CHECK_NEAR(length[1], length[0], 5e-3);
}

/* Mirrored in X, rolled backward: the same history. */
TEST(backward_is_the_mirror_of_forward)
{
    ovr_stress_options o = level8();
    ovr_life_options life = ovr_life_options_default();
    ovr_life_result result[2];
    o.inlet = -2.75;
    life.least_depth = 8 * D;
    for (int k = 0; k < 2; k++) {
        static double P[NODES], back[NODES];
        double sign = k ? -1 : 1;
        ovr_material_range range = about(sign * -3);
        ovr_material_history *p = made(&o, &range);
        ovr_moment m = {.direction = k ? -1 : 1, .dU = 2 * D};
        for (long step = 0; step < 1000; step++) {
            m.U = sign * (double)step * 2 * D;
            for (size_t i = 0; i < NODES; i++) {
                double X = -2.75 + (double)i * D;
                double at = X - (-3 + (double)step * 2 * D);
                P[i] = fabs(X) < 1 ? sqrt(1 - X * X) : 0;
                P[i] *= 1 + (at > 0 ? 0.5 * exp(-at / 0.3) : 0);
                back[NODES - 1 - i] = P[i];
            }
            if (step == 0)
                ovr_material_history_begin(p, k ? back : P, NULL, &m);
            else
                ovr_material_history_step(p, k ? back : P, NULL, &m);
        }
        ovr_material_history_end(p, k ? back : P, NULL, &m);
        result[k] = life_of(p, &life, NULL);
        ovr_material_history_free(p);
    }
    CHECK_CLOSE(result[1].equivalent_length, result[0].equivalent_length, 1e-3);
    CHECK_CLOSE(result[1].worst_amplitude, result[0].worst_amplitude, 1e-4);
    CHECK_NEAR(result[1].worst_xi, -result[0].worst_xi, 2.01 * D);
}

/* More points than the fields have nodes, all of one steady contact. */
TEST(windows_may_be_wider_than_the_fields)
{
    ovr_stress_options o = level8();
    static double P[NODES];
    double smooth;
    ovr_material_range range = about(0);
    ovr_moment m = {.direction = 1};
    range.from = -10, range.to = 10;
    o.depth_min = o.depth_max = 4 * D;
    ovr_material_history *p = made(&o, &range);
    ovr_material material = ovr_material_history_points(p);
    float *R = calloc(material.points, sizeof *R);
    assert_true(R && material.points > 5000);
    hertz(1, P);
    ovr_material_history_begin(p, P, NULL, &m);
    ovr_material_history_end(p, P, NULL, &m);
    ovr_material_history_measure(p, OVR_MEASURE_CIRCLE, R, &smooth);
    for (size_t k = 0; k < material.points; k++)
        CHECK_CLOSE((double)R[k], smooth, 1e-3);
    free(R);
    ovr_material_history_free(p);
}

/* Points whose material history the run cut while the hump was in the contact.
 */
TEST(interrupted_writes_are_reported)
{
    ovr_stress_options o = level8();
    static double P[NODES];
    ovr_material_range range = about(-3);
    ovr_material_history *p = made(&o, &range);
    ovr_moment m = {.direction = 1, .dU = D};
    hump(-3, P);
    ovr_material_history_begin(p, P, NULL, &m);
    m.U = 3;
    m.disturbed = true;
    ovr_material_history_end(p, P, NULL, &m);
    ovr_material material = ovr_material_history_points(p);
    for (size_t k = 0; k < material.points; k++) {
        double X = material.start + (double)k * material.step;
        if (fabs(X - 2) > 1e-9)
            assert_int_equal(material.complete[k], X > 2);
    }
    ovr_material_history_free(p);
}

/* A state copied in the middle of the run gives the same bits. */
TEST(a_copied_state_goes_on)
{
    enum { STEPS = 300, HALF = 140 };
    ovr_stress_options o = level8();
    ovr_material_range range = about(-0.5);
    static double P[NODES];
    ovr_material_history *p[2] = {made(&o, &range), made(&o, &range)};
    const ovr_memory_piece *a, *b;
    size_t pieces = ovr_material_history_state(p[0], &a);
    ovr_material_history_state(p[1], &b);
    for (long k = 0; k <= STEPS; k++) {
        double U = (double)k * 1.3 * D;
        ovr_moment m = {(double)k, U, 1.3 * D, 1, false};
        hump(-0.5 + U, P);
        if (k == HALF)
            for (size_t j = 0; j < pieces; j++)
                memcpy(b[j].memory, a[j].memory, a[j].bytes);
        for (int which = 0; which < (k >= HALF ? 2 : 1); which++)
            if (k == 0)
                ovr_material_history_begin(p[which], P, NULL, &m);
            else
                ovr_material_history_step(p[which], P, NULL, &m);
    }
    for (size_t j = 0; j < pieces; j++)
        assert_memory_equal(a[j].memory, b[j].memory, a[j].bytes);
    ovr_material_history_free(p[0]);
    ovr_material_history_free(p[1]);
}

/* Residual stresses leave amplitudes and move von Mises by what they are. */
TEST(residual_stresses_are_added)
{
    ovr_stress_options o = level8();
    static double P[NODES];
    double R[2], mises[2], hydro[2];
    hertz(1, P);
    o.depth_min = o.depth_max = 0.5;
    for (int k = 0; k < 2; k++) {
        ovr_material_range range = about(0);
        ovr_moment m = {.direction = 1};
        range.residual_x = k ? -0.1 : 0;
        range.residual_y = k ? -0.1 : 0;
        ovr_material_history *p = made(&o, &range);
        ovr_material_history_begin(p, P, NULL, &m);
        ovr_material_history_measure(p, OVR_MEASURE_CIRCLE, NULL, &R[k]);
        ovr_material_history_measure(p, OVR_MEASURE_VON_MISES, NULL, &mises[k]);
        ovr_material_history_measure(p, OVR_MEASURE_HYDRO_MAX, NULL, &hydro[k]);
        ovr_material_history_free(p);
    }
    CHECK_CLOSE(R[1], R[0], 1e-6);
    CHECK_NEAR(hydro[1] - hydro[0], -0.2 / 3, 1e-6);
    /* at x = 0, z = 0.5 by hand */
    double maximum = 0;
    for (double x = -3; x < 3; x += D / 2) {
        ovr_in_plane s = ovr_hertz_stress(1, 0, x, 0.5);
        double sx = s.d - s.h - 0.1, sz = -s.d - s.h, sy = -0.6 * s.h - 0.1;
        maximum = fmax(maximum,
                       sqrt(((sx - sz) * (sx - sz) + (sz - sy) * (sz - sy) +
                             (sy - sx) * (sy - sx)) /
                                2 +
                            3 * s.tau * s.tau));
    }
    CHECK_NEAR(mises[1], maximum, 1e-4);
    assert_true(mises[1] < mises[0]);
}

/* ---------------------------------------------------------------------- life
 */

/* R(z) by closed form, on the program's own depths. */
static double hertz_amplitude(double z)
{
    double maximum = 0;
    for (double x = 0.8; x < 2.5; x += 1e-5 + 1e-4 * z)
        maximum = fmax(maximum, fabs(ovr_hertz_stress(1, 0, x, z).tau));
    return maximum;
}

static size_t closed_form(double *z, double *A)
{
    size_t n = 0;
    for (double at = 4 * D; at <= 2.5; at *= exp2(0.2), n++) {
        z[n] = at;
        A[n] = hertz_amplitude(at);
    }
    return n;
}

TEST(risk_is_the_integral)
{
    double z[64], A[64], risk[64];
    size_t n = closed_form(z, A);
    for (size_t k = 0; k < ROWS(truth_life); k++) {
        ovr_life_options life = ovr_life_options_default();
        life.limit = truth_life[k][0];
        ovr_risk(&life, n, z, A, risk);
        /* just under the largest amplitude the depths are too far apart */
        CHECK_CLOSE(risk[0], truth_life[k][1], life.limit < 0.2 ? 1e-3 : 3e-2);
    }
}

/* Load 2: p_h and b grow by sqrt 2; life falls as p_h^-8. */
TEST(life_falls_with_the_eighth_power)
{
    double z[64], A[64], risk[64];
    size_t n = closed_form(z, A);
    ovr_life_options life = ovr_life_options_default();
    ovr_risk(&life, n, z, A, risk);
    double once = risk[0], factor = sqrt(2);
    for (size_t j = 0; j < n; j++) {
        z[j] *= factor;
        A[j] *= factor;
    }
    ovr_risk(&life, n, z, A, risk);
    double lives = pow(risk[0] / once, -1 / life.weibull);
    CHECK_NEAR(log(lives) / log(factor), -8, 1e-6);
}

TEST(raceways_lose_what_features_add)
{
    ovr_life_options life = ovr_life_options_default();
    CHECK_NEAR(ovr_life_ratio(&life, 0, 100, 7), 1, 0);
    CHECK_CLOSE(ovr_life_ratio(&life, 50, 100, 2), pow(2, -8. / 9), 1e-12);
    assert_true(isnan(ovr_life_ratio(&life, -200, 100, 1)));
}

/* Below the limit there is nothing to compare with. */
TEST(below_the_limit_there_is_no_length)
{
    ovr_stress_options o = level8();
    ovr_material_range range = about(-3);
    ovr_life_options life = ovr_life_options_default();
    double length[64];
    life.least_depth = 8 * D;
    life.limit = 0.4;
    ovr_material_history *p = made(&o, &range);
    roll(p, -3, 2 * D, 100, false);
    ovr_life_result result = life_of(p, &life, length);
    assert_true(isnan(result.equivalent_length) && isnan(length[0]));
    CHECK_NEAR(result.utilisation, 0.25 / 0.4, 2e-3);
    CHECK_NEAR(result.smooth_risk, 0, 0);
    ovr_material_history_free(p);
}

/* ------------------------------------------------------------------ refusals
 */

TEST(nonsense_is_refused)
{
    ovr_stress_options o = level8();
    ovr_error err;
    ovr_material_range range = about(0);
    range.to = range.from;
    assert_null(ovr_material_history_create(&o, &range, NULL, &err));
    CHECK_ERROR(&err, OVR_BAD_INPUT, "must be below the upper limit");
    range = about(0);
    range.reach = 3;
    assert_null(ovr_material_history_create(&o, &range, NULL, &err));
    CHECK_ERROR(&err, OVR_BAD_INPUT, "need fields");
    range = about(0);
    range.poisson = 0.6;
    assert_null(ovr_material_history_create(&o, &range, NULL, &err));
    CHECK_ERROR(&err, OVR_BAD_INPUT, "Poisson");
    range = about(0);
    ovr_material_history *p = made(&o, &range);
    CHECK_STATUS(ovr_material_history_amplitude(p, OVR_CRITERION_DANG_VAN, 0,
                                                NULL, NULL, &err),
                 OVR_BAD_INPUT, &err);
    ovr_material_history_free(p);
}

static ovr_status try_to_make(void *options, const ovr_allocator *hook,
                              ovr_error *err)
{
    ovr_material_range range = about(0);
    ovr_material_history *p = ovr_material_history_create(options, &range, hook,
                                                          err);
    ovr_material_history_free(p);
    return p ? OVR_OK : err->status;
}

TEST(memory_may_run_out)
{
    ovr_stress_options o = level8();
    o.mesh = 5.5 / 112;
    o.nodes = 113;
    assert_true(test_every_allocation(try_to_make, &o) > 1);
}
