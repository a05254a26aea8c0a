/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Transfer between a grid and the next coarser one, halved along X and across.
 *
 *     P_c   full weighting (1 2 1)/4 both ways where all nine nodes have P > 0,
 *           injection elsewhere
 *     r_c   full weighting of the residual of pressurized nodes
 *     gap_c = H_f + w_c(P_c) - H0, so that P_c yields the fine film
 *     F_c   = N_c(P_c) + r_c
 *     P_f  += bilinear (P_c - entry_c) where P_f > 0; at least 0.2 P_f is kept
 *
 * A coarse grid cannot decide whether a pocket of few nodes is cavitated.  A
 * correction that sets P to 0 there is reversed by the next relaxation, and R
 * stalls.
 */
#include "multigrid/vector.h"
#include "strip/kernels.h"
#include "strip/vectors.h"

void OVR_STRIP_KERNEL(sum)(const ovr_strip_grid *g, ovr_part rows,
                           const double *x, double *sums)
{
    for (size_t i = rows.from; i < rows.to; i++) {
        vec sum = all(0);
        for (size_t j = 0; j < g->lines; j += VEC)
            sum += choose(lines_before(j, g->lines),
                          load(x + ovr_strip_row(g, i) + j), all(0));
        sums[i] = sum_of_lanes(sum);
    }
}

/* Column sums of three rows with the weights 1 2 1. */
static inline vec weighted(const double *x, size_t s)
{
    return load(x - s) + 2 * load(x) + load(x + s);
}

/* Residual where P > 0, zero elsewhere. */
static inline vec wet_residual(const ovr_strip_fields *f, size_t k)
{
    return choose(load(f->P + k) > 0, load(f->r + k), all(0));
}

static inline vec least(const double *x, size_t s)
{
    return smaller(load(x - s), smaller(load(x), load(x + s)));
}

static inline void restrict_vector(const ovr_strip_fields *f, size_t s,
                                   size_t k, double H0,
                                   const ovr_strip_fields *to, size_t K)
{
    /* `even`: fine nodes on coarse ones, between `before` and `after`. */
    const double *P = f->P + k, *H = f->H + k;
    vec even = evens(weighted(P, s), weighted(P + VEC, s));
    vec after = odds(weighted(P, s), weighted(P + VEC, s));
    vec before = evens(weighted(P - 1, s), weighted(P + VEC - 1, s));
    vec P_c = (1. / 16) * (before + 2 * even + after);
    vec low = smaller(evens(least(P, s), least(P + VEC, s)),
                      smaller(odds(least(P, s), least(P + VEC, s)),
                              evens(least(P - 1, s), least(P + VEC - 1, s))));
    P_c = choose(low > 0, P_c, evens(load(P), load(P + VEC)));
    vec r[3];
    for (int part = 0; part < 3; part++) {
        size_t at_part = part == 2 ? k - 1 : k;
        vec a = wet_residual(f, at_part - s) + 2 * wet_residual(f, at_part) +
                wet_residual(f, at_part + s);
        at_part += VEC;
        vec b = wet_residual(f, at_part - s) + 2 * wet_residual(f, at_part) +
                wet_residual(f, at_part + s);
        r[part] = part == 1 ? odds(a, b) : evens(a, b);
    }
    store(to->P + K, P_c);
    store(to->entry + K, P_c);
    store(to->spread + K, (1. / 16) * (r[2] + 2 * r[0] + r[1]));
    store(to->gap + K, evens(load(H), load(H + VEC)) - H0);
}

/* Computes P, entry, the restricted residual (in spread) and H - H0 (in gap).
 * The halos of P, H and r of the fine grid must be up to date. */
void OVR_STRIP_KERNEL(restrict_fields)(const ovr_strip_grid *coarse,
                                       ovr_part rows,
                                       const ovr_strip_grid *fine,
                                       const ovr_strip_fields *own, double H0,
                                       const ovr_strip_fields *into)
{
    const ovr_strip_fields f = *own, to = *into;
    for (size_t i = rows.from; i < rows.to; i++)
        for (size_t j = 0; j < coarse->lines; j += VEC) {
            size_t k = ovr_strip_row(fine, 2 * i) + 2 * j;
            size_t K = ovr_strip_row(coarse, i) + j;
            if (i && i + 1 < coarse->n) {
                restrict_vector(&f, fine->stride, k, H0, &to, K);
                continue;
            }
            const double *H = f.H + k;
            store(to.P + K, all(0));
            store(to.entry + K, all(0));
            store(to.spread + K, all(0));
            store(to.gap + K, evens(load(H), load(H + VEC)) - H0);
        }
}

void OVR_STRIP_KERNEL(coarse_gap)(const ovr_strip_grid *g, ovr_part rows,
                                  const double *w, double *gap)
{
    for (size_t i = rows.from; i < rows.to; i++)
        for (size_t j = 0; j < g->lines; j += VEC) {
            size_t k = ovr_strip_row(g, i) + j;
            store(gap + k, load(gap + k) + load(w + k));
        }
}

void OVR_STRIP_KERNEL(coarse_side)(const ovr_strip_grid *g, ovr_part rows,
                                   const double *residual,
                                   const double *minus_N, double *F)
{
    rows = between_ends(g, rows);
    for (size_t i = rows.from; i < rows.to; i++)
        for (size_t j = 0; j < g->lines; j += VEC) {
            size_t k = ovr_strip_row(g, i) + j;
            store(F + k, load(residual + k) - load(minus_N + k));
        }
}

static inline void add_to_wet(double factor, vec change, double *P)
{
    const double kept = 0.2;
    vec p = load(P), v = larger(kept * p, fused(all(factor), change, p));
    store(P, choose(p > 0, v, p));
}

/* Changes of coarse P at line j and the next, of a row or the mean of two rows.
 */
static inline vec change_at(const ovr_strip_fields *c, size_t K, size_t next)
{
    vec here = load(c->P + K) - load(c->entry + K);
    if (!next)
        return here;
    return 0.5 * (here + load(c->P + K + next) - load(c->entry + K + next));
}

/* The halos of P and entry of the coarse grid must be up to date. */
void OVR_STRIP_KERNEL(correct)(const ovr_strip_grid *coarse,
                               const ovr_strip_grid *fine, ovr_part rows,
                               double factor, const ovr_strip_fields *from,
                               double *P)
{
    const ovr_strip_fields c = *from;
    rows = between_ends(fine, rows);
    for (size_t i = rows.from; i < rows.to; i++) {
        size_t next = i & 1 ? coarse->stride : 0;
        for (size_t j = 0; 2 * j < fine->lines; j += VEC) {
            size_t K = ovr_strip_row(coarse, i / 2) + j;
            vec here = change_at(&c, K, next);
            vec between = 0.5 * (here + change_at(&c, K + 1, next));
            double *p = P + ovr_strip_row(fine, i) + 2 * j;
            add_to_wet(factor, woven_first(here, between), p);
            if (2 * j + VEC < fine->lines)
                add_to_wet(factor, woven_second(here, between), p + VEC);
        }
    }
}

void OVR_STRIP_KERNEL(blend)(size_t n, size_t count, const double *c,
                             const double *const *from, double *to)
{
    for (size_t j = 0; j < n; j += VEC) {
        vec sum = all(0);
        for (size_t m = 0; m < count; m++)
            sum = fused(all(c[m]), load(from[m] + j), sum);
        store(to + j, sum);
    }
}

void OVR_STRIP_KERNEL(hold)(size_t n, const double *P_0, double *P)
{
    for (size_t j = 0; j < n; j += VEC)
        store(P + j,
              choose(load(P_0 + j) > 0, larger(all(0), load(P + j)), all(0)));
}

void OVR_STRIP_KERNEL(distance)(const ovr_strip_grid *g, ovr_part rows,
                                const double *a, const double *b, double *sums)
{
    for (size_t i = rows.from; i < rows.to; i++) {
        vec sum = all(0);
        for (size_t j = 0; j < g->lines; j += VEC) {
            size_t k = ovr_strip_row(g, i) + j;
            vec d = load(a + k) - load(b + k);
            sum += choose(lines_before(j, g->lines), larger(d, -d), all(0));
        }
        sums[i] = sum_of_lanes(sum);
    }
}

/* Multiplies the complex numbers of rows i and length - i by row i of the
 * table. */
void OVR_STRIP_KERNEL(multiply_modes)(size_t n, size_t length, size_t modes,
                                      ovr_part columns, const double *table,
                                      double *spectrum)
{
    for (size_t i = 0; i < length; i++) {
        const double *t = table + (i < n ? i : length - i) * modes;
        double *x = spectrum + 2 * i * modes;
        size_t m = columns.from;
        for (; m + VEC <= columns.to; m += VEC) {
            vec v = load(t + m);
            double *z = x + 2 * m;
            store(z, load(z) * woven_first(v, v));
            store(z + VEC, load(z + VEC) * woven_second(v, v));
        }
        for (; m < columns.to; m++) {
            x[2 * m] *= t[m];
            x[2 * m + 1] *= t[m];
        }
    }
}
