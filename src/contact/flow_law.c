/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Table of a rheological model (flow_law.h). f is evaluated some million times,
 * and is therefore tabulated first. */
#include "contact/flow_law.h"

#include <math.h>
#include <string.h>

#include "base/arena.h"
#include "base/error.h"
#include "base/given.h"
#include "contact/contact.h"

static const double MIN = OVR_CURVE_MIN, STEP = OVR_CURVE_STEP;
enum { GAUSS = 64, POINTS = OVR_CURVE_POINTS };

/* B-splines: nodes per unit of asinh; number of intervals; coefficients per
 * row, with one more on both sides. */
enum {
    PER = 4,
    SLIDES = 86,
    GRADIENTS = 26,
    ROW = GRADIENTS + 3,
    SIZE = (SLIDES + 3) * ROW
};

/* ------------------------------------------------------------------ laws */

/* ln f of the stress form, x = e^u. */
static double by_stress(const ovr_flow_form *form, double u)
{
    return u + (1 / form->n - 1) / form->a * log1p(exp(form->a * u));
}

/* Inverts v + (n - 1)/a ln(1 + e^(a v)) = u by Newton's method; the slope is
 * between n and 1. */
static double by_rate(const ovr_flow_form *form, double u)
{
    double n = form->n, a = form->a, v = fmax(u, u / n);
    for (int k = 0; k < 60; k++) {
        double e = exp(a * v), off = v + (n - 1) / a * log1p(e) - u;
        double slope = isinf(e) ? n : 1 + (n - 1) * e / (1 + e);
        v -= off / slope;
        if (fabs(off) < 1e-14 * fmax(1, fabs(u)))
            break;
    }
    return v;
}

/* Measured points are connected by straight lines in the logarithms of stress
 * and rate, which continue beyond the last point; below the first point the
 * film is Newtonian. */
static double by_points(const ovr_flow_form *form, double u)
{
    size_t n = form->points, k = 0;
    const double *rate = form->rate, *shear = form->shear;
    double eta = shear[0] / rate[0], tau0 = form->stress;
    double ln = u + log(tau0);
    if (ln <= log(shear[0]))
        return u;
    while (k + 2 < n && log(shear[k + 1]) < ln)
        k++;
    double slope = log(rate[k + 1] / rate[k]) / log(shear[k + 1] / shear[k]);
    return log(rate[k] * eta / tau0) + slope * (ln - log(shear[k]));
}

static void make_curve(const ovr_flow_form *form, ovr_curve *f)
{
    for (int k = 0; k < POINTS; k++) {
        double u = MIN + STEP * k;
        f->value[k] = form->rheology == OVR_CARREAU_STRESS ? by_stress(form, u)
                      : form->rheology == OVR_CARREAU      ? by_rate(form, u)
                                                           : by_points(form, u);
    }
    for (int k = 0; k < POINTS; k++) {
        int low = k ? k - 1 : 0, high = k + 1 < POINTS ? k + 1 : k;
        f->slope[k] = (f->value[high] - f->value[low]) / (STEP * (high - low));
    }
}

/* Needs x >= 0. */
static double curve_at(const ovr_curve *f, double x, double *by_x)
{
    double place = (log(x) - MIN) / STEP;
    if (!(place > 0)) {
        *by_x = 1;
        return x;
    }
    int k = place < POINTS - 1 ? (int)place : POINTS - 2;
    double t = place - k, d = f->value[k + 1] - f->value[k];
    double p = STEP * f->slope[k], q = STEP * f->slope[k + 1];
    double c2 = 3 * d - 2 * p - q, c3 = p + q - 2 * d, value, slope;
    if (t > 1) {
        value = f->value[k + 1] + (t - 1) * q;
        slope = q;
    } else {
        value = f->value[k] + t * (p + t * (c2 + t * c3));
        slope = p + t * (2 * c2 + 3 * t * c3);
    }
    value = exp(value);
    *by_x = value * slope / (STEP * x);
    return value;
}

double ovr_curve_at(const ovr_curve *f, double x, double *by_x)
{
    return x < 0 ? -curve_at(f, -x, by_x) : curve_at(f, x, by_x);
}

/* ------------------------------------------------------------- integrals */

typedef struct rule {
    double s[GAUSS], w[GAUSS];
} rule;

/* Gauss-Legendre on [-1, 1]: roots of the polynomial by Newton's method. */
static void make_rule(rule *r)
{
    for (int k = 0; k < GAUSS; k++) {
        double x = cos(acos(-1) * (k + 0.75) / (GAUSS + 0.5)), slope = 1;
        for (int step = 0; step < 20; step++) {
            double p = 1, before = 0;
            for (int j = 0; j < GAUSS; j++) {
                double next = ((2 * j + 1) * x * p - j * before) / (j + 1);
                before = p;
                p = next;
            }
            slope = GAUSS * (before - x * p) / (1 - x * x);
            x -= p / slope;
        }
        r->s[k] = x;
        r->w[k] = 2 / ((1 - x * x) * slope * slope);
    }
}

/* Half the integral of f(a + g s), and its derivative with respect to a. */
static double slid(const ovr_curve *f, const rule *r, double a, double g,
                   double *by_a)
{
    double sum = 0, slope = 0, by_x;
    for (int k = 0; k < GAUSS; k++) {
        sum += r->w[k] * ovr_curve_at(f, a + g * r->s[k], &by_x);
        slope += r->w[k] * by_x;
    }
    *by_a = slope / 2;
    return sum / 2;
}

/* Computes a by Newton's method between bounds, starting from `guess`. If a is
 * negligible compared with g (strongly shear-thinning laws), the guess is exact
 * and the sums would only contain rounding errors. */
static double mean_stress(const ovr_curve *f, const rule *r, double s_N,
                          double g, double guess)
{
    double low = 0, high = s_N, a = guess, by_a;
    for (int k = 0; k < 200 && guess > 1e-9 * g; k++) {
        double off = slid(f, r, a, g, &by_a) - s_N;
        if (fabs(off) <= 1e-12 * s_N)
            break;
        if (off > 0)
            high = fmin(high, a);
        else
            low = fmax(low, a);
        a -= off / by_a;
        if (!(a > low && a < high))
            a = low > 0 ? sqrt(low * high) : 0.5 * high;
    }
    return a;
}

static double flow_factor(const ovr_curve *f, const rule *r, double a, double g)
{
    double sum = 0, by_x;
    if (g == 0) {
        ovr_curve_at(f, a, &by_x);
        return by_x;
    }
    for (int k = 0; k < GAUSS; k++)
        sum += r->w[k] * r->s[k] * ovr_curve_at(f, a + g * r->s[k], &by_x);
    return 1.5 * sum / g;
}

static double node(int k)
{
    return sinh((double)k / PER);
}

/* ---------------------------------------------------------------- splines */

/* Converts n + 1 values, `apart` from each other and starting at position 1, to
 * spline coefficients; even at the first node, linear beyond the last. */
static void to_spline(double *v, int n, int apart)
{
    double pivot[SLIDES + 1];
    double *c = v + apart;
    pivot[0] = 0.5;
    c[0] *= 1.5;
    for (int k = 1; k < n; k++) {
        pivot[k] = 1 / (4 - pivot[k - 1]);
        c[k * apart] = (6 * c[k * apart] - c[(k - 1) * apart]) * pivot[k];
    }
    for (int k = n - 1; k >= 0; k--)
        c[k * apart] -= pivot[k] * c[(k + 1) * apart];
    v[0] = c[apart];
    c[(n + 1) * apart] = 2 * c[n * apart] - c[(n - 1) * apart];
}

/* Coefficients; node (i, j) is at [(i + 1) ROW + j + 1]. */
typedef struct splines {
    double flow[SIZE], stress[SIZE];
} splines;

static void make_splines(double *table)
{
    for (int i = 0; i <= SLIDES; i++)
        to_spline(table + (i + 1) * ROW, GRADIENTS, 1);
    for (int j = 0; j < ROW; j++)
        to_spline(table + j, SLIDES, ROW);
}

static void solve(splines *to, const ovr_curve *f)
{
    rule r;
    make_rule(&r);
    for (int j = 0; j <= GRADIENTS; j++) {
        double g = node(j), ratio, by_a;
        slid(f, &r, 0, g, &by_a);
        ratio = 1 / by_a;
        for (int i = 0; i <= SLIDES; i++) {
            double s_N = node(i), a = 0;
            int at = (i + 1) * ROW + j + 1;
            if (i > 0) {
                a = mean_stress(f, &r, s_N, g, ratio * s_N);
                ratio = a / s_N;
            }
            to->flow[at] = log(flow_factor(f, &r, a, g));
            to->stress[at] = log(ratio);
        }
    }
    make_splines(to->flow);
    make_splines(to->stress);
}

/* ------------------------------------------------------------------ table */

/* A position along s_N or g, 1 + s = 2^k (1 + m/4): interval of the spline,
 * weights, and their derivatives with respect to s. */
typedef struct place {
    int interval;
    double b[4], d[4];
} place;

static place place_of(int node, int intervals)
{
    place p;
    double s = ldexp(1 + node % 4 / 4., node / 4) - 1, at = PER * asinh(s);
    p.interval = at < intervals ? (int)at : intervals - 1;
    double t = at - p.interval, r = 1 - t, by_s = PER / hypot(1, s);
    p.b[0] = r * r * r / 6;
    p.b[1] = (4 - 6 * t * t + 3 * t * t * t) / 6;
    p.b[2] = (1 + 3 * t + 3 * t * t - 3 * t * t * t) / 6;
    p.b[3] = t * t * t / 6;
    p.d[0] = -0.5 * r * r * by_s;
    p.d[1] = t * (1.5 * t - 2) * by_s;
    p.d[2] = (0.5 + t - 1.5 * t * t) * by_s;
    p.d[3] = 0.5 * t * t * by_s;
    return p;
}

static void tabulate(const double *spline, double *table)
{
    for (int i = 0; i <= OVR_LAW_SLIDES; i++)
        for (int j = 0; j < OVR_LAW_ROW; j++) {
            place s = place_of(i, SLIDES), g = place_of(j, GRADIENTS);
            double *to = table + 4 * (i * OVR_LAW_ROW + j);
            const double *c = spline + s.interval * ROW + g.interval;
            for (int k = 0; k < 16; k++) {
                int m = k / 4, l = k % 4;
                to[0] += s.b[m] * g.b[l] * c[m * ROW + l];
                to[1] += s.d[m] * g.b[l] * c[m * ROW + l];
                to[2] += s.b[m] * g.d[l] * c[m * ROW + l];
                to[3] += s.d[m] * g.d[l] * c[m * ROW + l];
            }
        }
}

/* ------------------------------------------------------- public functions */

/* Apparent viscosities that increase by less than this between points are
 * considered equal: tables have four or more digits, each rounded. */
static const double ROUNDED = 1e-3;

static ovr_status check_points(const ovr_flow_form *form, ovr_error *err)
{
    if (form->points < 2)
        return ovr_fail_about(err, "rheology_file",
                              "needs at least two points, has %zu",
                              form->points);
    for (size_t k = 0; k < form->points; k++) {
        double before[2] = {k ? form->rate[k - 1] : 0,
                            k ? form->shear[k - 1] : 0};
        if (!(form->rate[k] > before[0] && form->shear[k] > before[1] &&
              isfinite(form->rate[k]) && isfinite(form->shear[k])))
            return ovr_fail_about(err, "rheology_file",
                                  "point %zu: rates and stresses must be "
                                  "positive and increase",
                                  k + 1);
        if (k && form->shear[k] / form->rate[k] >
                     (1 + ROUNDED) * before[1] / before[0])
            return ovr_fail_about(err, "rheology_file",
                                  "point %zu: the viscosity increases with "
                                  "the shear rate; only shear thinning is "
                                  "modelled",
                                  k + 1);
    }
    return OVR_OK;
}

static ovr_status check_form(const ovr_flow_form *form, ovr_error *err)
{
    if (form->rheology == OVR_FLOW_TABLE)
        return check_points(form, err);
    if (form->rheology != OVR_CARREAU && form->rheology != OVR_CARREAU_STRESS)
        return ovr_fail_about(err, "rheology",
                              "the Newtonian and the Eyring model have no "
                              "table");
    if (!(form->n >= OVR_CARREAU_N_MIN && form->n <= 1))
        return ovr_fail_about(err, "carreau_n",
                              "carreau_n = %g: must be %g to 1", form->n,
                              OVR_CARREAU_N_MIN);
    if (!(form->a >= OVR_CARREAU_A_MIN && form->a <= OVR_CARREAU_A_MAX))
        return ovr_fail_about(err, "carreau_a",
                              "carreau_a = %g: must be %g to %g", form->a,
                              OVR_CARREAU_A_MIN, OVR_CARREAU_A_MAX);
    return OVR_OK;
}

ovr_flow_law *ovr_flow_law_create(const ovr_flow_form *given,
                                  const ovr_allocator *allocator,
                                  ovr_error *err)
{
    ovr_flow_form form = ovr_flow_form_default();
    ovr_arena arena = ovr_arena_make(allocator);
    ovr_flow_law *made;
    splines *of;
    if (OVR_TAKE(ovr_flow_form, &form, given, err) || check_form(&form, err))
        return NULL;
    made = ovr_arena_take(&arena, 1, sizeof *made, err);
    of = made ? ovr_arena_take(&arena, 1, sizeof *of, err) : NULL;
    if (!of) {
        ovr_arena_release(&arena);
        return NULL;
    }
    make_curve(&form, &made->f);
    solve(of, &made->f);
    tabulate(of->flow, made->flow);
    tabulate(of->stress, made->stress);
    made->arena = arena;
    return made;
}

void ovr_flow_law_free(ovr_flow_law *law)
{
    ovr_arena arena;
    if (!law)
        return;
    arena = law->arena;
    ovr_arena_release(&arena);
}
