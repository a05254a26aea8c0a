/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The corrections of fourth_order.h: logarithms of eps, fluxes at half nodes,
 * their differences, each one pass. */
#include "multigrid/fourth_thinning.h"
#include "multigrid/power.h"
#include "multigrid/table.h"

enum { REACH = 3 }; /* nodes that a stencil takes on each side */

/* Numbers of the nodes in vector J; beyond the grid's ends they go on. */
static inline ivec nodes(const ovr_lanes *g, ptrdiff_t J)
{
    ivec number;
    for (int l = 0; l < VEC; l++)
        number[l] = J + l * (ptrdiff_t)g->S;
    return number;
}

static inline ivec inside(const ovr_lanes *g, ptrdiff_t J)
{
    ivec i = nodes(g, J);
    return (i >= OVR_FOURTH_MARGIN) & (i < (ptrdiff_t)g->n - OVR_FOURTH_MARGIN);
}

void OVR_KERNEL(fourth_mask)(const ovr_lanes *g, double *P, double *mask)
{
    repeat_ends(P, (ptrdiff_t)g->S, REACH);
    for (ptrdiff_t J = 0; J < (ptrdiff_t)g->S; J++) {
        vec minimum = at(P, J - REACH);
        for (ptrdiff_t d = 1 - REACH; d <= REACH; d++)
            minimum = smaller(minimum, at(P, J + d));
        put(mask, J, choose(inside(g, J) & (minimum > 0), all(1), all(0)));
    }
}

static void logarithms(const ovr_lanes *g, const double *eps, double *log_eps)
{
    log_table table;
    make_log_table(1. / 16, &table);
    for (ptrdiff_t J = -REACH; J < (ptrdiff_t)g->S + REACH; J++)
        put(log_eps, J, scaled_log2(&table, at(eps, J)));
}

/* 2 E of the equation of second order */
static inline vec through(const ovr_fields *f, ptrdiff_t J)
{
    return f->flow ? at(f->flow, J) : at(f->eps, J) + at(f->eps, J + 1);
}

/* eps at i + 1/2: by logarithms upstream, of nodes, elsewhere */
static inline vec middle(const table16 *table, const double *log_eps,
                         const ovr_fields *f, ivec upstream, ptrdiff_t J)
{
    const double *eps = f->eps;
    vec sum = at(eps, J) + at(eps, J + 1), mean = 0.5 * through(f, J);
    vec cubic = (9 * sum - at(eps, J - 1) - at(eps, J + 2)) / 16;
    vec power = 9 * (at(log_eps, J) + at(log_eps, J + 1)) - at(log_eps, J - 1) -
                at(log_eps, J + 2);
    vec held = larger(0.6 * mean, smaller(1.4 * mean, cubic));
    return choose(upstream, scaled_exp2(table, power), held);
}

/* 24 p D at i + 1/2 */
static inline vec steepness(const ovr_fields *f, ptrdiff_t J)
{
    return 27 * (at(f->P, J + 1) - at(f->P, J)) -
           (at(f->P, J + 2) - at(f->P, J - 1));
}

/* The same where the film shears thin. */
static void thinned_fluxes(const ovr_lanes *g, const ovr_fourth *c,
                           const ovr_fields *f)
{
    const ovr_fields own = *f;
    const thinning t = thinning_of(c->fluid, c->D);
    for (ptrdiff_t J = 1 - REACH; J < (ptrdiff_t)g->S + REACH - 2; J++) {
        vec rise = (1. / 24) * steepness(&own, J);
        vec flow = thinned(&t, &own, c->log_eps, rise, J);
        put(c->flux, J, flow * ((0.5 / c->D) * rise));
    }
}

static void fluxes(const ovr_lanes *g, const ovr_fourth *c, const ovr_fields *f)
{
    double scale = 1 / (24 * c->D);
    table16 table;
    make_exp_table(1, &table);
    for (ptrdiff_t J = 1 - REACH; J < (ptrdiff_t)g->S + REACH - 2; J++) {
        ivec i = nodes(g, J), upstream = (i >= c->first) & (i < c->behind);
        vec eps = middle(&table, c->log_eps, f, upstream, J);
        put(c->flux, J, eps * (scale * steepness(f, J)));
    }
}

/* The equation's left-hand side of fourth order less that of second. */
static inline vec excess(const ovr_fourth *c, const ovr_fields *f, ptrdiff_t J)
{
    vec P = at(f->P, J), q = at(f->q, J);
    vec fourth = 27 * (at(c->flux, J) - at(c->flux, J - 1)) -
                 (at(c->flux, J + 1) - at(c->flux, J - 2));
    vec second = through(f, J - 1) * (at(f->P, J - 1) - P) +
                 through(f, J) * (at(f->P, J + 1) - P);
    vec wedge = 3 * at(f->q, J + 1) - 8 * q + 6 * at(f->q, J - 1) -
                at(f->q, J - 3);
    return (1 / (24 * c->D)) * fourth - (0.5 / (c->D * c->D)) * second -
           (c->Cu / (12 * c->D)) * wedge;
}

static inline vec second_difference(const double *x, ptrdiff_t J)
{
    return at(x, J - 1) - 2 * at(x, J) + at(x, J + 1);
}

void OVR_KERNEL(fourth_order)(const ovr_lanes *g, const ovr_fourth *c,
                              const ovr_fields *f, const double *w)
{
    ptrdiff_t S = (ptrdiff_t)g->S;
    repeat_ends(f->P, S, REACH);
    repeat_ends(f->eps, S, REACH);
    repeat_ends(f->q, S, REACH);
    if (f->flow)
        repeat_ends(f->flow, S, REACH);
    logarithms(g, f->eps, c->log_eps);
    if (f->tangent) {
        double *const more[] = {f->H, f->share, f->drag};
        for (int k = 0; k < 3; k++)
            if (more[k])
                repeat_ends(more[k], S, REACH);
        thinned_fluxes(g, c, f);
    } else {
        fluxes(g, c, f);
    }
    double share = c->linear ? 1. / 12 : 1. / 24;
    for (ptrdiff_t J = 0; J < S; J++) {
        vec gap = share * second_difference(w, J) +
                  (c->local * c->D) * second_difference(f->P, J);
        put(c->F, J, choose(at(c->mask, J) > 0, -excess(c, f, J), all(0)));
        put(c->gap, J, choose(inside(g, J), gap, all(0)));
    }
    repeat_ends(c->gap, S, OVR_HALO);
}
