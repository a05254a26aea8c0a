/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "support/dent.h"
#include "results/results.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double *field_of(const void *source, const ovr_observable *which,
                              double *workspace)
{
    const test_dent *d = source;
    const struct {
        const char *name;
        const double *values;
    } field[] = {{"pressure", d->P},    {"film_thickness", d->H},
                 {"roughness", d->S},   {"density", d->rho},
                 {"viscosity", d->eta}, {"mass_flow", d->flow}};
    for (size_t k = 0; k < sizeof field / sizeof *field; k++)
        if (strcmp(which->name, field[k].name) == 0)
            return field[k].values;
    for (size_t i = 0; i < d->n; i++)
        workspace[i] = d->P[i] <= 0;
    return workspace;
}

void test_dent_init(test_dent *d, size_t n, double dT)
{
    double *block = calloc(7 * n, sizeof *block);
    memset(d, 0, sizeof *d);
    d->n = n;
    d->D = 5.5 / (double)(n - 1);
    d->dT = dT > 0 ? dT : d->D;
    d->X = block;
    d->P = block + n;
    d->H = block + 2 * n;
    d->S = block + 3 * n;
    d->rho = block + 4 * n;
    d->eta = block + 5 * n;
    d->flow = block + 6 * n;
    for (size_t i = 0; i < n; i++)
        d->X[i] = -4 + d->D * (double)i;
    d->frame = (ovr_frame){
        .state = &d->state, .seen = &d->seen, .field = field_of, .source = d};
    test_dent_move(d, 0);
}

void test_dent_free(test_dent *d)
{
    free(d->X);
}

static void fill_node(test_dent *d, size_t i, double T)
{
    double X = d->X[i], xi = (X + 4.6 - T) / 0.5;
    double hertz = 1 - X * X;
    d->S[i] = -0.1 * pow(10, -10 * xi * xi) * cos(2 * acos(-1) * xi);
    d->P[i] = hertz > 0 ? sqrt(hertz) * (1 + 0.3 * d->S[i]) : 0;
    d->H[i] = 0.08 + (hertz < 0 ? hertz * hertz / 4 : 0) - d->S[i];
    d->rho[i] = 1 + 0.2 * d->P[i];
    d->eta[i] = exp(8 * d->P[i]);
    d->flow[i] = 0.07 + 0.001 * sin(T) + 1e-6 * X;
}

void test_dent_move(test_dent *d, long step)
{
    double T = d->dT * (double)step;
    for (size_t i = 0; i < d->n; i++)
        fill_node(d, i, T);
    d->state = (ovr_state){.step = step,
                           .T = T,
                           .n = d->n,
                           .D = d->D,
                           .X = d->X,
                           .P = d->P,
                           .H = d->H,
                           .S = d->S,
                           .H0 = -0.5};
    d->seen = (ovr_observation){.T = T,
                                .dT = d->dT,
                                .H_min = 0.05 + 0.001 * cos(T),
                                .X_min = 0.9,
                                .H_min_located = 0.049 + 0.001 * cos(T),
                                .X_min_located = 0.91,
                                .H_cen = 0.08 + 0.002 * sin(T),
                                .P_cen = 1,
                                .P_max = 1.01 + 0.01 * sin(3 * T),
                                .P_spike = NAN,
                                .P_spike_located = step % 3 ? 0.8 : NAN,
                                .X_spike = NAN,
                                .H0 = -0.5,
                                .load = acos(-1) / 2,
                                .load_ratio = 1,
                                .speed_ratio = 1,
                                .residual = 1e-6,
                                .cycles = 2 + (int)(step % 2),
                                .converged = true};
}

ovr_contact test_contact_bare(void)
{
    return (ovr_contact){.M = 20,
                         .L = 10,
                         .lambda = 0.00925,
                         .alphabar = 17.84,
                         .u1_ratio = 1,
                         .u2_ratio = 1,
                         .ph = NAN,
                         .b = NAN,
                         .height = NAN,
                         .time = NAN,
                         .load = NAN,
                         .radius = NAN,
                         .modulus = NAN,
                         .viscosity = NAN,
                         .alpha = NAN,
                         .um = NAN};
}

ovr_contact test_contact_physical(void)
{
    ovr_contact c = test_contact_bare();
    c.ph = 1.05e9;
    c.b = 1.9e-4;
    c.height = 3.1e-6;
    c.time = 1.3e-4;
    c.radius = 0.01155;
    c.viscosity = 0.04;
    c.um = 1.46;
    return c;
}
