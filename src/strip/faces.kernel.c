/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Poiseuille flow at half nodes, along X and across, between two nodes a and b
 * at distance h.
 *
 *     flow = E (P_b - P_a),   E = phi_ab a_ab/h^2,   eps = phi H^3,
 *     phi = rho m
 *     a_ab = 2 A B/(A + B),   A = H_a^3,  B = H_b^3
 *     phi_ab = (phi_a + phi_b)/2
 *     or       (rho_a + rho_b)/2 (m_b - m_a)/ln(m_b/m_a)
 *
 * The mean a_ab sums the resistances of the gap (multigrid/faces.h).  If ln m
 * is linear in pressure, the logarithmic mean is the mean of m over pressure.
 * The derivatives of the flow are then -phi_a a_ab/h^2 and phi_b a_ab/h^2 at
 * constant density, which is elliptic at any step of pressure.  With secants
 * both are at least E.  At the peak of a spike phi is smallest; without
 * secants, Newton steps far from the solution are too large there.
 *
 * Both means are of second order.  At a pressure spike m changes by e^1 to e^7
 * in a mesh size.  There the arithmetic mean is too large by the factor
 * (d/2)/tanh(d/2), d = ln(m_b/m_a).
 *
 * With a rheological model E is that of thinning.h for this eps, with
 * derivatives by the chain rule.
 *
 * For |d| < 0.1 the quotient of the means is the series of tanh(d/2)/(d/2) to
 * the sixth power (error 1e-12).  In a_ab films below 1e-6 are replaced by
 * 1e-6.
 */
#include <math.h>

#include "multigrid/power.h"
#include "strip/kernels.h"
#include "strip/thinning.h"

/* Values of a node used at its four half nodes. */
typedef struct node {
    vec g;               /* 1/H^3 */
    vec phi, slope, log; /* log: of m */
    vec rho;
} node;

static inline node node_at(const ovr_strip_fields *f, const log_table *log,
                           bool logarithmic, size_t at_node)
{
    const double thinnest = 1e-6, least = 1e-280;
    vec H = load(f->H + at_node), cube = H * H * H;
    vec h = larger(H, all(thinnest));
    node a = {.g = 1 / (h * h * h)};
    vec inverse = a.g;
    if (any(H < thinnest))
        inverse = 1 / choose(cube * cube < least, all(1e-140), cube);
    a.phi = larger(load(f->eps + at_node) * inverse, all(least));
    if (logarithmic) {
        a.rho = load(f->rho + at_node);
        a.log = scaled_log2(log, a.phi / a.rho);
    } else {
        a.slope = load(f->deps + at_node) * inverse;
    }
    return a;
}

/* Nodes of a row in `work`. */
enum { ROWS = 4 };

static inline void keep(const ovr_strip_grid *g, bool logarithmic, node a,
                        size_t j, double *work)
{
    store(work + j, a.g);
    store(work + g->stride + j, a.phi);
    store(work + 2 * g->stride + j, logarithmic ? a.log : a.slope);
    if (logarithmic)
        store(work + 3 * g->stride + j, a.rho);
}

static inline node kept(const ovr_strip_grid *g, bool logarithmic, size_t j,
                        const double *work)
{
    node a = {.g = load(work + j), .phi = load(work + g->stride + j)};
    vec third = load(work + 2 * g->stride + j);
    if (logarithmic) {
        a.log = third;
        a.rho = load(work + 3 * g->stride + j);
    } else {
        a.slope = third;
    }
    return a;
}

/* Logarithmic mean of m times the mean density. */
static inline vec mean_of(node a, node b)
{
    vec d = b.log - a.log, square = d * d;
    vec m = a.phi / a.rho, n = b.phi / b.rho;
    vec density = 0.5 * (a.rho + b.rho);
    ivec near = square < 1e-2;
    vec series = less(all(1. / 120), all(17. / 20160), square);
    series = fused(square, fused(square, series, all(-1. / 12)), all(1));
    vec far = (n - m) / choose(near, all(1), d);
    return density * choose(near, 0.5 * (m + n) * series, far);
}

/* Newtonian, Eyring's or another law. */
typedef enum flow_kind { NEWTONIAN, BY_SINH, BY_CURVE } flow_kind;

/* Arguments of a pass over a grid. */
typedef struct faces {
    const ovr_strip_grid *g;
    ovr_strip_fields f;
    log_table log;
    thinning law;
    double secant; /* 1 or 0 */
} faces;

/* A half node: its two nodes, mesh size, gradients of P, and direction of the
 * flow. */
typedef struct face {
    node a, b;
    size_t at_a, at_b;
    double mesh;
    vec along, across;
} face;

/* Arrays of a half node's flow. */
typedef struct stored {
    double *E, *before, *after, *by_a, *by_b;
} stored;

static inline vec film_at(const faces *p, size_t k)
{
    return larger(load(p->f.H + k), all(1e-6));
}

/* Stores the derivatives of a flow with respect to both film thicknesses, from
 * those of E with respect to eps, c and H. */
static inline void store_by_film(const faces *p, const face *h, vec dP, vec eps,
                                 const thinned *flow, vec c, size_t k,
                                 const stored *to)
{
    vec H = film_at(p, h->at_a), G = film_at(p, h->at_b);
    vec share = 3 / (h->a.g + h->b.g), a2 = H * H, b2 = G * G;
    vec slides = 2 * flow->by_c * c / (a2 + b2);
    vec bends = (flow->T - flow->E) / (H + G);
    vec by_a = flow->by_eps * (share * h->a.g) / H + slides * b2 / H + bends;
    vec by_b = flow->by_eps * (share * h->b.g) / G + slides * a2 / G + bends;
    (void)eps;
    store(to->by_a + k, dP * by_a);
    store(to->by_b + k, dP * by_b);
}

/* Stores the flow of a half node at k, with the rheological model of thinning.h
 * if there is one. */
static INLINE void store_face(const faces *p, bool logarithmic, flow_kind thins,
                              bool across, const face *h, size_t k,
                              const stored *to)
{
    const double scale = 1 / (h->mesh * h->mesh);
    vec dP = load(p->f.P + h->at_b) - load(p->f.P + h->at_a);
    vec gap = 2 / (h->a.g + h->b.g), eps, before, after, c = all(0);
    if (logarithmic) {
        eps = mean_of(h->a, h->b) * gap;
        before = larger(h->a.phi * gap, p->secant * eps);
        after = larger(h->b.phi * gap, p->secant * eps);
    } else {
        vec half = 0.5 * gap * dP;
        eps = 0.5 * (h->a.phi + h->b.phi) * gap;
        before = less(eps, h->a.slope, half);
        after = fused(h->b.slope, half, eps);
    }
    thinned flow = {eps, eps, eps, all(0)};
    if (thins) {
        vec H = film_at(p, h->at_a), G = film_at(p, h->at_b);
        vec a2 = H * H, b2 = G * G, films = p->law.gradient * (H + G);
        c = p->law.slide *
            (load(p->f.rho + h->at_a) + load(p->f.rho + h->at_b)) *
            (a2 * b2 / (a2 + b2));
        flow = (thins == BY_CURVE ? thinned_by_curve : thinned_by_eyring)(
            &p->law, across, eps, c, films * h->along, films * h->across);
        vec share = flow.by_eps / larger(eps, all(1e-280));
        before = fused(share, before - eps, flow.T);
        after = fused(share, after - eps, flow.T);
    }
    store(to->E + k, scale * flow.E);
    store(to->before + k, scale * before);
    store(to->after + k, scale * after);
    if (to->by_a)
        store_by_film(p, h, scale * dP, eps, &flow, c, k, to);
}

/* Central difference of P across lines at a node. */
static inline vec slope_across(const faces *p, size_t k)
{
    return (load(p->f.P + k + 1) - load(p->f.P + k - 1)) / (2 * p->g->Dy);
}

static inline vec slope_along(const faces *p, size_t k)
{
    const size_t s = p->g->stride;
    return (load(p->f.P + k + s) - load(p->f.P + k - s)) / (2 * p->g->D);
}

static INLINE void face_along(const faces *p, bool logarithmic, flow_kind thins,
                              size_t k, face *h)
{
    const ovr_strip_fields *f = &p->f;
    const stored to = {f->along, f->along_before, f->along_after,
                       f->along_by_film[0], f->along_by_film[1]};
    h->at_a = k;
    h->at_b = k + p->g->stride;
    h->mesh = p->g->D;
    if (thins) {
        h->along = (load(f->P + h->at_b) - load(f->P + k)) / p->g->D;
        h->across = 0.5 * (slope_across(p, k) + slope_across(p, h->at_b));
    }
    store_face(p, logarithmic, thins, false, h, k, &to);
}

static INLINE void face_across(const faces *p, bool logarithmic,
                               flow_kind thins, size_t k, face *h)
{
    const ovr_strip_fields *f = &p->f;
    const stored to = {f->across, f->across_before, f->across_after,
                       f->across_by_film[0], f->across_by_film[1]};
    h->at_a = k;
    h->at_b = k + 1;
    h->mesh = p->g->Dy;
    if (thins) {
        h->across = (load(f->P + k + 1) - load(f->P + k)) / p->g->Dy;
        h->along = 0.5 * (slope_along(p, k) + slope_along(p, k + 1));
    }
    store_face(p, logarithmic, thins, true, h, k, &to);
}

/* Half nodes i + 1/2 and j + 1/2 of the rows. */
static INLINE void all_faces(const faces *p, ovr_part rows, bool logarithmic,
                             flow_kind thins, double *work)
{
    const ovr_strip_grid *g = p->g;
    const size_t first = OVR_STRIP_HALO, s = g->stride;
    const size_t end = first + (g->lines + VEC - 1) / VEC * VEC;
    double *here = work, *next = work + ROWS * s;
    for (size_t i = rows.from; i <= rows.to && i < g->n; i++) {
        /* Elements start in the halo before line 0. */
        size_t row = ovr_strip_row(g, i) - first;
        for (size_t j = 0; j < end + VEC && j < s; j += VEC) {
            keep(g, logarithmic, node_at(&p->f, &p->log, logarithmic, row + j),
                 j, next);
            if (i == rows.from || j < first || j >= end)
                continue;
            face h = {.a = kept(g, logarithmic, j, here),
                      .b = kept(g, logarithmic, j, next)};
            face_along(p, logarithmic, thins, row - s + j, &h);
        }
        /* Flow across lines is not used in the end rows. */
        bool beside = i && i < rows.to && i + 1 < g->n;
        for (size_t j = first - VEC; beside && j < end; j += VEC) {
            face h = {.a = kept(g, logarithmic, j, next),
                      .b = kept(g, logarithmic, j + 1, next)};
            face_across(p, logarithmic, thins, row + j, &h);
        }
        double *t = here;
        here = next;
        next = t;
    }
}

void OVR_STRIP_KERNEL(faces)(const ovr_strip_grid *g, ovr_part rows,
                             const ovr_fluid *fluid, bool logarithmic,
                             const ovr_strip_fields *f, double *work)
{
    const double Sigma0 = fluid->lubricant.Sigma0;
    const flow_kind kind = fluid->lubricant.rheology == OVR_NEWTONIAN
                               ? NEWTONIAN
                           : fluid->lubricant.flow_law ? BY_CURVE
                                                       : BY_SINH;
    faces p = {.g = g, .f = *f, .secant = fluid->secants};
    make_log_table(0x1.62e42fefa39efp-1, &p.log);
    if (kind != NEWTONIAN) {
        p.law.slide = fabs(fluid->sliding) / (12 * Sigma0);
        p.law.gradient = 1 / (4 * Sigma0);
        p.law.log = p.log;
        make_exp_table(1, &p.law.exp);
    }
    if (kind == BY_CURVE) {
        p.law.curve = fluid->lubricant.flow_law;
        make_log_table(1, &p.law.log2);
        make_log_table(0x1.62e42fefa39efp-1 / OVR_CURVE_STEP, &p.law.steps);
    }
    if (logarithmic && kind == BY_CURVE)
        all_faces(&p, rows, true, BY_CURVE, work);
    else if (logarithmic && kind == BY_SINH)
        all_faces(&p, rows, true, BY_SINH, work);
    else if (logarithmic)
        all_faces(&p, rows, true, NEWTONIAN, work);
    else if (kind == BY_CURVE)
        all_faces(&p, rows, false, BY_CURVE, work);
    else if (kind == BY_SINH)
        all_faces(&p, rows, false, BY_SINH, work);
    else
        all_faces(&p, rows, false, NEWTONIAN, work);
}
