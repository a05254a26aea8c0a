/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Fourth-order correction of shear-thinning films (fourth_order.h), for whole
 * vectors: the flux at a half node is E p, with E of the rheological model
 * (flow.h) for eps, rho H^2, H and the gradient there, each of fourth order:
 *     x_{i+1/2} = [9 (x_i + x_{i+1}) - x_{i-1} - x_{i+2}]/16
 * eps is interpolated by its logarithm and limited to within 40 % of the
 * two-node mean of the second-order equation (faces.h).
 */
#ifndef OVR_MULTIGRID_FOURTH_THINNING_H
#define OVR_MULTIGRID_FOURTH_THINNING_H

#include "multigrid/eyring.h"
#include "multigrid/faces.h"
#include "multigrid/flow.h"
#include "multigrid/flow_table.h"

/* The rheological model and its arguments. */
typedef struct thinning {
    const double *table; /* NULL: Eyring's law */
    double slide, gradient;
    face_kind kind;
    log_table log;
    exp_table growth;
} thinning;

static inline thinning thinning_of(const ovr_fluid *fluid, double D)
{
    thinning t = {.slide = ovr_flow_slide(fluid),
                  .gradient = ovr_flow_gradient(fluid, D),
                  .kind = face_kind_of(fluid)};
    if (fluid->lubricant.rheology != OVR_EYRING)
        t.table = fluid->lubricant.flow_law->flow;
    make_log_table(1, &t.log);
    make_exp_table(1, &t.growth);
    return t;
}

/* 16 x_{i+1/2} */
static inline vec sixteen(vec before, vec left, vec right, vec behind)
{
    return 9 * (left + right) - before - behind;
}

static inline vec sixteen_at(const double *x, ptrdiff_t J)
{
    return sixteen(at(x, J - 1), at(x, J), at(x, J + 1), at(x, J + 2));
}

/* rho H as used in the sliding stress with temperatures across the film
 * (fields.h). */
static inline vec sliding_content(const ovr_fields *f, ptrdiff_t J)
{
    return f->drag ? at(f->drag, J) * at(f->q, J) : at(f->q, J);
}

/* 2 eps at i + 1/2; log_eps is log2(eps)/16. */
static inline vec twice_eps(const thinning *t, const ovr_fields *f,
                            const double *log_eps, ptrdiff_t J)
{
    vec sum = face_at(f, t->kind, 0, J).flow;
    vec value = 2 * scaled_exp2(&t->growth, sixteen_at(log_eps, J));
    return smaller(larger(value, 0.6 * sum), 1.4 * sum);
}

/* 2 E at i + 1/2 from the pressure difference over D; all arguments of fourth
 * order. */
static inline vec thinned(const thinning *t, const ovr_fields *f,
                          const double *log_eps, vec rise, ptrdiff_t J)
{
    vec H = (1. / 16) * sixteen_at(f->H, J);
    vec content = (1. / 16) *
                  sixteen(sliding_content(f, J - 1), sliding_content(f, J),
                          sliding_content(f, J + 1), sliding_content(f, J + 2));
    vec eps = twice_eps(t, f, log_eps, J);
    vec c = (2 * t->slide) * larger(content * H, all(0));
    vec g = (2 * t->gradient) * H * rise;
    if (t->table) {
        vec some = larger(eps, all(1e-290));
        law_value v = law_at(t->table, smaller(c / some, all(1e280)), g);
        return law_power(&t->growth, &t->log, &v) * some;
    }
    eyring e = eyring_at(&t->growth, g);
    vec bc = e.B * c, square = fused(eps, eps, fused(bc, bc, all(1e-290)));
    return e.A * square * inverse_root(square);
}

#endif
