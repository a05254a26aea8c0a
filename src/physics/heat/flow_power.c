/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Power dissipated by the pressure flow (equations in flow_power.h). */
#include "physics/heat/flow_power.h"

#include <math.h>

#include "base/larger.h"
#include "physics/heat/heated.h"
#include "physics/heat/in_time.h"

ovr_status ovr_heat_flow_power_take(ovr_simulation *sim, ovr_error *err)
{
    ovr_heated *h = sim->heated;
    return OVR_TAKE_NODES(sim, err, &h->all_power, &h->node_power,
                          &h->half_power, &h->factor);
}

/* ------------------------------------------------------ Flow at half nodes */

/* True if nodes i and i + 1 are pressurized. */
static bool is_wet(const ovr_solution *now, size_t i)
{
    return i > 0 && i + 2 < now->n && now->P[i] > 0 && now->P[i + 1] > 0;
}

/* Fraction f at half node i + 1/2. */
static double steepness(const ovr_solution *now, size_t i)
{
    const double e = 2.718281828459045;
    const double *H = now->H, *q = now->q, *eps = now->eps;
    double left = eps[i] * H[i + 1] * H[i + 1] * q[i + 1];
    double right = eps[i + 1] * H[i] * H[i] * q[i];
    if (!(left > e * right || right > e * left))
        return 0;
    double x = ovr_smaller(fabs(log(left / right)) - 1, 1);
    return x * x * (3 - 2 * x);
}

/* Flow Q at half node i + 1/2, by the coefficient of Reynolds' equation. */
static double flow_by_pressure(const ovr_simulation *sim, size_t i)
{
    const ovr_solution *now = &sim->now;
    const double *v = sim->heated->skewed;
    double dX = now->X[i + 1] - now->X[i];
    double twice = now->flow ? now->flow[i] : now->eps[i] + now->eps[i + 1];
    return 0.5 * (twice * (now->P[i + 1] - now->P[i]) / dX - v[i] - v[i + 1]);
}

/* True if the flow is constant over a steep flank. */
static bool is_constant(const ovr_simulation *sim)
{
    return !(sim->heated->steps->dT > 0) || !sim->shapes.heights;
}

/* Computes p of all half nodes. */
static void fill_half_nodes(const ovr_simulation *sim, double *p)
{
    const ovr_solution *now = &sim->now;
    const ovr_heated *h = sim->heated;
    const double *P = now->P, *H = now->H, *q = now->q;
    const bool constant = is_constant(sim);
    double Cu = h->u1 - h->V / 2, F = NAN;
    for (size_t k = 0; k + 1 < now->n; k++) {
        size_t i = sim->histories.backward ? now->n - 2 - k : k;
        p[i] = 0;
        if (!is_wet(now, i))
            continue;
        double Q = flow_by_pressure(sim, i);
        double carried = Cu * (q[i] + q[i + 1]) / 2;
        double f = constant ? steepness(now, i) : 0;
        if (f > 0 && !isnan(F))
            Q += f * (carried - F - Q);
        else
            F = carried - Q;
        p[i] = Q * (H[i] + H[i + 1]) / (q[i] + q[i + 1]) * (P[i + 1] - P[i]) /
               (now->X[i + 1] - now->X[i]);
    }
}

/* -------------------------------------------------------------- Heat source */

/* Computes the heat source of all nodes and p, its part by the pressure. */
static void fill_nodes(const ovr_simulation *sim, double *all, double *p)
{
    const ovr_heated *h = sim->heated;
    const ovr_kernels *run = sim->grids.kernels;
    const double *w = h->cross_film.w;
    double *const *heating = h->film.heating;
    size_t n = sim->now.n;
    run->combine(n, w[0], heating[0], w[1], heating[1], all);
    for (int j = 2; j < h->cross_film.n; j++)
        run->combine(n, 1, all, w[j], heating[j], all);
    run->combine(n, 1, all, h->V, h->film.t, p);
}

/* Computes 1 + p_i [(c_{i-1/2} + c_{i+1/2})/2 - 1]/all_i. */
static void fill_factors(const ovr_simulation *sim, const double *all,
                         const double *p, const double *half, double *factor)
{
    const ovr_solution *now = &sim->now;
    double before = 0; /* c_{i-1/2} - 1 */
    for (size_t i = 0; i < now->n; i++) {
        double after = 0, own = ovr_larger(0, p[i]);
        if (is_wet(now, i) && own + ovr_larger(0, p[i + 1]) > 0)
            after = 2 * ovr_larger(0, half[i]) /
                        (own + ovr_larger(0, p[i + 1])) -
                    1;
        factor[i] = 1;
        if (own > 0 && all[i] > 0)
            factor[i] += (before + after) / 2 * own / all[i];
        before = after;
    }
}

void ovr_heat_flow_power(ovr_simulation *sim)
{
    ovr_heated *h = sim->heated;
    const double *factor = h->factor;
    fill_half_nodes(sim, h->half_power);
    fill_nodes(sim, h->all_power, h->node_power);
    fill_factors(sim, h->all_power, h->node_power, h->half_power, h->factor);
    for (int j = 0; j < h->cross_film.n; j++) {
        double *heating = h->film.heating[j];
        for (size_t i = 0; i < sim->now.n; i++)
            heating[i] *= factor[i];
    }
}
