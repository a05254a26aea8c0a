/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Film thickness, lubricant properties and the Reynolds coefficient at all
 * nodes, including the halo nodes that stencils read (laws: contact/laws):
 *
 *     H = H0 + gap - w
 *     eps = rho H^3/(eta lambda),  q = rho H
 *     d eps/dP (H fixed) = (rho' H - q eta'/eta) H^2/(eta lambda)
 *     d eps/dH (P fixed) = (3 rho - q (d eta/dH)/eta) H^2/(eta lambda), if
 *                          allocated
 *     log2(1/eta) and d ln(1/eta)/dP, if allocated
 *
 * With temperatures (fields.h), which are constant in a cycle,
 *     log2(1/eta) <- th log2(1/eta) + shift,  rho <- swell rho
 *
 * Error of eps: that of the logarithm in Roelands' law, below 1e-15 (5 + 1.2
 * stiffness), measured.  Results are finite for P up to 1e150; 1/eta is at
 * least 2^-900.
 *
 * Roelands' and Barus' laws with Dowson and Higginson's density are compiled
 * separately; all others share one loop with a branch per vector.
 *
 * A node needs a chain of about 60 dependent operations. Three short passes
 * over a block process more nodes in parallel than one long pass, and the
 * intermediate results stay in the nearest cache.
 */
#include "multigrid/kernels.h"
#include "multigrid/power.h"

#include "contact/laws/fluid.h"
#include "contact/laws/law.h"

enum { BLOCK = 192 };

/* Intermediate results between the passes: first stage of the viscosity law,
 * then log2(1/eta), and the slopes of ln eta. */
typedef struct block {
    _Alignas(64) double power[BLOCK];
    double slope[BLOCK], by_film[BLOCK];
} block;

/* Arguments of an evaluation. `law` (viscosity) and `other` (the fluid has its
 * own viscosity relation) are compile-time constants. */
typedef struct film {
    const ovr_fluid *fluid;
    fluid_laws laws;
    exp_table conductance; /* 2^y/lambda: 1/(eta lambda) */
    double H0;
    const double *gap, *w;
    ovr_fields f;
} film;

/* H, rho, q, q' at fixed H */
static inline void store_film(const film *c, ptrdiff_t i, vec rho, vec slope)
{
    vec H = c->H0 + load(c->gap + i) - load(c->w + i);
    store(c->f.H + i, H);
    store(c->f.rho + i, rho);
    store(c->f.q + i, rho * H);
    store(c->f.dq + i, slope * H);
}

/* First pass: film thickness, density and first stage of the viscosity. */
static INLINE void begin(const film *c, ovr_viscosity_law law, ptrdiff_t start,
                         ptrdiff_t end, block *work)
{
    for (ptrdiff_t i = start; i < end; i += VEC) {
        vec P = load(c->f.P + i), slope;
        vec a = dowson_higginson_divisor(&c->laws.density, P);
        vec t = viscosity_divisor(&c->laws, law, P), inverse = 1 / (a * t);
        vec power = viscosity_begin(&c->laws, law, P, t, inverse * a, &slope);
        vec by_pressure, rho = dowson_higginson_finish(
                             &c->laws.density, inverse * t, &by_pressure);
        store_film(c, i, rho, by_pressure);
        store(work->power + (i - start), power);
        store(work->slope + (i - start), slope);
    }
}

/* First pass for any density law. */
static INLINE void begin_any(const film *c, ovr_viscosity_law law,
                             ptrdiff_t start, ptrdiff_t end, block *work)
{
    ovr_density_law density = c->fluid->lubricant.density_law;
    for (ptrdiff_t i = start; i < end; i += VEC) {
        vec P = load(c->f.P + i), slope, by_pressure;
        vec t = viscosity_divisor(&c->laws, law, P);
        vec power = viscosity_begin(&c->laws, law, P, t, 1 / t, &slope);
        vec rho = density_at(&c->laws, density, P, &by_pressure);
        store_film(c, i, rho, by_pressure);
        store(work->power + (i - start), power);
        store(work->slope + (i - start), slope);
    }
}

/* Second pass: log2(1/eta). */
static INLINE void finish(const film *c, ovr_viscosity_law law, bool other,
                          ptrdiff_t start, ptrdiff_t count, block *work)
{
    if (other) {
        const ovr_law_nodes nodes = {(size_t)count,  c->f.P + start,
                                     c->f.H + start, work->power,
                                     work->slope,    work->by_film};
        c->fluid->law->at(c->fluid->law, &nodes);
    }
    for (ptrdiff_t j = 0; j < count && law == OVR_ROELANDS; j += VEC) {
        vec power = load(work->power + j), slope = load(work->slope + j);
        store(work->power + j,
              viscosity_finish(&c->laws, OVR_ROELANDS, power, &slope));
        store(work->slope + j, slope);
    }
}

/* Applies the thermal expansion to the density; returns the new rho H. */
static INLINE vec swelled(const ovr_fields *f, ptrdiff_t i)
{
    vec swell = load(f->swell + i), q = load(f->q + i) * swell;
    store(f->q + i, q);
    store(f->rho + i, load(f->rho + i) * swell);
    store(f->dq + i, load(f->dq + i) * swell);
    return q;
}

/* Last pass: viscosity and flow coefficients. */
static INLINE void flow(const film *c, bool other, ptrdiff_t start,
                        ptrdiff_t end, const block *work)
{
    const ovr_fields *f = &c->f;
    for (ptrdiff_t i = start; i < end; i += VEC) {
        vec power = load(work->power + (i - start));
        vec slope = load(work->slope + (i - start));
        vec H = load(f->H + i), q = load(f->q + i);
        if (f->th) {
            vec th = load(f->th + i);
            power = fused(th, power, load(f->shift + i));
            slope *= th;
        }
        if (f->swell)
            q = swelled(f, i);
        power = larger(power, all(-900));
        if (f->log_fluidity) {
            store(f->log_fluidity + i, power);
            store(f->log_slope + i, -slope);
        }
        vec factor = scaled_exp2(&c->conductance, power) * (H * H);
        vec dq = less(load(f->dq + i), q, slope);
        store(f->eps + i, q * factor);
        store(f->deps + i, dq * factor);
        if (f->deps_dH) {
            vec by_film = 3 * load(f->rho + i);
            if (other)
                by_film = less(by_film, q, load(work->by_film + (i - start)));
            store(f->deps_dH + i, by_film * factor);
        }
    }
}

static INLINE void by_law(const film *c, ovr_viscosity_law law, bool any_law,
                          bool other, ptrdiff_t end)
{
    block work;
    for (ptrdiff_t start = -OVR_HALO * VEC; start < end; start += BLOCK) {
        ptrdiff_t stop = end - start < BLOCK ? end : start + BLOCK;
        if (any_law)
            begin_any(c, law, start, stop, &work);
        else
            begin(c, law, start, stop, &work);
        finish(c, law, other, start, stop - start, &work);
        flow(c, other, start, stop, &work);
    }
}

/* True for laws of viscosity and density whose first stages share a division.
 */
static bool shares_division(const ovr_lubricant *oil)
{
    return !viscosity_is_direct(oil->viscosity_law) &&
           oil->density_law <= OVR_INCOMPRESSIBLE;
}

void OVR_KERNEL(film)(const ovr_fluid *fluid, double H0, const ovr_lanes *g,
                      const double *gap, const double *w, const ovr_fields *f)
{
    ptrdiff_t end = ((ptrdiff_t)g->S + 1) * VEC;
    film c = {.fluid = fluid, .H0 = H0, .gap = gap, .w = w, .f = *f};
    ovr_viscosity_law law = fluid->lubricant.viscosity_law;
    fluid_laws_make(&fluid->lubricant, &c.laws);
    make_exp_table(1 / fluid->lambda, &c.conductance);
    if (!shares_division(&fluid->lubricant))
        by_law(&c, fluid->law ? OVR_ISOVISCOUS : law, true, fluid->law != NULL,
               end);
    else if (fluid->law)
        by_law(&c, OVR_ISOVISCOUS, false, true, end);
    else if (law == OVR_ROELANDS)
        by_law(&c, OVR_ROELANDS, false, false, end);
    else
        by_law(&c, OVR_BARUS, false, false, end);
}
