/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Modes of a surface's thermal memory (equations in modes.h). */
#include <complex.h>
#include <math.h>

#include "multigrid/plain.h"

#include "multigrid/modes.h"

/* c_l and d_l of w_1 (modes.h): minimal maximum error, with sum c = 1 and sum c
 * d = 1/5 (exact to first order in x). */
static const double OWN_WEIGHT[OVR_OWN_POLES][2] = {
    {0.020963912965770385, 8.146366438064549e-05},
    {0.13101958871322827, 0.0064770002090667935},
    {0.8480164983210014, 0.23484174111307513}};

/* Computes a from rho. */
static double complex pole(double complex rho)
{
    return 2 * rho / (1 + 2 * rho + csqrt(1 + 4 * rho));
}

/* Computes z_n and z_n+1 from y_n-1, y_n-2 and v_n-1, where v falls by f per
 * node. */
static void end_of(const ovr_sweeps *s, double complex a, double f,
                   const double y[2], double v, double z[2])
{
    double part = s->c * v * f / (f * f - s->b[0] * f + s->b[1]);
    double gain = s->c / (1 - s->b[0] * f + s->b[1] * f * f);
    double complex inverse = 1 / a,
                   G = s->c / ((1 - a * a) * (1 - conj(a) * a));
    double re = (y[0] - part * f) / 2;
    double im = (re * creal(inverse) - (y[1] - part) / 2) / cimag(inverse);
    double complex B = re + im * I;
    z[0] = part * f * f * gain + 2 * creal(B * a * G);
    z[1] = part * f * f * f * gain + 2 * creal(B * a * a * G);
}

/* 1/(1 + g x + h x^2), x = r (2 - E - 1/E) */
static ovr_sweeps sweeps_of(double r, double g, double h, double complex *a)
{
    ovr_sweeps s;
    *a = pole(r * (g / 2 + I * sqrt(h - g * g / 4)));
    s.b[0] = 2 * creal(*a);
    s.b[1] = creal(*a * conj(*a));
    s.c = 1 - s.b[0] + s.b[1];
    for (int k = 0; k < 2; k++) {
        const double y[2] = {k == 0, k == 1};
        double z[2];
        end_of(&s, *a, 0, y, 0, z);
        s.end[0][k] = z[0];
        s.end[1][k] = z[1];
    }
    return s;
}

/* Computes the factors by which a mode continues beyond the ends. */
static void find_factors(ovr_spread *s, double complex a, int m)
{
    const double none[2] = {0, 0};
    double f = exp(s->logarithm[0][m]), z[2];
    double A = s->past.c / (1 - s->past.b[0] * f + s->past.b[1] * f * f);
    s->left[0][m] = A * f;
    s->left[1][m] = A * f * f;
    end_of(&s->past, a, exp(s->logarithm[1][m]), none, 1, z);
    s->right[0][m] = z[0];
    s->right[1][m] = z[1];
}

ovr_spread ovr_spread_of(double kappa, double u, double dT, double D,
                         const double *rate)
{
    double r = kappa * dT / (D * D);
    double complex a;
    int upstream = u < 0;
    ovr_spread s = {.on = true};
    s.before = sweeps_of(r, 0.6, 0.168, &a);
    s.past = sweeps_of(r, 1, 0.5, &a);
    for (int l = 0; l < OVR_OWN_POLES; l++)
        s.own[l] = creal(pole(r * OWN_WEIGHT[l][1]));
    for (int m = 0; m < OVR_MODES; m++) {
        double root = sqrt(u * u + 4 * kappa * rate[m]) + fabs(u);
        s.logarithm[upstream][m] = -D * root / (2 * kappa);
        s.logarithm[!upstream][m] = -D * 2 * rate[m] / root;
        find_factors(&s, a, m);
    }
    return s;
}

void ovr_modes_integrals(double dT, const double *rate, double *fade, double *a,
                         double *b)
{
    for (int m = 0; m < OVR_MODES; m++) {
        double x = rate[m] * dT, e = exp(-x);
        bool small = x < 1e-3; /* by series */
        fade[m] = e;
        a[m] = dT * (small ? 0.5 - x / 6 : (x - 1 + e) / (x * x));
        b[m] = dT * (small ? 0.5 - x / 3 : (1 - e * (1 + x)) / (x * x));
    }
}

/* Adds gain times the integral of q e^(-mu x) over the nodes before each node,
 * in direction `direction`. */
static void integrate(size_t n, double D, const double *mu, const double *gain,
                      int direction, const double *q, double *psi)
{
    double before = 0, last[OVR_MODES] = {0};
    double e[OVR_MODES], a[OVR_MODES], b[OVR_MODES];
    ovr_modes_integrals(D, mu, e, a, b);
    for (size_t j = 0; j < n; j++) {
        size_t i = direction > 0 ? j : n - 1 - j;
        double *here = psi + i * OVR_MODES;
        for (int m = 0; m < OVR_MODES; m++) {
            last[m] = e[m] * last[m] + a[m] * q[i] + b[m] * before;
            here[m] += gain[m] * last[m];
        }
        before = q[i];
    }
}

void ovr_modes_steady(size_t n, double D, double kappa, double u,
                      const double *rate, const double *q, double *psi)
{
    double down[OVR_MODES], up[OVR_MODES], gain[OVR_MODES];
    for (int m = 0; m < OVR_MODES; m++) {
        double root = sqrt(u * u + 4 * kappa * rate[m]);
        down[m] = 2 * rate[m] / (root + fabs(u));
        up[m] = (root + fabs(u)) / (2 * kappa);
        gain[m] = 1 / root;
    }
    for (size_t i = 0; i < n * OVR_MODES; i++)
        psi[i] = 0;
    integrate(n, D, down, gain, u < 0 ? -1 : 1, q, psi);
    integrate(n, D, up, gain, u < 0 ? 1 : -1, q, psi);
}

/* Value at a distance of `nodes` beyond an end, where the field decays. */
static double far(const ovr_departures *f, const ovr_spread *s,
                  const double *psi, int m, int side, double nodes)
{
    double end = psi[(side ? (f->n - 1) * OVR_MODES : 0) + (size_t)m];
    return end * exp(s->logarithm[side][m] * nodes);
}

/* Value at node i, also beyond an end. */
static double value(const ovr_departures *f, const ovr_spread *s,
                    const double *psi, int m, ptrdiff_t i)
{
    ptrdiff_t last = (ptrdiff_t)f->n - 1;
    bool after = i > last;
    if (i >= 0 && !after)
        return psi[i * OVR_MODES + m];
    if (s->on)
        return far(f, s, psi, m, after, (double)(after ? i - last : -i));
    return after == (f->meshes >= 0) /* consistent with ovr_departures_at */
               ? psi[(after ? last * OVR_MODES : 0) + m]
               : 0;
}

double ovr_mode_at(const ovr_departures *departures, const ovr_spread *s,
                   const double *psi, int m, size_t i)
{
    ptrdiff_t first = (ptrdiff_t)i + departures->first;
    double at = (double)i - departures->meshes,
           last = (double)departures->n - 1, sum = 0;
    if (s->on && at < 0)
        return far(departures, s, psi, m, 0, -at);
    if (s->on && at > last)
        return far(departures, s, psi, m, 1, at - last);
    for (ptrdiff_t k = 0; k < 4; k++)
        sum += departures->c[k] * value(departures, s, psi, m, first + k);
    return sum;
}

/* Computes sum w_m Psi_m at nodes whose departure point is outside the domain.
 */
static void add_ends(const ovr_modes_look *l, double *sum)
{
    const ovr_departures *f = l->departures;
    for (size_t i = 0; i < f->n; i++) {
        if (i >= f->from && i < f->to)
            continue;
        sum[i] = 0;
        for (int m = 0; m < OVR_MODES; m++)
            sum[i] += l->weight[m] * ovr_mode_at(f, l->spread, l->psi, m, i);
    }
}

/* Coefficients of a field that is zero beyond the ends. */
static void set_sweeps(const ovr_sweeps *s, int field, ovr_swept *set)
{
    set->c[field] = s->c;
    for (int k = 0; k < 2; k++) {
        set->b[k][field] = s->b[k];
        set->begin[k][field] = set->after[k][field] = 0;
        for (int j = 0; j < 2; j++)
            set->end[k][j][field] = s->end[k][j];
    }
}

static ovr_sweeps of_pole(double a)
{
    return (ovr_sweeps){1 - a, {a, 0}, {{a / (1 + a), 0}, {0, 0}}};
}

enum { PAST, OWN_BEFORE, BEFORE, OWN }; /* OWN: as many as poles */

/* Diffusion is linear: the sum of fields is diffused once, except for the
 * contributions from outside the domain. */
static void fill_set(const ovr_modes_look *l, ovr_swept *set)
{
    const ovr_spread *s = l->spread;
    set_sweeps(&s->past, PAST, set);
    set_sweeps(&s->before, OWN_BEFORE, set);
    set_sweeps(&s->past, BEFORE, set);
    for (int p = 0; p < OVR_OWN_POLES; p++) {
        const ovr_sweeps pole = of_pole(s->own[p]);
        set_sweeps(&pole, OWN + p, set);
    }
    for (int m = 0; m < OVR_MODES; m++) {
        size_t last = l->departures->n - 1;
        double v_0 = ovr_mode_at(l->departures, s, l->psi, m, 0);
        double v_n = ovr_mode_at(l->departures, s, l->psi, m, last);
        for (int k = 0; k < 2; k++) {
            set->begin[k][PAST] += l->weight[m] * s->left[k][m] * v_0;
            set->after[k][PAST] += l->weight[m] * s->right[k][m] * v_n;
        }
    }
}

static void write_fields(const ovr_modes_look *l)
{
    for (size_t i = 0; i < l->departures->n; i++) {
        double *at = l->fields + i * OVR_SWEPT;
        at[PAST] = l->past[i];
        at[OWN_BEFORE] = at[BEFORE] = l->before[i];
        for (int p = OWN; p < OVR_SWEPT; p++)
            at[p] = l->q[i];
    }
}

static void read_fields(const ovr_modes_look *l)
{
    double gain = 4. / 3 * sqrt(l->dT);
    for (size_t i = 0; i < l->departures->n; i++) {
        const double *at = l->fields + i * OVR_SWEPT;
        double own = (1 + l->more[1]) * at[OWN_BEFORE] / 2 -
                     (1 + l->more[0]) * l->q[i];
        for (int p = 0; p < OVR_OWN_POLES; p++)
            own += (1 + l->more[0]) * OWN_WEIGHT[p][0] * at[OWN + p];
        l->past[i] = at[PAST] + gain * own;
        l->before[i] = at[BEFORE];
    }
}

void ovr_modes_past(const ovr_modes_look *l)
{
    const ovr_spread *s = l->spread;
    double own = s->on ? 0 : 2.0 / 3 * sqrt(l->dT) * (1 + l->more[1]);
    ovr_swept set = {.c = {0}};
    l->run->sum_modes(l->departures->n, l->weight, l->psi, own, l->q,
                      l->workspace);
    ovr_carry_along(l->departures, l->workspace, l->past);
    ovr_carry_along(l->departures, l->q, l->before);
    if (!s->on)
        return;
    add_ends(l, l->past);
    fill_set(l, &set);
    write_fields(l);
    l->run->sweep_fields(l->departures->n, &set, l->fields);
    read_fields(l);
}

/* ----------------------------------------------------------------- kernels */

void ovr_sum_modes_plain(size_t n, const double *weight, const double *psi,
                         double q_weight, const double *q, double *sum)
{
    for (size_t i = 0; i < n; i++) {
        sum[i] = q_weight * q[i];
        for (size_t m = 0; m < OVR_MODES; m++)
            sum[i] += weight[m] * psi[i * OVR_MODES + m];
    }
}

/* Two sweeps of a field with the given stride, from y_-1 and y_-2. */
static void sweep(size_t n, size_t stride, const ovr_sweeps *s,
                  const double begin[2], const double after[2], double *v)
{
    double y1 = begin[0], y2 = begin[1], z1, z2;
    for (size_t i = 0; i < n; i++) {
        double y = s->c * v[i * stride] - s->b[1] * y2 + s->b[0] * y1;
        y2 = y1;
        v[i * stride] = y1 = y;
    }
    z1 = s->end[0][0] * y1 + s->end[0][1] * y2 + after[0];
    z2 = s->end[1][0] * y1 + s->end[1][1] * y2 + after[1];
    for (size_t i = n; i-- > 0;) {
        double z = s->c * v[i * stride] - s->b[1] * z2 + s->b[0] * z1;
        z2 = z1;
        v[i * stride] = z1 = z;
    }
}

void ovr_sweep_fields_plain(size_t n, const ovr_swept *set, double *v)
{
    for (int k = 0; k < OVR_SWEPT; k++) {
        const ovr_sweeps s = {set->c[k],
                              {set->b[0][k], set->b[1][k]},
                              {{set->end[0][0][k], set->end[0][1][k]},
                               {set->end[1][0][k], set->end[1][1][k]}}};
        const double begin[2] = {set->begin[0][k], set->begin[1][k]};
        const double after[2] = {set->after[0][k], set->after[1][k]};
        sweep(n, OVR_SWEPT, &s, begin, after, v + k);
    }
}

/* Diffuses mode m after convection. */
static void spread_mode(const ovr_modes_step *w, int m, double *mode)
{
    const ovr_spread *s = w->spread;
    double first = mode[0], last = mode[(w->departures->n - 1) * OVR_MODES];
    const double begin[2] = {s->left[0][m] * first, s->left[1][m] * first};
    const double after[2] = {s->right[0][m] * last, s->right[1][m] * last};
    sweep(w->departures->n, OVR_MODES, &s->past, begin, after, mode);
}

void ovr_step_modes_plain(const ovr_modes_step *w, const double *psi,
                          double *to)
{
    for (int m = 0; m < OVR_MODES; m++) {
        double *mode = to + m;
        for (size_t i = 0; i < w->departures->n; i++)
            mode[i * OVR_MODES] = ovr_mode_at(w->departures, w->spread, psi, m,
                                              i);
        if (w->spread->on)
            spread_mode(w, m, mode);
        for (size_t i = 0; i < w->departures->n; i++)
            mode[i * OVR_MODES] = w->fade[m] * mode[i * OVR_MODES] +
                                  w->now[m] * w->q[i] +
                                  w->before[m] * w->q_before[i];
    }
}
