/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "multigrid/tripoles.h"

#include <math.h>
#include <string.h>

#include "multigrid/field.h"

/* ------------------------------------------------------------ band matrices */

static void banded_take(ovr_banded *A, size_t n, ovr_arena *arena,
                        ovr_error *err)
{
    A->row = ovr_field(arena, n * OVR_BAND_WIDTH, err);
    A->factor = ovr_field(arena, n * OVR_BAND, err);
    A->pivot = ovr_arena_take(arena, n, sizeof *A->pivot, err);
}

/* Address of A_ij. */
static double *at(const ovr_banded *A, size_t i, size_t j)
{
    return A->row + i * OVR_BAND_WIDTH + j + OVR_BAND - i;
}

static size_t minimum(size_t a, size_t b)
{
    return a < b ? a : b;
}

static size_t largest_in(const ovr_banded *A, size_t n, size_t c)
{
    size_t best = c, end = minimum(n, c + OVR_BAND + 1);
    for (size_t i = c + 1; i < end; i++)
        if (fabs(*at(A, i, c)) > fabs(*at(A, best, c)))
            best = i;
    return best;
}

/* Exchanges two rows, from column c on. */
static void exchange(const ovr_banded *A, size_t c, size_t other, size_t count)
{
    double *a = at(A, c, c), *b = at(A, other, c);
    for (size_t j = 0; j < count; j++) {
        double value = a[j];
        a[j] = b[j];
        b[j] = value;
    }
}

/* Factors n rows in place; the diagonal is replaced by its inverse. Returns
 * false if the matrix is singular. */
static bool banded_factor(ovr_banded *A, size_t n)
{
    for (size_t c = 0; c < n; c++) {
        size_t end = minimum(n, c + OVR_BAND + 1);
        size_t count = minimum(n - c, 2 * OVR_BAND + 1);
        size_t best = A->pivot[c] = largest_in(A, n, c);
        if (best != c)
            exchange(A, c, best, count);
        double *top = at(A, c, c), inverse = 1 / top[0];
        if (!(fabs(top[0]) > 0 && isfinite(top[0])))
            return false;
        for (size_t i = c + 1; i < end; i++) {
            double *row = at(A, i, c), factor = row[0] * inverse;
            A->factor[c * OVR_BAND + i - c - 1] = factor;
            for (size_t j = 1; j < count; j++)
                row[j] -= factor * top[j];
        }
        top[0] = inverse;
    }
    return true;
}

static void forward(const ovr_banded *A, size_t n, double *x)
{
    for (size_t c = 0; c < n; c++) {
        const double *factor = A->factor + c * OVR_BAND;
        size_t end = minimum(n, c + OVR_BAND + 1), best = A->pivot[c];
        double value = x[best];
        x[best] = x[c];
        x[c] = value;
        for (size_t i = c + 1; i < end; i++)
            x[i] -= factor[i - c - 1] * value;
    }
}

/* sum_j row_j x_j of the neighbours j = 2.. 2 BAND, in three independent sums.
 */
static double beyond_the_next(const double *row, const double *x)
{
    double a = 0, b = 0, c = 0;
    for (size_t j = 2; j < 2 * OVR_BAND; j += 3) {
        a += row[j] * x[j];
        b += row[j + 1] * x[j + 1];
        c += row[j + 2] * x[j + 2];
    }
    return a + b + c;
}
_Static_assert((2 * OVR_BAND - 1) % 3 == 0, "neighbours in three chains");

/* The neighbour computed last is subtracted last: the dependent chain is then
 * two operations long, and sums of several rows overlap. */
static void backward(const ovr_banded *A, size_t n, double *x)
{
    for (size_t i = n; i-- > 0;) {
        const double *row = at(A, i, i);
        double value = x[i];
        if (i + 2 * OVR_BAND < n)
            value -= beyond_the_next(row, x + i);
        else
            for (size_t j = 2; i + j < n; j++)
                value -= row[j] * x[i + j];
        if (i + 1 < n)
            value -= row[1] * x[i + 1];
        x[i] = value * row[0];
    }
}

/* Solves A x = b in place. */
static void banded_solve(const ovr_banded *A, size_t n, double *x)
{
    forward(A, n, x);
    backward(A, n, x);
}

/* -------------------------------------------------------- coarse correction */

enum { STRIDE = 16, MOST = 128 };

void ovr_deflation_fit(ovr_deflation *d, size_t n)
{
    const size_t intervals = (n - 1) / d->stride;
    d->count = intervals > 2 ? intervals - 1 : 0;
    d->of = NAN;
}

ovr_status ovr_deflation_take(ovr_deflation *d, size_t n, ovr_arena *arena,
                              ovr_error *err)
{
    size_t s = STRIDE;
    while ((n - 1) / s > MOST)
        s *= 2;
    *d = (ovr_deflation){.stride = s};
    ovr_deflation_fit(d, n);
    const size_t count = d->count;
    if (!count)
        return OVR_OK;
    const size_t width = (n - 1) / s + count + 2, m = count + 1;
    d->hat = ovr_field(arena, s * width, err);
    d->columns = ovr_field(arena, n * m, err);
    d->matrix = ovr_field(arena, m * m, err);
    d->value = ovr_field(arena, m, err);
    d->pivot = ovr_arena_take(arena, m, sizeof *d->pivot, err);
    return ovr_arena_status(arena);
}

/* Deformation by a hat function at nodes r + s (far - x) from its middle, r <
 * s. */
static void fill_hats(ovr_deflation *d, size_t n, const double *kernel)
{
    const ptrdiff_t s = (ptrdiff_t)d->stride, most = (ptrdiff_t)n;
    const ptrdiff_t far = (most - 1) / s;
    const ptrdiff_t width = far + (ptrdiff_t)d->count + 2;
    for (ptrdiff_t r = 0; r < s; r++)
        for (ptrdiff_t x = 0; x < width; x++) {
            ptrdiff_t distance = r + s * (far - x);
            double sum = 0;
            for (ptrdiff_t m = 1 - s; m < s; m++) {
                ptrdiff_t at = distance - m;
                at = at > most ? most : at < -most ? -most : at;
                sum += (1 - fabs((double)m) / (double)s) * kernel[at];
            }
            d->hat[r * width + x] = sum;
        }
}

/* Deformation at node j by all hat functions. */
static const double *hats_on(const ovr_deflation *d, size_t n, size_t j)
{
    const size_t s = d->stride, far = (n - 1) / s;
    return d->hat + (j % s) * (far + d->count + 2) + far + 1 - j / s;
}

/* Weight of the hat function after node i; those before and after it have the
 * numbers i/s - 1 and i/s. */
static double weight_after(const ovr_deflation *d, size_t i)
{
    return (double)(i % d->stride) / (double)d->stride;
}

/* Adds a row of A P with its weights to two rows of R A P. */
static void restrict_row(const ovr_deflation *d, const ovr_kernels *run,
                         size_t i, const double *from)
{
    const size_t m = d->count + 1, after = i / d->stride;
    const double share = weight_after(d, i);
    if (after > 0 && after <= d->count) {
        double *to = d->matrix + (after - 1) * m;
        run->combine(m, 1, to, 1 - share, from, to);
    }
    if (after < d->count) {
        double *to = d->matrix + after * m;
        run->combine(m, 1, to, share, from, to);
    }
}

static void make_row(const ovr_deflation *d, const ovr_kernels *run,
                     const ovr_newton_row *row, size_t n, size_t i)
{
    const size_t m = d->count + 1;
    double *to = d->columns + i * m;
    memset(to, 0, m * sizeof *to);
    for (size_t k = i == 1; k < 4 && i + k < n + 2; k++) {
        const size_t j = i + k - 2, after = j / d->stride;
        const double share = weight_after(d, j);
        run->combine(d->count, 1, to, row->e[k], hats_on(d, n, j), to);
        if (after > 0 && after <= d->count)
            to[after - 1] += row->local[k] * (1 - share);
        if (after < d->count)
            to[after] += row->local[k] * share;
        to[d->count] -= row->e[k];
    }
}

static bool factor_coarse(ovr_deflation *d, const ovr_kernels *run)
{
    const size_t m = d->count + 1;
    for (size_t c = 0; c < m; c++) {
        size_t best = c;
        for (size_t i = c + 1; i < m; i++)
            if (fabs(d->matrix[i * m + c]) > fabs(d->matrix[best * m + c]))
                best = i;
        double *top = d->matrix + c * m, *other = d->matrix + best * m;
        for (size_t j = 0; best != c && j < m; j++) {
            double value = top[j];
            top[j] = other[j];
            other[j] = value;
        }
        d->pivot[c] = best;
        if (!(fabs(top[c]) > 0 && isfinite(top[c])))
            return false;
        top[c] = 1 / top[c];
        for (size_t i = c + 1; i < m; i++) {
            double *row = d->matrix + i * m, share = row[c] * top[c];
            row[c] = share;
            run->combine(m - c - 1, 1, row + c + 1, -share, top + c + 1,
                         row + c + 1);
        }
    }
    return true;
}

bool ovr_deflation_factor(ovr_deflation *d, const ovr_kernels *run,
                          const ovr_newton_row *row, size_t n, double D,
                          const double *kernel)
{
    const size_t m = d->count + 1;
    double *force = d->matrix + d->count * m;
    if (!d->count)
        return false;
    if (d->of != kernel[0]) { /* the kernel does not change during a run */
        fill_hats(d, n, kernel);
        d->of = kernel[0];
    }
    memset(d->matrix, 0, m * m * sizeof *d->matrix);
    for (size_t i = 1; i + 1 < n; i++) {
        make_row(d, run, &row[i], n, i);
        restrict_row(d, run, i, d->columns + i * m);
    }
    for (size_t j = 0; j < d->count; j++)
        force[j] = D * (double)d->stride;
    return factor_coarse(d, run);
}

static void solve(const ovr_deflation *d, double *x)
{
    const size_t m = d->count + 1;
    for (size_t c = 0; c < m; c++) {
        double value = x[d->pivot[c]];
        x[d->pivot[c]] = x[c];
        x[c] = value;
    }
    for (size_t i = 1; i < m; i++)
        for (size_t j = 0; j < i; j++)
            x[i] -= d->matrix[i * m + j] * x[j];
    for (size_t i = m; i-- > 0;) {
        for (size_t j = i + 1; j < m; j++)
            x[i] -= d->matrix[i * m + j] * x[j];
        x[i] *= d->matrix[i * m + i];
    }
}

void ovr_deflation_apply(ovr_deflation *d, const ovr_kernels *run, size_t n,
                         double D, const double *v, double *u)
{
    const size_t m = d->count + 1;
    double *x = d->value, sum = 0;
    memset(x, 0, m * sizeof *x);
    for (size_t i = 1; i + 1 < n; i++) {
        const size_t after = i / d->stride;
        const double share = weight_after(d, i);
        if (after > 0 && after <= d->count)
            x[after - 1] += (1 - share) * v[i - 1];
        if (after < d->count)
            x[after] += share * v[i - 1];
    }
    x[d->count] = v[n - 2];
    solve(d, x);
    for (size_t i = 1; i + 1 < n; i++)
        u[i - 1] = v[i - 1] - run->gain(m, d->columns + i * m, x, NULL);
    for (size_t j = 0; j < d->count; j++)
        sum += x[j];
    u[n - 2] = v[n - 2] - D * (double)d->stride * sum;
}

void ovr_deflation_add(const ovr_deflation *d, size_t n, double *step)
{
    for (size_t i = 1; i + 1 < n; i++) {
        const size_t after = i / d->stride;
        const double share = weight_after(d, i);
        if (after > 0 && after <= d->count)
            step[i] += (1 - share) * d->value[after - 1];
        if (after < d->count)
            step[i] += share * d->value[after];
    }
    step[n] += d->value[d->count];
}

/* Size of a vector of the system: rows 1..n-2 and the force. */
static size_t size_of(size_t n)
{
    return n - 1;
}

ovr_tripoles *ovr_tripoles_take(size_t n, ovr_arena *arena, ovr_error *err)
{
    ovr_tripoles *t = ovr_arena_take(arena, 1, sizeof *t, err);
    if (!t)
        return NULL;
    t->row = ovr_arena_take(arena, n, sizeof *t->row, err);
    banded_take(&t->band, n, arena, err);
    t->basis = ovr_field(arena, (OVR_TRIPOLE_PRODUCTS + 1) * n, err);
    t->column = ovr_field(arena, n, err);
    t->q = ovr_field(arena, n, err);
    t->w = ovr_field(arena, n, err);
    t->u = ovr_field(arena, n, err);
    return ovr_deflation_take(&t->smooth, n, arena, err) ? NULL : t;
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

/* Deformation by a tripole at a distance of d mesh sizes. */
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

/* Factors the band of local terms; includes the elastic terms unless `kernel`
 * is NULL. */
static bool factor(ovr_tripoles *t, size_t n, const double *kernel)
{
    enum { REACH = OVR_BAND + 2 };
    double of[2 * REACH + 1];
    for (int d = -REACH; d <= REACH; d++)
        of[d + REACH] = kernel ? pressed(kernel, d) : 0;
    for (size_t i = 1; i + 1 < n; i++)
        fill_row(t, n, i, of + REACH);
    return banded_factor(&t->band, n - 2);
}

/* Sum of dP of tripoles without the factor D; interior tripoles have zero sum.
 */
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
    banded_solve(&t->band, n - 2, t->column);
}

/* Computes dP and dH0 for a right-hand side by the band. */
static void by_band(const ovr_tripoles *t, size_t n, double D, const double *v,
                    double *step)
{
    double *q = t->q, H0;
    memcpy(q, v, (n - 2) * sizeof *q);
    banded_solve(&t->band, n - 2, q);
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

/* Computes dP and dH0 for a right-hand side by coarse correction and band. */
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

/* Multiplies a step by the matrix: changes of all rows. */
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

/* Applies Givens rotations to a column and the right-hand side; the new
 * rotation is computed from the last two elements. */
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

/* Number of products after which little progress means failure. */
enum { TRIAL = 30 };

/* Largest residual, relative to the first one, with which GMRES may go on after
 * the trial, and with which it may end at the maximum number of products. A
 * step of a larger residual misleads Newton's method. The local band finds a
 * better one in 20 to 30 products; if it fails, no better step is known. */
typedef struct usable {
    double trial, end;
} usable;

static usable usable_with(bool elastic)
{
    return elastic ? (usable){0.1, 1e-3} : (usable){INFINITY, 0.5};
}

/* Extends the basis until the residual is 1e-4 of the right-hand side (2 to 5
 * products; with 1e-2 some Newton steps diverge). Returns the number of
 * vectors, or 0 if they are unusable. If rounding or the maximum number of
 * products ends the iteration earlier, the next Newton step reduces the
 * remaining residual. */
static int grow(const ovr_hierarchy *grids, const ovr_level *level,
                ovr_tripoles *t, usable most, double *step, double *g)
{
    const double enough = 1e-4;
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
        if (k + 1 == TRIAL && fabs(g[k + 1]) > most.trial * first)
            return 0;
        scale(next, 1 / length, m);
    }
    return fabs(g[OVR_TRIPOLE_PRODUCTS]) <= most.end * first
               ? OVR_TRIPOLE_PRODUCTS
               : 0;
}

/* Computes the linear combination of basis vectors by solving the triangular
 * system. */
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

/* Solves with one preconditioner; `kernel` is NULL for that of local terms. */
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
    count = grow(grids, level, t, usable_with(kernel), step, g);
    if (!count)
        return false;
    combine(grids->kernels, t, m, count, g);
    precondition(t, grids->kernels, n, level->grid.D, t->basis, step);
    return true;
}

/* Solves with the elastic band, unless it has failed shortly before. */
static bool solve_elastic(ovr_asperity *touch, const ovr_hierarchy *grids,
                          const ovr_level *level, const double *kernel,
                          double missing, double *step)
{
    enum { MAX_DOUBLINGS = 10 };
    if (touch->omitted > 0) {
        touch->omitted--;
        return false;
    }
    if (solve_by(grids, level, kernel, missing, step)) {
        touch->failures = 0;
        return true;
    }
    touch->omitted = 1 << touch->failures;
    if (touch->failures < MAX_DOUBLINGS)
        touch->failures++;
    return false;
}

/* The band with its elastic part needs a tenth of the products, but it is
 * nearly singular far from the solution if asperities carry most of the load.
 */
bool ovr_tripoles_solve(ovr_hierarchy *grids, const ovr_level *level,
                        double missing, double *step)
{
    ovr_tripoles *t = grids->touch.tripoles;
    const double *kernel = grids->touch.kernel + level->grid.n + 2; /* k(0) */
    for (size_t i = 1; i + 1 < level->grid.n; i++)
        proportion(&t->row[i], kernel[0]);
    return solve_elastic(&grids->touch, grids, level, kernel, missing, step) ||
           solve_by(grids, level, NULL, missing, step);
}
