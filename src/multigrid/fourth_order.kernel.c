/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Fourth-order corrections (fourth_order.h): logarithms of eps, fluxes at half
 * nodes, and their differences, one pass each. */
#include "multigrid/fourth_thinning.h"
#include "multigrid/power.h"
#include "multigrid/table.h"

enum {
    WET = 1,  /* pressurized nodes required on each side of a corrected node */
    REACH = 3 /* nodes of a stencil on each side */
};

/* Indices of the nodes in vector J, also beyond the ends of the grid. */
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
        vec minimum = at(P, J - WET);
        for (ptrdiff_t d = 1 - WET; d <= WET; d++)
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

/* 2 E of the second-order equation */
static inline vec through(const ovr_fields *f, ptrdiff_t J)
{
    return f->flow ? at(f->flow, J) : at(f->eps, J) + at(f->eps, J + 1);
}

/* eps at i + 1/2: interpolated by logarithms upstream, by values elsewhere */
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

/* Fluxes of shear-thinning films. */
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
        ivec i = nodes(g, J), upstream = (i >= c->first) & (i < c->end);
        vec eps = middle(&table, c->log_eps, f, upstream, J);
        put(c->flux, J, eps * (scale * steepness(f, J)));
    }
}

/* H^3 as a divisor */
static inline vec cube_at(const ovr_fields *f, ptrdiff_t J)
{
    vec h = face_film(at(f->H, J));
    return h * h * h;
}

/* m = eps/(rho H^3) */
static inline vec fluidity_at(const ovr_fields *f, ptrdiff_t J)
{
    return at(f->eps, J) / (at(f->rho, J) * cube_at(f, J));
}

/* Integral of m dP between neighbouring nodes. */
static void reduced_rises(const ovr_lanes *g, const ovr_fields *f, double *rise)
{
    const double ln2 = 0x1.62e42fefa39efp-1, most = 0.3;
    vec left = fluidity_at(f, -REACH);
    for (ptrdiff_t J = -REACH; J < (ptrdiff_t)g->S + REACH - 1; J++) {
        vec right = fluidity_at(f, J + 1);
        vec d = ln2 * (at(f->log_fluidity, J + 1) - at(f->log_fluidity, J));
        vec dP = at(f->P, J + 1) - at(f->P, J);
        vec slopes = at(f->log_slope, J + 1) - at(f->log_slope, J);
        vec bend = (1. / 12) * slopes * dP;
        bend = larger(all(-most), smaller(all(most), bend));
        vec mean = face_log_mean(left, right, d, face_inverse(d));
        put(rise, J, mean * dP * (1 - bend));
        left = right;
    }
}

/* H^3 and rho H^3 of four nodes from J - 1 on, for the half node after J. */
typedef struct around {
    vec cube[4], rho[4];
} around;

static inline void load_around(const ovr_fields *f, ptrdiff_t J, around *a,
                               int k)
{
    a->cube[k] = cube_at(f, J);
    a->rho[k] = a->cube[k] * at(f->rho, J);
}

/* Flux at i + 1/2 by the reduced pressure: rho H^3 times the slope of the
 * reduced pressure. */
static inline vec reduced_flux(const ovr_fourth *c, const ovr_fields *f,
                               const around *n, ptrdiff_t J)
{
    const double most = 0.4;
    vec a = n->cube[1], b = n->cube[2];
    vec cubic = (1. / 16) *
                (9 * (n->rho[1] + n->rho[2]) - n->rho[0] - n->rho[3]);
    vec mean = a * b / (a + b) * (at(f->rho, J) + at(f->rho, J + 1));
    vec rise = at(c->rise, J);
    vec bend = (1. / 24) * (2 * rise - at(c->rise, J - 1) - at(c->rise, J + 1));
    vec size = most * larger(rise, -rise);
    cubic = larger((1 - most) * mean, smaller((1 + most) * mean, cubic));
    bend = larger(-size, smaller(size, bend));
    return (1 / c->D) * cubic * (rise + bend);
}

/* Share of the reduced pressure in the flux upstream of X = 0: 0 where ln eps
 * is smooth, 1 where it has spikes. */
static inline vec reduced_share(const double *log_eps, ptrdiff_t J)
{
    const double per_log = 16 * 0x1.62e42fefa39efp-1; /* 16 ln 2 */
    vec b = at(log_eps, J), c = at(log_eps, J + 1);
    vec left = at(log_eps, J - 1) - 2 * b + c,
        right = b - 2 * c + at(log_eps, J + 2);
    vec bend = per_log * (larger(left, -left) + larger(right, -right));
    return larger(all(0), smaller(all(1), bend - OVR_REDUCED_FROM));
}

/* Fluxes by reduced pressures, upstream of X = 0 only where ln eps has spikes.
 */
static void reduced_fluxes(const ovr_lanes *g, const ovr_fourth *c,
                           const ovr_fields *f)
{
    double scale = 1 / (24 * c->D);
    table16 table;
    make_exp_table(1, &table);
    around n;
    reduced_rises(g, f, c->rise);
    for (int k = 0; k < 3; k++)
        load_around(f, k - REACH, &n, k);
    for (ptrdiff_t J = 1 - REACH; J < (ptrdiff_t)g->S + REACH - 2; J++) {
        ivec i = nodes(g, J), upstream = (i >= c->first) & (i < c->end);
        load_around(f, J + 2, &n, 3);
        vec eps = middle(&table, c->log_eps, f, upstream, J);
        vec share = choose(upstream, reduced_share(c->log_eps, J), all(1));
        vec direct = eps * (scale * steepness(f, J));
        vec reduced = reduced_flux(c, f, &n, J);
        put(c->flux, J,
            choose(share < 1, (1 - share) * direct, all(0)) +
                choose(share > 0, share * reduced, all(0)));
        for (int k = 0; k < 3; k++) {
            n.cube[k] = n.cube[k + 1];
            n.rho[k] = n.rho[k + 1];
        }
    }
}

/* Left-hand side of the equation of fourth order minus that of second order. */
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
    double *const fields[] = {
        f->P, f->H,    f->rho,  f->eps,          f->deps,
        f->q, f->flow, f->drag, f->log_fluidity, f->log_slope};
    for (size_t k = 0; k < sizeof fields / sizeof *fields; k++)
        if (fields[k])
            repeat_ends(fields[k], S, REACH);
    logarithms(g, f->eps, c->log_eps);
    if (ovr_flow_is_shear_thinning(c->fluid))
        thinned_fluxes(g, c, f);
    else if (c->reduced)
        reduced_fluxes(g, c, f);
    else
        fluxes(g, c, f);
    double share = c->linear ? 1. / 12 : 1. / 24;
    for (ptrdiff_t J = 0; J < S; J++) {
        vec gap = share * second_difference(w, J) +
                  (c->local * c->D) * second_difference(f->P, J);
        put(c->F, J, choose(at(c->mask, J) > 0, -excess(c, f, J), all(0)));
        put(c->gap, J, choose(inside(g, J), gap, all(0)));
    }
    repeat_ends(c->gap, S, OVR_HALO);
}
