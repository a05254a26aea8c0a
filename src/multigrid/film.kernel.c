/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Film, lubricant properties and the Reynolds coefficient at all nodes, those
 * of the halo that stencils reach included:
 *
 *     H = H0 + gap - w
 *     rho = 1 + d P/a = 1 + d - d A/a,  a = A + P         Dowson-Higginson
 *     eta = exp(alphabar P0/z [t^z - 1]),  t = 1 + P/P0   Roelands
 *     eps = rho H^3/(eta lambda)
 *     d rho/dP = d A/a^2,  eta'/eta = alphabar t^z/t
 *     d eps/dP (H fixed) = (rho' H - q eta'/eta) H^2/(eta lambda),  q = rho H
 *     d eps/dH (P fixed) = 3 rho H^2/(eta lambda), where it has a place
 *
 * Powers are taken to the base 2 (power.h): 1/eta = 2^(S - S t^z) with S =
 * alphabar P0/(z ln 2), the tables of the two powers holding S and 1/lambda as
 * factors.  One division a node: 1/a and 1/t from 1/(a t).  Barus and
 * isoviscous (alphabar = 0) differ in the exponent, incompressible is d = 0.
 *
 * Error of eps: that of t and of z log2 t, some 2^-51 for z <= 1, grows by the
 * stiffness alphabar P0/z t^z = ln eta + alphabar P0/z, up to 80 in contacts:
 * below 1e-15 (5 + 1.2 stiffness), measured.  Numbers for P up to 1e150; 1/eta
 * below 2^-900 is held there.
 *
 * A node is a chain of some 60 dependent operations.  Three short passes over
 * a block keep more nodes in flight than one long one, and what one leaves for
 * the next stays in the nearest cache.
 */
#include "multigrid/kernels.h"
#include "multigrid/power.h"

enum { BLOCK = 192 };

/* What one pass leaves for the next. */
typedef struct block {
    _Alignas(64) double power[BLOCK]; /* z log2 t, then log2(1/eta) */
    double slope[BLOCK];              /* 1/t, then eta'/eta */
} block;

/* The laws as the passes use them; d is `range`. */
typedef struct laws {
    double A, range, inv_P0, stiffness, slope;
    log_table log;
    table16 growth;      /* S 2^(j/16): S t^z */
    table16 conductance; /* 2^(j/16)/lambda: 1/(eta lambda) */
} laws;

static void prepare(const ovr_fluid *fluid, laws *c)
{
    const double ln2 = 0x1.62e42fefa39efp-1, inv_ln2 = 0x1.71547652b82fep0;
    const ovr_lubricant *law = &fluid->lubricant;
    bool compressible = law->density_law == OVR_DOWSON_HIGGINSON;
    *c = (laws){.A = compressible ? law->A : 1,
                .range = compressible ? 0.34 : 0};
    make_exp_table(1 / fluid->lambda, &c->conductance);
    if (law->viscosity_law == OVR_ROELANDS) {
        c->inv_P0 = 1 / law->P0;
        c->stiffness = inv_ln2 * law->alphabar * law->P0 / law->z;
        c->slope = ln2 * law->z / law->P0; /* alphabar/S */
        make_log_table(law->z, &c->log);
        make_exp_table(c->stiffness, &c->growth);
    } else if (law->viscosity_law == OVR_BARUS) {
        c->slope = law->alphabar;
        c->stiffness = inv_ln2 * law->alphabar;
    }
}

/* H, rho, q, q' at fixed H */
static inline void store_film(const laws *c, ptrdiff_t i, vec H, vec inv_a,
                              const ovr_fields *f)
{
    vec drop = c->range * c->A * inv_a, rho = (1 + c->range) - drop;
    store(f->H + i, H);
    store(f->rho + i, rho);
    store(f->q + i, rho * H);
    store(f->dq + i, drop * (inv_a * H));
}

/* First pass: film, density and, Roelands, the logarithm. */
static inline void begin_roelands(const laws *c, double H0, ptrdiff_t start,
                                  ptrdiff_t end, const double *gap,
                                  const double *w, const ovr_fields *f,
                                  block *work)
{
    for (ptrdiff_t i = start; i < end; i += VEC) {
        vec P = load(f->P + i), a = c->A + P;
        vec t = fused(P, all(c->inv_P0), all(1)), inverse = 1 / (a * t);
        vec power = scaled_log2(&c->log, t);
        store_film(c, i, H0 + load(gap + i) - load(w + i), inverse * t, f);
        store(work->power + i - start, power);
        store(work->slope + i - start, inverse * a);
    }
}

static inline void begin_barus(const laws *c, double H0, ptrdiff_t start,
                               ptrdiff_t end, const double *gap,
                               const double *w, const ovr_fields *f,
                               block *work)
{
    for (ptrdiff_t i = start; i < end; i += VEC) {
        vec P = load(f->P + i), power = -c->stiffness * P;
        store_film(c, i, H0 + load(gap + i) - load(w + i), 1 / (c->A + P), f);
        store(work->power + i - start, larger(power, all(-900)));
        store(work->slope + i - start, all(c->slope));
    }
}

/* Second pass, Roelands: t^z. */
static inline void grow(const laws *c, ptrdiff_t count, block *work)
{
    for (ptrdiff_t j = 0; j < count; j += VEC) {
        vec growth = scaled_exp2(&c->growth, load(work->power + j));
        vec slope = c->slope * growth * load(work->slope + j);
        store(work->power + j, larger(c->stiffness - growth, all(-900)));
        store(work->slope + j, slope);
    }
}

/* Last pass: the viscosity. */
static INLINE void finish(const laws *c, bool by_film, ptrdiff_t start,
                          ptrdiff_t end, const ovr_fields *f, const block *work)
{
    for (ptrdiff_t i = start; i < end; i += VEC) {
        vec conductance = scaled_exp2(&c->conductance,
                                      load(work->power + i - start));
        vec H = load(f->H + i), q = load(f->q + i);
        vec flow = conductance * (H * H);
        vec dq = less(load(f->dq + i), q, load(work->slope + i - start));
        store(f->eps + i, q * flow);
        store(f->deps + i, dq * flow);
        if (by_film)
            store(f->deps_dH + i, 3 * load(f->rho + i) * flow);
    }
}

void OVR_KERNEL(film)(const ovr_fluid *fluid, double H0, const ovr_lanes *g,
                      const double *gap, const double *w, const ovr_fields *f)
{
    bool roelands = fluid->lubricant.viscosity_law == OVR_ROELANDS;
    ptrdiff_t end = ((ptrdiff_t)g->S + 1) * VEC;
    block work;
    laws c;
    prepare(fluid, &c);
    for (ptrdiff_t start = -OVR_HALO * VEC; start < end; start += BLOCK) {
        ptrdiff_t stop = end - start < BLOCK ? end : start + BLOCK;
        if (roelands) {
            begin_roelands(&c, H0, start, stop, gap, w, f, &work);
            grow(&c, stop - start, &work);
        } else {
            begin_barus(&c, H0, start, stop, gap, w, f, &work);
        }
        if (f->deps_dH)
            finish(&c, true, start, stop, f, &work);
        else
            finish(&c, false, start, stop, f, &work);
    }
}
