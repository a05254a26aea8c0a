/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Surface temperature of a layered body under a varying heat flux, computed
 * from the modes of the surface (solids.h), compared with heat conduction in
 * depth,
 *
 *     rho c T_t = (k T_z)_z,  -k T_z = q(t) at z = 0
 *
 * by finite volumes that grow with depth to where the temperature does not
 * change, with second-order backward differences and ten steps per step of the
 * run. q is that of a point passing an elliptic contact and then a spike,
 * linear within steps. Lengths and times are in units of the body: e_0 = 1, and
 * tau = d^2 rho c/k. */
#include <math.h>
#include <stdlib.h>

#include "contact/layers.h"
#include "physics/heat/solids.h"
#include "support/test.h"

enum { CELLS = 1200, FINE = 150, SUBSTEPS = 10 };

typedef struct column {
    int n;
    double dz[CELLS], capacity[CELLS], conductance[CELLS]; /* to the next */
    double T[CELLS], before[CELLS];
    double top; /* conductance from the surface to the first cell's middle */
} column;

/* Layers from the surface down; below them k = rho c = 1. */
static void make_column(int layers, const double *thickness, const double *k,
                        const double *rho_c, double deepest, column *c)
{
    double of[CELLS], z = 0, dz;
    int n = 0;
    for (int j = 0; j < layers; j++)
        for (int i = 0; i < FINE; i++, n++) {
            c->dz[n] = thickness[j] / FINE;
            of[n] = k[j];
            c->capacity[n] = rho_c[j] * c->dz[n];
        }
    for (dz = c->dz[n - 1]; z < deepest && n < CELLS; n++) {
        c->dz[n] = dz;
        of[n] = 1;
        c->capacity[n] = dz;
        z += dz;
        dz *= 1.02;
    }
    assert_true(z >= deepest);
    for (int i = 0; i + 1 < n; i++)
        c->conductance[i] = 2 / (c->dz[i] / of[i] + c->dz[i + 1] / of[i + 1]);
    c->top = 2 * of[0] / c->dz[0];
    c->n = n;
    for (int i = 0; i < n; i++)
        c->T[i] = c->before[i] = 0;
}

/* (3 T - 4 T' + T'')/(2 dt) = ..., Thomas's algorithm. */
static void advance(column *c, double q, double dt, bool first)
{
    static double ratio[CELLS], value[CELLS];
    double lead = first ? 1 : 1.5, one = first ? 1 : 2, two = first ? 0 : 0.5;
    for (int i = 0; i < c->n; i++) {
        double up = i ? c->conductance[i - 1] : 0;
        double down = i + 1 < c->n ? c->conductance[i] : 0;
        double m = c->capacity[i] / dt;
        double r = m * (one * c->T[i] - two * c->before[i]) + (i ? 0 : q);
        double diagonal = lead * m + up + down - (i ? up * ratio[i - 1] : 0);
        ratio[i] = down / diagonal;
        value[i] = (r + (i ? up * value[i - 1] : 0)) / diagonal;
    }
    for (int i = c->n - 1; i >= 0; i--) {
        c->before[i] = c->T[i];
        c->T[i] = value[i] + (i + 1 < c->n ? ratio[i] * c->T[i + 1] : 0);
    }
}

static double flux(double t)
{
    double spike = exp(-pow((t - 2.6) / 0.06, 2));
    return (t < 2 ? sqrt(t * (2 - t)) : 0) + spike;
}

static double warmed_at(const void *data, double t)
{
    return ovr_warmed_at(data, t);
}

/* Largest difference over the largest temperature. */
static double apart(int layers, const double *tau, const double *effusivity,
                    double dT)
{
    static column c;
    const double end = 4, N = 1 / sqrt(acos(-1));
    double thickness[2], k[2], rho_c[2], psi[OVR_MAX_MODES] = {0};
    double worst = 0, maximum = 0, q = flux(0);
    ovr_warmed w = {.layers = layers};
    for (int j = 0; j < layers; j++) { /* of alike diffusivity */
        w.tau[j] = tau[j];
        w.effusivity[j] = k[j] = rho_c[j] = effusivity[j];
        thickness[j] = sqrt(tau[j]);
    }
    w.effusivity[layers] = 1;
    make_column(layers, thickness, k, rho_c, 6 * sqrt(end), &c);
    ovr_memory m = {0};
    const ovr_warmth warm = {warmed_at, &w};
    ovr_memory_layered(dT / 8, end + dT, warm, &m);
    ovr_memory_fit(dT, end + dT, &m);
    for (int step = 1; step * dT <= end + dT / 2; step++) {
        double now = flux(step * dT);
        for (int s = 1; s <= SUBSTEPS; s++)
            advance(&c, q + (now - q) * s / SUBSTEPS, dT / SUBSTEPS,
                    step == 1 && s == 1);
        double truth = c.T[0] + now / c.top;
        double T = N * (ovr_memory_past(&m, psi, q) +
                        4. / 3 * (1 + m.more[0]) * sqrt(dT) * now);
        ovr_memory_step(&m, q, now, psi);
        worst = fmax(worst, fabs(T - truth));
        maximum = fmax(maximum, truth);
        q = now;
    }
    return worst / maximum;
}

/* Bad and good conductors on the body, from layers that a step sees through to
 * such that the body is hardly felt. */
TEST(one_layer)
{
    for (double tau = 2e-4; tau < 3; tau *= 4)
        for (double e = 0.12; e < 5; e *= 5) {
            double off = apart(1, &tau, &e, 0.02);
            print_message("tau %.1e e %.2f: %.1e\n", tau, e, off);
            CHECK_NEAR(off, 0, 1e-3);
        }
}

/* DLC on an interlayer on steel, and the other way round. */
TEST(two_layers)
{
    const double tau[] = {0.004, 0.02}, e[] = {0.12, 0.5},
                 turned[] = {0.5, 0.12};
    CHECK_NEAR(apart(2, tau, e, 0.02), 0, 1e-3);
    CHECK_NEAR(apart(2, tau, turned, 0.02), 0, 1e-3);
}
