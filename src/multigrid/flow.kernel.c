/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Flow of a film that shears thin (equations in flow.h): 2 E, 2 T, R at all
 * half nodes that rows reach, from P and the film. */
#include "multigrid/flow.h"
#include "multigrid/eyring.h"
#include "multigrid/flow_table.h"

/* Of both nodes, summed: eps, c, B c; 2 W and 1/(2 W). */
typedef struct half {
    vec eps, c, bc, W, inv_W;
} half;

/* psi_c q */
static inline vec dragged(const ovr_fields *f, ptrdiff_t J)
{
    return f->drag ? at(f->drag, J) * at(f->q, J) : at(f->q, J);
}

static inline half half_at(const ovr_fields *f, double slide, vec B,
                           ptrdiff_t J)
{
    const double least = 1e-290; /* its root is W where all else vanishes */
    vec drag = fused(dragged(f, J), at(f->H, J),
                     dragged(f, J + 1) * at(f->H, J + 1));
    half h = {.eps = at(f->eps, J) + at(f->eps, J + 1), .c = slide * drag};
    h.bc = B * h.c;
    vec square = fused(h.eps, h.eps, fused(h.bc, h.bc, all(least)));
    h.inv_W = inverse_root(square);
    h.W = square * h.inv_W;
    return h;
}

/* 2 dE/dH of node J + k, by eps, c and g */
static inline vec by_film(const ovr_fields *f, ptrdiff_t J, vec R, vec by_c,
                          vec by_g)
{
    return fused(R, at(f->deps_dH, J), fused(by_c, 2 * dragged(f, J), by_g));
}

/* 2 dE/dH of both nodes. */
static inline void put_by_film(const ovr_fields *f, ptrdiff_t J, vec R,
                               vec by_c, vec by_g)
{
    put(f->by_left, J, by_film(f, J, R, by_c, by_g));
    put(f->by_right, J, by_film(f, J + 1, R, by_c, by_g));
}

/* `film`: whether changes by the film have a place. */
static INLINE void by_table(const ovr_fluid *fluid, double D,
                            const ovr_lanes *g, const ovr_fields *f, bool film)
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
        half h = half_at(&own, slide, all(0), J);
        vec eps = larger(h.eps, all(1e-290));
        vec s_N = smaller(h.c / eps, all(1e280));
        law_value v = law_at(table, s_N, gradient * H * dP);
        vec Phi = law_power(&growth, &log, &v), flow = Phi * eps;
        vec R = Phi * less(all(1), v.s, v.by_s);
        vec tangent = flow * fused(v.g, v.by_g, all(1));
        put(own.flow, J, flow);
        put(own.tangent, J, tangent);
        put(own.by_eps, J, R);
        if (film)
            put_by_film(&own, J, R, slide * Phi * v.by_s / v.beyond,
                        (tangent - flow) / H);
    }
}

static INLINE void by_eyring(const ovr_fluid *fluid, double D,
                             const ovr_lanes *g, const ovr_fields *f, bool film)
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
        half h = half_at(&own, slide, e.B, J);
        vec flow = e.A * h.W, R = e.A * h.eps * h.inv_W;
        vec bend = (1. / 3) * e.A * e.A * e.B * e.square * h.bc * h.bc;
        vec tangent = less((3 * e.shc - 2 * e.A) * h.W, bend, h.inv_W);
        put(own.flow, J, flow);
        put(own.tangent, J, tangent);
        put(own.by_eps, J, R);
        if (film)
            put_by_film(&own, J, R, slide * e.A * e.B * h.bc * h.inv_W,
                        (tangent - flow) / H);
    }
}

void OVR_KERNEL(flow)(const ovr_fluid *fluid, double D, const ovr_lanes *g,
                      const ovr_fields *f)
{
    bool is_eyring = fluid->lubricant.rheology == OVR_EYRING;
    if (is_eyring && f->by_left)
        by_eyring(fluid, D, g, f, true);
    else if (is_eyring)
        by_eyring(fluid, D, g, f, false);
    else if (f->by_left)
        by_table(fluid, D, g, f, true);
    else
        by_table(fluid, D, g, f, false);
}
