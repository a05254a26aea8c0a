/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Film, lubricant properties and the Reynolds coefficient at all nodes:
 *
 *     H = H0 + gap - w
 *     rho = b/a,  a = A + P,  b = A + 1.34 P              Dowson-Higginson
 *     eta = exp(alphabar P0/z [t^z - 1]),  t = 1 + P/P0   Roelands
 *     eps = rho H^3/(eta lambda)
 *     d eps/dP (H fixed) = eps (rho'/rho - eta'/eta)
 *     rho' = 0.34 A/a^2,  eta'/eta = alphabar t^z/t
 *
 * One logarithm, two exponentials and a single division a node: 1/(a b), 1/t
 * and the logarithm's 1/(m + 1) all come from 1/(a b t (m + 1)).  Barus and
 * isoviscous (alphabar = 0) are the same without Roelands' part,
 * incompressible is a = b = 1.
 *
 * A node is a chain of some 60 dependent operations.  Three short passes over
 * a block keep more nodes in flight than one long one: twice as fast.
 */
#include "multigrid/kernels.h"
#include "multigrid/vector.h"

enum { BLOCK = 128 };

/* What one pass leaves for the next. */
typedef struct block {
    double exponent[BLOCK]; /* of t^z, then of 1/eta */
    double slope[BLOCK];    /* rho'/rho, then less eta'/eta */
    double inv_t[BLOCK];
} block;

/* a = a0 + a1 P, b = a0 + b1 P, slope = a0 (b1 - a1) */
typedef struct density {
    double a0, a1, b1, slope;
} density;

static density density_of(const ovr_lubricant *law)
{
    if (law->density_law == OVR_INCOMPRESSIBLE)
        return (density){1, 0, 0, 0};
    return (density){law->A, 1, 1.34, 0.34 * law->A};
}

/* H, rho, q, q'; eps as if eta were 1/scale */
static inline void store_film(const ovr_fields *f, size_t i, vec H, vec rho,
                              vec inv_a, double slope, double scale)
{
    vec q = rho * H;
    store(f->H + i, H);
    store(f->rho + i, rho);
    store(f->dq + i, slope * inv_a * inv_a * H);
    store(f->q + i, q);
    store(f->eps + i, scale * q * (H * H));
}

/* Roelands, first pass: everything but the exponentials. */
static inline void begin_roelands(const ovr_fluid *fluid, double H0,
                                  size_t start, size_t end, const double *gap,
                                  const double *w, const ovr_fields *f,
                                  block *work)
{
    const ovr_lubricant *law = &fluid->lubricant;
    density c = density_of(law);
    double inv_P0 = 1 / law->P0, inv_lambda = 1 / fluid->lambda;
    for (size_t i = start; i < end; i += VEC) {
        vec P = load(f->P + i), t = 1 + P * inv_P0, k;
        vec a = c.a0 + c.a1 * P, b = c.a0 + c.b1 * P;
        vec m = mantissa(t, &k), m1 = m + 1, ab = a * b, tm = t * m1;
        vec inverse = 1 / (ab * tm), inv_ab = inverse * tm;
        vec rest = inverse * ab, inv_a = b * inv_ab; /* rest: 1/(t (m + 1)) */
        vec log_t = logarithm(k, (m - 1) * (rest * t));
        store_film(f, i, H0 + load(gap + i) - load(w + i), b * inv_a, inv_a,
                   c.slope, inv_lambda);
        store(work->exponent + i - start, smaller(law->z * log_t, all(700)));
        store(work->slope + i - start, c.slope * inv_ab);
        store(work->inv_t + i - start, rest * m1);
    }
}

/* Second pass: t^z. */
static inline void power(const ovr_lubricant *law, size_t count, block *work)
{
    vec stiffness = all(law->alphabar * law->P0 / law->z);
    vec alphabar = all(law->alphabar);
    for (size_t j = 0; j < count; j += VEC) {
        vec tz = exponential(load(work->exponent + j));
        vec eta_slope = alphabar * tz * load(work->inv_t + j);
        store(work->exponent + j, stiffness - stiffness * tz);
        store(work->slope + j, load(work->slope + j) - eta_slope);
    }
}

/* Last pass: the viscosity. */
static inline void finish(size_t start, size_t end, const ovr_fields *f,
                          const block *work)
{
    for (size_t i = start; i < end; i += VEC) {
        vec E = larger(load(work->exponent + i - start), all(-700));
        vec eps = exponential(E) * load(f->eps + i);
        store(f->eps + i, eps);
        store(f->deps + i, eps * load(work->slope + i - start));
    }
}

static inline void begin_barus(const ovr_fluid *fluid, double H0, size_t start,
                               size_t end, const double *gap, const double *w,
                               const ovr_fields *f, block *work)
{
    const ovr_lubricant *law = &fluid->lubricant;
    bool isoviscous = law->viscosity_law == OVR_ISOVISCOUS;
    double alphabar = isoviscous ? 0 : law->alphabar;
    double inv_lambda = 1 / fluid->lambda;
    density c = density_of(law);
    for (size_t i = start; i < end; i += VEC) {
        vec P = load(f->P + i), a = c.a0 + c.a1 * P, b = c.a0 + c.b1 * P;
        vec inv_ab = 1 / (a * b), inv_a = b * inv_ab;
        store_film(f, i, H0 + load(gap + i) - load(w + i), b * inv_a, inv_a,
                   c.slope, inv_lambda);
        store(work->exponent + i - start, -alphabar * P);
        store(work->slope + i - start, c.slope * inv_ab - alphabar);
    }
}

void OVR_KERNEL(film)(const ovr_fluid *fluid, double H0, size_t n,
                      const double *gap, const double *w, const ovr_fields *f)
{
    bool roelands = fluid->lubricant.viscosity_law == OVR_ROELANDS;
    block work;
    for (size_t start = 0; start < n; start += BLOCK) {
        size_t end = n - start < BLOCK ? n : start + BLOCK;
        if (roelands) {
            begin_roelands(fluid, H0, start, end, gap, w, f, &work);
            power(&fluid->lubricant, end - start, &work);
        } else {
            begin_barus(fluid, H0, start, end, gap, w, f, &work);
        }
        finish(start, end, f, &work);
    }
}
