/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Residual stresses of plastic strains compared with an independent
 * computation; means compared with quadrature, energy, and the free surface. */
#include <math.h>

#include "stress/yielding.h"
#include "support/test.h"

static const double nu = 0.3;

/* By quadrature of the Green's function, k = 3, strain in 0.2 < z < 0.4, nu =
 * 0.3: strain x, z, xz at z = 0.1 and 0.3; sx, sz, t and the sinking. */
static const struct {
    ovr_plastic_strain e;
    double z, x, zz, t, w;
} truth[] = {
    {{1, 0, 0},
     0.1,
     0.1791160084936423,
     -0.006521281648543549,
     -0.04586468089814272,
     0.03880812729028932},
    {{1, 0, 0},
     0.3,
     -0.39396513150052104,
     -0.04385084455622111,
     0.011983767561935837,
     0.03880812729028932},
    {{0, 1, 0},
     0.1,
     -0.024215336501177298,
     -0.0016277906701860287,
     -0.006309871322707482,
     -0.10483944040544249},
    {{0, 1, 0},
     0.3,
     0.12179953888274148,
     -0.0034445773096409118,
     -0.028091564665207527,
     -0.10483944040544249},
    {{0, 0, 1},
     0.1,
     -0.20333134499481956,
     0.004893490978357515,
     0.039554809575435244,
     -0.14364756769573178},
    {{0, 0, 1},
     0.3,
     -0.0028080840939399138,
     0.07734258036034698,
     0.182170133977372,
     -0.14364756769573178},
};

TEST(closed_forms)
{
    const ovr_strained_layer layer = {0.2, 0.4};
    for (size_t i = 0; i < sizeof truth / sizeof *truth; i++) {
        ovr_residual_stress s = ovr_residual_at(3, nu, layer, truth[i].e,
                                                truth[i].z);
        CHECK_NEAR(s.x, truth[i].x, 1e-10);
        CHECK_NEAR(s.z, truth[i].zz, 1e-10);
        CHECK_NEAR(s.xz, truth[i].t, 1e-10);
        CHECK_NEAR(ovr_plastic_sinking(3, nu, layer, truth[i].e), truth[i].w,
                   1e-10);
    }
}

/* Means over a layer beside the strained one, over itself and over a part of
 * it that the strain fills, against Simpson's rule of the closed forms. */
TEST(means)
{
    const ovr_strained_layer source = {0.2, 0.4},
                             to[] = {{0, 0.2}, {0.2, 0.4}, {0.4, 0.43}};
    const ovr_plastic_strain e = {0.7, -0.4, 0.3};
    enum { PARTS = 400 };
    for (double k = 0.5; k < 60; k *= 2.7)
        for (size_t i = 0; i < sizeof to / sizeof *to; i++) {
            double x = 0, z = 0, t = 0, h = to[i].bottom - to[i].top;
            for (int j = 0; j <= PARTS; j++) {
                double ends = j == 0 ? 1e-13 : j == PARTS ? -1e-13 : 0;
                double at = to[i].top + h * j / PARTS + ends;
                double weight = j == 0 || j == PARTS ? 1 : j % 2 ? 4 : 2;
                ovr_residual_stress s = ovr_residual_at(k, nu, source, e, at);
                x += weight * s.x / (3 * PARTS);
                z += weight * s.z / (3 * PARTS);
                t += weight * s.xz / (3 * PARTS);
            }
            ovr_residual_stress s = ovr_residual_mean(k, nu, source, e, to[i]);
            CHECK_NEAR(s.x, x, 2e-9);
            CHECK_NEAR(s.z, z, 2e-9);
            CHECK_NEAR(s.xz, t, 2e-9);
        }
}

/* The surface is free, and equilibrium holds: sx k + t' = 0, sz' = k t with
 * e^ikx and tau = i t, by differences of second order. */
TEST(equilibrium)
{
    const ovr_strained_layer layer = {0.1, 0.25};
    const ovr_plastic_strain e = {0.3, -0.8, 0.5};
    const double h = 1e-5, at[] = {0.03, 0.17, 0.6};
    for (double k = 0.4; k < 50; k *= 3) {
        ovr_residual_stress top = ovr_residual_at(k, nu, layer, e, 0);
        CHECK_NEAR(top.z, 0, 1e-12);
        CHECK_NEAR(top.xz, 0, 1e-12);
        for (int i = 0; i < 3; i++) {
            ovr_residual_stress s = ovr_residual_at(k, nu, layer, e, at[i]);
            ovr_residual_stress a = ovr_residual_at(k, nu, layer, e, at[i] - h);
            ovr_residual_stress b = ovr_residual_at(k, nu, layer, e, at[i] + h);
            CHECK_NEAR((b.xz - a.xz) / (2 * h), -k * s.x, 1e-5);
            CHECK_NEAR((b.z - a.z) / (2 * h), k * s.xz, 1e-5);
        }
    }
}

enum { LAYERS = 12, SIZE = 3 * LAYERS };

/* Strains of unit length, e:e = 1, that span the deviatoric ones. */
static ovr_plastic_strain unit_strain(int which)
{
    const ovr_plastic_strain of[] = {{sqrt(0.5), -sqrt(0.5), 0},
                                     {sqrt(1 / 6.0), sqrt(1 / 6.0), 0},
                                     {0, 0, sqrt(0.5)}};
    return of[which];
}

/* Eigenvalues of a symmetric matrix to its diagonal, by Jacobi's rotations. */
static void eigenvalues(double A[SIZE][SIZE])
{
    for (int sweep = 0; sweep < 30; sweep++)
        for (int p = 0; p < SIZE; p++)
            for (int q = p + 1; q < SIZE; q++) {
                double angle = 0.5 * atan2(2 * A[p][q], A[q][q] - A[p][p]);
                double c = cos(angle), s = sin(angle);
                for (int i = 0; i < SIZE; i++) {
                    double a = A[i][p], b = A[i][q];
                    A[i][p] = c * a - s * b;
                    A[i][q] = s * a + c * b;
                }
                for (int i = 0; i < SIZE; i++) {
                    double a = A[p][i], b = A[q][i];
                    A[p][i] = c * a - s * b;
                    A[q][i] = s * a + c * b;
                }
            }
}

/* Residual stress works against the strain that makes it: symmetric, between
 * -2G = -(1 - nu) and 0. */
TEST(spectrum)
{
    ovr_strained_layer layer[LAYERS];
    double z = 0, h = 0.004;
    for (int i = 0; i < LAYERS; i++, h *= 1.4) {
        layer[i] = (ovr_strained_layer){z, z + h};
        z += h;
    }
    for (double k = 0.5; k < 400; k *= 3) {
        double A[SIZE][SIZE];
        for (int q = 0; q < SIZE; q++)
            for (int p = 0; p < SIZE; p++) {
                ovr_strained_layer to = layer[p / 3], from = layer[q / 3];
                ovr_residual_stress s = ovr_residual_mean(
                    k, nu, from, unit_strain(q % 3), to);
                ovr_plastic_strain e = unit_strain(p % 3);
                double work = s.x * e.x + s.z * e.z - s.y * (e.x + e.z) -
                              2 * s.xz * e.xz;
                A[p][q] = work *
                          sqrt((to.bottom - to.top) / (from.bottom - from.top));
            }
        for (int q = 0; q < SIZE; q++)
            for (int p = 0; p < q; p++)
                CHECK_NEAR(A[p][q], A[q][p], 1e-8);
        eigenvalues(A);
        double minimum = 0, maximum = -1;
        for (int p = 0; p < SIZE; p++) {
            minimum = fmin(minimum, A[p][p]);
            maximum = fmax(maximum, A[p][p]);
        }
        assert_true(minimum >= -(1 - nu) - 1e-8);
        assert_true(maximum < 0);
    }
}
