/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Modes of a surface's thermal memory (equations in modes.h), in vectors of
 * modes, node by node; near the ends mode by mode. */
#include "multigrid/modes.h"
#include "multigrid/kernels.h"
#include "multigrid/vector.h"

enum { VECTORS = OVR_MODES / VEC };

void OVR_KERNEL(sum_modes)(size_t n, const double *weight, const double *psi,
                           double q_weight, const double *q, double *sum)
{
    vec w[VECTORS];
    for (int k = 0; k < VECTORS; k++)
        w[k] = load(weight + k * VEC);
    for (size_t i = 0; i < n; i++) {
        const double *at = psi + i * OVR_MODES;
        vec part = w[0] * load(at);
        double whole = q_weight * q[i];
        UNROLL
        for (int k = 1; k < VECTORS; k++)
            part = fused(w[k], load(at + k * VEC), part);
        for (int l = 0; l < VEC; l++)
            whole += part[l];
        sum[i] = whole;
    }
}

/* Modes of node i at its departure point. */
static INLINE void carried(const ovr_modes_step *w, const ovr_departures *f,
                           const double *psi, size_t i, vec *v)
{
    const double *at = psi + ((ptrdiff_t)i + f->first) * OVR_MODES;
    if (i < f->from || i >= f->to) {
        double each[OVR_MODES];
        for (int m = 0; m < OVR_MODES; m++)
            each[m] = ovr_mode_at(f, w->spread, psi, m, i);
        for (int k = 0; k < VECTORS; k++)
            v[k] = load(each + k * VEC);
        return;
    }
    UNROLL
    for (int k = 0; k < VECTORS; k++) {
        const double *from = at + k * VEC;
        vec sum = f->c[0] * load(from);
        sum = fused(all(f->c[1]), load(from + OVR_MODES), sum);
        sum = fused(all(f->c[2]), load(from + 2 * OVR_MODES), sum);
        v[k] = fused(all(f->c[3]), load(from + 3 * OVR_MODES), sum);
    }
}

/* Advances convected and diffused modes by a time step. */
static INLINE void later(const ovr_modes_step *w, size_t i, const vec *v,
                         double *to)
{
    vec q = all(w->q[i]), q_before = all(w->q_before[i]);
    UNROLL
    for (int k = 0; k < VECTORS; k++) {
        vec sum = load(w->fade + k * VEC) * v[k];
        sum = fused(load(w->now + k * VEC), q, sum);
        sum = fused(load(w->before + k * VEC), q_before, sum);
        store(to + i * OVR_MODES + k * VEC, sum);
    }
}

/* One node of a sweep: x <- c v + b0 x - b1 before; `before` is the previous x.
 */
static INLINE void sweep(const ovr_sweeps *s, const vec *v, vec *x, vec *before)
{
    UNROLL
    for (int k = 0; k < VECTORS; k++) {
        vec next = fused(all(-s->b[1]), before[k], s->c * v[k]);
        next = fused(all(s->b[0]), x[k], next);
        before[k] = x[k];
        x[k] = next;
    }
}

/* Initial value of a sweep from outside the domain, where the end value is v.
 */
static INLINE void beyond(const double gain[2][OVR_MODES], const vec *v, vec *x,
                          vec *before)
{
    for (int k = 0; k < VECTORS; k++) {
        x[k] = load(gain[0] + k * VEC) * v[k];
        before[k] = load(gain[1] + k * VEC) * v[k];
    }
}

/* The sweep along x: y_i; and the initial values of z. */
static INLINE void forth(const ovr_modes_step *w, const double *psi, double *to,
                         vec *z, vec *after)
{
    const ovr_departures f = *w->departures;
    const ovr_sweeps s = w->spread->past;
    vec y[VECTORS], before[VECTORS], v[VECTORS];
    carried(w, &f, psi, 0, v);
    beyond(w->spread->left, v, y, before);
    for (size_t i = 0; i < f.n; i++) {
        carried(w, &f, psi, i, v);
        sweep(&s, v, y, before);
        UNROLL
        for (int k = 0; k < VECTORS; k++)
            store(to + i * OVR_MODES + k * VEC, y[k]);
    }
    beyond(w->spread->right, v, z, after);
    for (int k = 0; k < VECTORS; k++) {
        z[k] += s.end[0][0] * y[k] + s.end[0][1] * before[k];
        after[k] += s.end[1][0] * y[k] + s.end[1][1] * before[k];
    }
}

static INLINE void back(const ovr_modes_step *w, double *to, vec *z, vec *after)
{
    const ovr_sweeps s = w->spread->past;
    vec y[VECTORS];
    for (size_t i = w->departures->n; i-- > 0;) {
        UNROLL
        for (int k = 0; k < VECTORS; k++)
            y[k] = load(to + i * OVR_MODES + k * VEC);
        sweep(&s, y, z, after);
        later(w, i, z, to);
    }
}

void OVR_KERNEL(step_modes)(const ovr_modes_step *given, const double *psi,
                            double *to)
{
    const ovr_modes_step w = *given;
    vec v[VECTORS], after[VECTORS];
    if (w.spread->on) {
        forth(&w, psi, to, v, after);
        back(&w, to, v, after);
        return;
    }
    for (size_t i = 0; i < w.departures->n; i++) {
        carried(&w, w.departures, psi, i, v);
        later(&w, i, v, to);
    }
}

/* One node of a sweep of several fields: x <- c v + b0 x - b1 before. */
static INLINE void sweep_node(const ovr_swept *s, double *at, vec *x,
                              vec *before)
{
    UNROLL
    for (int k = 0; k < OVR_SWEPT / VEC; k++) {
        const int l = k * VEC;
        vec next = load(s->c + l) * load(at + l);
        next = less(next, load(s->b[1] + l), before[k]);
        next = fused(load(s->b[0] + l), x[k], next);
        before[k] = x[k];
        x[k] = next;
        store(at + l, next);
    }
}

void OVR_KERNEL(sweep_fields)(size_t n, const ovr_swept *given, double *v)
{
    const ovr_swept s = *given;
    vec x[OVR_SWEPT / VEC], before[OVR_SWEPT / VEC];
    for (int k = 0; k < OVR_SWEPT / VEC; k++) {
        x[k] = load(s.begin[0] + k * VEC);
        before[k] = load(s.begin[1] + k * VEC);
    }
    for (size_t i = 0; i < n; i++)
        sweep_node(&s, v + i * OVR_SWEPT, x, before);
    for (int k = 0; k < OVR_SWEPT / VEC; k++) {
        const int l = k * VEC;
        vec y1 = x[k], y2 = before[k];
        x[k] = fused(load(s.end[0][0] + l), y1, load(s.after[0] + l));
        x[k] = fused(load(s.end[0][1] + l), y2, x[k]);
        before[k] = fused(load(s.end[1][0] + l), y1, load(s.after[1] + l));
        before[k] = fused(load(s.end[1][1] + l), y2, before[k]);
    }
    for (size_t i = n; i-- > 0;)
        sweep_node(&s, v + i * OVR_SWEPT, x, before);
}
