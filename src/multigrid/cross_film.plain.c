/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Columns across the film, node by node (equations in cross_film.h). */
#include <math.h>

#include "multigrid/plain.h"

#include "base/larger.h"
#include "contact/flow_law.h"
#include "contact/heat_numbers.h"
#include "contact/laws/fluid.h"
#include "contact/laws/law.h"
#include "multigrid/cross_film.h"
#include "multigrid/expansion.h"

static const double INV_LN2 = 1.4426950408889634;

void ovr_log_viscosity_plain(size_t n, const ovr_fluid *fluid, const double *P,
                             const double *H, double *log_eta)
{
    ovr_viscosity_law law = fluid->lubricant.viscosity_law;
    fluid_laws c = {0};
    fluid_laws_make(&fluid->lubricant, &c);
    for (size_t i = 0; i < n; i++) {
        double t = viscosity_divisor(&c, law, P[i]), slope, by_film, power;
        const ovr_law_nodes node = {1, P + i, H + i, &power, &slope, &by_film};
        if (fluid->law)
            fluid->law->at(fluid->law, &node);
        else {
            power = viscosity_begin(&c, law, P[i], t, 1 / t, &slope);
            power = viscosity_finish(&c, law, power, &slope);
        }
        log_eta[i] = -power / INV_LN2;
    }
}

static ovr_sheet sheet_at(const ovr_columns *c, size_t i)
{
    const double *X = c->X, *P = c->P;
    bool inside = i > 0 && i + 1 < c->n;
    ovr_sheet sheet = {.H = c->H[i],
                       .rho = c->q[i] / c->H[i],
                       .P = P[i],
                       .log_eta = c->log_eta[i],
                       .lambda = c->lambda,
                       .V = c->V,
                       .u1 = c->u1,
                       .Sigma0 = c->Sigma0,
                       .limit = c->limit * P[i],
                       .wet = inside && P[i] > 0,
                       .law = c->law};
    if (inside)
        sheet.P_X = (P[i + 1] - P[i - 1]) / (X[i + 1] - X[i - 1]);
    if (c->P_T)
        sheet.P_T = c->P_T[i];
    return sheet;
}

static double fall(const ovr_columns *c, double log_eta,
                   const ovr_cross_film_flow *flow)
{
    double a = fabs(flow->t) / c->Sigma0, softer = 1, by_a;
    if (flow->limited && !c->always_falls)
        return 0;
    if (a > 1e-3 && c->law) {
        double f = ovr_curve_at(&c->law->f, a, &by_a);
        softer = f / (a * by_a);
    } else if (a > 1e-3)
        softer = tanh(a) / a;
    return ovr_heat_viscosity_fall(c->heat, log_eta, flow->mean) * softer;
}

/* Stores the coefficients of the Reynolds equation. */
static void store_fields(const ovr_columns *c, const ovr_cross_film_flow *flow,
                         size_t i)
{
    double skew = flow->m[1] / flow->m[0];
    double psi = 3 * (flow->m[2] - flow->m[1] * skew);
    /* the viscosity at ln eta = 0 and 1 determines th and shift for any law */
    double at_0 = ovr_heat_log_viscosity(c->heat, 0, flow->mean);
    c->th[i] = ovr_heat_log_viscosity(c->heat, 1, flow->mean) - at_0;
    c->shift[i] = -at_0 * INV_LN2 + log2(psi);
    c->drag[i] = psi / flow->m[0];
    c->swell[i] = expansion_lightness(c->heat, expansion_at(c->heat, c->P[i]),
                                      flow->mean);
    c->skewed[i] = c->V / 2 * skew * c->q[i];
}

void ovr_column_flow(const ovr_columns *c, size_t i)
{
    double T[OVR_CROSS_FILM_MAX];
    ovr_sheet sheet = sheet_at(c, i);
    ovr_cross_film_flow flow = {0};
    for (int j = 0; j < c->cross_film->n; j++)
        T[j] = c->used[j][i];
    if (c->th)
        sheet.wet = false; /* only the viscosity ratios are needed */
    ovr_cross_film_flow_of(c->cross_film, c->heat, &sheet, T, &flow);
    if (c->th) {
        store_fields(c, &flow, i);
        return;
    }
    for (int j = 0; j < c->cross_film->n; j++) {
        c->u[j][i] = flow.u[j];
        c->heating[j][i] = flow.heating[j];
    }
    c->t[i] = flow.t;
    if (c->even)
        c->even[i] = flow.even;
    c->fall[i] = fall(c, sheet.log_eta, &flow);
}

/* Steady: index of the upstream node of a layer; n: none. */
static size_t upstream(const ovr_columns *c, int j, size_t i)
{
    return c->back || (c->both_ways && c->u[j][i] < 0) ? i + 1 : i - 1;
}

double ovr_column_departure(const ovr_columns *c, int j, size_t i)
{
    size_t from = c->min_u > 0 ? upstream(c, j, i) : i;
    return from < c->n ? c->departure[j][from] : 0;
}

double ovr_column_travel(const ovr_columns *c, int j, size_t i)
{
    double u = c->back ? -c->u[j][i] : c->u[j][i];
    if (!(c->min_u > 0))
        return c->dT;
    return (i ? c->X[i] - c->X[i - 1] : c->X[1] - c->X[0]) /
           ovr_larger(c->both_ways ? fabs(u) : u, c->min_u);
}

void ovr_column_heat(const ovr_columns *c, size_t i)
{
    double departure[OVR_CROSS_FILM_MAX], stay[OVR_CROSS_FILM_MAX],
        T[OVR_CROSS_FILM_MAX];
    ovr_sheet sheet = sheet_at(c, i);
    ovr_cross_film_flow flow = {0};
    ovr_wall wall[2];
    int n = c->cross_film->n;
    double cooling = c->heat->theta * c->fall[i] / c->q[i];
    for (int j = 0; j < n; j++) {
        double rate = ovr_larger(0, cooling * c->heating[j][i]);
        double travel = ovr_column_travel(c, j, i);
        flow.u[j] = c->u[j][i];
        flow.heating[j] = c->heating[j][i];
        flow.beta[j] = ovr_expansion(c->heat, c->P[i], c->used[j][i]);
        stay[j] = 1 / (1 / travel + rate);
        departure[j] = (ovr_column_departure(c, j, i) / travel +
                        rate * c->used[j][i]) *
                       stay[j];
    }
    for (int k = 0; k < 2; k++)
        wall[k] = (ovr_wall){c->heat->bulk[k] +
                                 c->heat->solid[k] * c->past[k][i],
                             c->resistance[k]};
    ovr_cross_film_solve(c->cross_film, c->heat, &sheet, &flow, departure, stay,
                         wall, T);
    c->mean[i] = 0;
    for (int j = 0; j < n; j++) {
        c->T[j][i] = T[j];
        c->mean[i] += c->cross_film->w[j] * T[j];
    }
    for (int k = 0; k < 2; k++)
        c->into[k][i] = (T[k ? n - 1 : 0] - wall[k].h) / wall[k].resistance;
}

void ovr_flow_cross_film_plain(const ovr_columns *c)
{
    for (size_t i = 0; i < c->n; i++)
        ovr_column_flow(c, i);
}

void ovr_heat_cross_film_plain(const ovr_columns *c)
{
    for (size_t i = 1; i < c->n; i++)
        ovr_column_heat(c, i);
}
