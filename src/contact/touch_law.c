/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "contact/touch_law.h"

#include <math.h>

/* Limit of ln(A/p_h): no film with a larger pressure occurs, except in initial
 * guesses. */
static const double HIGHEST = 25;

/* exp(-60) = 1e-26 p_h is negligible; for most nodes the evaluation can be
 * skipped. */
static const double LOWEST = -60;

static double exponential_at(const ovr_asperity_law *law, double H,
                             double *slope)
{
    double power = -H / law->decay;
    double A = power < LOWEST ? 0 : law->amplitude * exp(fmin(power, HIGHEST));
    *slope = A / law->decay;
    return A;
}

/* Below a thousandth of its decay length, the layer's pressure continues as its
 * tangent, so that negative gaps during the iteration are opened. */
static double layer_at(const ovr_asperity_law *law, double H, double *slope)
{
    const double minimum = 1e-3;
    double d = law->layer_decay, x = fmax(H / d, minimum);
    if (law->layer / d - x < LOWEST)
        return *slope = 0;
    double rest = expm1(fmin(x, 500));
    double A = expm1(law->layer / d) / rest;
    *slope = A * (1 + 1 / rest) / d;
    return A + *slope * fmax(minimum * d - H, 0);
}

/* ------------------------------------------------------------------- tables
 */

/* Index of the point at or before H; the last but one beyond the end. */
static size_t before(const ovr_asperity_table *t, double H)
{
    size_t low = 0, high = t->n - 1;
    while (high - low > 1) {
        size_t middle = (low + high) / 2;
        if (t->H[middle] <= H)
            low = middle;
        else
            high = middle;
    }
    return low;
}

/* ln A and its slope. */
static double ln_at(const ovr_asperity_table *t, double H, double *slope)
{
    size_t last = t->n - 1, i;
    double h, v, rise, a, b;
    if (H <= t->H[0] || H >= t->H[last]) {
        i = H <= t->H[0] ? 0 : last;
        *slope = t->slope[i];
        return t->ln_A[i] + t->slope[i] * (H - t->H[i]);
    }
    i = before(t, H);
    h = t->H[i + 1] - t->H[i];
    v = (H - t->H[i]) / h;
    rise = t->ln_A[i + 1] - t->ln_A[i];
    a = t->slope[i] * h - rise;
    b = rise - t->slope[i + 1] * h;
    *slope = (rise + (1 - 2 * v) * (a * (1 - v) + b * v) +
              v * (1 - v) * (b - a)) /
             h;
    return t->ln_A[i] + v * rise + v * (1 - v) * (a * (1 - v) + b * v);
}

static double table_at(const ovr_asperity_table *t, double H, double *slope)
{
    double by, ln_A = ln_at(t, H, &by);
    double A = ln_A < LOWEST ? 0 : exp(fmin(ln_A, HIGHEST));
    *slope = -by * A;
    return A;
}

/* The contact area fraction is interpolated as its quotient with A. */
static double table_area(const ovr_asperity_table *t, double H)
{
    size_t i = before(t, H);
    double slope, v = (H - t->H[i]) / (t->H[i + 1] - t->H[i]);
    double left = t->area[i] / exp(t->ln_A[i]);
    double right = t->area[i + 1] / exp(t->ln_A[i + 1]);
    v = fmin(fmax(v, 0), 1);
    return fmin(1, ((1 - v) * left + v * right) * table_at(t, H, &slope));
}

ovr_status ovr_asperity_table_take(ovr_asperity_table *table, size_t n,
                                   ovr_arena *arena, ovr_error *err)
{
    double **const all[] = {&table->H, &table->ln_A, &table->slope,
                            &table->area};
    for (size_t k = 0; k < sizeof all / sizeof *all; k++)
        if (!(*all[k] = ovr_arena_take(arena, n, sizeof **all[k], err)))
            return OVR_NO_MEMORY;
    table->n = n;
    return OVR_OK;
}

void ovr_asperity_table_slopes(ovr_asperity_table *t)
{
    size_t last = t->n - 1;
    double *s = t->slope;
    for (size_t i = 0; i <= last; i++) {
        size_t l = i ? i - 1 : 0, r = i < last ? i : last - 1;
        double hl = t->H[l + 1] - t->H[l], hr = t->H[r + 1] - t->H[r];
        double left = (t->ln_A[l + 1] - t->ln_A[l]) / hl;
        double right = (t->ln_A[r + 1] - t->ln_A[r]) / hr;
        double w = (hl + 2 * hr) / (3 * (hl + hr));
        s[i] = left * right > 0 ? left * right / (w * right + (1 - w) * left)
                                : 0;
    }
}

/* ---------------------------------------------------------- Greenwood & Tripp
 */

static double normal_density(double x)
{
    return exp(-x * x / 2) / sqrt(2 * acos(-1.0));
}

static double F(double m, double u)
{
    const double step = 0.02, far = 5; /* y^2 = 25 standard deviations */
    double sum = 0;
    for (double y = step; y < far; y += step)
        sum += 2 * pow(y, 2 * m + 1) * normal_density(u + y * y);
    return sum * step;
}

ovr_status ovr_asperity_greenwood_tripp(ovr_asperity_table *t, double sigma,
                                        double density, double sharpness,
                                        double modulus, ovr_arena *arena,
                                        ovr_error *err)
{
    enum { POINTS = 181 };
    const double from = -3, step = 0.05, pi = acos(-1.0);
    double squared = density * density;
    double scale = 16 * sqrt(2) * pi / 15 * squared * sqrt(sharpness) * modulus;
    ovr_status status = ovr_asperity_table_take(t, POINTS, arena, err);
    for (size_t i = 0; !status && i < POINTS; i++) {
        double u = from + step * (double)i, value = F(2.5, u);
        t->H[i] = sigma * u;
        t->ln_A[i] = log(scale * value);
        t->slope[i] = -2.5 * F(1.5, u) / value / sigma;
        t->area[i] = fmin(1, pi * pi * squared * F(2, u));
    }
    return status;
}

/* ------------------------------------------------------------ complete law */

void ovr_asperity_law_at(const void *law, double H, double *A, double *slope)
{
    const ovr_asperity_law *l = law;
    double steep = 0;
    *A = *slope = 0;
    if (l->amplitude > 0)
        *A = exponential_at(l, H, slope);
    if (l->table.n)
        *A = table_at(&l->table, H, slope);
    if (l->layer > 0) {
        *A += layer_at(l, H, &steep);
        *slope += steep;
    }
}

double ovr_asperity_law_area(const ovr_asperity_law *law, double H)
{
    double slope;
    if (law->amplitude > 0)
        return fmin(1, 0.95 * exponential_at(law, H, &slope) / law->amplitude);
    if (law->table.n)
        return table_area(&law->table, H);
    return law->layer > 0 ? fmin(1, layer_at(law, H, &slope)) : 0;
}
