/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Newton's method on the coarsest grid of the strip, with a dense matrix.
 *
 *     sum_c [A_rc + sum_m B_rm k(m, c)] dP_c + (sum_m B_rm) dH0 = r_r
 *     B_rm = dN_r/dH_m
 *     sum_c dP_c = lines force/D - sum P
 *
 * Unknowns are H0 and the pressures of the nodes that move.  A_rc are
 * derivatives at fixed film.  Derivatives of the flow across by the gradient
 * along, and the other way round, are neglected.  The derivatives of the
 * logarithmic mean are those of a linear ln phi.  The last steps then converge
 * linearly, with a factor below 1e-2.
 *
 * Cost: 1 ms for 230 unknowns (29 x 8 nodes).
 */
#include <math.h>
#include <string.h>

#include "strip/across.h"
#include "strip/kernels.h"

/* Stencil of a row: the node, W, E, S, N, and the second node upstream. */
enum { SELF, WEST, EAST, SOUTH, NORTH, FAR, STENCIL };

typedef struct stencil {
    size_t i[STENCIL], j[STENCIL];
    double by_pressure[STENCIL], by_film[STENCIL];
} stencil;

static stencil stencil_at(const ovr_strip_level *level, size_t i, size_t j)
{
    const ovr_strip_grid *g = &level->grid;
    const ovr_strip_fields *f = &level->f;
    const double *a = i == 1 ? level->weights.first : level->weights.a;
    size_t far = i >= 2 ? i - 2 : i - 1;
    size_t south = ovr_across_line(g->lines, (ptrdiff_t)j - 1);
    size_t north = ovr_across_line(g->lines, (ptrdiff_t)j + 1);
    stencil s = {.i = {i, i - 1, i + 1, i, i, far},
                 .j = {j, j, j, south, north, j}};
    size_t k = ovr_strip_row(g, i) + j, w = k - g->stride;
    size_t ww = ovr_strip_row(g, far) + j;
    size_t below = ovr_strip_row(g, i) + south;
    s.by_pressure[SELF] = -f->along_after[w] - f->along_before[k] -
                          f->across_after[below] - f->across_before[k] -
                          a[0] * f->dq[k];
    s.by_pressure[WEST] = f->along_before[w] - a[1] * f->dq[w];
    s.by_pressure[EAST] = f->along_after[k];
    s.by_pressure[SOUTH] = f->across_before[below];
    s.by_pressure[NORTH] = f->across_after[k];
    s.by_pressure[FAR] = -a[2] * f->dq[ww];
    double *by = s.by_film;
    by[WEST] = -f->along_by_film[0][w];
    by[EAST] = f->along_by_film[1][k];
    by[SOUTH] = -f->across_by_film[0][below];
    by[NORTH] = f->across_by_film[1][k];
    by[SELF] = f->along_by_film[0][k] - f->along_by_film[1][w] +
               f->across_by_film[0][k] - f->across_by_film[1][below];
    by[SELF] -= a[0] * f->rho[k];
    by[WEST] -= a[1] * f->rho[w];
    by[FAR] -= a[2] * f->rho[ww];
    return s;
}

static size_t padded(size_t lines)
{
    return (lines + 7) / 8 * 8;
}

/* Computes sum_m dN/dH_m k(m, .) for all nodes of rows 1..n-2. */
static void spread_film(const ovr_strip *strip, const stencil *s, double *to)
{
    const ovr_strip_grid *g = &strip->level[0].grid;
    for (size_t c = 1; c + 1 < g->n; c++, to += padded(g->lines)) {
        const double *k[STENCIL];
        for (int m = 0; m < STENCIL; m++) {
            size_t d = s->i[m] > c ? s->i[m] - c : c - s->i[m];
            k[m] = ovr_strip_influence_of(strip, d, s->j[m]);
        }
        strip->run->blend(g->lines, STENCIL, s->by_film, k, to);
    }
}

/* Numbers the unknowns row after row; returns their count. */
static size_t find_unknowns(const ovr_strip_level *level, int *place)
{
    const ovr_strip_grid *g = &level->grid;
    size_t count = 0;
    for (size_t i = 1; i + 1 < g->n; i++)
        for (size_t j = 0; j < g->lines; j++)
            if (level->f.moves[ovr_strip_row(g, i) + j] > 0)
                place[count++] = (int)(i * g->lines + j);
    return count;
}

/* Fills row r of the matrix; `film` has a value per node of the grid. */
static void fill_row(const ovr_strip *strip, size_t count, size_t r,
                     double *film, double *row)
{
    const int *place = strip->unknown;
    const ovr_strip_level *level = &strip->level[0];
    const size_t lines = level->grid.lines;
    size_t i = (size_t)place[r] / lines, j = (size_t)place[r] % lines;
    stencil s = stencil_at(level, i, j);
    double by_H0 = 0;
    for (int m = 0; m < STENCIL; m++)
        by_H0 += s.by_film[m];
    spread_film(strip, &s, film);
    for (int m = 0; m < STENCIL; m++)
        if (s.i[m] >= 1 && s.i[m] + 1 < level->grid.n)
            film[(s.i[m] - 1) * padded(lines) + s.j[m]] += s.by_pressure[m];
    for (size_t c = 0; c < count; c++) {
        size_t ci = (size_t)place[c] / lines, cj = (size_t)place[c] % lines;
        row[c] = film[(ci - 1) * padded(lines) + cj];
    }
    row[count] = by_H0;
    row[count + 1] = level->f.r[ovr_strip_row(&level->grid, i) + j];
}

static double apply(ovr_strip *strip, size_t count, bool shortened)
{
    const double most = 0.3;
    ovr_strip_level *level = &strip->level[0];
    /* Light loads have films of hundreds of b^2/R. */
    double most_film = 0.2 * fmax(1, fabs(ovr_strip_centre(level, level->f.H)));
    const size_t lines = level->grid.lines;
    const double *x = strip->solution;
    double largest = 0, factor = 1;
    for (size_t c = 0; c < count; c++)
        largest = fmax(largest, fabs(x[c]));
    if (shortened && largest > most)
        factor = most / largest;
    if (fabs(x[count]) * factor > most_film)
        factor = most_film / fabs(x[count]);
    for (size_t c = 0; c < count; c++) {
        size_t i = (size_t)strip->unknown[c] / lines;
        size_t j = (size_t)strip->unknown[c] % lines;
        double *P = &level->f.P[ovr_strip_row(&level->grid, i) + j];
        *P = fmax(0, *P + fmax(-most, fmin(most, factor * x[c])));
    }
    strip->H0 += factor * x[count];
    return largest;
}

static size_t stride_of(size_t unknowns)
{
    return (unknowns + 8 + 7) / 8 * 8;
}

/* Arguments of the pass that fills the matrix. */
typedef struct filling {
    const ovr_strip *strip;
    size_t count;
} filling;

static void fill_rows(void *data, int member, size_t from, size_t to)
{
    const filling *f = data;
    double *film = ovr_strip_work_of(f->strip, member);
    for (size_t r = from; r < to; r++)
        fill_row(f->strip, f->count, r, film,
                 f->strip->matrix + r * stride_of(f->count + 1));
}

double ovr_strip_newton(ovr_strip *strip, bool shortened)
{
    ovr_strip_level *level = &strip->level[0];
    const ovr_strip_grid *g = &level->grid;
    const ovr_strip_cycling any = ovr_strip_steady(&strip->fluid);
    ovr_strip_choose_nodes(strip, level, &any.smoothing);
    size_t count = find_unknowns(level, strip->unknown);
    size_t m = count + 1, stride = stride_of(m);
    ovr_team_run(&strip->team, count, fill_rows, &(filling){strip, count});
    double *last = strip->matrix + count * stride;
    for (size_t c = 0; c < count; c++)
        last[c] = 1;
    last[count] = 0;
    last[m] = level->force * (double)ovr_across_intervals(g->lines) / g->D -
              ovr_strip_sum(strip, level, level->f.P);
    if (!strip->kernels->dense_solve(m, stride, strip->matrix, strip->solution))
        return -1;
    double largest = apply(strip, count, shortened);
    ovr_strip_refresh(strip, level);
    return isfinite(largest) ? largest : -1;
}
