/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Flow of a shear-thinning film (equations in flow.h): 2 E, 2 T and R at all
 * half nodes that rows read, from P and the film. */
#include "multigrid/flow.h"
#include "multigrid/eyring.h"
#include "multigrid/faces.h"
#include "multigrid/flow_table.h"

/* Sums over both nodes: eps, c, B c; 2 W and 1/(2 W); fraction of c from the
 * node before. */
typedef struct half {
    face eps;
    vec c, bc, W, inv_W, square;
} half;

/* psi_c q */
static inline vec dragged(const ovr_fields *f, ptrdiff_t J)
{
    return f->drag ? at(f->drag, J) * at(f->q, J) : at(f->q, J);
}

/* eps and psi_c rho H^2 of both nodes */
static INLINE half sums_at(const ovr_fields *f, face_kind kind, double secant,
                           double slide, ptrdiff_t J)
{
    vec H = at(f->H, J), G = at(f->H, J + 1);
    half h = {.eps = face_at(f, kind, secant, J), .square = all(1)};
    if (kind == FACE_SUMS) {
        h.c = slide * fused(dragged(f, J), H, dragged(f, J + 1) * G);
        return h;
    }
    h.square = face_square_share(H, G);
    h.c = slide *
          larger(face_sum(h.square, dragged(f, J) * H, dragged(f, J + 1) * G),
                 all(0));
    return h;
}

static INLINE half half_at(const ovr_fields *f, face_kind kind, double secant,
                           double slide, vec B, ptrdiff_t J)
{
    const double minimum = 1e-290; /* its square root is W if all other terms
                                    * vanish */
    half h = sums_at(f, kind, secant, slide, J);
    h.bc = B * h.c;
    vec square = fused(h.eps.flow, h.eps.flow, fused(h.bc, h.bc, all(minimum)));
    h.inv_W = inverse_root(square);
    h.W = square * h.inv_W;
    return h;
}

/* Stores 2 E of a rheological model and its derivatives with respect to the
 * pressures, from 2 T and R: R d(2 eps)/dP_i dP = R (2 eps - left). */
static INLINE void store_flow(const ovr_fields *f, ptrdiff_t J, const face *eps,
                              vec flow, vec tangent, vec R)
{
    put(f->flow, J, flow);
    put(f->out_left, J, fused(R, eps->left - eps->flow, tangent));
    put(f->out_right, J, fused(R, eps->right - eps->flow, tangent));
}

/* d(2 eps)/dH of node J with weight p; K is the other node. */
static INLINE vec eps_by_film(const ovr_fields *f, face_kind kind, ptrdiff_t J,
                              ptrdiff_t K, vec flow, vec p)
{
    if (kind == FACE_SUMS)
        return at(f->deps_dH, J);
    if (kind == FACE_LOGARITHMIC)
        return face_logarithmic_by_film(flow, p, at(f->H, J), at(f->deps_dH, J),
                                        at(f->eps, J));
    return face_by_film(3, p, at(f->H, J), at(f->deps_dH, J), at(f->eps, J),
                        at(f->eps, K));
}

/* Derivative of psi_c rho H^2 with respect to H of node J. */
static INLINE vec drag_by_film(const ovr_fields *f, face_kind kind, ptrdiff_t J,
                               ptrdiff_t K, vec p)
{
    vec H = at(f->H, J), d = dragged(f, J);
    if (kind == FACE_SUMS)
        return 2 * d;
    return face_by_film(2, p, H, 2 * d, d * H, dragged(f, K) * at(f->H, K));
}

/* 2 dE/dH of both nodes, through eps, c and g. */
static INLINE void store_by_film(const ovr_fields *f, face_kind kind,
                                 ptrdiff_t J, const half *h, vec R, vec by_c,
                                 vec by_g)
{
    const face *e = &h->eps;
    ptrdiff_t K = J + 1;
    vec eps = eps_by_film(f, kind, J, K, e->flow, e->share);
    vec drag = drag_by_film(f, kind, J, K, h->square);
    put(f->by_left, J, fused(R, eps, fused(by_c, drag, by_g)));
    eps = eps_by_film(f, kind, K, J, e->flow, 2 - e->share);
    drag = drag_by_film(f, kind, K, J, 2 - h->square);
    put(f->by_right, J, fused(R, eps, fused(by_c, drag, by_g)));
}

/* `film`: derivatives with respect to the film thickness are stored. */
static INLINE void by_table(const ovr_fluid *fluid, double D,
                            const ovr_lanes *g, const ovr_fields *f,
                            face_kind kind, bool film)
{
    const ovr_fields own = *f;
    const double *table = fluid->lubricant.flow_law->flow;
    double slide = ovr_flow_slide(fluid), secant = fluid->secants;
    double gradient = ovr_flow_gradient(fluid, D);
    log_table log;
    exp_table growth;
    make_log_table(1, &log);
    make_exp_table(1, &growth);
    for (ptrdiff_t J = -OVR_HALO; J < (ptrdiff_t)g->S; J++) {
        vec H = at(own.H, J) + at(own.H, J + 1);
        vec dP = at(own.P, J + 1) - at(own.P, J);
        half h = half_at(&own, kind, secant, slide, all(0), J);
        vec eps = larger(h.eps.flow, all(1e-290));
        vec s_N = smaller(h.c / eps, all(1e280));
        law_value v = law_at(table, s_N, gradient * H * dP);
        vec Phi = law_power(&growth, &log, &v), flow = Phi * eps;
        vec R = Phi * less(all(1), v.s, v.by_s);
        vec tangent = flow * fused(v.g, v.by_g, all(1));
        store_flow(&own, J, &h.eps, flow, tangent, R);
        if (film)
            store_by_film(&own, kind, J, &h, R, slide * Phi * v.by_s / v.beyond,
                          (tangent - flow) / H);
    }
}

static INLINE void by_eyring(const ovr_fluid *fluid, double D,
                             const ovr_lanes *g, const ovr_fields *f,
                             face_kind kind, bool film)
{
    const ovr_fields own = *f; /* a copy, so that the compiler can assume no
                                * store changes it */
    double slide = ovr_flow_slide(fluid), secant = fluid->secants;
    double gradient = ovr_flow_gradient(fluid, D);
    exp_table growth;
    make_exp_table(1, &growth);
    for (ptrdiff_t J = -OVR_HALO; J < (ptrdiff_t)g->S; J++) {
        vec H = at(own.H, J) + at(own.H, J + 1);
        vec dP = at(own.P, J + 1) - at(own.P, J);
        eyring e = eyring_at(&growth, gradient * H * dP);
        half h = half_at(&own, kind, secant, slide, e.B, J);
        vec flow = e.A * h.W, R = e.A * h.eps.flow * h.inv_W;
        vec bend = (1. / 3) * e.A * e.A * e.B * e.square * h.bc * h.bc;
        vec tangent = less((3 * e.shc - 2 * e.A) * h.W, bend, h.inv_W);
        store_flow(&own, J, &h.eps, flow, tangent, R);
        if (film)
            store_by_film(&own, kind, J, &h, R,
                          slide * e.A * e.B * h.bc * h.inv_W,
                          (tangent - flow) / H);
    }
}

static INLINE void by_law(const ovr_fluid *fluid, double D, const ovr_lanes *g,
                          const ovr_fields *f, face_kind kind, bool film)
{
    if (fluid->lubricant.rheology == OVR_EYRING)
        by_eyring(fluid, D, g, f, kind, film);
    else
        by_table(fluid, D, g, f, kind, film);
}

static INLINE void by_mean(const ovr_fluid *fluid, double D, const ovr_lanes *g,
                           const ovr_fields *f, bool film)
{
    switch (face_kind_of(fluid)) {
    case FACE_SUMS: by_law(fluid, D, g, f, FACE_SUMS, film); break;
    case FACE_BY_GAP: by_law(fluid, D, g, f, FACE_BY_GAP, film); break;
    case FACE_LOGARITHMIC:
        by_law(fluid, D, g, f, FACE_LOGARITHMIC, film);
        break;
    }
}

void OVR_KERNEL(flow)(const ovr_fluid *fluid, double D, const ovr_lanes *g,
                      const ovr_fields *f)
{
    if (f->by_left)
        by_mean(fluid, D, g, f, true);
    else
        by_mean(fluid, D, g, f, false);
}

/* Cubes and fluidities of a node are computed once for both of its faces. */
static INLINE void newtonian(const ovr_fluid *fluid, const ovr_lanes *g,
                             const ovr_fields *f, face_kind kind, bool film)
{
    const ovr_fields own = *f;
    double secant = fluid->secants;
    face_node before = face_node_at(&own, kind, -OVR_HALO);
    for (ptrdiff_t J = -OVR_HALO; J < (ptrdiff_t)g->S; J++) {
        face_node right = face_node_at(&own, kind, J + 1);
        face_node left = face_loaded(&own, kind, J);
        left.cube = before.cube;
        left.m = before.m;
        face s = face_between(kind, secant, &left, &right);
        before = right;
        put(own.flow, J, s.flow);
        put(own.out_left, J, s.left);
        put(own.out_right, J, s.right);
        if (film) {
            put(own.by_left, J,
                eps_by_film(&own, kind, J, J + 1, s.flow, s.share));
            put(own.by_right, J,
                eps_by_film(&own, kind, J + 1, J, s.flow, 2 - s.share));
        }
    }
}

/* Stores half-node values by the gap, without rheological model. */
void OVR_KERNEL(faces)(const ovr_fluid *fluid, const ovr_lanes *g,
                       const ovr_fields *f)
{
    if (f->log_fluidity && f->by_left)
        newtonian(fluid, g, f, FACE_LOGARITHMIC, true);
    else if (f->log_fluidity)
        newtonian(fluid, g, f, FACE_LOGARITHMIC, false);
    else if (f->by_left)
        newtonian(fluid, g, f, FACE_BY_GAP, true);
    else
        newtonian(fluid, g, f, FACE_BY_GAP, false);
}
