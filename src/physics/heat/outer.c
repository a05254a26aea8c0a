/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Outer iteration of temperatures and film (equations in outer.h). */
#include "physics/heat/outer.h"

#include <math.h>

#include "base/larger.h"
#include "physics/heat/heated.h"
#include "physics/heat/skew.h"

ovr_status ovr_heat_outer_take(ovr_simulation *sim, ovr_error *err)
{
    ovr_heated *h = sim->heated;
    ovr_heat_outer *t = ovr_arena_take(&sim->arena, 1, sizeof *t, err);
    if (!t)
        return OVR_NO_MEMORY;
    h->outer = t;
    for (int k = 0; k < OVR_OUTER_KEPT; k++)
        for (int j = 0; j < h->cross_film.n; j++)
            OVR_TAKE_NODES(sim, err, &t->u[k][j], &t->r[k][j]);
    return ovr_arena_status(&sim->arena);
}

void ovr_heat_outer_begin(ovr_simulation *sim)
{
    ovr_heat_outer *t = sim->heated->outer;
    t->kept = 0;
    t->helped = false;
    t->w = fabs(sim->heated->V) < 1 ? 0.6 : 0.35;
    t->small = ovr_heat_opposed(sim) ? 0.03 : 0.1;
    t->change = INFINITY;
}

void ovr_heat_outer_forget(ovr_heat_outer *outer)
{
    outer->kept = 0;
}

/* ------------------------------------------------------ Anderson's method */

/* Normal equations for the g_j; A is symmetric. */
typedef struct minimum {
    double A[OVR_OUTER_KEPT][OVR_OUTER_KEPT], b[OVR_OUTER_KEPT];
} minimum;

static void add_node(const ovr_heated *h, size_t i, minimum *l)
{
    const ovr_heat_outer *t = h->outer;
    for (int j = 0; j < h->cross_film.n; j++) {
        double r = h->T[j][i] - h->used[j][i], d[OVR_OUTER_KEPT] = {0};
        for (int k = 0; k < t->kept; k++) {
            d[k] = r - t->r[k][j][i];
            l->b[k] += d[k] * r;
            for (int m = 0; m <= k; m++)
                l->A[k][m] += d[k] * d[m];
        }
    }
}

/* Sums the normal equations over the nodes included in the residual. */
static minimum equations(const ovr_simulation *sim)
{
    const double pressed = ovr_heat_pressed(sim);
    minimum l = {.b = {0}};
    for (size_t i = 0; i < sim->now.n; i++)
        if (sim->now.P[i] > pressed)
            add_node(sim->heated, i, &l);
    return l;
}

/* Solves by Cholesky's method; omits iterations that are nearly linearly
 * dependent on more recent ones. */
static void solve(int n, minimum *l, double *g)
{
    const double min_part = 1e-10;
    for (int k = 0; k < n; k++) {
        double whole = l->A[k][k];
        for (int m = 0; m <= k; m++) {
            for (int i = 0; i < m; i++)
                l->A[k][m] -= l->A[k][i] * l->A[m][i];
            if (m < k)
                l->A[k][m] = l->A[m][m] > 0 ? l->A[k][m] / l->A[m][m] : 0;
        }
        l->A[k][k] = l->A[k][k] > min_part * whole ? sqrt(l->A[k][k]) : 0;
        g[k] = l->b[k];
        for (int m = 0; m < k; m++)
            g[k] -= l->A[k][m] * g[m];
        g[k] = l->A[k][k] > 0 ? g[k] / l->A[k][k] : 0;
    }
    for (int k = n - 1; k >= 0; k--) {
        for (int m = k + 1; m < n; m++)
            g[k] -= l->A[m][k] * g[m];
        g[k] = l->A[k][k] > 0 ? g[k] / l->A[k][k] : 0;
    }
}

/* Makes space for the present iteration before the others; reuses the memory of
 * the oldest one. */
static void keep(ovr_heat_outer *t, int points)
{
    const int last = OVR_OUTER_KEPT - 1;
    for (int j = 0; j < points; j++) {
        double *u = t->u[last][j], *r = t->r[last][j];
        for (int k = last; k > 0; k--) {
            t->u[k][j] = t->u[k - 1][j];
            t->r[k][j] = t->r[k - 1][j];
        }
        t->u[0][j] = u;
        t->r[0][j] = r;
    }
    if (t->kept < OVR_OUTER_KEPT)
        t->kept++;
}

/* Stores this iteration and computes the next u from the stored ones. */
static void move(ovr_heated *h, size_t n, const double *g)
{
    const double maximum = 0.5, few = 10;
    ovr_heat_outer *t = h->outer;
    int before = t->kept;
    keep(t, h->cross_film.n);
    for (int j = 0; j < h->cross_film.n; j++)
        for (size_t i = 0; i < n; i++) {
            double u = h->used[j][i], r = h->T[j][i] - u, step = t->w * r;
            double limit = maximum * fabs(u) + few;
            for (int k = 0; k < before; k++) {
                int at = (k + 1) % OVR_OUTER_KEPT; /* present position */
                step += g[k] *
                        (t->u[at][j][i] - u + t->w * (t->r[at][j][i] - r));
            }
            t->u[0][j][i] = u;
            t->r[0][j][i] = r;
            step = ovr_larger(-limit, ovr_smaller(step, limit));
            h->used[j][i] = ovr_heat_bounded(h, u + step);
        }
}

/* ---------------------------------------------------- an outer iteration */

static double largest_rest(const ovr_simulation *sim)
{
    const ovr_heated *h = sim->heated;
    double rest = 0, rise = 1e-300, pressed = ovr_heat_pressed(sim);
    for (int j = 0; j < h->cross_film.n; j++)
        for (size_t i = 0; i < sim->now.n; i++) {
            rise = ovr_larger(rise, fabs(h->T[j][i]));
            if (sim->now.P[i] > pressed)
                rest = ovr_larger(rest, fabs(h->T[j][i] - h->used[j][i]));
        }
    return rest / rise;
}

double ovr_heat_iterate(ovr_simulation *sim)
{
    const double grows = 2, lower = 0.7, min_w = 0.1;
    ovr_heated *h = sim->heated;
    ovr_heat_outer *t = h->outer;
    double change = largest_rest(sim), g[OVR_OUTER_KEPT] = {0};
    if (!t->helped && change > t->change && t->w > min_w)
        t->w *= lower;
    if (change > t->small || change > grows * t->change)
        t->kept = 0;
    t->change = change;
    t->helped = t->kept > 0;
    if (t->helped) {
        minimum l = equations(sim);
        solve(t->kept, &l, g);
    }
    move(h, sim->now.n, g);
    return change;
}
