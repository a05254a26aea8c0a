/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Integrates the flow across the film, with 5 or 7 points per node (equations
 * in cross_film.h).  Arrays in the order of the nodes, with more than VEC + 1
 * nodes: vectors begin at node 1, and the last one overlaps the one before. The
 * two end nodes are cavitated and are computed separately.
 *
 * With L and l of log2 eta = L l + K: Roelands L = (ln eta + C)/ln 2, l =
 * x^(-S0); others L = 1, l = -beta T/ln 2.
 */
#include "multigrid/cross_film.h"
#include "multigrid/eyring.h"
#include "multigrid/flow_table.h"
#include "multigrid/kernels.h"

#include "multigrid/expansion.h" /* over vectors */

#include "contact/laws/fluid.h"
#include "contact/laws/law.h"

static const double LN2 = 0x1.62e42fefa39efp-1;
static const double INV_LN2 = 0x1.71547652b82fep0;

/* --------------------------------------------------------------- viscosity */

static INLINE void by_fluid(const fluid_laws *c, ovr_viscosity_law law,
                            size_t n, const double *P, double *log_eta)
{
    for (size_t k = 0; k < n; k += VEC) {
        size_t i = k + VEC <= n ? k : n - VEC;
        vec p = load(P + i), t = viscosity_divisor(c, law, p), slope;
        vec power = viscosity_begin(c, law, p, t, 1 / t, &slope);
        power = viscosity_finish(c, law, power, &slope);
        store(log_eta + i, -LN2 * power);
    }
}

/* Evaluates the viscosity-pressure relation that the fluid defines by
 * functions. */
static void by_object(const ovr_fluid *fluid, size_t n, const double *P,
                      const double *H, double *log_eta)
{
    enum { BLOCK = 192 };
    double slope[BLOCK], by_film[BLOCK];
    for (size_t i = 0; i < n; i += BLOCK) {
        size_t count = n - i < BLOCK ? n - i : BLOCK;
        const ovr_law_nodes nodes = {count,       P + i, H + i,
                                     log_eta + i, slope, by_film};
        fluid->law->at(fluid->law, &nodes);
    }
    for (size_t i = 0; i < n; i++)
        log_eta[i] *= -LN2;
}

/* ln(eta/eta0) at T0 */
void OVR_KERNEL(log_viscosity)(size_t n, const ovr_fluid *fluid,
                               const double *P, const double *H,
                               double *log_eta)
{
    fluid_laws c;
    fluid_laws_make(&fluid->lubricant, &c);
    if (fluid->law)
        by_object(fluid, n, P, H, log_eta);
    else if (fluid->lubricant.viscosity_law == OVR_ROELANDS)
        by_fluid(&c, OVR_ROELANDS, n, P, log_eta);
    else
        by_fluid(&c, fluid->lubricant.viscosity_law, n, P, log_eta);
}

/* -------------------------------------------------------------------- flow */

/* Constants of all nodes. */
typedef struct shared {
    ovr_columns c; /* a copy, so that the compiler can assume no store changes
                    * it */
    ovr_cross_film cross_film;
    ovr_heat heat;
    log_table cooling; /* -S0 log2 x */
    log_table ln;      /* Sigma0 ln x */
    log_table curve;   /* ln x/STEP */
    log_table log2;
    exp_table growth; /* 2^y */
    double inv_above; /* 1/(T0 - 138 K) */
} shared;

/* Values at a vector of nodes. */
typedef struct nodes {
    vec G, Y;                        /* H P_X/2; lambda eta_m/(12 H) */
    vec r[OVR_CROSS_FILM_MAX], m[3]; /* viscosity ratios, moments */
    vec mean, x, level, steep;       /* T_m; x, l there; L */
} nodes;

static INLINE vec bounded_by(vec x, vec maximum)
{
    return larger(smaller(x, maximum), -maximum);
}

static INLINE vec bounded(vec x, double maximum)
{
    return bounded_by(x, all(maximum));
}

static INLINE vec magnitude(vec x)
{
    return larger(x, -x);
}

static INLINE vec level_of(const shared *s, bool by_power, vec T, vec *x)
{
    *x = larger(fused(T, all(s->inv_above), all(1)), all(1e-3));
    if (by_power)
        return scaled_exp2(&s->growth, scaled_log2(&s->cooling, *x));
    return (-s->heat.beta * INV_LN2) * T;
}

/* Computes viscosity ratios from temperatures, their moments, and Y. */
static INLINE nodes temperatures(const shared *s, int n, bool by_power,
                                 size_t i)
{
    const ovr_columns *c = &s->c;
    vec T[OVR_CROSS_FILM_MAX], log_eta = load(c->log_eta + i), x;
    nodes v = {.mean = all(0), .m = {all(0), all(0), all(0)}};
    UNROLL
    for (int j = 0; j < n; j++) {
        T[j] = load(c->used[j] + i);
        v.mean = fused(T[j], all(s->cross_film.w[j]), v.mean);
    }
    v.level = level_of(s, by_power, v.mean, &v.x);
    v.steep = by_power ? (log_eta + s->heat.C) * INV_LN2 : all(1);
    UNROLL
    for (int j = 0; j < n; j++) {
        double at = s->cross_film.s[j];
        vec up = v.steep * (v.level - level_of(s, by_power, T[j], &x));
        v.r[j] = scaled_exp2(&s->growth, bounded(up, 100 * INV_LN2));
        vec part = s->cross_film.w[j] * v.r[j];
        v.m[0] += part;
        v.m[1] = fused(part, all(at), v.m[1]);
        v.m[2] = fused(part, all(at * at), v.m[2]);
    }
    vec log2_eta = by_power ? v.steep * v.level - s->heat.C * INV_LN2
                            : fused(log_eta, all(INV_LN2), v.level);
    log2_eta = larger(smaller(log2_eta, all(300 * INV_LN2)), all(-1000));
    v.Y = scaled_exp2(&s->growth, log2_eta) * (c->lambda / 12 / load(c->H + i));
    return v;
}

/* Mean stress and u_z, as in cross_film.c. */
static INLINE vec newtonian(const shared *s, int n, const nodes *v, vec *rate)
{
    vec t = -fused(v->Y, all(s->c.V), v->G * v->m[1]) / v->m[0];
    vec inverse = 1 / v->Y;
    UNROLL
    for (int j = 0; j < n; j++)
        rate[j] = v->r[j] * inverse * fused(v->G, all(s->cross_film.s[j]), t);
    return t;
}

/* sinh and cosh of x; sinh by a series where the difference of exponentials
 * loses its digits */
static INLINE void hyperbolic(const shared *s, vec x, vec *sh, vec *ch)
{
    static const double series[] = {1, 1. / 6, 1. / 120, 1. / 5040,
                                    1. / 362880};
    vec up = scaled_exp2(&s->growth, INV_LN2 * x), down = 1 / up;
    vec small = x * polynomial(4, series, x * x);
    *sh = choose(magnitude(x) < 0.3, small, 0.5 * (up - down));
    *ch = 0.5 * (up + down);
}

static INLINE vec eyring_flow(const shared *s, int n, const nodes *v, vec *rate)
{
    vec sh[OVR_CROSS_FILM_MAX], ch[OVR_CROSS_FILM_MAX], A = all(0), B = all(0);
    double Sigma0 = s->c.Sigma0;
    vec g = bounded(v->G / Sigma0, 200), b = (-s->c.V / Sigma0) * v->Y;
    UNROLL
    for (int j = n / 2; j < n; j++) {
        hyperbolic(s, g * s->cross_film.s[j], &sh[j], &ch[j]);
        sh[n - 1 - j] = -sh[j];
        ch[n - 1 - j] = ch[j];
    }
    UNROLL
    for (int j = 0; j < n; j++) {
        vec part = s->cross_film.w[j] * v->r[j];
        A = fused(part, ch[j], A);
        B = fused(part, sh[j], B);
    }
    vec square = (A - B) * (A + B), whole = fused(b, b, square);
    vec root = whole * inverse_root(whole), inverse = 1 / square;
    vec sinh_a = less(b * A, root, B) * inverse;
    vec cosh_a = less(root * A, b, B) * inverse;
    vec scale = Sigma0 / v->Y;
    UNROLL
    for (int j = 0; j < n; j++)
        rate[j] = scale * v->r[j] * fused(sinh_a, ch[j], cosh_a * sh[j]);
    vec t = arsinh(&s->ln, Sigma0, magnitude(sinh_a));
    return choose(sinh_a < 0, -t, t);
}

/* f(x) and its derivative (contact/flow_law.h) */
static vec curve_at(const shared *s, vec x, vec *by_x)
{
    const ovr_curve *f = &s->c.law->f;
    vec y = larger(magnitude(x), all(1e-300));
    vec place = scaled_log2(&s->curve, y) - OVR_CURVE_MIN / OVR_CURVE_STEP;
    vec in = smaller(larger(place, all(0)), all(OVR_CURVE_POINTS - 1.5));
    cell k = whole_part(in);
    vec t = place - from_whole(k), low = gather(f->value, k);
    vec d = gather(f->value + 1, k) - low;
    vec p = OVR_CURVE_STEP * gather(f->slope, k);
    vec q = OVR_CURVE_STEP * gather(f->slope + 1, k);
    vec c2 = 3 * d - 2 * p - q, c3 = p + q - 2 * d;
    vec value = choose(t > 1, low + d + (t - 1) * q,
                       low + t * (p + t * (c2 + t * c3)));
    vec slope = choose(t > 1, q, p + t * (2 * c2 + 3 * t * c3));
    value = scaled_exp2(&s->growth, bounded(INV_LN2 * value, 1000));
    *by_x = choose(place > 0, value * slope / (OVR_CURVE_STEP * y), all(1));
    value = choose(place > 0, value, magnitude(x));
    return choose(x < 0, -value, value);
}

/* Initial guess: the stress of a film with the same mean fluidity. */
static vec first_stress(const shared *s, vec uniform, vec g)
{
    law_value v = law_at(s->c.law->stress, smaller(uniform, all(1e280)), g);
    return uniform * law_power(&s->growth, &s->log2, &v);
}

/* Excess of the computed sliding speed, and its derivative. */
static vec too_much(const shared *s, const nodes *v, vec a, vec g, vec b,
                    vec *by_a)
{
    vec sum = -b, slope;
    *by_a = all(0);
    for (int j = 0; j < s->cross_film.n; j++) {
        vec part = s->cross_film.w[j] * v->r[j];
        vec at = fused(g, all(s->cross_film.s[j]), a);
        sum = fused(part, curve_at(s, at, &slope), sum);
        *by_a = fused(part, slope, *by_a);
    }
    return sum;
}

/* Mean stress relative to Sigma0 for a tabulated law. Elements that have
 * converged do not change. */
static vec law_stress(const shared *s, const nodes *v, vec g, vec b)
{
    vec uniform = magnitude(b) / v->m[0], high = magnitude(g) + uniform;
    vec low = -high, a = first_stress(s, uniform, g), by_a;
    a = choose(b < 0, -a, a);
    ivec active = high > low;
    for (int k = 0; k < 60 && any(active); k++) {
        vec off = too_much(s, v, a, g, b, &by_a), step = off / by_a;
        ivec above = off > 0;
        high = choose(above, a, high);
        low = choose(above, low, a);
        vec next = a - step;
        ivec moves = magnitude(step) > 1e-13 * (magnitude(next) + magnitude(g));
        ivec inside = (next > low) & (next < high);
        next = choose(moves & ~inside, 0.5 * (low + high), next);
        a = choose(active, next, a);
        active &= moves & (high > low);
    }
    return a;
}

static vec law_flow(const shared *s, const nodes *v, vec *rate)
{
    double Sigma0 = s->c.Sigma0;
    vec g = bounded(v->G / Sigma0, 300), b = (-s->c.V / Sigma0) * v->Y, unused;
    vec a = law_stress(s, v, g, b), scale = Sigma0 / v->Y;
    for (int j = 0; j < s->cross_film.n; j++)
        rate[j] = scale * v->r[j] *
                  curve_at(s, fused(g, all(s->cross_film.s[j]), a), &unused);
    return Sigma0 * a;
}

/* Sum of w_j cosh(g s_j). */
static INLINE vec mean_cosh(const shared *s, int n, vec g)
{
    vec sum = all(s->cross_film.w[n / 2]);
    UNROLL
    for (int j = n / 2 + 1; j < n; j++) {
        vec up = scaled_exp2(&s->growth, (INV_LN2 * s->cross_film.s[j]) * g);
        sum = fused(all(s->cross_film.w[j]), up + 1 / up, sum);
    }
    return sum;
}

/* Mean stress of a film with uniform fluidity m_0. */
static INLINE vec uniform(const shared *s, int n, const nodes *v, int law)
{
    double Sigma0 = s->c.Sigma0;
    vec b = (-s->c.V / Sigma0) * v->Y, g = v->G / Sigma0;
    nodes even = *v;
    if (s->c.V == 0)
        return all(0);
    if (law == 0)
        return -s->c.V * v->Y / v->m[0];
    if (law == 1) {
        vec a = magnitude(b) / (v->m[0] * mean_cosh(s, n, bounded(g, 200)));
        vec t = arsinh(&s->ln, Sigma0, a);
        return choose(b < 0, -t, t);
    }
    for (int j = 0; j < n; j++)
        even.r[j] = v->m[0];
    return Sigma0 * law_stress(s, &even, bounded(g, 300), b);
}

/* ----------------------------------------------------------------- results */

/* gamma relative to -d ln eta/dT: tanh(a)/a for Eyring's law, f/(a f') for
 * other laws */
static INLINE vec softer(const shared *s, int law, vec t)
{
    vec a = magnitude(t) / s->c.Sigma0;
    if (law == 2) {
        vec by_a, f = curve_at(s, a, &by_a);
        return choose(a > 1e-3, f / (a * by_a), all(1));
    }
    vec up = scaled_exp2(&s->growth, smaller(2 * INV_LN2 * a, all(100)));
    return choose(a > 1e-3, (up - 1) / ((up + 1) * a), all(1));
}

/* Stores the coefficients of the Reynolds equation. */
static INLINE void store_fields(const shared *s, bool by_power, const nodes *v,
                                size_t i)
{
    const ovr_columns *c = &s->c;
    vec skew = v->m[1] / v->m[0], psi = 3 * less(v->m[2], v->m[1], skew);
    vec shift = -v->level;
    if (by_power)
        shift = (1 - v->level) * (s->heat.C * INV_LN2);
    store(c->th + i, by_power ? v->level : all(1));
    store(c->shift + i, shift + scaled_log2(&s->log2, psi));
    store(c->drag + i, psi / v->m[0]);
    vec bT_f = expansion_at(&s->heat, load(c->P + i));
    store(c->swell + i, expansion_lightness(&s->heat, bT_f, v->mean));
    store(c->skewed + i, (0.5 * c->V) * skew * load(c->q + i));
}

/* Stores stress and gamma. */
static INLINE void store_stress(const shared *s, bool by_power, int law,
                                const nodes *v, vec t, ivec limited, size_t i)
{
    vec fall = all(s->heat.beta);
    if (by_power)
        fall = (s->heat.S0 * LN2 * s->inv_above) * v->steep * v->level / v->x;
    store(s->c.t + i, t);
    store(s->c.fall + i, choose(limited, all(0), fall * softer(s, law, t)));
}

/* Stores velocities and heat source of a pressurized film. At cavitated nodes
 * the velocity profile is linear. */
static INLINE void store_flow(const shared *s, int n, const nodes *v, vec t,
                              const vec *rate, size_t i)
{
    const ovr_columns *c = &s->c;
    ivec wet = load(c->P + i) > 0;
    UNROLL
    for (int j = 0; j < n; j++) {
        vec u = all(c->u1);
        UNROLL
        for (int k = 0; k < n; k++)
            u = fused(rate[k], all(s->cross_film.integral[j][k]), u);
        vec made = fused(v->G, all(s->cross_film.s[j]), t) * rate[j];
        store(c->u[j] + i,
              choose(wet, u, all(c->u1 - c->V * (1 + s->cross_film.s[j]) / 2)));
        store(c->heating[j] + i, choose(wet, made, all(0)));
    }
}

/* `law`: 0 Newtonian, 1 Eyring, 2 tabulated. */
static INLINE void flow(const shared *s, int n, bool by_power, int law,
                        nodes *v, size_t i)
{
    const ovr_columns *c = &s->c;
    vec rate[OVR_CROSS_FILM_MAX], P = load(c->P + i);
    vec dX = load(c->X + i + 1) - load(c->X + i - 1);
    vec P_X = (load(c->P + i + 1) - load(c->P + i - 1)) / dX;
    v->G = 0.5 * load(c->H + i) * P_X;
    vec t = law == 2   ? law_flow(s, v, rate)
            : law == 1 ? eyring_flow(s, n, v, rate)
                       : newtonian(s, n, v, rate);
    vec maximum = larger(c->limit * P - magnitude(v->G), all(0));
    if (c->even) {
        vec even = bounded_by(uniform(s, n, v, law), maximum);
        store(c->even + i, choose(P > 0, even, all(0)));
    }
    ivec limited = magnitude(t) > maximum;
    limited = c->always_falls ? (ivec){0} : limited & (P > 0);
    t = bounded_by(t, maximum);
    t = choose(P > 0, t, all(0));
    store_flow(s, n, v, t, rate, i);
    store_stress(s, by_power, law, v, t, limited, i);
}

static INLINE void columns(const shared *s, int n, bool by_power, int law)
{
    size_t last = s->c.n - 1;
    for (size_t k = 1; k < last; k += VEC) {
        size_t i = k + VEC <= last ? k : last - VEC;
        nodes v = temperatures(s, n, by_power, i);
        if (s->c.th)
            store_fields(s, by_power, &v, i);
        else
            flow(s, n, by_power, law, &v, i);
    }
}

void OVR_KERNEL(flow_cross_film)(const ovr_columns *c)
{
    shared s = {.c = *c, .cross_film = *c->cross_film, .heat = *c->heat};
    double above = s.heat.T0 - OVR_ROELANDS_T;
    make_log_table(-s.heat.S0, &s.cooling);
    make_log_table(LN2 * c->Sigma0, &s.ln);
    make_log_table(LN2 / OVR_CURVE_STEP, &s.curve);
    make_log_table(1, &s.log2);
    make_exp_table(1, &s.growth);
    s.inv_above = 1 / above;
    int law = c->law ? 2 : c->Sigma0 < 1e300 ? 1 : 0;
    bool by_power = s.heat.C > 0;
    if (s.cross_film.n == 5 && law == 1 && by_power)
        columns(&s, 5, true, 1); /* unrolled for the usual case */
    else if (s.cross_film.n == 5)
        columns(&s, 5, by_power, law);
    else
        columns(&s, 7, by_power, law);
    ovr_column_flow(c, 0);
    ovr_column_flow(c, c->n - 1);
}
