/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Distributive line relaxation: assembly and use of the pentadiagonal
 * system (equations in line.h; solution in band.kernel.c).
 */
#include <stdlib.h>

#include "multigrid/kernels.h"
#include "multigrid/vector.h"

/* Each column j of the system changes P_{j-1}, P_j, P_{j+1} by (minus, 1,
 * plus) delta_j.  Node 1 is a monopole, and when steady so is a dry node that
 * wants to rise (a dry one that does not has delta = 0 anyway). */
static void set_shares(size_t n, double minus, double plus, bool transient,
                       const double *P, const ovr_band *band)
{
    for (size_t i = 0; i < n; i += VEC) {
        ivec wet = transient ? ~(ivec){0} : load(P + i) > 0;
        store(band->minus + i, choose(wet, all(minus), all(0)));
        store(band->plus + i, choose(wet, all(plus), all(0)));
    }
    band->minus[0] = band->minus[1] = band->minus[n - 1] = 0;
    band->plus[0] = band->plus[1] = band->plus[n - 1] = 0;
}

/* Coefficients of the wedge in a block of rows. */
typedef struct wedge {
    vec a0, a1, a2;
} wedge;

static inline wedge block_wedge(const ovr_weights *w, size_t i)
{
    wedge c = {all(w->a0), all(w->a1), all(w->a2)};
    if (i == 0) { /* row 1 is of first order */
        c.a0[1] = w->a0_first;
        c.a1[1] = w->a1_first;
        c.a2[1] = 0;
    }
    return c;
}

/* e_0 k_|d| + e_1 k_|d+1| + e_2 k_|d+2| */
static inline vec elastic(const vec e[3], const double k[6], int d)
{
    return fused(e[0], all(k[abs(d)]),
                 fused(e[1], all(k[abs(d + 1)]), e[2] * k[abs(d + 2)]));
}

/* A[d + 3] = dN_i/dP_{i+d}, d = -3..3: elastic band and local part, without
 * d eps/dH */
static inline void derivatives(const ovr_fields *f, double half, const wedge *c,
                               const double k[6], size_t i, vec A[7])
{
    vec P0 = load(f->P + i), up = load(f->P + i - 1) - P0,
        down = load(f->P + i + 1) - P0;
    vec e0 = load(f->eps + i), em = load(f->eps + i - 1) + e0,
        ep = load(f->eps + i + 1) + e0, h = all(half);
    vec e[3] = {c->a0 * load(f->rho + i), c->a1 * load(f->rho + i - 1),
                c->a2 * load(f->rho + i - 2)};
    for (int d = -3; d <= 3; d++)
        A[d + 3] = elastic(e, k, d);
    A[1] = less(A[1], c->a2, load(f->dq + i - 2));
    A[2] = less(fused(h, fused(load(f->deps + i - 1), up, em), A[2]), c->a1,
                load(f->dq + i - 1));
    A[3] = less(less(A[3], h, less(em + ep, load(f->deps + i), up + down)),
                c->a0, load(f->dq + i));
    A[4] = fused(h, fused(load(f->deps + i + 1), down, ep), A[4]);
}

/* The shares of the columns about a block of rows; inside the grid all the
 * same when in time. */
static inline void load_shares(const ovr_band *band, size_t i, bool uniform,
                               vec minus[5], vec plus[5])
{
    for (size_t d = 0; d < 5; d++) {
        minus[d] = load(band->minus + i + (uniform ? 0 : d - 2));
        plus[d] = load(band->plus + i + (uniform ? 0 : d - 2));
    }
}

/* Dry rows hold P_i: exactly in time, delta_i = 0 when steady. */
static inline void hold_dry(vec b[5], ivec dry, bool transient, vec minus,
                            vec plus)
{
    vec held[5] = {all(0), transient ? plus : all(0), all(1),
                   transient ? minus : all(0), all(0)};
    for (size_t d = 0; d < 5; d++)
        b[d] = choose(dry, held[d], b[d]);
}

/* b_d = A_d + minus_{i+d} A_{d-1} + plus_{i+d} A_{d+1} and the right-hand
 * side */
static inline void assemble_block(const ovr_fields *f, const vec A[7],
                                  bool transient, bool uniform, size_t i,
                                  const ovr_band *band)
{
    vec r = load(f->r + i), P = load(f->P + i), moves = all(1);
    vec minus[5], plus[5], b[5];
    ivec dry = (P <= 0) & (r >= OVR_DRY_TOLERANCE * A[3]);
    load_shares(band, i, uniform, minus, plus);
    for (size_t d = 0; d < 5; d++)
        b[d] = fused(minus[d], A[d], fused(plus[d], A[d + 2], A[d + 1]));
    if (any(dry)) {
        hold_dry(b, dry, transient, minus[3], plus[1]);
        r = choose(dry, -P, r);
        if (transient)
            moves = choose(dry, all(0), moves);
    }
    for (size_t d = 0; d < 5; d++)
        store(band->b[d] + i, b[d]);
    store(band->delta + i, r);
    store(band->moves + i, moves);
}

static inline void assemble_rows(const ovr_fields *f, const ovr_weights *w,
                                 const double k[6], bool transient,
                                 bool uniform, size_t from, size_t to,
                                 const ovr_band *band)
{
    for (size_t i = from; i < to; i += VEC) {
        vec A[7];
        wedge c = block_wedge(w, i);
        derivatives(f, w->half, &c, k, i, A);
        assemble_block(f, A, transient, uniform, i, band);
    }
}

static void hold_row(const ovr_band *band, size_t i)
{
    for (size_t d = 0; d < 5; d++)
        band->b[d][i] = d == 2;
    band->delta[i] = 0;
}

void OVR_KERNEL(band_assemble)(size_t n, const ovr_weights *w,
                               const double k[6], double minus, double plus,
                               bool transient, const ovr_fields *f,
                               const ovr_band *band)
{
    enum { EDGE = 8 };
    size_t end = (n - 1) / EDGE * EDGE - EDGE;
    set_shares(n, minus, plus, transient, f->P, band);
    if (transient) {
        assemble_rows(f, w, k, true, false, 0, EDGE, band);
        assemble_rows(f, w, k, true, true, EDGE, end, band);
        assemble_rows(f, w, k, true, false, end, n, band);
    } else {
        assemble_rows(f, w, k, false, false, 0, n, band);
    }
    hold_row(band, 0);
    hold_row(band, n - 1);
}

/* P_j <- max(0, P_j + change), |change| <= limit; a node held dry stays dry
 * whatever the rounding of its row. */
void OVR_KERNEL(distribute)(size_t n, double limit, const ovr_band *band,
                            double *P)
{
    const double *delta = band->delta, *minus = band->minus, *plus = band->plus;
    double last = P[n - 1];
    for (size_t i = 0; i < n; i += VEC) {
        vec change = load(delta + i) +
                     load(minus + i + 1) * load(delta + i + 1) +
                     load(plus + i - 1) * load(delta + i - 1);
        change = smaller(larger(change, all(-limit)), all(limit));
        store(P + i,
              larger(load(P + i) + change, all(0)) * load(band->moves + i));
    }
    P[0] = 0;
    P[n - 1] = last;
    for (size_t i = n; i < n + VEC; i++)
        P[i] = 0;
}
