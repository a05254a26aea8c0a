/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Flow of a shear-thinning film at a half node, with Eyring's law. The pressure
 * gradient has components along and across the rolling direction; sliding is
 * along it.  Stresses are in units of Sigma0, s = -1..1 is the place across the
 * film.
 *
 *     tau(s) = a + s G,   G = H grad P/(2 Sigma0),   F(t) = sinh(t)/t
 *     <F(|tau|) tau> = (c/eps, 0),   c = |V| rho H^2/(12 Sigma0)
 *     flow_k = E_k dP/dX_k,   E_k = eps (3/g_k) <s F tau_k>
 *     D = d(F tau)/d tau,   K_m = <s^m D>,   v = K_0^-1 K_1 e_k
 *     T_k = d flow_k/d grad_k = 3 eps (K_2 - K_1 K_0^-1 K_1)_kk
 *     dE_k/dc = 3 v_x/g_k,    eps dE_k/d eps = E_k - c dE_k/dc
 *
 * The brackets are means over the film by five Gauss points.  The mean stress a
 * is a guess, exact without a gradient across.  Its derivative corrects the
 * flow to second order.  The error of E is 1e-7 where |G| < 0.3, 1e-4 where |G|
 * < 1 and one per cent at |G| = 3.
 *
 * Gradients are limited to twelve. The viscosity occurs in eps only, so no
 * quotient can overflow.
 *
 * For other laws the same means are computed with F(t) = f(t)/t
 * (contact/flow_law.h), and a is corrected by a Newton step.
 *
 * Source: Conry, Wang and Cusano, J. Tribol. 109 (1987) 648, for flow along X.
 */
#ifndef OVR_STRIP_THINNING_H
#define OVR_STRIP_THINNING_H

#include "contact/flow_law.h"
#include "multigrid/flow_table.h"
#include "multigrid/power.h"

typedef struct thinning {
    double slide;    /* |V|/(12 Sigma0) */
    double gradient; /* 1/(4 Sigma0) */
    log_table log;
    exp_table exp;
    /* For other laws than Eyring's: f and its table, log2 x, ln x in table
     * steps */
    const ovr_flow_law *curve;
    log_table log2, steps;
} thinning;

/* E, T, eps dE/d eps and dE/dc. */
typedef struct thinned {
    vec E, T, by_eps, by_c;
} thinned;

static inline vec natural_log(const thinning *law, vec x)
{
    return scaled_log2(&law->log, x);
}

static inline vec exponential(const thinning *law, vec x)
{
    return scaled_exp2(&law->exp, 0x1.71547652b82fep0 * x);
}

/* g/sinh g of a positive g. */
static inline vec sine_quotient(const thinning *law, vec g)
{
    vec e = exponential(law, g);
    return choose(g > 1e-2, 2 * g / (e - 1 / e), 1 - (1. / 6) * g * g);
}

/* The Langevin function coth g - 1/g. */
static inline vec langevin(const thinning *law, vec g)
{
    vec e = exponential(law, 2 * g), h = larger(g, all(1e-4));
    vec far = (e + 1) / larger(e - 1, all(1e-4)) - 1 / h;
    return choose(g > 0.1, far, g * (1. / 3 - (1. / 45) * g * g));
}

static inline vec held_gradient(vec g)
{
    return smaller(larger(g, -g), all(12));
}

/* Mean stress a, and the terms w e/2 and back/(2 e), e = exp(t - x), of the
 * shear rate at a stress t. */
typedef struct mean_stress {
    vec x, y, w, back;
} mean_stress;

/* Guess of the mean stress: the linear response to sliding along and across
 * the gradient. */
static INLINE mean_stress guess_mean_stress(const thinning *law, vec eps, vec c,
                                            vec gx, vec gy)
{
    vec square = gx * gx + gy * gy + 1e-12, g = square * inverse_root(square);
    vec along = gx * gx / square;
    vec series = 1. / 600 + square * (1. / 17000);
    vec side = 1 / (1 + square * (1. / 18 + square * series));
    vec cb = c * (sine_quotient(law, g) * along + side * (1 - along));
    vec root = eps * eps + cb * cb + 1e-290;
    vec w = cb + root * inverse_root(root);
    vec a = natural_log(law, w / eps);
    vec across = -gy * langevin(law, gx) * a * inverse_root(9 + a * a);
    return (mean_stress){a, across, w, eps * (eps / w)};
}

/* Means over the film at the mean stress (ax, ay): F tau, K_0, K_1, K_2. */
typedef struct means {
    vec Fx, Fy, kxx, kxy, kyy, lxx, lxy, lyy, J, mm;
} means;

static const double gauss_place[] = {0.90617984593866396, 0.53846931010568311,
                                     0, -0.53846931010568311,
                                     -0.90617984593866396};
static const double gauss_weight[] = {0.1184634425280945, 0.23931433524968324,
                                      0.28444444444444444, 0.23931433524968324,
                                      0.1184634425280945};

static INLINE means means_of_eyring(const thinning *law, bool across,
                                    const mean_stress *a, vec gx, vec gy)
{
    means s = {0};
    UNROLL
    for (int k = 0; k < 5; k++) {
        const double place = gauss_place[k], weight = gauss_weight[k];
        vec tx = fused(all(place), gx, a->x), ty = fused(all(place), gy, a->y);
        vec t2 = tx * tx + ty * ty + 1e-8, it = inverse_root(t2);
        vec e = exponential(law, fused(t2, it, -a->x));
        vec p = 0.5 * a->w * e, q = 0.5 * a->back / e, F = (p - q) * it;
        vec D = ((p + q) - F) * it * it;
        vec ux = F * tx, uy = F * ty;
        vec dxx = fused(D * tx, tx, F), dxy = D * tx * ty;
        vec dyy = fused(D * ty, ty, F);
        double first = weight * place, second = first * place;
        s.Fx += weight * ux;
        s.Fy += weight * uy;
        s.kxx += weight * dxx;
        s.kxy += weight * dxy;
        s.kyy += weight * dyy;
        s.lxx += first * dxx;
        s.lxy += first * dxy;
        s.lyy += first * dyy;
        s.J += first * (across ? uy : ux);
        s.mm += second * (across ? dyy : dxx);
    }
    return s;
}

/* Flow from the means, corrected to the stress <F tau> = (stress, 0). `eps`
 * multiplies the means; c is the sliding. */
static INLINE thinned flow_of_means(const means *s, bool across, vec eps,
                                    vec stress, vec c, vec g)
{
    vec inverse = 1 / (s->kxx * s->kyy - s->kxy * s->kxy);
    vec bx = across ? s->lxy : s->lxx, by = across ? s->lyy : s->lxy;
    vec vx = (s->kyy * bx - s->kxy * by) * inverse;
    vec vy = (s->kxx * by - s->kxy * bx) * inverse;
    vec J = s->J + (vx * (stress - s->Fx) - vy * s->Fy);
    vec third = 3 / g;
    thinned f = {.E = eps * J * third,
                 .T = 3 * eps * (s->mm - vx * bx - vy * by),
                 .by_c = vx * third};
    f.by_eps = f.E - c * f.by_c;
    return f;
}

/* Flow along X or across with Eyring's law. */
static INLINE thinned thinned_by_eyring(const thinning *law, bool across,
                                        vec eps, vec c, vec gx, vec gy)
{
    eps = larger(eps, all(1e-280));
    gx = held_gradient(gx);
    gy = held_gradient(gy);
    if (across)
        gy = larger(gy, all(1e-4));
    else
        gx = larger(gx, all(1e-4));
    const mean_stress a = guess_mean_stress(law, eps, c, gx, gy);
    const means s = means_of_eyring(law, across, &a, gx, gy);
    return flow_of_means(&s, across, all(1), c, c, across ? gy : gx);
}

/* f(t)/t of a tabulated law, and f'(t), t > 0 (contact/flow_law.h). */
static INLINE vec rate_of_curve(const thinning *law, vec t, vec *slope)
{
    const ovr_curve *f = &law->curve->f;
    const double step = OVR_CURVE_STEP, first = OVR_CURVE_MIN / OVR_CURVE_STEP;
    vec place = scaled_log2(&law->steps, t) - first;
    vec in = smaller(larger(place, all(0)), all(OVR_CURVE_POINTS - 1.5));
    vec value, by_place;
    for (int l = 0; l < VEC; l++) {
        size_t k = (size_t)in[l];
        double u = place[l] - (double)k, d = f->value[k + 1] - f->value[k];
        double p = step * f->slope[k], q = step * f->slope[k + 1];
        double c2 = 3 * d - 2 * p - q, c3 = p + q - 2 * d;
        value[l] = u > 1 ? f->value[k + 1] + (u - 1) * q
                         : f->value[k] + u * (p + u * (c2 + u * c3));
        by_place[l] = u > 1 ? q : p + u * (2 * c2 + 3 * u * c3);
    }
    value = exponential(law, smaller(value, all(460))) / t;
    *slope = choose(place > 0, value * by_place * (1 / step), all(1));
    return choose(place > 0, value, all(1));
}

static INLINE means means_of_curve(const thinning *law, bool across, vec ax,
                                   vec ay, vec gx, vec gy)
{
    means s = {0};
    for (int k = 0; k < 5; k++) {
        const double place = gauss_place[k], weight = gauss_weight[k];
        vec tx = fused(all(place), gx, ax);
        vec ty = fused(all(place), gy, ay);
        vec t2 = tx * tx + ty * ty + 1e-8, it = inverse_root(t2), slope;
        vec F = rate_of_curve(law, t2 * it, &slope);
        vec D = (slope - F) * it * it, dxy = weight * D * tx * ty;
        vec dxx = weight * fused(D * tx, tx, F);
        vec dyy = weight * fused(D * ty, ty, F);
        s.Fx += weight * F * tx;
        s.Fy += weight * F * ty;
        s.kxx += dxx;
        s.kxy += dxy;
        s.kyy += dyy;
        s.lxx += place * dxx;
        s.lxy += place * dxy;
        s.lyy += place * dyy;
        s.J += weight * place * F * (across ? ty : tx);
        s.mm += place * place * (across ? dyy : dxx);
    }
    return s;
}

/* Flow along X or across with a tabulated law. The mean stress is that of the
 * table without a gradient across, corrected by a Newton step. */
static INLINE thinned thinned_by_curve(const thinning *law, bool across,
                                       vec eps, vec c, vec gx, vec gy)
{
    const double steepest = 100, most = 1e100;
    eps = larger(eps, all(1e-280));
    gx = smaller(larger(larger(gx, -gx), all(across ? 0 : 1e-4)),
                 all(steepest));
    gy = smaller(larger(larger(gy, -gy), all(across ? 1e-4 : 0)),
                 all(steepest));
    vec s_N = smaller(c / eps, all(most));
    law_value guess = law_at(law->curve->stress, s_N, gx);
    vec ax = s_N * law_power(&law->exp, &law->log2, &guess), ay = all(0);
    means s = means_of_curve(law, across, ax, ay, gx, gy);
    vec inverse = 1 / (s.kxx * s.kyy - s.kxy * s.kxy), r = s_N - s.Fx;
    ax += (s.kyy * r + s.kxy * s.Fy) * inverse;
    ay -= (s.kxx * s.Fy + s.kxy * r) * inverse;
    s = means_of_curve(law, across, ax, ay, gx, gy);
    return flow_of_means(&s, across, eps, s_N, c, across ? gy : gx);
}

#endif
