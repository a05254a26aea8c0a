/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "multigrid/film_end.h"

#include <math.h>

/* A level, and rows on the way: diagonal, right-hand side, coefficient of the
 * next node. */
typedef struct film {
    const ovr_level *level;
    double *G, *b, *U;
} film;

static double value(const film *f, const double *x, size_t i)
{
    return x[ovr_lanes_place(&f->level->lanes, i)];
}

static bool is_wet(const film *f, size_t i)
{
    return value(f, f->level->f.P, i) > 0;
}

/* 2 E of the half node before node i. */
static double flow_before(const film *f, size_t i)
{
    const ovr_fields *x = &f->level->f;
    if (x->flow)
        return value(f, x->flow, i - 1);
    return value(f, x->eps, i - 1) + value(f, x->eps, i);
}

/* Row i; returns L_i. */
static double row_of(const film *f, size_t i)
{
    const ovr_weights *w = &f->level->weights;
    const ovr_fields *x = &f->level->f;
    double before = w->half * flow_before(f, i);
    double after = w->half * flow_before(f, i + 1);
    double L = before - w->a[1] * value(f, x->dq, i - 1);
    f->U[i] = after;
    f->G[i] = before + after + w->a[0] * value(f, x->dq, i);
    f->b[i] = -value(f, x->r, i) + f->G[i] * value(f, x->P, i) -
              L * value(f, x->P, i - 1) - after * value(f, x->P, i + 1);
    return L;
}

/* Rows first..last; P before the first stays, and so does its share. */
static void eliminate(const film *f, size_t first, size_t last)
{
    double L = row_of(f, first);
    f->b[first] += L * value(f, f->level->f.P, first - 1);
    for (size_t i = first + 1; i <= last; i++) {
        double factor = row_of(f, i) / f->G[i - 1];
        f->G[i] -= factor * f->U[i - 1];
        f->b[i] += factor * f->b[i - 1];
    }
}

static void put_in(const film *f, size_t first, size_t last)
{
    const double most = 0.05;
    double *P = f->level->f.P, next = value(f, P, last + 1);
    for (size_t i = last; i >= first; i--) {
        next = fmin(most, fmax(0, (f->b[i] + f->U[i] * next) / f->G[i]));
        P[ovr_lanes_place(&f->level->lanes, i)] = next;
    }
}

/* Behind the wet node `end`, as far as it is dry. */
static void extend(const film *f, size_t end)
{
    enum { REACH = 32 };
    size_t last = end + 1, most = f->level->grid.n - 2;
    while (last < most && last < end + REACH && !is_wet(f, last + 1))
        last++;
    eliminate(f, end + 1, last);
    put_in(f, end + 1, last);
}

/* Whether a film ends before node i, which is dry and wants to rise. */
static bool moves_to(const film *f, size_t i)
{
    const ovr_level *l = f->level;
    double size;
    if (i < 2 || i + 1 >= l->grid.n || is_wet(f, i) || !is_wet(f, i - 1))
        return false;
    size = l->weights.a[0] * value(f, l->f.q, i);
    return value(f, l->f.r, i) < -1e-6 * size;
}

bool ovr_film_ends(const ovr_hierarchy *grids, const ovr_level *level)
{
    const film f = {level, grids->band.b[0], grids->band.b[1],
                    grids->band.b[2]};
    const ovr_lanes *g = &level->lanes;
    bool moved = false;
    for (size_t J = 0; J < g->S; J++) {
        unsigned rising = ~(unsigned)(level->f.wet[J] | level->f.held[J]);
        for (size_t l = 0; rising && l < g->V; l++)
            if (rising >> l & 1 && moves_to(&f, l * g->S + J)) {
                extend(&f, l * g->S + J - 1);
                moved = true;
            }
    }
    return moved;
}
