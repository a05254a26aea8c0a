/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "multigrid/hybrid.h"

#include "base/larger.h"
#include "multigrid/reynolds_row.h"

/* Row i for fixed film and properties and the present P: residual, dN_i/dP_i,
 * dN_i/dP_{i-1}; whether the node stays cavitated, which can change during the
 * sweep. */
typedef struct row {
    double r, own, before;
    bool held;
} row;

static row row_at(const ovr_level *level, const ovr_fields *f, size_t i)
{
    const ovr_weights *w = &level->weights;
    row_kind kind = row_kind_of(f);
    row_weights c = i == 1 ? row_first(w, kind) : row_inner(w, kind);
    ptrdiff_t J = (ptrdiff_t)i;
    double e[3], A[4] = {0};
    row_by_film(f, &c, J, e);
    A[1] = row_elastic(e, level->k, -1);
    A[2] = row_elastic(e, level->k, 0);
    row_by_pressure(f, &c, J, A);
    double r = row_residual(f, &c, J);
    return (row){.r = r,
                 .own = A[2],
                 .before = A[1],
                 .held = row_holds(f, r, w->hold, J)};
}

static void seidel(const ovr_smoothing *how, const ovr_fields *f, size_t i,
                   row s)
{
    double next = f->P[i] + how->relax_seidel * s.r / s.own;
    if (!s.held)
        f->P[i] = next > 0 ? next : 0;
}

/* Line solve of rows first..last for fixed film thickness by the Thomas
 * algorithm, then projection to P >= 0. Cavitated nodes stay constrained unless
 * their pressure should become positive. */
static void exit_line(const ovr_hierarchy *grids, const ovr_level *level,
                      const ovr_fields *f, size_t first, size_t last)
{
    double half = level->weights.half, above = 0, change = 0;
    double *upper = grids->band.b[0], *delta = grids->band.delta;
    for (size_t i = first; i <= last; i++) {
        row s = row_at(level, f, i);
        row_faces faces = row_faces_at(f, f->flow, (ptrdiff_t)i);
        double lower = half * faces.before, right = half * faces.after;
        if (s.held) {
            s.r = lower = right = 0;
            s.own = 1;
        }
        double scale = 1 / (s.own - lower * above);
        upper[i] = above = right * scale;
        delta[i] = change = (s.r - lower * change) * scale;
    }
    change = 0;
    for (size_t i = last; i >= first; i--) {
        change = delta[i] - upper[i] * change;
        double next = f->P[i] + change;
        f->P[i] = next > 0 ? next : 0;
    }
}

/* Finds the rows near the film end in which a line solve with fixed film is
 * stable, see hybrid.h. */
static bool exit_window(const ovr_level *level, const ovr_fields *f,
                        size_t *first, size_t *last)
{
    enum { BEHIND = 8 };
    const double *P = f->P, *eps = f->eps;
    double D = level->grid.D;
    size_t end = level->grid.n - 2, i;
    while (end > 1 && !(P[end] > 0))
        end--;
    for (i = end; i > 1; i--) {
        double length = D * (double)(end - i + 2);
        if (length * length > 3 * eps[i - 1])
            break;
    }
    *first = i;
    *last = end + BEHIND < level->grid.n - 1 ? end + BEHIND : level->grid.n - 2;
    return end > 1;
}

static void relax_exit(const ovr_hierarchy *grids, const ovr_level *level,
                       const ovr_fields *f)
{
    enum { LINES = 4 };
    size_t first, last;
    if (exit_window(level, f, &first, &last))
        for (int k = 0; k < LINES; k++)
            exit_line(grids, level, f, first, last);
}

void ovr_relax_hybrid(ovr_hierarchy *grids, ovr_level *level,
                      const ovr_smoothing *how)
{
    const ovr_fields *f = ovr_level_ordered(grids, level);
    double *restrict P = f->P, *restrict delta = grids->band.delta;
    double bound = how->switch_value * level->grid.D * level->grid.D;
    size_t n = level->grid.n;
    for (size_t i = 1; i + 1 < n; i++) {
        row s = row_at(level, f, i);
        delta[i] = 0;
        if (0.5 * row_outflow(f, f->flow, 0.5, (ptrdiff_t)i) > bound)
            seidel(how, f, i, s);
        else
            delta[i] = ovr_clipped(how->relax_dipole * s.r / (s.own - s.before),
                                   how->limit);
    }
    delta[n - 1] = 0;
    for (size_t i = 1; i + 1 < n; i++) {
        double next = P[i] + delta[i] - delta[i + 1];
        P[i] = next > 0 ? next : 0;
    }
    relax_exit(grids, level, f);
    ovr_level_write(grids, level, P, level->f.P);
}

void ovr_coarsest_paper(ovr_hierarchy *grids, ovr_level *level,
                        const ovr_smoothing *how, int cycle_index)
{
    int sweeps = cycle_index > 1 ? 20 : 100;
    for (int s = 0; s < sweeps; s++) {
        if (s)
            ovr_level_refresh(grids, level);
        ovr_relax_hybrid(grids, level, how);
        grids->H0 -= 0.02 * (level->force - ovr_level_load(grids, level));
    }
}
