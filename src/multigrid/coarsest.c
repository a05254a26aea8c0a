/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "multigrid/coarsest.h"

#include <math.h>
#include <string.h>

#include "base/larger.h"
#include "multigrid/content.h"
#include "multigrid/field.h"
#include "multigrid/mixed_contact.h"
#include "multigrid/tripoles.h"

#include "multigrid/content_row.h"

/* Number of stored values of K/pi of a level: distances -(n + 1) .. n + 2.
 * Distance 0 has index n + 2. */
static size_t distances(size_t n)
{
    return 2 * n + 5;
}

double *ovr_newton_kernel(size_t n, ovr_arena *arena, ovr_error *err)
{
    return ovr_field(arena, distances(n), err);
}

/* Number of values in a row: n + 1 unknowns and the right-hand side, rounded up
 * to whole vectors. */
static size_t stride_of(size_t n)
{
    return (n + 2 + 14) / 8 * 8;
}

int ovr_newton_levels(const ovr_hierarchy *grids)
{
    int levels = grids->finest - grids->coarsest + 1;
    int maximum = grids->content ? 3 : 2;
    return levels < maximum ? levels : maximum;
}

ovr_status ovr_newton_prepare(ovr_hierarchy *grids, ovr_arena *arena,
                              ovr_error *err)
{
    ovr_newton *newton = &grids->newton;
    const ovr_level *level = &grids->level[grids->coarsest], *top;
    top = level + newton->levels - 1;
    size_t m = top->grid.n + 1;
    newton->matrix = ovr_field(arena, m * stride_of(top->grid.n), err);
    newton->change = ovr_field(arena, m, err);
    for (int k = 0; k < newton->levels; k++)
        newton->kernel[k] = ovr_newton_kernel((level + k)->grid.n, arena, err);
    if (grids->content)
        newton->wet = ovr_field(arena, m, err);
    return ovr_arena_status(arena);
}

static void fill_kernel(const ovr_hierarchy *grids, const ovr_level *level,
                        double *kernel)
{
    for (size_t d = 0; d < distances(level->grid.n); d++) {
        double at = (double)d - (double)(level->grid.n + 2);
        kernel[d] = ovr_influence_at(&grids->influence, at, level->grid.D);
    }
}

void ovr_newton_fill(ovr_hierarchy *grids)
{
    for (int k = 0; k < grids->newton.levels; k++)
        fill_kernel(grids, &grids->level[grids->coarsest + k],
                    grids->newton.kernel[k]);
    if (grids->touch.kernel)
        fill_kernel(grids, &grids->level[grids->finest], grids->touch.kernel);
}

static row_weights weights_of(const ovr_hierarchy *grids,
                              const ovr_level *level, const ovr_fields *f,
                              size_t i)
{
    const ovr_weights *w = &level->weights;
    row_kind kind = row_kind_of(f);
    row_weights c = i == 1 ? row_first(w, kind) : row_inner(w, kind);
    return grids->conserving ? row_limited(f, w, &c, (ptrdiff_t)i) : c;
}

/* Derivatives of row i with respect to film thickness and pressure at nodes
 * i-2..i+1. */
static ovr_newton_row local_row(const ovr_hierarchy *grids,
                                const ovr_level *level, const ovr_fields *f,
                                const row_weights *c, size_t i)
{
    ovr_newton_row row = {.r = f->r[i]};
    ptrdiff_t J = (ptrdiff_t)i;
    if (grids->conserving)
        row_content_by_film(f, c, J, row.e);
    else
        row_by_film(f, c, J, row.e);
    row_flow_by_film(f, c, J, row.e);
    row_by_pressure(f, c, J, row.local);
    if (grids->touch.at)
        ovr_asperity_pressurized_row(grids, level, i, &row);
    return row;
}

/* Address of k(0) of a level; k(d) is d elements further. */
static const double *kernel_of(const ovr_hierarchy *grids,
                               const ovr_level *level)
{
    return grids->newton.kernel[level->number - grids->coarsest] +
           level->grid.n + 2;
}

/* Row i of the Jacobian: elastic terms through dH at i-2..i+1, dH_{i+d}/dP_j =
 * -k(j - i - d), then the local terms, dN_i/dH0 and the right-hand side.
 */
static void full_row(const ovr_hierarchy *grids, const ovr_level *level,
                     const ovr_newton_row *of, size_t i, double *row)
{
    size_t n = level->grid.n;
    const double *e = of->e;
    grids->kernels->dense_row(n, e, kernel_of(grids, level) - i, row);
    for (size_t d = i == 1; d < 4; d++)
        row[i + d - 2] += of->local[d];
    row[n] = -(e[0] + e[1] + e[2] + e[3]);
    row[n + 1] = of->r;
}

static bool is_held(const ovr_hierarchy *grids, const ovr_level *level,
                    size_t i)
{
    if (i == 0 || i == level->grid.n - 1)
        return true;
    return !grids->conserving && ovr_lanes_has(&level->lanes, level->f.held, i);
}

/* Assembles the matrix: rows 0..n-1 for pressures, row n for the force. The
 * right-hand side is column n + 1. */
static void assemble(const ovr_hierarchy *grids, const ovr_level *level,
                     const ovr_fields *f)
{
    size_t n = level->grid.n, stride = stride_of(n);
    double *row = grids->newton.matrix;
    const double *wet = grids->newton.wet; /* at cavitated nodes the unknown is
                                            * q */
    for (size_t i = 0; i < n; i++, row += stride) {
        row_weights c;
        ovr_newton_row of;
        if (is_held(grids, level, i)) {
            memset(row, 0, (n + 2) * sizeof *row);
            row[i] = 1;
            continue;
        }
        c = weights_of(grids, level, f, i);
        of = local_row(grids, level, f, &c, i);
        full_row(grids, level, &of, i, row);
        if (!grids->conserving)
            continue;
        for (size_t j = 0; j < n; j++)
            row[j] *= wet[j];
        for (size_t m = 0; m < 3 && m <= i; m++)
            if (!f->wet[i - m])
                row[i - m] = -row_content_weight(f, &c, (int)m, (ptrdiff_t)i);
    }
    for (size_t j = 0; j < n; j++)
        row[j] = level->grid.D * (grids->conserving ? wet[j] : 1);
    row[n] = 0;
    row[n + 1] = level->force - ovr_level_load(grids, level);
}

/* Solves the same system by tripoles. The system is solved again only if the
 * cavitation boundary moves. */
static bool solve_touching(ovr_hierarchy *grids, const ovr_level *level,
                           const ovr_fields *f)
{
    enum { TURNS = 5 };
    const ovr_asperity *touch = &grids->touch;
    double *step = touch->step;
    double missing = level->force - ovr_level_load(grids, level);
    ovr_asperity_open(grids, level, f);
    for (int turn = 0; turn < TURNS; turn++) {
        for (size_t i = 1; i + 1 < level->grid.n; i++) {
            row_weights c = weights_of(grids, level, f, i);
            touch->tripoles->row[i] = touch->dry[i]
                                          ? ovr_asperity_cavitated_row(grids,
                                                                       level, i)
                                          : local_row(grids, level, f, &c, i);
        }
        if (!ovr_tripoles_solve(grids, level, missing, step))
            return false;
        if (!ovr_asperity_close(grids, level, step))
            break;
    }
    return true;
}

/* Copies the phases to the order of the nodes, after those of nodes with P = 0
 * and q = rho H have been decided. */
static void order_states(const ovr_hierarchy *grids, const ovr_level *level,
                         const ovr_fields *f)
{
    grids->kernels->content_choose(&level->lanes, &level->weights, &level->f);
    ovr_content_read(level, level->f.wet, f->wet);
    ovr_content_read(level, level->f.limited, f->limited);
    ovr_content_read(level, level->f.spent, f->spent);
    for (size_t i = 0; i < level->grid.n; i++)
        grids->newton.wet[i] = f->wet[i];
}

/* Changes P of pressurized nodes, which become cavitated at zero, and q of
 * cavitated nodes. */
static void advance(const ovr_hierarchy *grids, const ovr_level *level,
                    const ovr_fields *f, double limit)
{
    const double *change = grids->newton.change;
    for (size_t i = 1; i + 1 < level->grid.n; i++) {
        if (!grids->conserving || f->wet[i])
            f->P[i] = fmax(0, f->P[i] + ovr_clipped(change[i], limit));
        else
            f->q[i] = fmax(0, f->q[i] + change[i]);
        if (!grids->conserving || !f->wet[i] || f->P[i] > 0)
            continue;
        ovr_content_mark(level, level->f.wet, i, false);
        ovr_content_mark(level, level->f.dried, i, true);
    }
    ovr_level_write(grids, level, f->P, level->f.P);
    if (grids->conserving)
        ovr_level_write(grids, level, f->q, level->f.q);
}

/* Applies the step, or only a part of it if the full step increases the
 * residual much. */
static void advance_touching(ovr_hierarchy *grids, ovr_level *level,
                             const ovr_fields *f, double limit)
{
    enum { PARTS = 6 };
    const double worse = 30;
    const ovr_asperity *touch = &grids->touch;
    double H0 = grids->H0, part = 1;
    double maximum = worse * fmax(ovr_level_imbalance(grids, level), 1);
    ovr_asperity_limit(touch, level->grid.n, limit);
    for (int k = 0; k < PARTS; k++, part /= 4) {
        grids->H0 = H0 + part * touch->step[level->grid.n];
        ovr_asperity_advance(grids, level, f, part);
        ovr_level_properties(grids, level);
        ovr_level_residual(grids, level);
        if (ovr_level_imbalance(grids, level) < maximum)
            return;
    }
}

/* Returns the work of a Newton step in node cycles: n^3/5000 for a dense solve,
 * 5 n with asperity contact (levels 7 to 9). */
static double work_of(const ovr_hierarchy *grids, double n)
{
    const double dense = 1. / 5000, contact = 5;
    return grids->touch.at ? contact * n : dense * n * n * n;
}

bool ovr_newton_step(ovr_hierarchy *grids, ovr_level *level, double limit)
{
    const ovr_newton *newton = &grids->newton;
    const ovr_fields *f;
    size_t n = level->grid.n;
    double H;
    if (ovr_hierarchy_stops(grids))
        return false;
    grids->stopping.work += work_of(grids, (double)n);
    ovr_level_residual(grids, level);
    f = ovr_level_ordered(grids, level);
    if (grids->conserving)
        order_states(grids, level, f);
    if (grids->touch.at) {
        ovr_asperity_prepare(grids, level, f);
        if (!solve_touching(grids, level, f))
            return false;
        advance_touching(grids, level, f, limit);
        return isfinite(grids->H0);
    }
    assemble(grids, level, f);
    if (!grids->kernels->dense_solve(n + 1, stride_of(n), newton->matrix,
                                     newton->change))
        return false;
    advance(grids, level, f, limit);
    /* the limit is proportional to H if H > 1: rigid contacts with thick films
     */
    H = fabs(ovr_level_centre(level, level->f.H));
    grids->H0 += ovr_clipped(newton->change[n],
                             limit * 2 / 3 * (H > 1 ? H : 1));
    return isfinite(grids->H0);
}
