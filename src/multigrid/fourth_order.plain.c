/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Fourth-order corrections in plain C (fourth_order.h). */
#include <math.h>

#include "multigrid/plain.h"

#include "multigrid/flow.h"

/* True if node i is so far from both ends that every stencil fits. */
static bool inside(ptrdiff_t i, size_t n)
{
    return i >= OVR_FOURTH_MARGIN && i < (ptrdiff_t)n - OVR_FOURTH_MARGIN;
}

void ovr_fourth_mask_plain(const ovr_lanes *g, double *P, double *mask)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)g->n; i++) {
        bool wet = inside(i, g->n);
        for (ptrdiff_t d = -1; wet && d <= 1; d++)
            wet = P[i + d] > 0;
        mask[i] = wet;
    }
}

/* 2 E of the second-order equation */
static double through(const ovr_fields *f, ptrdiff_t i)
{
    return f->flow ? f->flow[i] : f->eps[i] + f->eps[i + 1];
}

/* eps at i + 1/2 */
static double middle(const ovr_fields *f, ptrdiff_t i, bool upstream)
{
    const double *eps = f->eps + i;
    double mean = 0.5 * through(f, i);
    double cubic = (9 * (eps[0] + eps[1]) - eps[-1] - eps[2]) / 16;
    if (upstream)
        return exp(
            (9 * (log(eps[0]) + log(eps[1])) - log(eps[-1]) - log(eps[2])) /
            16);
    return fmin(fmax(cubic, 0.6 * mean), 1.4 * mean);
}

/* rho H as used in the sliding stress with temperatures across the film
 * (fields.h). */
static double sliding_content(const ovr_fields *f, ptrdiff_t i)
{
    return f->drag ? f->drag[i] * f->q[i] : f->q[i];
}

/* E at i + 1/2 of a shear-thinning film, for a pressure difference `rise` over
 * D. */
static double thinned(const ovr_fourth *c, const ovr_fields *f, double rise,
                      ptrdiff_t i)
{
    const ovr_fluid newtonian = {.by_gap = c->fluid->by_gap,
                                 .logarithmic = c->fluid->logarithmic};
    const double *H = f->H + i, *eps = f->eps + i, *rho = f->rho + i;
    const ovr_pair two = {.H = {H[0], H[1]},
                          .q = {rho[0] * H[0], rho[1] * H[1]},
                          .eps = {eps[0], eps[1]}};
    double mean = ovr_flow_between(&newtonian, 1, &two);
    double e = fmin(fmax(middle(f, i, true), 0.6 * mean), 1.4 * mean);
    double h = (9 * (H[0] + H[1]) - H[-1] - H[2]) / 16;
    double q = (9 * (sliding_content(f, i) + sliding_content(f, i + 1)) -
                sliding_content(f, i - 1) - sliding_content(f, i + 2)) /
               16;
    /* equal values at both nodes, so that all means agree */
    const ovr_pair nodes = {{0, rise}, {h, h}, {q, q}, {e, e}};
    return ovr_flow_between(c->fluid, c->D, &nodes);
}

/* Integral of m dP, m = eps/(rho H^3), from a node to the next. */
static double reduced_rise(const ovr_fields *f, ptrdiff_t i)
{
    double m[2], dP = f->P[i + 1] - f->P[i];
    for (int k = 0; k < 2; k++)
        m[k] = f->eps[i + k] / (f->rho[i + k] * pow(f->H[i + k], 3));
    double x = 0.5 * log(m[1] / m[0]),
           bend = (f->log_slope[i + 1] - f->log_slope[i]) * dP / 12;
    double mean = 0.5 * (m[0] + m[1]) * (x != 0 ? tanh(x) / x : 1);
    return mean * dP * (1 - fmin(fmax(bend, -0.3), 0.3));
}

static double reduced_flux(const ovr_fourth *c, const ovr_fields *f,
                           ptrdiff_t i)
{
    double x[4], rise = reduced_rise(f, i);
    for (ptrdiff_t k = 0; k < 4; k++)
        x[k] = f->rho[i + k - 1] * pow(f->H[i + k - 1], 3);
    double a = pow(f->H[i], 3), b = pow(f->H[i + 1], 3);
    double mean = a * b / (a + b) * (f->rho[i] + f->rho[i + 1]);
    double cubic = (9 * (x[1] + x[2]) - x[0] - x[3]) / 16;
    double bend = (2 * rise - reduced_rise(f, i - 1) - reduced_rise(f, i + 1)) /
                  24;
    double size = 0.4 * fabs(rise);
    return fmin(fmax(cubic, 0.6 * mean), 1.4 * mean) *
           (rise + fmin(fmax(bend, -size), size)) / c->D;
}

/* Share of the reduced pressure in the flux upstream of X = 0: 0 where ln eps
 * is smooth, 1 where it has spikes. */
static double reduced_share(const ovr_fields *f, ptrdiff_t i)
{
    double a = log(f->eps[i - 1]), b = log(f->eps[i]), c = log(f->eps[i + 1]),
           d = log(f->eps[i + 2]);
    double bend = fabs(a - 2 * b + c) + fabs(b - 2 * c + d);
    return fmin(fmax(bend - OVR_REDUCED_FROM, 0), 1);
}

static double flux(const ovr_fourth *c, const ovr_fields *f, ptrdiff_t i)
{
    const double *P = f->P + i;
    double slope = (27 * (P[1] - P[0]) - (P[2] - P[-1])) / (24 * c->D);
    bool upstream = i >= c->first && i < c->end;
    if (ovr_flow_is_shear_thinning(c->fluid))
        return thinned(c, f, slope * c->D, i) * slope;
    if (!c->reduced)
        return middle(f, i, upstream) * slope;
    double share = upstream ? reduced_share(f, i) : 1,
           reduced = share > 0 ? reduced_flux(c, f, i) : 0,
           direct = share < 1 ? middle(f, i, upstream) * slope : 0;
    return (1 - share) * direct + share * reduced;
}

/* Left-hand side of the equation of fourth order minus that of second order. */
static double excess(const ovr_fourth *c, const ovr_fields *f, ptrdiff_t i)
{
    const double *P = f->P + i, *q = f->q + i;
    double fourth = (27 * (flux(c, f, i) - flux(c, f, i - 1)) -
                     (flux(c, f, i + 1) - flux(c, f, i - 2))) /
                    (24 * c->D);
    double second = (through(f, i - 1) * (P[-1] - P[0]) +
                     through(f, i) * (P[1] - P[0])) /
                    (2 * c->D * c->D);
    double wedge = (3 * q[1] - 8 * q[0] + 6 * q[-1] - q[-3]) / 12;
    return fourth - second - c->Cu * wedge / c->D;
}

static double second_difference(const double *x)
{
    return x[-1] - 2 * x[0] + x[1];
}

void ovr_fourth_order_plain(const ovr_lanes *g, const ovr_fourth *c,
                            const ovr_fields *f, const double *w)
{
    for (ptrdiff_t i = 1; i + 2 < (ptrdiff_t)g->n; i++)
        c->flux[i] = flux(c, f, i);
    for (ptrdiff_t i = 0; i < (ptrdiff_t)g->n; i++) {
        double gap = second_difference(w + i) / (c->linear ? 12 : 24) +
                     c->local * c->D * second_difference(f->P + i);
        c->F[i] = c->mask[i] > 0 ? -excess(c, f, i) : 0;
        c->gap[i] = inside(i, g->n) ? gap : 0;
    }
}
