/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Levelling of profiles, and the Gaussian filter.
 *
 * Gaussian filter (ISO 16610-21). The weight at distance d is
 *
 *     s(d) = exp(-pi (d/(alpha lambda))^2),  alpha = sqrt(ln 2/pi).
 *
 * A wave is multiplied by 2^(-(lambda/wavelength)^2), which is one half at the
 * cut-off lambda. The weight is set to zero beyond d = lambda, where it is
 * 7e-7. A straight line is fitted with these weights, and its value at the
 * point is the result (regression of first order, ISO 16610-28). In a symmetric
 * window this equals the plain filter. Near the ends, where the window is
 * one-sided, straight lines are still reproduced exactly. Cost O(n
 * lambda/spacing).
 *
 * Levelling: polynomials p_k that are orthogonal on the points are computed by
 * the three-term recurrence (Forsythe 1957),
 *
 *     p_(k+1) = (t - a_k) p_k - b_k p_(k-1),  t in [-1, 1].
 *
 * The component of the profile along each p_k is subtracted.
 */
#include "surface/conditioning.h"

#include <math.h>

static const double DECAY = 14.238829324987503738; /* pi/alpha^2 */

double ovr_share(size_t n, const double *x, size_t i)
{
    double from = i ? x[i - 1] : x[0], to = i + 1 < n ? x[i + 1] : x[n - 1];
    return (to - from) / 2;
}

/* ------------------------------------------------------------- levelling */

typedef struct basis {
    size_t n;
    double *p, *older, *t;
} basis;

/* Returns <f p, p> with f = 1 or t, or <z, p>. */
static double product(const basis *b, const double *x, const double *f,
                      const double *g)
{
    double sum = 0;
    for (size_t i = 0; i < b->n; i++)
        sum += ovr_share(b->n, x, i) * f[i] * g[i];
    return sum;
}

/* Computes the orthogonal polynomial of degree k + 1 from that of degree k. */
static void raise(basis *b, const double *x, double norm, double norm_older)
{
    double a = 0, c = norm_older > 0 ? norm / norm_older : 0;
    double *next = b->older;
    for (size_t i = 0; i < b->n; i++)
        a += ovr_share(b->n, x, i) * b->t[i] * b->p[i] * b->p[i];
    a /= norm;
    for (size_t i = 0; i < b->n; i++)
        next[i] = (b->t[i] - a) * b->p[i] - c * b->older[i];
    b->older = b->p;
    b->p = next;
}

void ovr_level(size_t n, const double *x, double *z, int degree, double *work)
{
    basis b = {n, work, work + n, work + 2 * n};
    double norm_older = 0;
    for (size_t i = 0; i < n; i++) {
        b.p[i] = 1;
        b.older[i] = 0;
        b.t[i] = 2 * (x[i] - x[0]) / (x[n - 1] - x[0]) - 1;
    }
    for (int k = 0; k <= degree && (size_t)k < n; k++) {
        double norm = product(&b, x, b.p, b.p);
        if (!(norm > 0))
            return;
        double c = product(&b, x, z, b.p) / norm;
        for (size_t i = 0; i < n; i++)
            z[i] -= c * b.p[i];
        raise(&b, x, norm, norm_older);
        norm_older = norm;
    }
}

static void centroid(const double *x, const double *z, size_t m, double *at,
                     double *height)
{
    *at = *height = 0;
    for (size_t i = 0; i < m; i++) {
        *at += x[i] / (double)m;
        *height += z[i] / (double)m;
    }
}

void ovr_level_ends(size_t n, const double *x, double *z)
{
    size_t m = n / 10 ? n / 10 : 1;
    double x0, z0, x1, z1;
    centroid(x, z, m, &x0, &z0);
    centroid(x + n - m, z + n - m, m, &x1, &z1);
    for (size_t i = 0; i < n; i++)
        z[i] -= z0 + (z1 - z0) * (x[i] - x0) / (x1 - x0);
}

/* ------------------------------------------------------- Gaussian filter */

/* Sums for the weighted line fit about one point. */
typedef struct moments {
    double s0, s1, s2, t0, t1;
} moments;

static double fitted(const moments *m)
{
    double det = m->s0 * m->s2 - m->s1 * m->s1;
    if (det > 1e-12 * m->s0 * m->s2)
        return (m->s2 * m->t0 - m->s1 * m->t1) / det;
    return m->t0 / m->s0;
}

static double weight(double d)
{
    return exp(-DECAY * d * d);
}

void ovr_gaussian(const ovr_points *of, double lambda, bool uniform,
                  double *mean, double *work)
{
    const double *x = of->x, *z = of->y;
    size_t n = of->n, first = 0, last = 0;
    double *share = work, *kernel = work + n;
    for (size_t i = 0; i < n; i++) {
        share[i] = ovr_share(n, x, i);
        kernel[i] = uniform ? weight((x[i] - x[0]) / lambda) : 0;
    }
    for (size_t i = 0; i < n; i++) {
        moments m = {0};
        while (x[i] - x[first] > lambda)
            first++;
        while (last < n && x[last] - x[i] <= lambda)
            last++;
        for (size_t j = first; j < last; j++) {
            double d = (x[j] - x[i]) / lambda;
            double w = uniform ? kernel[j > i ? j - i : i - j] : weight(d);
            w *= share[j];
            m.s0 += w;
            m.s1 += w * d;
            m.s2 += w * d * d;
            m.t0 += w * z[j];
            m.t1 += w * d * z[j];
        }
        mean[i] = fitted(&m);
    }
}
