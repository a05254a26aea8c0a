/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Flow of a film that shears thin (equations in flow.h): 2 E, 2 T, R at all
 * half nodes that rows reach, from P and the film. */
#include "multigrid/flow.h"
#include "multigrid/eyring.h"
#include "multigrid/faces.h"
#include "multigrid/flow_table.h"

/* Sums over both nodes: eps, c, B c; 2 W and 1/(2 W); by the gap, the shares of
 * the node before in eps and c. */
typedef struct half {
    vec eps, c, bc, W, inv_W, share, square;
} half;

/* psi_c q */
static inline vec dragged(const ovr_fields *f, ptrdiff_t J)
{
    return f->drag ? at(f->drag, J) * at(f->q, J) : at(f->q, J);
}

/* eps and psi_c rho H^2 of both nodes */
static INLINE half sums_at(const ovr_fields *f, bool gap, double slide,
                           ptrdiff_t J)
{
    vec H = at(f->H, J), G = at(f->H, J + 1);
    if (!gap) {
        vec drag = fused(dragged(f, J), H, dragged(f, J + 1) * G);
        return (half){.eps = at(f->eps, J) + at(f->eps, J + 1),
                      .c = slide * drag};
    }
    vec share = face_share(H, G), square = face_square_share(H, G);
    vec sum = face_sum(share, at(f->eps, J), at(f->eps, J + 1));
    vec drag = face_sum(square, dragged(f, J) * H, dragged(f, J + 1) * G);
    return (half){.eps = larger(sum, all(0)),
                  .c = slide * larger(drag, all(0)),
                  .share = share,
                  .square = square};
}

static INLINE half half_at(const ovr_fields *f, bool gap, double slide, vec B,
                           ptrdiff_t J)
{
    const double minimum = 1e-290; /* its root is W where all else vanishes */
    half h = sums_at(f, gap, slide, J);
    h.bc = B * h.c;
    vec square = fused(h.eps, h.eps, fused(h.bc, h.bc, all(minimum)));
    h.inv_W = inverse_root(square);
    h.W = square * h.inv_W;
    return h;
}

/* d(2 eps)/dH of node J, the other being K, whose share is p. */
static inline vec eps_by_film(const ovr_fields *f, ptrdiff_t J, ptrdiff_t K,
                              vec p)
{
    return face_by_film(3, p, at(f->H, J), at(f->deps_dH, J), at(f->eps, J),
                        at(f->eps, K));
}

/* The same of psi_c rho H^2. */
static inline vec drag_by_film(const ovr_fields *f, ptrdiff_t J, ptrdiff_t K,
                               vec p)
{
    vec H = at(f->H, J), d = dragged(f, J);
    return face_by_film(2, p, H, 2 * d, d * H, dragged(f, K) * at(f->H, K));
}

/* 2 dE/dH of both nodes, by eps, c and g. */
static INLINE void put_by_film(const ovr_fields *f, bool gap, ptrdiff_t J,
                               const half *h, vec R, vec by_c, vec by_g)
{
    ptrdiff_t K = J + 1;
    vec eps[2] = {at(f->deps_dH, J), at(f->deps_dH, K)};
    vec drag[2] = {2 * dragged(f, J), 2 * dragged(f, K)};
    if (gap) {
        eps[0] = eps_by_film(f, J, K, h->share);
        eps[1] = eps_by_film(f, K, J, 2 - h->share);
        drag[0] = drag_by_film(f, J, K, h->square);
        drag[1] = drag_by_film(f, K, J, 2 - h->square);
    }
    put(f->by_left, J, fused(R, eps[0], fused(by_c, drag[0], by_g)));
    put(f->by_right, J, fused(R, eps[1], fused(by_c, drag[1], by_g)));
}

/* `film`: whether changes by the film have a place. */
static INLINE void by_table(const ovr_fluid *fluid, double D,
                            const ovr_lanes *g, const ovr_fields *f, bool gap,
                            bool film)
{
    const ovr_fields own = *f;
    const double *table = fluid->lubricant.flow_law->flow;
    double slide = ovr_flow_slide(fluid);
    double gradient = ovr_flow_gradient(fluid, D);
    log_table log;
    exp_table growth;
    make_log_table(1, &log);
    make_exp_table(1, &growth);
    for (ptrdiff_t J = -OVR_HALO; J < (ptrdiff_t)g->S; J++) {
        vec H = at(own.H, J) + at(own.H, J + 1);
        vec dP = at(own.P, J + 1) - at(own.P, J);
        half h = half_at(&own, gap, slide, all(0), J);
        vec eps = larger(h.eps, all(1e-290));
        vec s_N = smaller(h.c / eps, all(1e280));
        law_value v = law_at(table, s_N, gradient * H * dP);
        vec Phi = law_power(&growth, &log, &v), flow = Phi * eps;
        vec R = Phi * less(all(1), v.s, v.by_s);
        vec tangent = flow * fused(v.g, v.by_g, all(1));
        put(own.flow, J, flow);
        put(own.tangent, J, tangent);
        put(own.by_eps, J, R);
        if (gap)
            put(own.share, J, h.share);
        if (film)
            put_by_film(&own, gap, J, &h, R, slide * Phi * v.by_s / v.beyond,
                        (tangent - flow) / H);
    }
}

static INLINE void by_eyring(const ovr_fluid *fluid, double D,
                             const ovr_lanes *g, const ovr_fields *f, bool gap,
                             bool film)
{
    const ovr_fields own = *f; /* a copy that no store can change */
    double slide = ovr_flow_slide(fluid);
    double gradient = ovr_flow_gradient(fluid, D);
    exp_table growth;
    make_exp_table(1, &growth);
    for (ptrdiff_t J = -OVR_HALO; J < (ptrdiff_t)g->S; J++) {
        vec H = at(own.H, J) + at(own.H, J + 1);
        vec dP = at(own.P, J + 1) - at(own.P, J);
        eyring e = eyring_at(&growth, gradient * H * dP);
        half h = half_at(&own, gap, slide, e.B, J);
        vec flow = e.A * h.W, R = e.A * h.eps * h.inv_W;
        vec bend = (1. / 3) * e.A * e.A * e.B * e.square * h.bc * h.bc;
        vec tangent = less((3 * e.shc - 2 * e.A) * h.W, bend, h.inv_W);
        put(own.flow, J, flow);
        put(own.tangent, J, tangent);
        put(own.by_eps, J, R);
        if (gap)
            put(own.share, J, h.share);
        if (film)
            put_by_film(&own, gap, J, &h, R, slide * e.A * e.B * h.bc * h.inv_W,
                        (tangent - flow) / H);
    }
}

static INLINE void by_law(const ovr_fluid *fluid, double D, const ovr_lanes *g,
                          const ovr_fields *f, bool gap, bool film)
{
    if (fluid->lubricant.rheology == OVR_EYRING)
        by_eyring(fluid, D, g, f, gap, film);
    else
        by_table(fluid, D, g, f, gap, film);
}

void OVR_KERNEL(flow)(const ovr_fluid *fluid, double D, const ovr_lanes *g,
                      const ovr_fields *f)
{
    if (f->share && f->by_left)
        by_law(fluid, D, g, f, true, true);
    else if (f->share)
        by_law(fluid, D, g, f, true, false);
    else if (f->by_left)
        by_law(fluid, D, g, f, false, true);
    else
        by_law(fluid, D, g, f, false, false);
}

static INLINE void by_gap(const ovr_lanes *g, const ovr_fields *f, bool film)
{
    const ovr_fields own = *f;
    for (ptrdiff_t J = -OVR_HALO; J < (ptrdiff_t)g->S; J++) {
        vec p = face_share(at(own.H, J), at(own.H, J + 1));
        vec sum = face_sum(p, at(own.eps, J), at(own.eps, J + 1));
        put(own.share, J, p);
        put(own.flow, J, larger(sum, all(0)));
        if (film) {
            put(own.by_left, J, eps_by_film(&own, J, J + 1, p));
            put(own.by_right, J, eps_by_film(&own, J + 1, J, 2 - p));
        }
    }
}

/* Stores faces by the gap, without a flow law. */
void OVR_KERNEL(faces)(const ovr_lanes *g, const ovr_fields *f)
{
    if (f->by_left)
        by_gap(g, f, true);
    else
        by_gap(g, f, false);
}
