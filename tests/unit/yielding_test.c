/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Plastic material: first yield, shakedown in rolling, collapse of a strip,
 * hardening in uniaxial stress, a window compared with its mirror image. */
#include <math.h>
#include <string.h>

#include "stress/stress.h"
#include "stress/yielding.h"
#include "support/test.h"

static const double nu = 0.3;

static ovr_yielding *make(size_t points, double mesh, size_t layers,
                          const double *edge, ovr_hardening hardening,
                          int iterations, double enough)
{
    const ovr_yielding_options o = {points, mesh,      layers,     edge,
                                    nu,     hardening, iterations, enough};
    ovr_error err;
    ovr_yielding *y = ovr_yielding_create(&o, NULL, &err);
    assert_non_null(y);
    return y;
}

static void set(ovr_yielding *y, size_t j, size_t i, ovr_in_plane s)
{
    const ovr_layer_load *load = ovr_yielding_load(y, j);
    load->h[i] = (float)s.h;
    load->d[i] = (float)s.d;
    load->tau[i] = (float)s.tau;
}

/* ------------------------------------------------- rolling, the same along x
 */

enum { LAYERS = 60 };
static const double thick = 0.025, stride = 0.02;

typedef struct rolled {
    double first, last, x_min, z_min, x_half, y_half;
} rolled;

/* p0 = 1 over a body of k = 1/ratio, so many times. */
static rolled roll(double ratio, int passes)
{
    double edge[LAYERS + 1], Y = sqrt(3) / ratio;
    rolled r = {.x_min = 0};
    for (int j = 0; j <= LAYERS; j++)
        edge[j] = j * thick;
    ovr_yielding *y = make(4, 1, LAYERS, edge, (ovr_hardening){.yield = Y}, 40,
                           1e-6);
    for (int pass = 1; pass <= passes; pass++) {
        double before[LAYERS], maximum = 0;
        for (size_t j = 0; j < LAYERS; j++)
            before[j] = ovr_yielding_strain(y, j, 1).all;
        for (double x = -5; x <= 5; x += stride) {
            for (size_t j = 0; j < LAYERS; j++)
                for (size_t i = 0; i < 4; i++)
                    set(y, j, i,
                        ovr_hertz_stress(1, 0, x, ((double)j + .5) * thick));
            assert_true(ovr_yielding_flow(y).work >= 0);
        }
        for (size_t j = 0; j < LAYERS; j++)
            maximum = fmax(maximum,
                           ovr_yielding_strain(y, j, 1).all - before[j]);
        r.last = maximum;
        if (pass == 1)
            r.first = maximum;
    }
    for (size_t j = 0; j < LAYERS; j++) {
        ovr_stressed s = ovr_yielding_residual(y, j, 2);
        if (s.x < r.x_min) {
            r.x_min = s.x;
            r.z_min = ((double)j + .5) * thick;
        }
        CHECK_NEAR(s.z, 0, 1e-12);
        CHECK_NEAR(s.xz, 0, 1e-12);
    }
    ovr_stressed a = ovr_yielding_residual(y, 19, 0);
    ovr_stressed b = ovr_yielding_residual(y, 20, 0);
    r.x_half = (a.x + b.x) / 2;
    r.y_half = (a.y + b.y) / 2;
    ovr_yielding_free(y);
    return r;
}

/* An independent computation's numbers: 2 % (its step of the path 0.02, layers
 * of 0.025, the same here).  Above 4 k shear that nothing holds goes on as long
 * as it is let: 40 iterations, as there. */
TEST(rolling)
{
    static const struct {
        double ratio, first, last, x_min, z_min, x_half, y_half;
    } truth[] = {
        {3.15, 0.01198, 0, -0.008439, 0.7125, 0, 0},
        {3.8, 0.446286, 0, -0.101488, 0.7875, -0.072658, -0.113954},
        {4.02, 2.087345, 0.742167, -0.149005, 0.5625, -0.131777, -0.212452}};
    for (size_t i = 0; i < 3; i++) {
        rolled r = roll(truth[i].ratio, 6);
        CHECK_NEAR(r.first, truth[i].first, 0.02 * truth[i].first);
        CHECK_NEAR(r.x_min, truth[i].x_min, 0.02 * -truth[i].x_min);
        CHECK_NEAR(r.z_min, truth[i].z_min, i < 2 ? 1e-9 : 0.05);
        CHECK_NEAR(r.x_half, truth[i].x_half, 0.02 * -truth[i].x_half + 1e-9);
        CHECK_NEAR(r.y_half, truth[i].y_half, 0.02 * -truth[i].y_half + 1e-9);
        assert_true(truth[i].last > 0 ? r.last > 0.1 : r.last < 1e-4 * r.first);
    }
}

/* Melan's limit of 4 k, and the residual stresses there (K. L. Johnson, Contact
 * Mechanics, 1985, section 9.2). */
TEST(shakedown)
{
    rolled below = roll(3.98, 8), above = roll(4.02, 8);
    assert_true(below.first > 0.1);
    assert_true(below.last < 1e-3 * below.first);
    assert_true(above.last > 0.1);
    CHECK_NEAR(above.x_half, -0.134, 0.03 * 0.134);
    CHECK_NEAR(above.y_half, -0.2134, 0.03 * 0.2134);
}

TEST(first_yield)
{
    CHECK_NEAR(roll(3.10, 1).first, 0, 0);
    rolled r = roll(3.115, 1);
    assert_true(r.first > 0);
    CHECK_NEAR(r.z_min, 0.7043, thick);
}

/* --------------------------------------------------------- a strip, and more
 */

/* Below uniform pressure p on |x| < a (K. L. Johnson, section 2.5). */
static ovr_in_plane below_strip(double p, double a, double x, double z)
{
    double one = atan2(z, x - a), two = atan2(z, x + a);
    double angle = one - two, pi = acos(-1.0);
    double c = sin(2 * one) - sin(2 * two);
    double sx = -p / (2 * pi) * (2 * angle + c);
    double sz = -p / (2 * pi) * (2 * angle - c);
    double tau = p / (2 * pi) * (cos(2 * one) - cos(2 * two));
    return (ovr_in_plane){-(sx + sz) / 2, (sx - sz) / 2, tau};
}

enum { POINTS = 256, DEPTHS = 24 };

/* The window is 3 wide, its middle at x = 0. */
static double at_point(size_t i)
{
    return 3. * ((double)i / POINTS - 0.5);
}

static ovr_yielding *pressed(double p, double x0, ovr_hardening h, int times,
                             ovr_flowed *flowed)
{
    double edge[DEPTHS + 1];
    ovr_yielding_layers(DEPTHS, 0.012, 1.5, edge);
    ovr_yielding *y = make(POINTS, 3. / POINTS, DEPTHS, edge, h, times, 0);
    for (size_t j = 0; j < DEPTHS; j++)
        for (size_t i = 0; i < POINTS; i++)
            set(y, j, i,
                below_strip(p, 0.15, at_point(i) - x0,
                            (edge[j] + edge[j + 1]) / 2));
    *flowed = ovr_yielding_flow(y);
    return y;
}

static double max_flowed(const ovr_yielding *y)
{
    double maximum = 0;
    for (size_t j = 0; j < DEPTHS; j++)
        for (size_t i = 0; i < POINTS; i++)
            maximum = fmax(maximum, ovr_yielding_strain(y, j, i).all);
    return maximum;
}

/* First yield at 1.70 Y, collapse at 2.97 Y. Below 2.97 Y the plastic flow of a
 * body without hardening ends, above it continues. */
TEST(strip)
{
    const ovr_hardening perfect = {.yield = 1};
    ovr_flowed flowed;
    ovr_yielding_free(pressed(1.69, 0, perfect, 8, &flowed));
    assert_int_equal(flowed.iterations, 0);
    ovr_yielding_free(pressed(1.8, 0, perfect, 8, &flowed));
    assert_true(flowed.points > 0);
    double some[2], many[2];
    const double p[] = {2.5, 3.3};
    for (int k = 0; k < 2; k++) {
        ovr_yielding *y = pressed(p[k], 0, perfect, 300, &flowed);
        some[k] = max_flowed(y);
        ovr_yielding_free(y);
        y = pressed(p[k], 0, perfect, 600, &flowed);
        many[k] = max_flowed(y);
        ovr_yielding_free(y);
    }
    assert_true(many[0] < 1.05 * some[0]);
    assert_true(many[1] > 1.5 * some[1]);
}

/* What is pressed from the other side is the mirror image, to rounding of the
 * floats that the stresses are given in. */
TEST(mirror)
{
    const ovr_hardening h = {
        .law = OVR_HARDENS_LINEAR, .yield = 1, .modulus = 0.05};
    ovr_flowed flowed;
    ovr_yielding *a = pressed(2.1, 0.3, h, 100, &flowed);
    ovr_yielding *b = pressed(2.1, -0.3, h, 100, &flowed);
    const double *w = ovr_yielding_sinking(a), *v = ovr_yielding_sinking(b);
    assert_true(flowed.points > 10);
    assert_true(flowed.work > 0);
    assert_true(flowed.left < 1e-3);
    for (size_t i = 1; i < POINTS; i++) {
        size_t o = POINTS - i;
        CHECK_NEAR(w[i], v[o], 1e-6);
        for (size_t j = 0; j < DEPTHS; j++) {
            ovr_strained e = ovr_yielding_strain(a, j, i);
            ovr_strained f = ovr_yielding_strain(b, j, o);
            CHECK_NEAR(e.x, f.x, 1e-5);
            CHECK_NEAR(e.z, f.z, 1e-5);
            CHECK_NEAR(e.xz, -f.xz, 1e-5);
            ovr_stressed s = ovr_yielding_residual(a, j, i);
            ovr_stressed t = ovr_yielding_residual(b, j, o);
            CHECK_NEAR(s.y, t.y, 1e-5);
            CHECK_NEAR(s.xz, -t.xz, 1e-5);
        }
    }
    assert_true(w[(size_t)(0.6 * POINTS)] > 0); /* x = 0.3: it sinks */
    ovr_yielding_free(a);
    ovr_yielding_free(b);
}

/* Strains alone make up the state: set elsewhere, all is the same, to the bit.
 */
TEST(state_is_strain)
{
    const ovr_hardening h = {
        .law = OVR_HARDENS_KINEMATIC, .yield = 1, .modulus = 0.1};
    ovr_flowed flowed;
    ovr_yielding *a = pressed(2.4, 0.1, h, 8, &flowed);
    ovr_yielding *b = pressed(0.1, 0, h, 8, &flowed);
    for (size_t j = 0; j < DEPTHS; j++)
        memcpy(ovr_yielding_strains(b, j), ovr_yielding_strains(a, j),
               4 * POINTS * sizeof(double));
    ovr_yielding_settle(b);
    assert_memory_equal(ovr_yielding_sinking(a), ovr_yielding_sinking(b),
                        POINTS * sizeof(double));
    for (size_t j = 0; j < DEPTHS; j++)
        for (size_t i = 0; i < POINTS; i++) {
            ovr_stressed s = ovr_yielding_residual(a, j, i);
            ovr_stressed t = ovr_yielding_residual(b, j, i);
            assert_memory_equal(&s, &t, sizeof s);
        }
    ovr_yielding_free(a);
    ovr_yielding_free(b);
}

/* ------------------------------------------------------------ at one point */

/* Pure shear held to a stress: Y(e) of the flow that it takes. */
TEST(hardening)
{
    const ovr_hardening law[] = {
        {.law = OVR_HARDENS_LINEAR, .yield = 1, .modulus = 0.2},
        {.law = OVR_HARDENS_KINEMATIC, .yield = 1, .modulus = 0.2},
        {.law = OVR_HARDENS_SWIFT,
         .strength = 0.8,
         .offset = 20,
         .power = 0.1,
         .microstrain = 5100}};
    for (int k = 0; k < 3; k++) {
        ovr_strained e = {0};
        const ovr_stressed s = {.xz = 1.3 / sqrt(3)};
        double work = 0;
        for (int i = 0; i < 2000; i++)
            ovr_plastic_flow(&law[k], nu, s, &e, &work);
        double all = k < 2 ? 0.3 / 0.2 : (pow(1.3 / 0.8, 10) - 20) / 5100;
        CHECK_NEAR(e.all, all, 1e-4 * all + 1e-5);
        CHECK_NEAR(2 * e.xz / sqrt(3), all, 1e-4 * all + 1e-5);
        CHECK_NEAR(work, 1.3 * all, 1e-3 * all);
        CHECK_NEAR(e.x, 0, 0);
        /* the other way: kinematic hardening flows 2 Y below */
        const ovr_stressed back = {.xz = -0.75 / sqrt(3)};
        bool flows = ovr_plastic_flow(&law[k], nu, back, &e, &work) > 0;
        assert_int_equal(flows, k == 1);
    }
}
