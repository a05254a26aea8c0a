/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "multigrid/composite_film.h"

#include <stdlib.h>
#include <string.h>

/* Lagrange's weights of the midpoint of 2 h nodes, by distance. */
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

void ovr_composite_film_make(ovr_composite_film *film)
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

void ovr_composite_film_parent(const ovr_composite_film *film,
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

/* w beyond the ends of a whole grid, where its patch ends too. */
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

/* Sums of the pairs about all midpoints, times c, to `sum`. */
static void add_pairs(size_t count, double c, const double *from, ptrdiff_t out,
                      double *restrict sum)
{
    const double *left = from - out, *right = from + 1 + out;
    for (size_t I = 0; I < count; I++)
        sum[I] += c * (left[I] + right[I]);
}

void ovr_patch_outer(const ovr_composite_film *film, const ovr_hierarchy *grids,
                     ovr_patch *patch, ovr_patch *parent)
{
    const ovr_grid *grid = &patch->level->grid;
    const double *w = parent->w + grid->first, *P = parent->P + grid->first;
    size_t count = (grid->n - 1) / 2;
    double *middle = patch->q; /* free until it is read again */
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

/* K of values in the order of the nodes, to the same. */
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
    double *added = patch->q; /* free until it is read again */
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

/* Y of node I of a patch, X zero beyond its ends. */
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

/* X, and the load that it is. */
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

void ovr_patch_detail(const ovr_hierarchy *grids,
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
