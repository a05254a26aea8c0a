/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Stresses of a snapshot: closed forms, direct sums, identities, order. */
#include <complex.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "reference/stress_snapshot.h"
#include "reference/stress_truth.h"
#include "stress/circle.h"
#include "stress/element.h"
#include "stress/loops.h"
#include "stress/stress.h"
#include "support/test.h"

#define ROWS(table) (sizeof(table) / sizeof(table)[0])
static const double pi = 3.14159265358979323846;
static const double D8 = 5.5 / 1792;

static void check_stress(ovr_in_plane s, const double *truth, double tolerance)
{
    CHECK_NEAR(s.d - s.h, truth[0], tolerance);
    CHECK_NEAR(-s.d - s.h, truth[1], tolerance);
    CHECK_NEAR(s.tau, truth[2], tolerance);
}

/* ------------------------------------------------------------ closed forms */

TEST(hats_and_hertz_are_exact)
{
    for (size_t k = 0; k < ROWS(truth_hat_normal); k++) {
        const double *r = truth_hat_normal[k], *q = truth_hat_shear[k];
        check_stress(ovr_element_stress(OVR_ELEMENT_HAT, 1, 1, 0, r[0], r[1]),
                     r + 2, 1e-12);
        check_stress(ovr_element_stress(OVR_ELEMENT_HAT, 1, 0, 1, q[0], q[1]),
                     q + 2, 1e-12);
    }
    for (size_t k = 0; k < ROWS(truth_hertz_normal); k++) {
        const double *r = truth_hertz_normal[k], *q = truth_hertz_shear_unit[k];
        check_stress(ovr_hertz_stress(1, 0, r[0], r[1]), r + 2, 1e-12);
        check_stress(ovr_hertz_stress(0, 1, q[0], q[1]), q + 2, 1e-12);
    }
}

/* Other densities' potentials give their stresses by the same equations. */
TEST(equations_hold_for_other_densities)
{
    for (size_t k = 0; k < ROWS(truth_strip_normal); k++) {
        const double *r = truth_strip_normal[k], *q = truth_strip_shear[k];
        double complex w = r[0] + I * r[1], both = clog(w - 1) - clog(w + 1);
        ovr_potential none = {0, 0};
        ovr_potential strip = {both / (pi * I),
                               (1 / (w - 1) - 1 / (w + 1)) / (pi * I)};
        check_stress(ovr_stress_of(r[1], strip, none), r + 2, 1e-12);
        check_stress(ovr_stress_of(q[1], none, strip), q + 2, 1e-12);
        const double *b = truth_parabola_normal[k];
        ovr_potential parabola = {((1 - w * w) * both - 2 * w) / (pi * I),
                                  (-2 * w * both - 4) / (pi * I)};
        check_stress(ovr_stress_of(b[1], parabola, none), b + 2, 1e-12);
    }
}

/* Far off an element is a point; the spline's moments vanish to the third. */
TEST(elements_are_points_from_far)
{
    for (double x = -90; x <= 90; x += 30) {
        ovr_in_plane point = ovr_element_stress(OVR_ELEMENT_POINT, 1, 1, 1, x,
                                                40);
        ovr_in_plane spline = ovr_element_stress(OVR_ELEMENT_SPLINE, 1, 1, 1, x,
                                                 40);
        CHECK_NEAR(spline.h, point.h, 1e-8);
        CHECK_NEAR(spline.d, point.d, 1e-8);
        CHECK_NEAR(spline.tau, point.tau, 1e-8);
    }
    /* where the change is */
    ovr_in_plane in = ovr_element_stress(OVR_ELEMENT_SPLINE, 1, 1, 0, 100, 2);
    ovr_in_plane out = ovr_element_stress(OVR_ELEMENT_POINT, 1, 1, 0, 100, 2);
    CHECK_NEAR(in.h, out.h, 1e-8);
}

/* --------------------------------------------------------------- direct sums
 */

static ovr_in_plane direct(ovr_element element, double D, size_t n,
                           const double *P, const double *Q, double x, double z)
{
    ovr_in_plane sum = {0, 0, 0};
    for (size_t j = 0; j < n; j++) {
        ovr_in_plane one = ovr_element_stress(element, D, P[j], Q ? Q[j] : 0,
                                              x - (double)j * D, z);
        sum.h += one.h;
        sum.d += one.d;
        sum.tau += one.tau;
    }
    return sum;
}

/* Pressure linear between the nodes, as the truth summed it. */
TEST(hats_sum_to_the_truth)
{
    for (size_t k = 0; k < ROWS(snapshot_linear); k++) {
        const double *r = snapshot_linear[k];
        ovr_in_plane s = direct(OVR_ELEMENT_HAT, D8, SNAPSHOT_NODES,
                                snapshot_pressure, NULL, r[0] * D8, r[1]);
        check_stress(s, r + 2, 1e-11);
    }
}

/* cos kx over infinity is cos kx cut off smoothly, far away. */
static double cut_cosine(double k, double x)
{
    return cos(k * x) * exp(-pow(x / 2.8, 6));
}

TEST(waves_have_their_fourier_integral)
{
    enum { NODES = 6145 };
    static double P[NODES];
    const double D = 12. / (NODES - 1), k = 2 * pi / 0.25;
    for (size_t j = 0; j < NODES; j++)
        P[j] = cut_cosine(k, -6 + (double)j * D);
    for (size_t i = 0; i < ROWS(truth_cosine); i++) {
        const double *r = truth_cosine[i];
        static double none[NODES];
        ovr_in_plane p = direct(OVR_ELEMENT_AUTO, D, NODES, P, NULL, r[0] + 6,
                                r[1]);
        ovr_in_plane q = direct(OVR_ELEMENT_AUTO, D, NODES, none, P, r[0] + 6,
                                r[1]);
        check_stress(p, r + 2, 1e-6);
        check_stress(q, r + 5, 1e-6);
    }
}

/* (1 - x^2)^3: hats err with D^2, splines with D^4. */
static double error_of(ovr_element element, int n, double z)
{
    double worst = 0, D[2] = {2. / n, 2. / (8 * n)};
    for (double x = -1.3; x < 1.4; x += 0.37) {
        ovr_in_plane s[2] = {{0, 0, 0}, {0, 0, 0}};
        for (int which = 0; which < 2; which++)
            for (int j = 0; j <= (which ? 8 * n : n); j++) {
                double at = -1 + j * D[which];
                double p = pow(1 - at * at, 3);
                ovr_in_plane one = ovr_element_stress(
                    which ? OVR_ELEMENT_SPLINE : element, D[which], p, 0,
                    x - at, z);
                s[which].h += one.h;
                s[which].d += one.d;
                s[which].tau += one.tau;
            }
        worst = fmax(worst, fabs(s[0].h - s[1].h));
        worst = fmax(worst, fabs(s[0].d - s[1].d));
        worst = fmax(worst, fabs(s[0].tau - s[1].tau));
    }
    return worst;
}

TEST(elements_have_their_order)
{
    double hats = log2(error_of(OVR_ELEMENT_HAT, 32, 0.05) /
                       error_of(OVR_ELEMENT_HAT, 64, 0.05));
    double splines = log2(error_of(OVR_ELEMENT_SPLINE, 24, 0.05) /
                          error_of(OVR_ELEMENT_SPLINE, 48, 0.05));
    CHECK_NEAR(hats, 2, 0.2);
    CHECK_NEAR(splines, 4, 0.6);
}

/* ----------------------------------------------------------------- the fields
 */

static ovr_stress_options level8(void)
{
    ovr_stress_options o = ovr_stress_options_default();
    o.mesh = D8;
    o.inlet = -4;
    o.nodes = SNAPSHOT_NODES;
    return o;
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

/* One depth alone, so that it is the truth's. */
static ovr_in_plane field_at(double z, double X)
{
    ovr_stress_options o = level8();
    o.depth_min = o.depth_max = z;
    ovr_stress *s = made(&o);
    ovr_stress_solve(s, snapshot_pressure, NULL, 0, OVR_STRESS_ALL_LEVELS);
    ovr_stress_row row = ovr_stress_at(s, 0);
    double D = row.step;
    /* nodes of a coarse row: turn them onto X */
    double shift = fmod((X - row.start) / D8, D / D8);
    ovr_stress_solve(s, snapshot_pressure, NULL, shift, OVR_STRESS_ALL_LEVELS);
    row = ovr_stress_at(s, 0);
    ovr_in_plane result = value(&row, (size_t)lround((X - row.start) / D));
    ovr_stress_free(s);
    return result;
}

TEST(fields_meet_the_truth)
{
    for (size_t k = 0; k < ROWS(snapshot_spline); k++) {
        const double *r = snapshot_spline[k];
        double X = -4 + r[0] * D8;
        /* floats carry 2e-7; near the surface the two splines differ where
         * the pressure has kinks */
        double tolerance = r[1] >= 9 * D8 ? 2e-6 : r[1] >= 3 * D8 ? 3e-5 : 2e-3;
        check_stress(field_at(r[1], X), r + 2, tolerance);
    }
}

/* A node's fields less direct sums. */
static double off_the_sum(const ovr_stress_row *row, size_t i, const double *P,
                          const double *Q)
{
    double X = row->start + (double)i * row->step;
    ovr_in_plane a = value(row, i);
    /* a spline turned is not a sum of points up here */
    ovr_in_plane b = direct(OVR_ELEMENT_POINT, D8, SNAPSHOT_NODES, P, Q, X + 4,
                            row->z);
    return fmax(fabs(a.tau - b.tau), fmax(fabs(a.h - b.h), fabs(a.d - b.d)));
}

/* Whole fields against direct sums: what the cut transforms lose, with nodes
 * turned by any part of a mesh. */
static double worst_against_sums(ovr_stress *s, const double *P,
                                 const double *Q, double shift)
{
    double worst = 0;
    size_t depths = ovr_stress_depths(s, NULL);
    ovr_stress_solve(s, P, Q, shift, OVR_STRESS_ALL_LEVELS);
    for (size_t j = 0; j < depths; j += 3) {
        ovr_stress_row row = ovr_stress_at(s, j);
        for (size_t i = 1; row.start + (double)i * row.step < 2.6; i += 97)
            worst = fmax(worst, off_the_sum(&row, i, P, Q));
    }
    return worst;
}

TEST(cut_transforms_are_the_sums)
{
    ovr_stress_options o = level8();
    static double Q[SNAPSHOT_NODES];
    for (size_t j = 0; j < SNAPSHOT_NODES; j++)
        Q[j] = 0.1 * snapshot_pressure[j];
    ovr_stress *s = made(&o);
    CHECK_NEAR(worst_against_sums(s, snapshot_pressure, NULL, 0), 0, 2e-6);
    ovr_stress_free(s);
    o.traction = true;
    s = made(&o);
    CHECK_NEAR(worst_against_sums(s, snapshot_pressure, Q, 0), 0, 2e-6);
    ovr_stress_free(s);
    /* a turn is exact for what the mesh carries: from 9 D downward */
    o.traction = false;
    o.depth_min = 9 * D8;
    s = made(&o);
    CHECK_NEAR(worst_against_sums(s, snapshot_pressure, NULL, 0.37), 0, 2e-6);
    CHECK_NEAR(worst_against_sums(s, snapshot_pressure, NULL, 29.81), 0, 2e-6);
    ovr_stress_free(s);
}

/* Between the nodes that a deep field is kept at it is whole too. */
TEST(every_node_is_the_sums)
{
    ovr_stress_options o = level8();
    double worst = 0;
    ovr_error err;
    ovr_stress *s = made(&o);
    ovr_stress_solve(s, snapshot_pressure, NULL, 0, OVR_STRESS_ALL_LEVELS);
    for (size_t j = 0; j < ovr_stress_depths(s, NULL); j += 2) {
        ovr_stress_row row;
        CHECK_OK(ovr_stress_at_every_node(s, j, &row, &err), &err);
        CHECK_CLOSE(row.step, D8, 1e-12);
        for (size_t i = 1; row.start + (double)i * D8 < 2.6; i += 31)
            worst = fmax(worst, off_the_sum(&row, i, snapshot_pressure, NULL));
    }
    CHECK_NEAR(worst, 0, 2e-6);
    ovr_stress_free(s);
}

/* Everything that two sets of fields differ by, with tau's sign. */
static double difference(const ovr_stress *a, const ovr_stress *b,
                         bool mirrored)
{
    double worst = 0;
    for (size_t j = 0; j < ovr_stress_depths(a, NULL); j++) {
        ovr_stress_row r = ovr_stress_at(a, j), s = ovr_stress_at(b, j);
        size_t count = (size_t)(5.2 / r.step) + 1;
        for (size_t i = 0; i < count; i++) {
            ovr_in_plane u = value(&r, i);
            ovr_in_plane v = value(&s, mirrored ? count - 1 - i : i);
            worst = fmax(worst, fabs(u.h - v.h));
            worst = fmax(worst, fabs(u.d - v.d));
            worst = fmax(worst, fabs(u.tau - (mirrored ? -v.tau : v.tau)));
        }
    }
    return worst;
}

TEST(a_mirrored_pressure_mirrors_the_field)
{
    enum { NODES = 1665 };
    ovr_stress_options o = ovr_stress_options_default();
    static double P[NODES], back[NODES];
    uint64_t seed = 7;
    o.mesh = 2.6 / ((NODES - 1) / 2);
    o.inlet = -2.6;
    o.nodes = NODES;
    for (size_t j = 0; j < NODES; j++) {
        double X = -2.6 + (double)j * o.mesh;
        P[j] = X * X < 1 ? sqrt(1 - X * X) * (1 + 0.3 * sin(9 * X + 1)) : 0;
        P[j] += fabs(X) < 1 ? 0.1 * test_random(&seed, 0, 1) : 0;
        back[NODES - 1 - j] = P[j];
    }
    ovr_stress *a = made(&o), *b = made(&o);
    ovr_stress_solve(a, P, NULL, 0, OVR_STRESS_ALL_LEVELS);
    ovr_stress_solve(b, back, NULL, 0, OVR_STRESS_ALL_LEVELS);
    CHECK_NEAR(difference(a, b, true), 0, 3e-6);
    ovr_stress_free(a);
    ovr_stress_free(b);
}

TEST(fields_superpose)
{
    static double P[3][SNAPSHOT_NODES];
    ovr_stress_options o = level8();
    ovr_stress *s[3];
    uint64_t seed = 3;
    for (size_t j = 0; j < SNAPSHOT_NODES; j++) {
        P[0][j] = test_random(&seed, 0, 1);
        P[1][j] = snapshot_pressure[j];
        P[2][j] = P[0][j] + P[1][j];
    }
    for (int k = 0; k < 3; k++) {
        s[k] = made(&o);
        ovr_stress_solve(s[k], P[k], NULL, 0, OVR_STRESS_ALL_LEVELS);
    }
    for (size_t j = 0; j < ovr_stress_depths(s[0], NULL); j++) {
        ovr_stress_row a = ovr_stress_at(s[0], j), b = ovr_stress_at(s[1], j);
        ovr_stress_row c = ovr_stress_at(s[2], j);
        for (size_t i = 0; i < c.count; i++) {
            CHECK_NEAR(value(&a, i).tau + value(&b, i).tau, value(&c, i).tau,
                       2e-6);
            CHECK_NEAR(value(&a, i).h + value(&b, i).h, value(&c, i).h, 3e-6);
        }
    }
    for (int k = 0; k < 3; k++)
        ovr_stress_free(s[k]);
}

/* Equal inputs give equal bits, also of another object; and levels that are
 * not asked for keep what they hold. */
TEST(bits_stay)
{
    ovr_stress_options o = level8();
    ovr_stress *a = made(&o), *b = made(&o);
    static double none[SNAPSHOT_NODES];
    ovr_stress_solve(a, snapshot_pressure, NULL, 3.3, OVR_STRESS_ALL_LEVELS);
    ovr_stress_solve(b, none, NULL, 0, OVR_STRESS_ALL_LEVELS);
    ovr_stress_solve(b, snapshot_pressure, NULL, 3.3, 1u << 0 | 1u << 3);
    for (size_t j = 0; j < ovr_stress_depths(a, NULL); j++) {
        ovr_stress_row r = ovr_stress_at(a, j), s = ovr_stress_at(b, j);
        bool same = !memcmp(r.shear, s.shear, 2 * r.count * sizeof(float));
        assert_int_equal(same, r.level == 0 || r.level == 3);
    }
    ovr_stress_free(a);
    ovr_stress_free(b);
}

/* -------------------------------------------------------------- the loops */

enum { LOOP = 203 };

static void random_floats(uint64_t *seed, size_t n, float *v)
{
    for (size_t k = 0; k < n; k++)
        v[k] = (float)test_random(seed, -1, 1);
}

static void near_floats(size_t n, const float *a, const float *b)
{
    for (size_t k = 0; k < n; k++)
        CHECK_NEAR((double)a[k], (double)b[k], 2e-6);
}

/* Extents of paths, high above low. */
static void compare_circles(const ovr_stress_loops *a,
                            const ovr_stress_loops *b)
{
    enum { ROWS_OF = 2 * OVR_HALF_DIRECTIONS };
    static float rows[ROWS_OF * LOOP], A[LOOP], B[LOOP];
    uint64_t seed = 13;
    for (size_t i = 0; i < LOOP; i++)
        for (size_t m = 0; m < OVR_HALF_DIRECTIONS; m++) {
            double low = test_random(&seed, -1, 0.5);
            rows[(m + OVR_HALF_DIRECTIONS) * LOOP + i] = (float)low;
            rows[m * LOOP + i] = (float)(low + test_random(&seed, 0, 1));
        }
    a->circles(LOOP, rows, LOOP, A);
    b->circles(LOOP, rows, LOOP, B);
    near_floats(LOOP, A, B);
    b->circles(5, rows + 3, LOOP, B); /* fewer than a vector holds */
    near_floats(5, A + 3, B);
}

static void compare_loops(const ovr_stress_loops *a, const ovr_stress_loops *b)
{
    static float in[6][2 * LOOP], A[6][2 * LOOP], B[6][2 * LOOP];
    uint64_t seed = 11;
    for (int k = 0; k < 6; k++)
        random_floats(&seed, (size_t)2 * LOOP, in[k]);
    ovr_bins p = {in[0], in[1]}, u = {in[2], in[3]}, v = {in[4], in[5]};
    ovr_load_bins load[] = {{p, u, v}, {u, v, p}};
    for (size_t loads = 1; loads <= 2; loads++) {
        a->spread(LOOP / 2, LOOP - 1, load, loads, A[0]);
        b->spread(LOOP / 2, LOOP - 1, load, loads, B[0]);
        near_floats((size_t)2 * LOOP, A[0], B[0]);
    }
    ovr_state_constants c = {0.3F, 0.1F, 0.1F, -0.2F};
    ovr_node_states to_a = {A[0], A[1], A[2], A[3], A[4], A[5]};
    ovr_node_states to_b = {B[0], B[1], B[2], B[3], B[4], B[5]};
    a->states(LOOP, in[0], in[1], &c, &to_a);
    b->states(LOOP, in[0], in[1], &c, &to_b);
    for (int k = 0; k < 6; k++)
        near_floats(LOOP, A[k], B[k]);
    a->extents(LOOP, in[0], in[1], 0.6F, 0.8F, A[0], A[1]);
    b->extents(LOOP, in[0], in[1], 0.6F, 0.8F, B[0], B[1]);
    a->raise(LOOP, in[3], A[2]);
    b->raise(LOOP, in[3], B[2]);
    a->lower(LOOP, in[4], A[3]);
    b->lower(LOOP, in[4], B[3]);
    for (int k = 0; k < 4; k++)
        near_floats(LOOP, A[k], B[k]);
    assert_true(a->largest(LOOP, in[5]) == b->largest(LOOP, in[5]));
    compare_circles(a, b);
}

TEST(every_instruction_set_agrees)
{
    static const char *const names[] = {"base", "avx2", "avx512"};
    for (size_t k = 0; k < 3; k++) {
        const ovr_stress_loops *loops = ovr_stress_loops_choose(names[k]);
        if (loops)
            compare_loops(loops, ovr_stress_loops_choose("plain"));
    }
}

/* ------------------------------------------------------------------ refusals
 */

static void refuses(ovr_stress_options o, const char *part)
{
    ovr_error err;
    assert_null(ovr_stress_create(&o, NULL, &err));
    CHECK_ERROR(&err, OVR_BAD_INPUT, part);
    assert_true(isnan(ovr_stress_memory(&o)));
}

/* int (A - A_u) dz with A_u = A_0 + s z, which is a polynomial. */
TEST(limits_by_depth_enter_the_risk)
{
    const double at[] = {0.1, 2}, limits[] = {0.1, 0.29};
    double z[21], A[21], risk[21];
    ovr_life_options life = ovr_life_options_default();
    life.exponent = 1;
    life.depth_exponent = 0;
    life.limits = 2;
    life.limit_z = at;
    life.limit_A = limits;
    for (int j = 0; j < 21; j++) {
        z[j] = 0.1 * exp2(0.2 * j);
        A[j] = 0.5;
    }
    ovr_risk(&life, 21, z, A, risk);
    CHECK_CLOSE(risk[0], 0.41 * (z[20] - 0.1) - 0.05 * (z[20] * z[20] - 0.01),
                1e-12);
    life.limits = 1; /* one: the same at all depths */
    ovr_risk(&life, 21, z, A, risk);
    CHECK_CLOSE(risk[0], 0.4 * (z[20] - 0.1), 1e-12);
    life.limit_A = NULL;
    ovr_risk(&life, 21, z, A, risk);
    assert_true(isnan(risk[0]));
}

TEST(nonsense_is_refused)
{
    ovr_stress_options o = level8();
    o.depth_min = D8 / 3;
    refuses(o, "less than D/2");
    o = level8();
    o.depth_max = D8;
    refuses(o, "depth_max");
    o = level8();
    o.per_octave = 0;
    refuses(o, "depths_per_octave");
    o = level8();
    o.to = o.from;
    refuses(o, "must be below the upper limit");
    o = level8();
    o.mesh = 0;
    refuses(o, "mesh");
}

static ovr_status try_to_make(void *options, const ovr_allocator *hook,
                              ovr_error *err)
{
    ovr_stress *s = ovr_stress_create(options, hook, err);
    ovr_stress_free(s);
    return s ? OVR_OK : err->status;
}

TEST(memory_may_run_out)
{
    ovr_stress_options o = level8();
    o.mesh = 5.5 / 112;
    o.nodes = 113;
    assert_true(test_every_allocation(try_to_make, &o) > 1);
}

/* The predicted memory agrees with the allocated memory within 10 %. */
TEST(memory_is_predicted)
{
    ovr_stress_options o = level8();
    test_faults faults;
    ovr_error err;
    test_faults_init(&faults);
    ovr_stress *s = ovr_stress_create(&o, &faults.hook, &err);
    assert_non_null(s);
    /* a scratch line of potentials is freed again */
    double kept = faults.bytes - 32. * 4096;
    CHECK_CLOSE(ovr_stress_memory(&o), kept, 0.1);
    ovr_stress_free(s);
}
