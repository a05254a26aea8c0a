/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A time step of temperatures across the film (equations in cross_film.h).
 * Nodes 1 to n - 1 are processed in vectors that begin at node 1, of which the
 * last overlaps the one before; the end is computed separately. The matrix of a
 * node is symmetric with a dominant diagonal: elimination without pivoting.
 */
#include "multigrid/cross_film.h"
#include "multigrid/kernels.h"
#include "multigrid/vector.h"

#include "multigrid/expansion.h" /* over vectors */

/* Rows of the matrix from the diagonal on, and the right-hand side. */
typedef struct rows {
    vec A[OVR_CROSS_FILM_MAX][OVR_CROSS_FILM_MAX], b[OVR_CROSS_FILM_MAX];
} rows;

static INLINE vec wall_at(const ovr_columns *c, const ovr_heat *heat, int k,
                          size_t i)
{
    return fused(load(c->past[k] + i), all(heat->solid[k]), all(heat->bulk[k]));
}

static INLINE void assemble(const ovr_columns *c,
                            const ovr_cross_film *cross_film,
                            const ovr_heat *heat, int n, size_t i, rows *m)
{
    vec q = load(c->q + i), H = load(c->H + i), P = load(c->P + i);
    vec dX = load(c->X + i + 1) - load(c->X + i - 1), P_T;
    P_T = c->P_T ? load(c->P_T + i) : all(0);
    vec P_X = (load(c->P + i + 1) - load(c->P + i - 1)) / dX;
    vec conduction = heat->conduction / H, cooling = load(c->fall + i);
    vec bT_f = choose(P > 0, expansion_at(heat, P), all(0));
    vec pressing = heat->theta * bT_f * H;
    UNROLL
    for (int j = 0; j < n; j++) {
        double w = cross_film->w[j];
        vec made = (w * heat->theta) * load(c->heating[j] + i);
        vec less_made = larger(made * cooling, all(0));
        vec stored = (w / c->dT) * q;
        vec used = load(c->used[j] + i);
        vec press = w * pressing * fused(load(c->u[j] + i), P_X, P_T);
        press *= expansion_lightness(heat, bT_f, used);
        UNROLL
        for (int l = j; l < n; l++)
            m->A[j][l] = conduction * cross_film->K[j][l];
        m->A[j][j] += stored + less_made - press;
        m->b[j] = fused(less_made, used, made);
        m->b[j] = fused(stored, load(c->departure[j] + i), m->b[j]);
        m->b[j] = fused(press, all(heat->T0), m->b[j]);
    }
    for (int k = 0; k < 2; k++) {
        double G = heat->conduction / c->resistance[k];
        int j = k ? n - 1 : 0;
        m->A[j][j] += G;
        m->b[j] = fused(all(G), wall_at(c, heat, k, i), m->b[j]);
    }
}

static INLINE void eliminate(int n, rows *m)
{
    vec inverse[OVR_CROSS_FILM_MAX];
    UNROLL
    for (int k = 0; k < n; k++) {
        inverse[k] = 1 / m->A[k][k];
        UNROLL
        for (int i = k + 1; i < n; i++) {
            vec factor = m->A[k][i] * inverse[k];
            UNROLL
            for (int j = i; j < n; j++)
                m->A[i][j] = less(m->A[i][j], factor, m->A[k][j]);
            m->b[i] = less(m->b[i], factor, m->b[k]);
        }
    }
    UNROLL
    for (int k = n - 1; k >= 0; k--) {
        UNROLL
        for (int j = k + 1; j < n; j++)
            m->b[k] = less(m->b[k], m->A[k][j], m->b[j]);
        m->b[k] *= inverse[k];
    }
}

static INLINE void columns(const ovr_columns *given, int n)
{
    const ovr_columns own = *given, *c = &own; /* a copy, so that the compiler
                                                * can assume no store changes it
                                                */
    const ovr_cross_film cross_film = *c->cross_film;
    const ovr_heat heat = *c->heat;
    for (size_t at = 1; at < c->n - 1; at += VEC) {
        size_t i = at + VEC <= c->n - 1 ? at : c->n - 1 - VEC;
        vec mean = all(0);
        rows m;
        assemble(c, &cross_film, &heat, n, i, &m);
        eliminate(n, &m);
        UNROLL
        for (int j = 0; j < n; j++) {
            store(c->T[j] + i, m.b[j]);
            mean = fused(m.b[j], all(cross_film.w[j]), mean);
        }
        store(c->mean + i, mean);
        for (int k = 0; k < 2; k++)
            store(c->into[k] + i,
                  (m.b[k ? n - 1 : 0] - wall_at(c, &heat, k, i)) /
                      c->resistance[k]);
    }
}

void OVR_KERNEL(heat_cross_film)(const ovr_columns *c)
{
    if (c->cross_film->n == 5)
        columns(c, 5);
    else
        columns(c, 7);
    ovr_column_heat(c, c->n - 1);
}
