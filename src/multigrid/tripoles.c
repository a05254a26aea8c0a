/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "multigrid/tripoles.h"

#include <math.h>
#include <string.h>

#include "multigrid/deflation.h"
#include "multigrid/field.h"

/* A vector of the system: the rows 1..n-2, then the force. */
static size_t size_of(size_t n)
{
    return n - 1;
}

ovr_status ovr_tripoles_take(ovr_tripoles *t, size_t n, ovr_arena *arena,
                             ovr_error *err)
{
    t->row = ovr_arena_take(arena, n, sizeof *t->row, err);
    if (!t->row || ovr_banded_take(&t->band, n, arena, err))
        return OVR_NO_MEMORY;
    t->basis = ovr_field(arena, (OVR_TRIPOLE_PRODUCTS + 1) * n, err);
    t->column = t->basis ? ovr_field(arena, n, err) : NULL;
    t->q = t->column ? ovr_field(arena, n, err) : NULL;
    t->w = t->q ? ovr_field(arena, n, err) : NULL;
    t->u = t->w ? ovr_field(arena, n, err) : NULL;
    return t->u ? ovr_deflation_take(&t->smooth, n, arena, err) : OVR_NO_MEMORY;
}

static void proportion(ovr_newton_row *row, double k0)
{
    double maximum = 0;
    for (int m = 0; m < 4; m++)
        maximum = fmax(maximum,
                       fmax(fabs(row->local[m]), fabs(row->e[m] * k0)));
    for (int m = 0; m < 4 && maximum > 0; m++) {
        row->e[m] /= maximum;
        row->local[m] /= maximum;
    }
    if (maximum > 0)
        row->r /= maximum;
}

/* The influence of a tripole, d mesh sizes away. */
static double pressed(const double *kernel, ptrdiff_t d)
{
    return kernel[d] - 0.5 * (kernel[d - 1] + kernel[d + 1]);
}

static void fill_row(const ovr_tripoles *t, size_t n, size_t i,
                     const double *of)
{
    const ovr_newton_row *row = &t->row[i];
    double *to = t->band.row + (i - 1) * OVR_BAND_WIDTH;
    memset(to, 0, OVR_BAND_WIDTH * sizeof *to);
    for (int d = -OVR_BAND; d <= OVR_BAND; d++)
        for (int m = -2; m < 2; m++)
            to[d + OVR_BAND] += row->e[m + 2] * of[d - m];
    for (int m = -2; m < 2; m++) {
        if (i + (size_t)(m + 2) < 3 || i + (size_t)(m + 2) > n)
            continue;
        to[m + OVR_BAND] += row->local[m + 2];
        to[m + OVR_BAND - 1] -= 0.5 * row->local[m + 2];
        to[m + OVR_BAND + 1] -= 0.5 * row->local[m + 2];
    }
}

/* Factors the band of local terms, with the influence of pressures unless
 * `kernel` is NULL. */
static bool factor(ovr_tripoles *t, size_t n, const double *kernel)
{
    enum { REACH = OVR_BAND + 2 };
    double of[2 * REACH + 1];
    for (int d = -REACH; d <= REACH; d++)
        of[d + REACH] = kernel ? pressed(kernel, d) : 0;
    for (size_t i = 1; i + 1 < n; i++)
        fill_row(t, n, i, of + REACH);
    return ovr_banded_factor(&t->band, n - 2);
}

/* Sum of dP of tripoles, without the factor D; their sum vanishes inside. */
static double sum_of(const double *q, size_t n)
{
    return 0.5 * (q[0] + q[n - 3]);
}

static void border(ovr_tripoles *t, size_t n)
{
    for (size_t i = 1; i + 1 < n; i++) {
        const double *e = t->row[i].e;
        t->column[i - 1] = -(e[0] + e[1] + e[2] + e[3]);
    }
    ovr_banded_solve(&t->band, n - 2, t->column);
}

/* dP and dH0 of a right-hand side, by the band. */
static void by_band(const ovr_tripoles *t, size_t n, double D, const double *v,
                    double *step)
{
    double *q = t->q, H0;
    memcpy(q, v, (n - 2) * sizeof *q);
    ovr_banded_solve(&t->band, n - 2, q);
    H0 = (sum_of(q, n) - v[n - 2] / D) / sum_of(t->column, n);
    for (size_t j = 0; j < n - 2; j++)
        q[j] -= H0 * t->column[j];
    step[0] = step[n - 1] = 0;
    for (size_t j = 0; j < n - 2; j++) {
        double before = j ? q[j - 1] : 0, after = j + 3 < n ? q[j + 1] : 0;
        step[j + 1] = q[j] - 0.5 * (before + after);
    }
    step[n] = H0;
}

/* dP and dH0 of a right-hand side, by the coarse correction and the band. */
static void precondition(ovr_tripoles *t, const ovr_kernels *run, size_t n,
                         double D, const double *v, double *step)
{
    if (!t->deflated) {
        by_band(t, n, D, v, step);
        return;
    }
    ovr_deflation_apply(&t->smooth, run, n, D, v, t->u);
    by_band(t, n, D, t->u, step);
    ovr_deflation_add(&t->smooth, n, step);
}

/* Multiplies a step by the matrix: the change of all rows. */
static void multiply(const ovr_hierarchy *grids, const ovr_level *level,
                     const ovr_tripoles *t, const double *step, double *v)
{
    size_t n = level->grid.n;
    double *w = t->w, sum = 0;
    ovr_level_write(grids, level, step, level->pressed);
    ovr_level_deform(grids, level, level->pressed, level->f.w);
    ovr_level_read(grids, level, level->f.w, w);
    for (size_t i = 1; i + 1 < n; i++) {
        const ovr_newton_row *row = &t->row[i];
        double value = 0;
        for (size_t m = i == 1; m < 4 && i + m < n + 2; m++) {
            size_t j = i + m - 2;
            value += row->e[m] * (w[j] - step[n]) + row->local[m] * step[j];
        }
        v[i - 1] = value;
        sum += step[i];
    }
    v[n - 2] = level->grid.D * sum;
}

static double product(const ovr_kernels *run, const double *a, const double *b,
                      size_t n)
{
    return run->gain(n, a, b, NULL);
}

/* a += share b */
static void add(const ovr_kernels *run, double *a, double share,
                const double *b, size_t n)
{
    run->combine(n, 1, a, share, b, a);
}

static void scale(double *a, double by, size_t n)
{
    for (size_t i = 0; i < n; i++)
        a[i] *= by;
}

/* Givens' rotations of a column, the new one made of its last two; the
 * right-hand side follows. */
static void rotate(double *column, int k, double *cosine, double *sine,
                   double *g)
{
    double a, b, length;
    for (int j = 0; j < k; j++) {
        a = column[j];
        b = column[j + 1];
        column[j] = cosine[j] * a + sine[j] * b;
        column[j + 1] = cosine[j] * b - sine[j] * a;
    }
    length = hypot(column[k], column[k + 1]);
    cosine[k] = length > 0 ? column[k] / length : 1;
    sine[k] = length > 0 ? column[k + 1] / length : 0;
    column[k] = length;
    g[k + 1] = -sine[k] * g[k];
    g[k] *= cosine[k];
}

/* Extends the basis until the remainder is 1e-4 of the right-hand side (2 to 5
 * products; with 1e-2 some steps of Newton's method diverge).  Returns the
 * number of vectors, 0 if they are of no use.  Where rounding or the number of
 * products ends it before, Newton's next step has the remainder. */
static int grow(const ovr_hierarchy *grids, const ovr_level *level,
                ovr_tripoles *t, double *step, double *g)
{
    const double enough = 1e-4, some = 0.5;
    const ovr_kernels *run = grids->kernels;
    double cosine[OVR_TRIPOLE_PRODUCTS], sine[OVR_TRIPOLE_PRODUCTS];
    size_t n = level->grid.n, m = size_of(n);
    double first = fabs(g[0]);
    for (int k = 0; k < OVR_TRIPOLE_PRODUCTS; k++) {
        double *v = t->basis + (size_t)k * m, *next = v + m;
        double *column = t->triangle[k], length;
        precondition(t, run, n, level->grid.D, v, step);
        multiply(grids, level, t, step, next);
        for (int j = 0; j <= k; j++) {
            const double *other = t->basis + (size_t)j * m;
            column[j] = product(run, next, other, m);
            add(run, next, -column[j], other, m);
        }
        column[k + 1] = length = sqrt(product(run, next, next, m));
        if (!isfinite(length))
            return 0;
        rotate(column, k, cosine, sine, g);
        if (fabs(g[k + 1]) <= enough * first)
            return k + 1;
        scale(next, 1 / length, m);
    }
    return fabs(g[OVR_TRIPOLE_PRODUCTS]) <= some * first ? OVR_TRIPOLE_PRODUCTS
                                                         : 0;
}

/* The sum of basis vectors that the triangle says. */
static void combine(const ovr_kernels *run, ovr_tripoles *t, size_t m,
                    int count, double *g)
{
    for (int k = count; k-- > 0;) {
        for (int j = k + 1; j < count; j++)
            g[k] -= t->triangle[j][k] * g[j];
        g[k] /= t->triangle[k][k];
    }
    scale(t->basis, g[0], m);
    for (int k = 1; k < count; k++)
        add(run, t->basis, g[k], t->basis + (size_t)k * m, m);
}

/* Solves by one preconditioner; `kernel` is NULL for that of local terms. */
static bool solve_by(const ovr_hierarchy *grids, const ovr_level *level,
                     const double *kernel, double missing, double *step)
{
    ovr_tripoles *t = grids->touch.tripoles;
    size_t n = level->grid.n, m = size_of(n);
    double g[OVR_TRIPOLE_PRODUCTS + 1], *v = t->basis;
    int count;
    for (size_t i = 1; i + 1 < n; i++)
        v[i - 1] = t->row[i].r;
    v[n - 2] = missing;
    if (!factor(t, n, kernel))
        return false;
    border(t, n);
    t->deflated = kernel &&
                  ovr_deflation_factor(&t->smooth, grids->kernels, t->row, n,
                                       level->grid.D, kernel);
    g[0] = sqrt(product(grids->kernels, v, v, m));
    if (!isfinite(g[0]))
        return false;
    if (g[0] == 0) {
        memset(step, 0, (n + 1) * sizeof *step);
        return true;
    }
    scale(v, 1 / g[0], m);
    count = grow(grids, level, t, step, g);
    if (!count)
        return false;
    combine(grids->kernels, t, m, count, g);
    precondition(t, grids->kernels, n, level->grid.D, t->basis, step);
    return true;
}

/* The elastic band, unless it has failed shortly before. */
static bool solve_elastic(ovr_touch *touch, const ovr_hierarchy *grids,
                          const ovr_level *level, double missing, double *step)
{
    enum { MAX_DOUBLINGS = 10 };
    if (touch->omitted > 0) {
        touch->omitted--;
        return false;
    }
    if (solve_by(grids, level, touch->kernel + level->grid.n + 2, missing,
                 step)) {
        touch->failures = 0;
        return true;
    }
    touch->omitted = 1 << touch->failures;
    if (touch->failures < MAX_DOUBLINGS)
        touch->failures++;
    return false;
}

/* The band with its elastic part takes a tenth of the products, but is nearly
 * singular in contacts that asperities carry, far from the solution. */
bool ovr_tripoles_solve(ovr_hierarchy *grids, const ovr_level *level,
                        double missing, double *step)
{
    ovr_tripoles *t = grids->touch.tripoles;
    const double *kernel = grids->touch.kernel + level->grid.n + 2; /* k(0) */
    for (size_t i = 1; i + 1 < level->grid.n; i++)
        proportion(&t->row[i], kernel[0]);
    return solve_elastic(&grids->touch, grids, level, missing, step) ||
           solve_by(grids, level, NULL, missing, step);
}
