/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "multigrid/film_end.h"

#include <math.h>

/* A level and its rows during elimination: diagonal, right-hand side,
 * coefficient of the next node away from the film. */
typedef struct film {
    const ovr_level *level;
    double *G, *b, *U, *before; /* before: P of all nodes before the change */
} film;

/* Nodes in the direction away from the film: out = 1 to the right, -1 to the
 * left. */
typedef struct stretch {
    ptrdiff_t first, last, out;
} stretch;

static double value(const film *f, const double *x, ptrdiff_t i)
{
    return x[ovr_lanes_place(&f->level->lanes, (size_t)i)];
}

static bool is_wet(const film *f, ptrdiff_t i)
{
    return value(f, f->level->f.P, i) > 0;
}

/* True if the node's pressure should become positive; the residual must exceed
 * a fraction of the row's size. */
static bool must_become_pressurized(const film *f, ptrdiff_t i, double share)
{
    double size = f->level->weights.a[0] * value(f, f->level->f.q, i);
    return value(f, f->level->f.r, i) < -share * size;
}

/* 2 E of the half node before node i. */
static double flow_before(const film *f, ptrdiff_t i)
{
    const ovr_fields *x = &f->level->f;
    if (x->flow)
        return value(f, x->flow, i - 1);
    return value(f, x->eps, i - 1) + value(f, x->eps, i);
}

/* Returns -dN_i/dP_{i-m} of the wedge at fixed film thickness (reynolds_row.h).
 */
static double wedge_by_pressure(const film *f, int m, ptrdiff_t i)
{
    const ovr_weights *w = &f->level->weights;
    const ovr_fields *x = &f->level->f;
    double dq = value(f, x->dq, i - m);
    if (!x->skew)
        return w->a[m] * dq;
    double s_1 = value(f, x->skew_by_P, i - m);
    double s = value(f, x->skew, i - m) + s_1 * value(f, x->P, i - m);
    return (w->a[m] + w->skew[m] * s) * dq +
           w->skew[m] * s_1 * value(f, x->q, i - m);
}

/* Computes row i; returns the coefficient of the neighbour on the film side. */
static double row_of(const film *f, ptrdiff_t i, ptrdiff_t out)
{
    const ovr_weights *w = &f->level->weights;
    const ovr_fields *x = &f->level->f;
    double before = w->half * flow_before(f, i);
    double after = w->half * flow_before(f, i + 1);
    double L = before - wedge_by_pressure(f, 1, i);
    f->G[i] = before + after + wedge_by_pressure(f, 0, i);
    f->b[i] = -value(f, x->r, i) + f->G[i] * value(f, x->P, i) -
              L * value(f, x->P, i - 1) - after * value(f, x->P, i + 1);
    f->U[i] = out > 0 ? after : L;
    return out > 0 ? L : after;
}

/* P before the first node is constant; its term is moved to the right-hand
 * side. */
static void eliminate(const film *f, const stretch *s)
{
    double inner = row_of(f, s->first, s->out);
    f->b[s->first] += inner * value(f, f->level->f.P, s->first - s->out);
    for (ptrdiff_t i = s->first; i != s->last;) {
        double G = f->G[i], b = f->b[i], U = f->U[i];
        i += s->out;
        double factor = row_of(f, i, s->out) / G;
        f->G[i] -= factor * U;
        f->b[i] += factor * b;
    }
}

static void substitute(const film *f, const stretch *s, double maximum)
{
    double *P = f->level->f.P, next = value(f, P, s->last + s->out);
    for (ptrdiff_t i = s->last; i != s->first - s->out; i -= s->out) {
        next = fmin(maximum, fmax(0, (f->b[i] + f->U[i] * next) / f->G[i]));
        P[ovr_lanes_place(&f->level->lanes, (size_t)i)] = next;
    }
}

/* ----------------------------------------------------- beyond the contact */

/* Node from which on the film is rigid, next to the contact. */
static ptrdiff_t rigid_from(const film *f, ptrdiff_t out)
{
    enum { STIFF = 1000 }; /* 10 to 1e5 all work */
    const ovr_level *l = f->level;
    double D = l->grid.D;
    double minimum = STIFF * l->weights.a[0] * fabs(l->k[0]) * 2 * D * D;
    ptrdiff_t last = (ptrdiff_t)l->grid.n - 1, i = out > 0 ? last : 0;
    for (ptrdiff_t in = i - out; in > 0 && in < last; in -= out) {
        if (!(value(f, l->f.eps, in) > minimum))
            break;
        i = in;
    }
    return i + out;
}

/* Finds the film end from the contact outward, and the cavitated nodes beyond
 * it. Returns true if a cavitated node must become pressurized. */
static bool find_film(const film *f, ptrdiff_t out, stretch *s)
{
    ptrdiff_t n = (ptrdiff_t)f->level->grid.n, from = rigid_from(f, out);
    bool dry = false, moves = false;
    *s = (stretch){from, from - out, out};
    for (ptrdiff_t i = from; i > 0 && i < n - 1; i += out) {
        bool wet = is_wet(f, i),
             up = !wet && must_become_pressurized(f, i, 1e-9);
        if (dry && (wet || up))
            break;
        dry = !wet && !up;
        moves |= up;
        s->last = i;
    }
    return moves;
}

static void keep(const film *f)
{
    for (size_t i = 0; i < f->level->grid.n; i++)
        f->before[i] = value(f, f->level->f.P, (ptrdiff_t)i);
}

static void restore(const film *f)
{
    for (size_t i = 0; i < f->level->grid.n; i++)
        f->level->f.P[ovr_lanes_place(&f->level->lanes, i)] = f->before[i];
}

static bool move_rigid(const film *f)
{
    bool moved = false;
    keep(f);
    for (ptrdiff_t out = -1; out <= 1; out += 2) {
        stretch s;
        if (!find_film(f, out, &s))
            continue;
        eliminate(f, &s);
        substitute(f, &s, INFINITY);
        moved = true;
    }
    return moved;
}

/* ----------------------------------------------------- at other film ends */

/* Solves the cavitated nodes after the pressurized node before `first`. */
static void extend(const film *f, ptrdiff_t first)
{
    enum { REACH = 32 };
    const double maximum = 0.05;
    stretch s = {first, first, 1};
    ptrdiff_t end = (ptrdiff_t)f->level->grid.n - 2;
    while (s.last < end && s.last < first - 1 + REACH && !is_wet(f, s.last + 1))
        s.last++;
    eliminate(f, &s);
    substitute(f, &s, maximum);
}

/* True if a film ends before node i, which is cavitated and should become
 * pressurized. */
static bool moves_to(const film *f, ptrdiff_t i)
{
    if (i < 2 || i + 1 >= (ptrdiff_t)f->level->grid.n || is_wet(f, i) ||
        !is_wet(f, i - 1))
        return false;
    return must_become_pressurized(f, i, 1e-6);
}

/* ---------------------------------------------------------- both solutions */

/* Calls `look` for each unconstrained cavitated node; returns true if any call
 * did. */
static bool for_free(const film *f, bool (*look)(const film *, ptrdiff_t))
{
    const ovr_lanes *g = &f->level->lanes;
    const ovr_fields *x = &f->level->f;
    bool found = false;
    for (size_t J = 0; J < g->S; J++) {
        unsigned all = (1U << g->V) - 1;
        unsigned free = all & ~(unsigned)(x->wet[J] | x->held[J]);
        for (size_t l = 0; free && l < g->V; l++)
            if (free >> l & 1)
                found |= look(f, (ptrdiff_t)(l * g->S + J));
    }
    return found;
}

static bool rises(const film *f, ptrdiff_t i)
{
    return i > 0 && i + 1 < (ptrdiff_t)f->level->grid.n &&
           must_become_pressurized(f, i, 1e-9);
}

static bool extend_to(const film *f, ptrdiff_t i)
{
    bool moves = moves_to(f, i);
    if (moves)
        extend(f, i);
    return moves;
}

/* True if the cavitated nodes contribute a considerable part of the total
 * imbalance R. */
static bool outweighs(const ovr_hierarchy *grids, const film *f)
{
    const double share = 0.1;
    const ovr_level *l = f->level;
    double lack = 0, H = fabs(ovr_level_centre(l, l->f.H));
    for (ptrdiff_t i = 1; i + 1 < (ptrdiff_t)l->grid.n; i++)
        if (!is_wet(f, i))
            lack += fmax(0, -value(f, l->f.r, i));
    return lack * l->grid.D > share * H * ovr_level_imbalance(grids, l);
}

/* Applies the rigid solution and discards it if R increases: if the film is
 * thick everywhere, the zone is as long as the domain, and deformation is not
 * negligible. */
static void try_rigid(const ovr_hierarchy *grids, ovr_level *level,
                      const film *f)
{
    const double worse = 3;
    double R = ovr_level_imbalance(grids, level);
    if (!move_rigid(f))
        return;
    ovr_level_refresh(grids, level);
    if (ovr_level_imbalance(grids, level) <= worse * R)
        return;
    restore(f);
    ovr_level_refresh(grids, level);
}

void ovr_move_cavitation_boundary(const ovr_hierarchy *grids, ovr_level *level)
{
    const film f = {level, grids->band.b[0], grids->band.b[1], grids->band.b[2],
                    grids->band.b[3]};
    if (!for_free(&f, rises))
        return;
    if (outweighs(grids, &f))
        try_rigid(grids, level, &f);
    if (for_free(&f, extend_to))
        ovr_level_refresh(grids, level);
}
