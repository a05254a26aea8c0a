/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "multigrid/composite.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "multigrid/field.h"

/* ------------------------------------------------------ the film on patches */

/* Lagrange's weights for interpolation at the midpoint of 2 h nodes, by
 * distance. */
static void midpoint(int h, double *a)
{
    for (int k = 0; k < h; k++) {
        double x = k + 0.5, value = 0.5;
        for (int j = 0; j < h; j++) {
            double y = j + 0.5;
            if (j != k)
                value *= y * y / (y * y - x * x);
        }
        a[k] = value;
    }
}

static void composite_film_make(ovr_composite_film *film)
{
    midpoint(OVR_FILM_MIDDLE, film->middle);
    midpoint(OVR_DETAIL_MIDDLE, film->detail);
    for (int t = 0; t < OVR_FILM_NEAR; t++) {
        double c = ovr_deformation_linear(t + 0.5, 1);
        for (int m = 0; m < OVR_FILM_MIDDLE; m++)
            c -= film->middle[m] * (ovr_deformation_linear(t - m, 1) +
                                    ovr_deformation_linear(t + 1 + m, 1));
        film->near[t] = c;
    }
}

/* Computes c_t/D' for a parent. */
static void composite_film_parent(const ovr_composite_film *film,
                                  const ovr_hierarchy *grids,
                                  const ovr_patch *parent, double *near)
{
    const ovr_influence *influence = &grids->influence;
    double D = parent->level->grid.D, R[2 * (OVR_FILM_NEAR + OVR_FILM_MIDDLE)];
    for (int t = 0; t < OVR_FILM_NEAR; t++)
        near[t] = film->near[t];
    if (!influence->parts)
        return;
    for (int d = 0; d < 2 * (OVR_FILM_NEAR + OVR_FILM_MIDDLE); d++)
        R[d] = ovr_influence_rest(influence, 0.5 * d, D) / D;
    for (int t = 0; t < OVR_FILM_NEAR; t++) {
        near[t] += R[2 * t + 1];
        for (int m = 0; m < OVR_FILM_MIDDLE; m++)
            near[t] -= film->middle[m] *
                       (R[2 * abs(t - m)] + R[2 * (t + 1 + m)]);
    }
}

/* Extends w beyond the ends of the whole grid, for a patch that ends there too.
 */
static void extend(const ovr_influence *influence, ovr_patch *parent)
{
    const ovr_grid *grid = &parent->level->grid;
    for (size_t k = 1; k <= OVR_FILM_MIDDLE; k++) {
        double before = 0, after = 0;
        for (size_t j = 0; j < grid->n; j++) {
            double K = ovr_influence_at(influence, (double)(j + k), grid->D);
            before += parent->P[j] * K;
            after += parent->P[grid->n - 1 - j] * K;
        }
        parent->w[-(ptrdiff_t)k] = before;
        parent->w[grid->n - 1 + k] = after;
    }
}

/* Adds c times the sums of node pairs around all midpoints to `sum`. */
static void add_pairs(size_t count, double c, const double *from, ptrdiff_t out,
                      double *restrict sum)
{
    const double *left = from - out, *right = from + 1 + out;
    for (size_t I = 0; I < count; I++)
        sum[I] += c * (left[I] + right[I]);
}

/* Computes o and I P' from the parent's w and P, which have been read. */
static void patch_outer(const ovr_composite_film *film,
                        const ovr_hierarchy *grids, ovr_patch *patch,
                        ovr_patch *parent)
{
    const ovr_grid *grid = &patch->level->grid;
    const double *w = parent->w + grid->first, *P = parent->P + grid->first;
    size_t count = (grid->n - 1) / 2;
    double *middle = patch->q; /* unused until it is read again */
    if (!patch->opens || !patch->closes)
        extend(&grids->influence, parent);
    memset(middle, 0, count * sizeof *middle);
    for (int m = 0; m < OVR_FILM_MIDDLE; m++)
        add_pairs(count, film->middle[m], w, m, middle);
    for (int t = 0; t < OVR_FILM_NEAR; t++)
        add_pairs(count, parent->level->grid.D * patch->near[t], P, t, middle);
    for (size_t I = 0; I <= count; I++) {
        patch->outer_w[2 * I] = w[I];
        patch->outer_P[2 * I] = P[I];
    }
    for (size_t I = 0; I < count; I++) {
        patch->outer_w[2 * I + 1] = middle[I];
        patch->outer_P[2 * I + 1] = 0.5 * (P[I] + P[I + 1]);
    }
}

/* Computes K x; both arrays are in the order of the nodes. */
static void deform(const ovr_hierarchy *grids, ovr_patch *p, const double *x,
                   double *w)
{
    const ovr_level *level = p->level;
    ovr_level_write(grids, level, x, p->wide[0]);
    grids->kernels->deformation(&level->mlmi, p->wide[0], p->wide[1]);
    ovr_level_read(grids, level, p->wide[1], w);
}

static bool is_base(const ovr_patch *patch)
{
    return patch->level != &patch->own;
}

void ovr_patch_deform(const ovr_hierarchy *grids, ovr_patch *patch)
{
    const ovr_level *level = patch->level;
    double *added = patch->q; /* unused until it is read again */
    if (is_base(patch)) {
        deform(grids, patch, patch->P, patch->w);
    } else {
        memset(added, 0, level->grid.n * sizeof *added);
        for (size_t i = patch->from; i <= patch->to; i++)
            added[i] = patch->P[i] - patch->outer_P[i];
        deform(grids, patch, added, patch->w);
        for (size_t i = 0; i < level->grid.n; i++)
            patch->w[i] += patch->outer_w[i];
    }
    ovr_level_write(grids, level, patch->w, level->f.w);
}

/* Y at node I of a patch; X is zero beyond its ends. */
static double gathered(const ovr_composite_film *film, const double *X,
                       ptrdiff_t n, ptrdiff_t i)
{
    double sum = i >= 0 && i < n ? X[i] : 0;
    for (int m = 0; m < OVR_DETAIL_MIDDLE; m++) {
        ptrdiff_t left = i - 2 * m - 1, right = i + 2 * m + 1;
        sum += film->detail[m] * ((left >= 0 && left < n ? X[left] : 0) +
                                  (right >= 0 && right < n ? X[right] : 0));
    }
    return 0.5 * sum;
}

/* Computes X and returns its load. */
static double surplus(ovr_patch *patch, const ovr_patch *parent, double *X)
{
    const double *P = parent->P + patch->level->grid.first;
    double load = 0;
    size_t n = patch->level->grid.n;
    memset(X, 0, n * sizeof *X);
    for (size_t i = patch->from; i <= patch->to; i++) {
        double outer = i % 2 ? 0.5 * (P[i / 2] + P[i / 2 + 1]) : P[i / 2];
        X[i] = patch->P[i] - outer;
        load += X[i];
    }
    for (size_t i = 0; i < n; i++)
        X[i] += patch->detail[i];
    return patch->level->grid.D * load;
}

/* Computes V' and its deformation for the parent, and the additional load of
 * the patch. The parent's P under the patch must equal that of the patch. */
static void patch_detail(const ovr_hierarchy *grids,
                         const ovr_composite_film *film, ovr_patch *patch,
                         ovr_patch *parent)
{
    enum { REACH = OVR_DETAIL_MIDDLE + 2 };
    ptrdiff_t n = (ptrdiff_t)patch->level->grid.n, half = (n - 1) / 2;
    ptrdiff_t first = (ptrdiff_t)patch->level->grid.first, last;
    double *X = patch->q, *V = parent->detail, *Y = parent->detail_w;
    last = (ptrdiff_t)parent->level->grid.n - 1;
    patch->added = surplus(patch, parent, X);
    memset(V, 0, parent->level->grid.n * sizeof *V);
    memset(Y, 0, parent->level->grid.n * sizeof *Y);
    for (ptrdiff_t I = first - REACH; I <= first + half + REACH; I++)
        if (I >= 0 && I <= last)
            Y[I] = gathered(film, X, n, 2 * (I - first));
    for (ptrdiff_t I = first - REACH; I <= first + half + REACH; I++)
        if (I >= 2 && I + 2 <= last) {
            double two = Y[I - 1] + Y[I + 1], four = Y[I - 2] + Y[I + 2];
            V[I] = Y[I] - (two - 2 * Y[I]) / 16 +
                   (four - 4 * two + 6 * Y[I]) / 128;
        }
    deform(grids, parent, V, parent->detail_w);
}

void ovr_base_fourth(const ovr_hierarchy *grids, ovr_patch *base,
                     const ovr_patch *patch)
{
    size_t begin = ovr_patch_begin(patch), end = ovr_patch_end(patch);
    double D = base->level->grid.D, *second = base->q, *P = base->P;
    memset(second, 0, base->level->grid.n * sizeof *second);
    for (size_t I = base->from; I <= base->to; I++)
        if (I <= begin || I >= end)
            second[I] = P[I - 1] - 2 * P[I] + P[I + 1];
    deform(grids, base, second, base->g);
    for (size_t I = 0; I < base->level->grid.n; I++) {
        base->g[I] /= 12;
        base->rigid[I] += base->g[I] + base->level->local * D * second[I];
    }
}

void ovr_patch_fourth(ovr_patch *patch, const ovr_patch *parent)
{
    const double *g = parent->g + patch->level->grid.first;
    for (size_t i = 0; i < patch->level->grid.n; i++) {
        const double *at = g + i / 2;
        patch->g[i] = i % 2 ? (9 * (at[0] + at[1]) - at[-1] - at[2]) / 16 : *at;
        patch->rigid[i] += patch->g[i];
    }
}

/* ------------------------------------------------------------------ memory */

static void *from_chunk(void *context, size_t bytes)
{
    ovr_composite *c = context;
    size_t at = (c->used + 63) / 64 * 64;
    if (at + bytes > c->size)
        return NULL;
    c->used = at + bytes;
    return c->chunk + at;
}

static void to_chunk(void *context, void *memory)
{
    (void)context;
    (void)memory;
}

/* Counts the memory of patches with these numbers of nodes; most are as large
 * as the previous one. */
static ovr_status count_bytes(const ovr_composite *c, const size_t *maximum,
                              int patches, size_t *bytes, ovr_error *err)
{
    ovr_patch pair[2];
    ovr_level wide = *c->part[0].level;
    ovr_status status = OVR_OK;
    size_t one = 0;
    pair[0] = (ovr_patch){.level = &wide};
    *bytes = 0;
    for (int k = 0; k < patches && !status; k++) {
        ovr_arena arena = ovr_arena_counting();
        wide.grid.n = maximum[k] + 2;
        if (k == 0 || maximum[k] != maximum[k - 1]) {
            status = ovr_patch_build(c->grids, &pair[1],
                                     (ovr_window){1, (maximum[k] - 1) / 2},
                                     &arena, err);
            one = arena.bytes;
            ovr_arena_release(&arena);
        }
        *bytes += one;
    }
    return status;
}

ovr_status ovr_composite_prepare(ovr_composite *c, ovr_hierarchy *grids,
                                 const size_t *maximum, int patches,
                                 ovr_arena *arena, ovr_error *err)
{
    size_t n = grids->level[grids->finest].grid.n;
    for (int k = 0; k < patches; k++)
        n = maximum[k] > n ? maximum[k] : n;
    c->grids = grids;
    ovr_patch_base(grids, &c->part[0], arena, err);
    OVR_TAKE_FIELDS(arena, n + OVR_MAX_LANES, err, &c->workspace[0],
                    &c->workspace[1]);
    if (count_bytes(c, maximum, patches, &c->size, err))
        return OVR_NO_MEMORY;
    c->size += (size_t)64 * 1024 * (size_t)(patches + 1);
    c->chunk = ovr_arena_take(arena, c->size, 1, err);
    return ovr_arena_status(arena);
}

void ovr_composite_begin(ovr_composite *c, double force)
{
    const ovr_allocator chunk = {from_chunk, to_chunk, c};
    ovr_patch *base = &c->part[0];
    const ovr_level *level = base->level;
    composite_film_make(&c->film);
    c->used = 0;
    c->memory = ovr_arena_make(&chunk);
    c->patches = 0;
    c->force = force;
    ovr_patch_read(c->grids, base);
    ovr_level_read(c->grids, level, level->f.gap, base->rigid);
    ovr_level_read(c->grids, level, level->f.F, base->F);
    memset(base->detail, 0, level->grid.n * sizeof *base->detail);
    memset(base->detail_w, 0, level->grid.n * sizeof *base->detail_w);
}

ovr_status ovr_composite_add(ovr_composite *c, ovr_window window,
                             ovr_error *err)
{
    ovr_patch *patch = &c->part[c->patches + 1], *parent = patch - 1;
    if (ovr_patch_build(c->grids, patch, window, &c->memory, err))
        return OVR_NO_MEMORY;
    ovr_patch_fill(c->grids, patch, parent);
    composite_film_parent(&c->film, c->grids, parent, patch->near);
    c->patches++;
    return OVR_OK;
}

/* -------------------------------------------------------------------- film */

/* Computes film thickness, residual and phase (pressurized or cavitated) of a
 * patch from its pressure. */
static void refresh(ovr_composite *c, ovr_patch *patch)
{
    ovr_patch_write(c->grids, patch);
    ovr_patch_deform(c->grids, patch);
    ovr_level_properties(c->grids, patch->level);
    ovr_patch_settle(c->grids, patch);
}

void ovr_composite_start(ovr_composite *c)
{
    ovr_patch *patch = &c->part[c->patches], *parent = patch - 1;
    ovr_level *level = patch->level;
    ovr_patch_read(c->grids, parent);
    ovr_patch_begin_from(patch, parent);
    patch_outer(&c->film, c->grids, patch, parent);
    ovr_level_write(c->grids, level, patch->rigid, level->f.gap);
    ovr_level_clear(level, level->f.F);
    refresh(c, patch);
}

/* ------------------------------------------------------------- restriction */

bool ovr_composite_leaf(const ovr_composite *c, int part, size_t i)
{
    const ovr_patch *finer = &c->part[part + 1];
    if (part == c->patches)
        return true;
    return (finer->opens && i <= ovr_patch_begin(finer)) ||
           (finer->closes && i >= ovr_patch_end(finer));
}

/* Restricts P to the parent under the patch. */
static void restrict_pressure(ovr_patch *patch, ovr_patch *parent)
{
    const double *P = patch->P;
    size_t first = patch->level->grid.first, n = patch->level->grid.n;
    for (size_t i = patch->from + 1; i + 1 <= patch->to; i += 2) {
        bool inject = (patch->opens && i < OVR_PATCH_EDGE + 8) ||
                      (patch->closes && i + OVR_PATCH_EDGE + 8 >= n);
        bool wet = P[i - 1] > 0 && P[i] > 0 && P[i + 1] > 0;
        parent->P[first + i / 2] = wet && !inject
                                       ? (P[i - 1] + 2 * P[i] + P[i + 1]) / 4
                                       : P[i];
    }
    memcpy(parent->entry, parent->P, parent->level->grid.n * sizeof *P);
}

/* Computes the parent's gap: the real gap outside the patch and, under the
 * patch, the gap for which the film thickness is that of the patch. */
static void restrict_gap(ovr_composite *c, ovr_patch *patch, ovr_patch *parent)
{
    const ovr_hierarchy *grids = c->grids;
    size_t first = patch->level->grid.first, n = patch->level->grid.n;
    double *gap = c->workspace[0], *H = c->workspace[1];
    for (size_t I = 0; I < parent->level->grid.n; I++)
        gap[I] = parent->rigid[I] - parent->detail_w[I];
    ovr_level_read(grids, patch->level, patch->level->f.H, H);
    for (size_t i = 0; i < n; i += 2)
        gap[first + i / 2] = H[i] - grids->H0 + parent->w[first + i / 2];
    ovr_level_write(grids, parent->level, gap, parent->level->f.gap);
}

/* Mass flow of the patch at the parent's half node I + 1/2. */
static double inner_flux(const ovr_composite *c, const ovr_patch *patch,
                         size_t I)
{
    size_t i = ovr_patch_node(patch, I);
    return 0.5 * (ovr_patch_flux(c->grids, patch, i) +
                  ovr_patch_flux(c->grids, patch, i + 1));
}

/* Residual at J*: inflow computed on one grid minus outflow computed on the
 * other. */
static double residual_at_end(const ovr_composite *c, const ovr_patch *patch,
                              const ovr_patch *parent, size_t J, bool begins)
{
    double left = begins ? ovr_patch_flux(c->grids, parent, J - 1)
                         : inner_flux(c, patch, J - 1);
    double right = begins ? inner_flux(c, patch, J)
                          : ovr_patch_flux(c->grids, parent, J);
    return parent->F[J] - (right - left) / parent->level->grid.D;
}

/* Full weighting of the residual at a pressurized node of the patch. */
static double weighted(const double *P, const double *r)
{
    double sum = 2 * r[0] + (P[-1] > 0 ? r[-1] : 0) + (P[1] > 0 ? r[1] : 0);
    return P[0] > 0 ? sum / 4 : 0;
}

/* F' = N' + r under the patch and at its ends, F0' elsewhere. */
static void restrict_sides(ovr_composite *c, ovr_patch *patch,
                           ovr_patch *parent)
{
    const ovr_hierarchy *grids = c->grids;
    ovr_level *level = parent->level;
    size_t begin = ovr_patch_begin(patch), end = ovr_patch_end(patch);
    double *r = c->workspace[0], *F = c->workspace[1];
    ovr_level_clear(level, level->f.F);
    ovr_level_residual(grids, level); /* -N' */
    ovr_level_read(grids, level, level->f.r, F);
    ovr_level_read(grids, patch->level, patch->level->f.r, r);
    for (size_t I = begin + 1; I < end; I++) {
        size_t i = ovr_patch_node(patch, I);
        F[I] = weighted(patch->P + i, r + i) - F[I];
    }
    if (patch->opens)
        F[begin] = residual_at_end(c, patch, parent, begin, true) - F[begin];
    if (patch->closes)
        F[end] = residual_at_end(c, patch, parent, end, false) - F[end];
    for (size_t I = 0; I < begin + !patch->opens; I++)
        F[I] = parent->F[I];
    for (size_t I = end + patch->closes; I < level->grid.n; I++)
        F[I] = parent->F[I];
    ovr_level_write(grids, level, F, level->f.F);
}

/* Restricts to the parent. Film and residual of the patch must be up to date;
 * those of the parent are up to date afterwards. */
static void restrict_to(ovr_composite *c, ovr_patch *patch, ovr_patch *parent)
{
    const ovr_hierarchy *grids = c->grids;
    ovr_level_read(grids, parent->level, parent->level->f.P, parent->P);
    restrict_pressure(patch, parent);
    ovr_patch_write(grids, parent);
    ovr_patch_deform(grids, parent);
    patch_detail(grids, &c->film, patch, parent);
    restrict_gap(c, patch, parent);
    ovr_level_properties(grids, parent->level);
    ovr_patch_read(grids, patch);
    ovr_patch_read(grids, parent);
    restrict_sides(c, patch, parent);
    if (parent == c->part)
        ovr_level_residual(grids, parent->level);
    else
        ovr_patch_settle(grids, parent);
}

/* Subtracts the load added by the patches from the load of the base. */
static void restrict_force(ovr_composite *c)
{
    double added = 0;
    for (int k = 1; k <= c->patches; k++)
        added += c->part[k].added;
    c->part[0].level->force = c->force - added;
}

/* -------------------------------------------------------------- correction */

static void correct(ovr_composite *c, ovr_patch *patch, ovr_patch *parent)
{
    const double *new, *old;
    ovr_patch_read(c->grids, parent);
    new = parent->P + patch->level->grid.first;
    old = parent->entry + patch->level->grid.first;
    for (size_t i = patch->from; i <= patch->to; i++) {
        size_t I = i / 2, J = I + i % 2;
        double change = 0.5 * (new[I] - old[I] + new[J] - old[J]);
        if (patch->P[i] > 0)
            patch->P[i] = fmax(0, patch->P[i] + change);
    }
    ovr_patch_edges(patch, parent);
    patch_outer(&c->film, c->grids, patch, parent);
    refresh(c, patch);
}

/* ------------------------------------------------------------------ cycles */

static void relax(ovr_composite *c, ovr_patch *patch, const ovr_cycling *how,
                  int sweeps)
{
    for (int s = 0; s < sweeps; s++) {
        ovr_patch_relax(c->grids, patch, how->smoothing.limit);
        refresh(c, patch);
    }
}

void ovr_composite_cycle(ovr_composite *c, const ovr_cycling *how)
{
    for (int k = c->patches; k > 0; k--) {
        relax(c, &c->part[k], how, how->sweeps_before);
        restrict_to(c, &c->part[k], &c->part[k - 1]);
    }
    restrict_force(c);
    ovr_cycle(c->grids, c->part[0].level, *how);
    for (int k = 1; k <= c->patches; k++) {
        correct(c, &c->part[k], &c->part[k - 1]);
        relax(c, &c->part[k], how, how->sweeps_after);
    }
}

/* Sum of rho_i (reynolds.h) over the leaves of a part. */
static double imbalance(const ovr_composite *c, int k)
{
    const ovr_patch *part = &c->part[k];
    double D = part->level->grid.D, half = 0.5 / (D * D), sum = 0;
    double *r = c->workspace[0];
    ovr_level_read(c->grids, part->level, part->level->f.r, r);
    for (size_t i = part->from; i <= part->to; i++) {
        double outflow = half * ovr_patch_outflow(part, i) * part->P[i];
        if (ovr_composite_leaf(c, k, i))
            sum += r[i] < 0 ? -r[i] : fmin(r[i], outflow);
    }
    return sum;
}

ovr_defect ovr_composite_defect(ovr_composite *c)
{
    const ovr_level *base = c->part[0].level;
    ovr_defect d = {0};
    for (int k = c->patches; k > 0; k--)
        restrict_to(c, &c->part[k], &c->part[k - 1]);
    restrict_force(c);
    ovr_patch_read(c->grids, &c->part[0]);
    for (int k = 0; k <= c->patches; k++)
        d.imbalance += c->part[k].level->grid.D * imbalance(c, k);
    d.centre = ovr_level_centre(base, base->f.H);
    d.imbalance /= fabs(d.centre);
    d.load = fabs(base->force - ovr_level_load(c->grids, base)) / c->force;
    if (c->grids->stopping.now)
        d.imbalance = INFINITY;
    return d;
}
