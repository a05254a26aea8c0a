/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Stresses in and below layers (stress/layered.h) compared with another
 * solution, and general properties. */
#include "support/test.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "contact/layers.h"
#include "reference/layers_truth.h"
#include "stress/layered.h"
#include "stress/stress.h"

static const double pi = 3.14159265358979323846;

static ovr_layered body_of(int k)
{
    const layers_truth *t = &truth_cases[k];
    ovr_layered body = {.layers = t->layers};
    for (int j = 0; j < t->layers; j++) {
        body.thickness[j] = t->thickness[j];
        body.layer[j] = (ovr_elastic){t->E[j], t->nu[j]};
    }
    body.below = (ovr_elastic){t->below[0], t->below[1]};
    return body;
}

/* sum c_j sin((2j + 1) theta), s = cos theta */
static double dry(int k, double s)
{
    double P = 0, theta;
    if (fabs(s) >= 1)
        return 0;
    theta = atan2(sqrt(1 - s * s), s);
    for (int j = 0; j < TRUTH_SERIES; j++)
        P += truth_series[k][j] * sin((2 * j + 1) * theta);
    return P;
}

/* HALF: number of D in the half-width; positions are in tenths of it. */
enum { HALF = 4000, TENTH = HALF / 10, OUT = 1300 };

static ovr_stress *fields(const ovr_layered *body, double a, double z)
{
    ovr_error err = {0};
    ovr_stress_options o = ovr_stress_options_default();
    o.mesh = a / HALF;
    o.nodes = 2 * (HALF + OUT) + 1;
    o.inlet = -(HALF + OUT) * o.mesh;
    o.from = o.inlet;
    o.to = -o.inlet;
    o.depth_min = o.depth_max = z;
    o.traction = true;
    o.layers = body;
    ovr_stress *s = ovr_stress_create(&o, NULL, &err);
    if (!s)
        print_message("%s\n", err.message);
    assert_non_null(s);
    return s;
}

static ovr_in_plane at(const ovr_stress_row *row, size_t i)
{
    return (ovr_in_plane){(double)row->mean[2 * i], (double)row->shear[2 * i],
                          (double)row->shear[2 * i + 1]};
}

/* What a sum lacks of a square root's end, -zeta(-1/2) D^1.5, at its node. */
static double end_of(int k)
{
    double slope = 0;
    for (int j = 0; j < TRUTH_SERIES; j++)
        slope += (2 * j + 1) * truth_series[k][j];
    return 0.20788622497735457 * slope * sqrt(2. / HALF);
}

TEST(stresses)
{
    size_t n = 2 * (HALF + OUT) + 1;
    double *P = calloc(n, sizeof *P), *Q = calloc(n, sizeof *Q);
    for (size_t r = 0; r < sizeof truth_stress / sizeof *truth_stress; r++) {
        int k = truth_stress[r].of;
        double a = truth_cases[k].half_width, mu = truth_stress[r].mu;
        ovr_layered body = body_of(k);
        ovr_stress *s = fields(&body, a, truth_stress[r].z);
        ovr_stress_row row;
        ovr_error err = {0};
        for (size_t i = 0; i < n; i++) {
            P[i] = dry(k, ((double)i - (HALF + OUT)) / HALF);
            if (i == OUT || i == OUT + 2 * HALF)
                P[i] = end_of(k);
            Q[i] = mu * P[i];
        }
        ovr_stress_solve(s, P, Q, 0, OVR_STRESS_ALL_LEVELS);
        CHECK_OK(ovr_stress_at_every_node(s, 0, &row, &err), &err);
        for (int p = 0; p < TRUTH_PLACES; p++) {
            double X = truth_places[p] * a;
            ovr_in_plane f = at(&row,
                                (size_t)lround((X - row.start) / row.step));
            CHECK_NEAR(f.d - f.h, truth_stress[r].sigma_x[p], 2e-6);
            CHECK_NEAR(-f.d - f.h, truth_stress[r].sigma_z[p], 2e-6);
            CHECK_NEAR(f.tau, truth_stress[r].tau_xz[p], 2e-6);
        }
        ovr_stress_free(s);
    }
    free(P);
    free(Q);
}

/* sigma_z, tau and the strain along x are the same on both sides of every
 * interface, for every wave. */
TEST(interfaces)
{
    const ovr_layered body = {3,
                              {0.1, 0.05, 0.3},
                              {{4, 0.2}, {0.02, 0.49}, {2, 0.3}},
                              {1, 0.25},
                              {0},
                              {0},
                              {0}};
    for (int q = 0; q < 2; q++)
        for (int j = 0; j < 3; j++)
            for (double k = 0.01; k < 60; k *= 2) {
                double z = ovr_layered_bottom(&body, j), f[2][3], strain[2];
                for (int side = 0; side < 2; side++) {
                    ovr_elastic of = j + side < 3 ? body.layer[j + side]
                                                  : body.below;
                    double *s = f[side], nu = of.poisson;
                    ovr_layered_wave(&body, k,
                                     z * (1 + (side ? 1e-13 : -1e-13)), q, s);
                    strain[side] = (1 + nu) / of.modulus *
                                   ((1 - nu) * s[0] - nu * s[1]);
                }
                CHECK_NEAR(f[0][1], f[1][1], 1e-10);
                CHECK_NEAR(f[0][2], f[1][2], 1e-10);
                CHECK_NEAR(strain[0], strain[1],
                           1e-10 * fmax(1, fabs(strain[1])));
            }
}

/* Layers of the substrate's moduli add nothing. */
TEST(nothing_of_nothing)
{
    const ovr_layered body = {
        2, {0.1, 0.3}, {{1, 0.3}, {1, 0.3}}, {1, 0.3}, {0}, {0}, {0}};
    for (int q = 0; q < 2; q++)
        for (double k = 0.01; k < 60; k *= 2)
            for (double z = 0.01; z < 2; z *= 2) {
                double f[3], s = k * z, e = exp(-s);
                ovr_layered_wave(&body, k, z, q, f);
                CHECK_NEAR(f[0], (q ? s - 2 : s - 1) * e, 1e-13);
                CHECK_NEAR(f[1], (q ? -s : -1 - s) * e, 1e-13);
                CHECK_NEAR(f[2], (q ? 1 - s : -s) * e, 1e-13);
            }
    (void)pi;
}
