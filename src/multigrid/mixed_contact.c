/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "multigrid/mixed_contact.h"

#include <math.h>
#include <string.h>

#include "multigrid/coarsest.h"

/* Number of elements in lanes, including the halo node. Elements beyond the
 * ends of the grid are zero in `pressed`, which never contains a deformation
 * here. */
static size_t places(const ovr_level *level)
{
    return level->lanes.S * level->lanes.V + level->lanes.V;
}

/* A and g of a node's film. */
static void law_at(const ovr_hierarchy *grids, double H, double *A, double *g)
{
    const ovr_asperity *touch = &grids->touch;
    touch->at(touch->law, H, A, g);
    *A *= touch->share;
    *g *= touch->share;
    if (!(*A >= OVR_TOUCH_MIN))
        *A = *g = 0;
}

void ovr_asperity_deform(const ovr_hierarchy *grids, const ovr_level *level)
{
    double *whole = level->pressed;
    for (size_t J = 0; J < places(level); J++)
        whole[J] = level->f.P[J] + level->asperity_P[J];
    ovr_level_deform(grids, level, whole, level->f.w);
}

/* Copies values to nodes that are stored in several lanes. */
static void repeat(const ovr_hierarchy *grids, const ovr_level *level,
                   double *values)
{
    double *workspace = grids->scratch[0];
    ovr_level_read(grids, level, values, workspace);
    ovr_level_write(grids, level, workspace, values);
}

const double *ovr_asperity_gap(const ovr_hierarchy *grids,
                               const ovr_level *level)
{
    return grids->touch.lifted ? grids->touch.gap : level->f.gap;
}

void ovr_asperity_settle(ovr_hierarchy *grids)
{
    ovr_asperity *touch = &grids->touch;
    touch->lifted = false;
    touch->rising = 0;
    touch->failures = touch->omitted = 0;
    memset(touch->lift, 0,
           grids->level[grids->finest].grid.n * sizeof *touch->lift);
}

void ovr_asperity_split(const ovr_hierarchy *grids, const ovr_level *level)
{
    double *P = level->f.P, *asperity_P = level->asperity_P;
    const double *gap = ovr_asperity_gap(grids, level);
    for (size_t J = 0; J < level->lanes.S * level->lanes.V; J++) {
        double whole = P[J] + asperity_P[J], A, g;
        if (!(P[J] > 0))
            continue;
        law_at(grids, grids->H0 + gap[J] - level->f.w[J], &A, &g);
        P[J] = fmax(whole - A, 0);
        asperity_P[J] = whole - P[J];
    }
    repeat(grids, level, P);
    repeat(grids, level, asperity_P);
}

double ovr_asperity_defect(const ovr_hierarchy *grids, const ovr_level *level)
{
    double sum = 0, A, g;
    for (size_t i = 1; i + 1 < level->grid.n; i++) {
        size_t J = ovr_lanes_place(&level->lanes, i);
        if (grids->touch.lifted)
            sum += fabs(grids->touch.lift[i]) / level->f.H[J];
        if (level->f.P[J] > 0)
            continue;
        law_at(grids, level->f.H[J], &A, &g);
        sum += fabs(level->asperity_P[J] - A);
    }
    return level->grid.D * sum;
}

double ovr_asperity_oil_share(const ovr_hierarchy *grids,
                              const ovr_level *level)
{
    if (!grids->touch.at || !(level->force > 0))
        return 1;
    return level->grid.D * grids->kernels->sum(&level->lanes, level->f.P) /
           level->force;
}

void ovr_asperity_prepare(const ovr_hierarchy *grids, const ovr_level *level,
                          const ovr_fields *f)
{
    const ovr_asperity *touch = &grids->touch;
    ovr_level_read(grids, level, level->asperity_P, touch->whole);
    for (size_t i = 0; i < level->grid.n; i++) {
        touch->whole[i] += f->P[i];
        law_at(grids, f->H[i], &touch->A[i], &touch->g[i]);
        touch->excess[i] = touch->whole[i] - touch->A[i] - f->P[i];
        touch->dry[i] = ovr_lanes_has(&level->lanes, level->f.held, i);
    }
}

void ovr_asperity_pressurized_row(const ovr_hierarchy *grids,
                                  const ovr_level *level, size_t i,
                                  ovr_newton_row *row)
{
    const ovr_asperity *touch = &grids->touch;
    for (size_t m = 0; m < 4; m++) {
        size_t node = i + m - 2;
        if (i + m < 2 || node == 0 || node + 1 >= level->grid.n)
            continue;
        if (touch->dry[node])
            row->local[m] = 0;
        row->e[m] -= row->local[m] * touch->g[node];
        row->r -= row->e[m] * touch->lift[node];
        row->r -= row->local[m] * touch->excess[node];
    }
}

/* Marks the cavitated nodes within `reach` of node i. */
static void open_about(const ovr_asperity *touch, size_t n, size_t i,
                       size_t reach)
{
    size_t from = i > reach ? i - reach : 1;
    size_t to = i + reach + 1 < n ? i + reach + 1 : n - 1;
    for (size_t j = from; j < to; j++) {
        touch->opened[j] |= touch->dry[j];
        touch->dry[j] = 0;
    }
}

void ovr_asperity_open(ovr_hierarchy *grids, const ovr_level *level,
                       const ovr_fields *f)
{
    enum { PATIENCE = 2, MAX = 7 };
    ovr_asperity *touch = &grids->touch;
    size_t n = level->grid.n;
    bool any = false;
    int doublings = touch->rising - PATIENCE + 2;
    memset(touch->opened, 0, n);
    for (size_t i = 1; i + 1 < n; i++) {
        bool rises = !(f->P[i] > 0) && !touch->dry[i] && !touch->opened[i];
        any |= rises;
        if (rises && touch->rising >= PATIENCE)
            open_about(touch, n, i,
                       (size_t)1 << (doublings < MAX ? doublings : MAX));
    }
    touch->rising = any ? touch->rising + 1 : 0;
}

/* Elastic deformation due to a step, without H0, in the order of the nodes. */
static const double *step_deformation(const ovr_hierarchy *grids,
                                      const ovr_level *level, const double *dP)
{
    double *w = level->f.w, *workspace = grids->scratch[0];
    ovr_level_write(grids, level, dP, level->pressed);
    ovr_level_deform(grids, level, level->pressed, w);
    ovr_level_read(grids, level, w, workspace);
    return workspace;
}

bool ovr_asperity_close(const ovr_hierarchy *grids, const ovr_level *level,
                        const double *step)
{
    const ovr_asperity *touch = &grids->touch;
    size_t n = level->grid.n;
    const double *w;
    bool any = false;
    if (!memchr(touch->opened, 1, n))
        return false;
    w = step_deformation(grids, level, step);
    for (size_t i = 1; i + 1 < n; i++) {
        double rises = touch->excess[i] + step[i] +
                       touch->g[i] * (step[n] - w[i] - touch->lift[i]);
        if (!touch->opened[i] || touch->dry[i] || rises >= 0)
            continue;
        touch->dry[i] = 1;
        any = true;
    }
    return any;
}

ovr_newton_row ovr_asperity_cavitated_row(const ovr_hierarchy *grids,
                                          const ovr_level *level, size_t i)
{
    const ovr_asperity *touch = &grids->touch;
    double g = touch->g[i];
    double scale = 1 / (1 + g * fabs(level->k[0]) * (double)level->grid.n);
    return (ovr_newton_row){
        .e[2] = -scale * g,
        .local[2] = scale,
        .r = scale * (touch->A[i] - touch->whole[i] + g * touch->lift[i])};
}

/* The film thickness closest to H that a step may produce. */
static double allowed(const ovr_asperity *touch, size_t i, double was, double H)
{
    const double minimum = 0.05, doubled = log(2), thin = 0.2, thick = 5;
    double A = touch->A[i], bottom = thin * was;
    if (!(was > 0))
        return H;
    if (touch->g[i] > 0)
        bottom = fmax(bottom,
                      was - fmax(doubled, log(minimum / A)) * A / touch->g[i]);
    return fmin(fmax(H, bottom), thick * was);
}

/* Computes the lift of each node: the film thickness minus the film thickness
 * due to the pressures. */
static void lift(ovr_hierarchy *grids, const ovr_level *level,
                 const double *was)
{
    ovr_asperity *touch = &grids->touch;
    double *w = grids->scratch[0], *gap = grids->scratch[1];
    ovr_level_read(grids, level, level->f.w, w);
    ovr_level_read(grids, level, level->f.gap, gap);
    touch->lifted = false;
    for (size_t i = 0; i < level->grid.n; i++) {
        double H = grids->H0 + gap[i] - w[i];
        touch->lift[i] = allowed(touch, i, was[i], H) - H;
        touch->lifted |= touch->lift[i] != 0;
        gap[i] += touch->lift[i];
    }
    ovr_level_write(grids, level, gap, touch->gap);
}

/* Sets the pressures after a part of the step, from their previous values
 * `whole`. */
static void set_pressures(ovr_hierarchy *grids, const ovr_level *level,
                          double part)
{
    const ovr_asperity *touch = &grids->touch;
    double *P = grids->scratch[0], *asperity_P = grids->scratch[1];
    size_t n = level->grid.n;
    for (size_t i = 1; i + 1 < n; i++) {
        double whole = fmax(touch->whole[i] + part * touch->step[i], 0);
        P[i] = touch->dry[i] ? 0 : whole;
        asperity_P[i] = touch->dry[i] ? whole : 0;
    }
    P[0] = P[n - 1] = asperity_P[0] = asperity_P[n - 1] = 0;
    ovr_level_write(grids, level, P, level->f.P);
    ovr_level_write(grids, level, asperity_P, level->asperity_P);
}

void ovr_asperity_limit(const ovr_asperity *touch, size_t n, double limit)
{
    double *step = touch->step;
    for (size_t i = 0; i < n; i++)
        step[i] = fmax(fmin(step[i], limit), -limit);
    step[n] = fmax(fmin(step[n], limit * 2 / 3), -limit * 2 / 3);
}

void ovr_asperity_advance(ovr_hierarchy *grids, const ovr_level *level,
                          const ovr_fields *f, double part)
{
    set_pressures(grids, level, part);
    ovr_asperity_deform(grids, level);
    lift(grids, level, f->H);
}

void ovr_asperity_move(ovr_hierarchy *grids, int l)
{
    ovr_asperity *touch = &grids->touch;
    for (int k = 0; k < OVR_LEVELS; k++) {
        if (!touch->kept_P[k])
            continue;
        grids->level[k].asperity_P = k == l ? touch->kept_P[k] : NULL;
        grids->level[k].pressed = k == l ? touch->kept_pressed[k] : NULL;
    }
    grids->finest = l;
    ovr_newton_fill(grids);
    ovr_deflation_fit(&touch->tripoles->smooth, grids->level[l].grid.n);
    ovr_asperity_settle(grids);
}

void ovr_asperity_clear(const ovr_level *level)
{
    ovr_level_clear(level, level->asperity_P);
    ovr_level_clear(level, level->pressed);
}

/* Value between nodes I - 1 and I: cubic interpolation if it is smooth there,
 * else linear. */
static double between(const double *v, size_t n, size_t I, bool smooth)
{
    double before = I > 1 ? v[I - 2] : 0, after = I + 1 < n ? v[I + 1] : 0;
    double mean = 0.5 * (v[I - 1] + v[I]);
    return smooth ? fmax(1.125 * mean - (before + after) / 16, 0) : mean;
}

/* True if the film is pressurized at nodes from..to. */
static bool is_pressurized(const double *P, size_t n, size_t from, size_t to)
{
    for (size_t I = from; I <= to; I++)
        if (I == 0 || I + 1 >= n || !(P[I] > 0))
            return false;
    return true;
}

void ovr_asperity_refine(ovr_hierarchy *grids, const ovr_level *coarse,
                         const ovr_level *fine, bool smooth)
{
    double *P = grids->touch.whole, *A = grids->touch.excess;
    double *fine_P = grids->scratch[0], *fine_A = grids->scratch[1];
    size_t n = coarse->grid.n;
    ovr_level_read(grids, coarse, coarse->f.P, P);
    ovr_level_read(grids, coarse, grids->touch.kept_P[coarse->number], A);
    fine_P[0] = fine_A[0] = 0;
    for (size_t I = 1; I < n; I++) {
        bool inside = I > 1 && is_pressurized(P, n, I - 2, I + 1);
        bool pressurized = is_pressurized(P, n, I - 1, I);
        fine_P[2 * I] = P[I];
        fine_A[2 * I] = A[I];
        fine_P[2 * I - 1] = pressurized ? between(P, n, I, smooth && inside)
                                        : 0;
        fine_A[2 * I - 1] = between(A, n, I, smooth);
    }
    ovr_level_write(grids, fine, fine_P, fine->f.P);
    ovr_level_write(grids, fine, fine_A, fine->asperity_P);
}
