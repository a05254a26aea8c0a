/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Flow by pressure at half nodes, along X and across, between two nodes a and b
 * at the distance h.
 *
 *     flow = E (P_b - P_a),   E = phi_ab a_ab/h^2,   eps = phi H^3
 *     a_ab = 2 A B/(A + B),   A = H_a^3,  B = H_b^3
 *     phi_ab = (phi_a + phi_b)/2   or   (phi_b - phi_a)/ln(phi_b/phi_a)
 *
 * The mean a_ab sums the resistances of the gap (faces.h).  If ln phi is linear
 * in pressure, the logarithmic mean is the mean of phi over pressure.  The
 * derivatives of the flow are then -phi_a a_ab/h^2 and phi_b a_ab/h^2, which is
 * elliptic at any step of pressure.
 *
 * Both means are of second order.  At a pressure spike phi changes by e^1 to
 * e^7 in a mesh size.  There the arithmetic mean is too large by the factor
 * (d/2)/tanh(d/2), d = ln(phi_b/phi_a).
 *
 * For |d| < 0.1 the quotient of the means is the series of tanh(d/2)/(d/2) to
 * the sixth power (error 1e-12).  In a_ab films below 1e-6 are replaced by
 * 1e-6.
 */
#include "multigrid/power.h"
#include "strip/kernels.h"

/* Values of a node that its four half nodes use. */
typedef struct node {
    vec g; /* 1/H^3 */
    vec phi, slope, log;
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
    if (logarithmic)
        a.log = scaled_log2(log, a.phi);
    else
        a.slope = load(f->deps + at_node) * inverse;
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
}

static inline node kept(const ovr_strip_grid *g, bool logarithmic, size_t j,
                        const double *work)
{
    node a = {.g = load(work + j), .phi = load(work + g->stride + j)};
    vec third = load(work + 2 * g->stride + j);
    if (logarithmic)
        a.log = third;
    else
        a.slope = third;
    return a;
}

/* Logarithmic mean of phi. */
static inline vec mean_of(node a, node b)
{
    vec d = b.log - a.log, square = d * d;
    ivec near = square < 1e-2;
    vec series = less(all(1. / 120), all(17. / 20160), square);
    series = fused(square, fused(square, series, all(-1. / 12)), all(1));
    vec far = (b.phi - a.phi) / choose(near, all(1), d);
    return choose(near, 0.5 * (a.phi + b.phi) * series, far);
}

/* E, -d flow/dP_a and d flow/dP_b between nodes whose P differs by dP. */
static inline void put_face(node a, node b, bool logarithmic, double scale,
                            vec dP, double *E, double *before, double *after)
{
    vec gap = 2 * scale / (a.g + b.g);
    if (logarithmic) {
        store(E, mean_of(a, b) * gap);
        store(before, a.phi * gap);
        store(after, b.phi * gap);
        return;
    }
    vec here = 0.5 * (a.phi + b.phi) * gap, half = 0.5 * gap * dP;
    store(E, here);
    store(before, less(here, a.slope, half));
    store(after, fused(b.slope, half, here));
}

static INLINE void all_faces(const ovr_strip_grid *g, bool logarithmic,
                             const ovr_strip_fields *own, double *work)
{
    const ovr_strip_fields f = *own;
    const double along = 1 / (g->D * g->D), across = 1 / (g->Dy * g->Dy);
    const size_t first = OVR_STRIP_HALO, s = g->stride;
    const size_t end = first + (g->lines + VEC - 1) / VEC * VEC;
    double *here = work, *next = work + ROWS * s;
    log_table log;
    make_log_table(0x1.62e42fefa39efp-1, &log);
    for (size_t i = 0; i < g->n; i++) {
        /* Elements from the halo before line 0 on. */
        size_t row = ovr_strip_row(g, i) - first;
        for (size_t j = 0; j < end + VEC && j < s; j += VEC) {
            keep(g, logarithmic, node_at(&f, &log, logarithmic, row + j), j,
                 next);
            if (!i)
                continue;
            size_t before = row - s + j;
            put_face(kept(g, logarithmic, j, here),
                     kept(g, logarithmic, j, next), logarithmic, along,
                     load(f.P + row + j) - load(f.P + before), f.along + before,
                     f.along_before + before, f.along_after + before);
        }
        for (size_t j = first - VEC; j < end; j += VEC)
            put_face(kept(g, logarithmic, j, next),
                     kept(g, logarithmic, j + 1, next), logarithmic, across,
                     load(f.P + row + j + 1) - load(f.P + row + j),
                     f.across + row + j, f.across_before + row + j,
                     f.across_after + row + j);
        double *t = here;
        here = next;
        next = t;
    }
}

void OVR_STRIP_KERNEL(faces)(const ovr_strip_grid *g, bool logarithmic,
                             const ovr_strip_fields *f, double *work)
{
    if (logarithmic)
        all_faces(g, true, f, work);
    else
        all_faces(g, false, f, work);
}
