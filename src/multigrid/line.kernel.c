/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Distributive line relaxation: assembly and use of the pentadiagonal
 * system (equations in line.h; solution in band.kernel.c).
 */
#include "multigrid/kernels.h"
#include "multigrid/vector.h"

static const double dry_tolerance = 1e-10;

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

/* A[d + 3] = dN_i/dP_{i+d}, d = -3..3: elastic band and local part, without
 * d eps/dH */
static inline void derivatives(const ovr_fields *f, double half, const wedge *c,
                               const double k[6], size_t i, vec A[7])
{
    vec P0 = load(f->P + i), Pm = load(f->P + i - 1), Pp = load(f->P + i + 1);
    vec e0 = load(f->eps + i), em = load(f->eps + i - 1),
        ep = load(f->eps + i + 1);
    vec r0 = c->a0 * load(f->rho + i), r1 = c->a1 * load(f->rho + i - 1),
        r2 = c->a2 * load(f->rho + i - 2);
    A[0] = r0 * k[3] + r1 * k[2] + r2 * k[1];
    A[1] = r0 * k[2] + r1 * k[1] + r2 * k[0];
    A[2] = r0 * k[1] + r1 * k[0] + r2 * k[1];
    A[3] = r0 * k[0] + r1 * k[1] + r2 * k[2];
    A[4] = r0 * k[1] + r1 * k[2] + r2 * k[3];
    A[5] = r0 * k[2] + r1 * k[3] + r2 * k[4];
    A[6] = r0 * k[3] + r1 * k[4] + r2 * k[5];
    A[1] -= c->a2 * load(f->drho + i - 2) * load(f->H + i - 2);
    A[2] += half * (em + e0 + load(f->deps + i - 1) * (Pm - P0)) -
            c->a1 * load(f->drho + i - 1) * load(f->H + i - 1);
    A[3] -= half * (em + 2 * e0 + ep - load(f->deps + i) * (Pm - 2 * P0 + Pp)) +
            c->a0 * load(f->drho + i) * load(f->H + i);
    A[4] += half * (e0 + ep + load(f->deps + i + 1) * (Pp - P0));
}

/* b_d = A_d + minus_{i+d} A_{d-1} + plus_{i+d} A_{d+1} and the right-hand
 * side; dry rows hold P_i: exactly in time, delta_i = 0 when steady. */
static inline void assemble_block(const ovr_fields *f, const vec A[7],
                                  bool transient, size_t i,
                                  const ovr_band *band)
{
    vec r = load(f->r + i), P = load(f->P + i);
    ivec dry = (P <= 0) & (r >= dry_tolerance * A[3]);
    for (size_t d = 0; d < 5; d++) {
        vec m = load(band->minus + i + d - 2), p = load(band->plus + i + d - 2);
        vec b = A[d + 1] + m * A[d] + p * A[d + 2], held = all(0);
        if (d == 1 && transient)
            held = p;
        if (d == 2)
            held = all(1);
        if (d == 3 && transient)
            held = m;
        store(band->b[d] + i, choose(dry, held, b));
    }
    store(band->delta + i, choose(dry, -P, r));
    store(band->moves + i, choose(transient ? dry : (ivec){0}, all(0), all(1)));
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
    set_shares(n, minus, plus, transient, f->P, band);
    for (size_t i = 0; i < n; i += VEC) {
        vec A[7];
        wedge c = block_wedge(w, i);
        derivatives(f, w->half, &c, k, i, A);
        assemble_block(f, A, transient, i, band);
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
