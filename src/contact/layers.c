/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Layers: reflection matrices, images, and dry contact (layers.h). */
#include "contact/layers.h"

#include <complex.h>
#include <math.h>
#include <string.h>

/* ------------------------------------------------------------- compliance */

typedef struct matrix {
    double a, b, c, d; /* rows a b, c d */
} matrix;

static matrix times(matrix x, matrix y)
{
    return (matrix){x.a * y.a + x.b * y.c, x.a * y.b + x.b * y.d,
                    x.c * y.a + x.d * y.c, x.c * y.b + x.d * y.d};
}

static matrix sum(matrix x, matrix y, double c)
{
    return (matrix){x.a + c * y.a, x.b + c * y.b, x.c + c * y.c, x.d + c * y.d};
}

static matrix inverse(matrix x)
{
    double D = x.a * x.d - x.b * x.c;
    return (matrix){x.d / D, -x.b / D, -x.c / D, x.a / D};
}

static const matrix T1 = {1, 0, -1, 1}, T2 = {1, 0, 1, 1};

/* D1 (which = -1) for waves that decay with depth, otherwise D2. */
static matrix displaced(ovr_elastic of, double which)
{
    double two_G = of.modulus / (1 + of.poisson), nu = of.poisson;
    return (matrix){-which / two_G, (1 - 2 * nu) / two_G, 1 / two_G,
                    which * 2 * (1 - nu) / two_G};
}

/* S at the top of a layer, from S below it; also R there. */
static matrix add_layer(matrix S, ovr_elastic of, double kt, matrix *reflection)
{
    const matrix D1 = displaced(of, -1), D2 = displaced(of, 1);
    double e = exp(-2 * kt);
    matrix R = times(inverse(sum(D2, times(S, T2), -1)),
                     sum(times(S, T1), D1, -1));
    R = times((matrix){e, -e * kt, 0, e}, times(R, (matrix){1, kt, 0, 1}));
    *reflection = R;
    return times(sum(D1, times(D2, R), 1), inverse(sum(T1, times(T2, R), 1)));
}

void ovr_layered_reflections(const ovr_layered *body, double k,
                             double to[OVR_LAYERS_MAX + 1][4])
{
    matrix S = times(displaced(body->below, -1), inverse(T1)), R;
    for (int j = body->layers - 1; j >= 0; j--) {
        S = add_layer(S, body->layer[j], k * body->thickness[j], &R);
        to[j][0] = R.a;
        to[j][1] = R.b;
        to[j][2] = R.c;
        to[j][3] = R.d;
    }
}

/* S_11 of wave k, in units of 1/thickness. */
static double compliance_of(const ovr_layered *body, double k)
{
    matrix S = times(displaced(body->below, -1), inverse(T1)), R;
    for (int j = body->layers - 1; j >= 0; j--)
        S = add_layer(S, body->layer[j], k * body->thickness[j], &R);
    return S.a;
}

static double half_space(ovr_elastic of)
{
    return 2 * (1 - of.poisson * of.poisson) / of.modulus;
}

static double substrates(const ovr_layered body[2])
{
    return half_space(body[0].below) + half_space(body[1].below);
}

/* A in the limit of short waves, which depends on the topmost layers only. */
static double softness_of_top(const ovr_layered body[2])
{
    double all = 0;
    for (int k = 0; k < 2; k++)
        all += half_space(body[k].layers ? body[k].layer[0] : body[k].below);
    return all / substrates(body);
}

double ovr_layers_softness(const ovr_layered body[2], double k)
{
    return (compliance_of(&body[0], k) + compliance_of(&body[1], k)) /
           substrates(body);
}

/* ----------------------------------------------------------------- images */

enum { SAMPLES = 200 };

typedef struct fit {
    double k[SAMPLES], A[SAMPLES];
    double column[OVR_IMAGES_MAX][SAMPLES]; /* the last is the right-hand side
                                             */
    double diagonal[OVR_IMAGES_MAX];
} fit;

/* Thickness of the thinnest layer, and the larger total thickness of both
 * bodies. */
static void extent(const ovr_layered body[2], double *thin, double *total)
{
    *thin = INFINITY;
    *total = 0;
    for (int k = 0; k < 2; k++) {
        double all = 0;
        for (int j = 0; j < body[k].layers; j++) {
            *thin = fmin(*thin, body[k].thickness[j]);
            all += body[k].thickness[j];
        }
        *total = fmax(*total, all);
    }
}

static void sample(fit *f, const ovr_layered body[2])
{
    double thin, total;
    extent(body, &thin, &total);
    double first = 1e-6 / total, ratio = 30 / thin / first;
    for (int i = 0; i < SAMPLES; i++) {
        f->k[i] = first * pow(ratio, i / (SAMPLES - 1.));
        f->A[i] = ovr_layers_softness(body, f->k[i]);
    }
}

static double dot(const double *x, const double *y, int from)
{
    double all = 0;
    for (int i = from; i < SAMPLES; i++)
        all += x[i] * y[i];
    return all;
}

/* Householder reflection that makes column c a multiple of the c-th unit
 * vector; applied to all columns up to the last. */
static void reflect(fit *f, int c, int last)
{
    double *v = f->column[c], size = sqrt(dot(v, v, c));
    f->diagonal[c] = v[c] > 0 ? -size : size;
    if (size == 0)
        return;
    v[c] -= f->diagonal[c];
    double square = dot(v, v, c);
    for (int j = c + 1; j <= last; j++) {
        double share = 2 * dot(v, f->column[j], c) / square;
        for (int i = c; i < SAMPLES; i++)
            f->column[j][i] -= share * v[i];
    }
}

/* Weights of n images with given depths; the first follows from the sum. */
static void weigh(fit *f, int n, ovr_images *to)
{
    double all = 1 - to->top, size[OVR_IMAGES_MAX];
    for (int i = 0; i < SAMPLES; i++) {
        double first = exp(-f->k[i] * to->depth[0]);
        for (int m = 1; m < n; m++)
            f->column[m - 1][i] = (exp(-f->k[i] * to->depth[m]) - first) /
                                  f->A[i];
        f->column[n - 1][i] = (f->A[i] - to->top - all * first) / f->A[i];
    }
    for (int c = 0; c < n - 1; c++) {
        size[c] = sqrt(dot(f->column[c], f->column[c], 0));
        for (int i = 0; i < SAMPLES; i++)
            f->column[c][i] /= size[c];
    }
    for (int c = 0; c < n - 1; c++)
        reflect(f, c, n - 1);
    to->weight[0] = all;
    for (int c = n - 2; c >= 0; c--) {
        double w = f->column[n - 1][c];
        for (int j = c + 1; j < n - 1; j++)
            w -= f->column[j][c] * to->weight[j + 1] * size[j];
        to->weight[c + 1] = w / f->diagonal[c] / size[c];
    }
    for (int m = 1; m < n; m++)
        to->weight[0] -= to->weight[m];
    to->count = n;
}

void ovr_images_scale(ovr_images *images, double stiffness, double unit)
{
    images->top *= stiffness;
    for (int m = 0; m < images->count; m++) {
        images->weight[m] *= stiffness;
        images->depth[m] *= unit;
    }
}

double ovr_images_softness(const ovr_images *images, double k)
{
    double A = images->top;
    for (int m = 0; m < images->count; m++)
        A += images->weight[m] * exp(-k * images->depth[m]);
    return A;
}

/* Maximum error of the images, evaluated between the sample points of the fit.
 */
static double error_of(const ovr_images *images, const fit *f,
                       const ovr_layered body[2])
{
    double maximum = 0;
    for (int i = 0; i + 1 < SAMPLES; i++) {
        double k = sqrt(f->k[i] * f->k[i + 1]);
        double A = ovr_layers_softness(body, k);
        maximum = fmax(maximum, fabs(ovr_images_softness(images, k) / A - 1));
    }
    return maximum;
}

/* True for half-spaces with moduli different from those of the substrates: no
 * images, but A(0) is not 1. */
static bool is_flat(const ovr_images *images, const fit *f)
{
    for (int i = 0; i < SAMPLES; i++)
        if (fabs(f->A[i] - images->top) > 1e-13)
            return false;
    return true;
}

void ovr_images_fit(const ovr_layered body[2], ovr_images *images)
{
    static const int counts[] = {24, 32, 40, 48, 56, OVR_IMAGES_MAX};
    double thin, total, best = INFINITY;
    ovr_images with;
    fit f;
    sample(&f, body);
    extent(body, &thin, &total);
    *images = (ovr_images){.top = softness_of_top(body)};
    if (is_flat(images, &f))
        return;
    double target = images->top > 1 ? 5e-9 : 1e-9;
    with = *images;
    for (int c = 0; best > target && c < (int)(sizeof counts / sizeof *counts);
         c++) {
        int n = counts[c];
        for (int m = 0; m < n; m++)
            with.depth[m] = 0.3 * thin *
                            pow(400 * total / (0.3 * thin), m / (n - 1.));
        weigh(&f, n, &with);
        with.error = error_of(&with, &f, body);
        if (with.error < best) {
            best = with.error;
            *images = with;
        }
    }
}

/* ------------------------------------------------------------ dry contact */

enum { MAX = 48 };

typedef struct system {
    double row[MAX][MAX + 1];
} system;

/* Slopes of all pressure terms at s; terms of deep images become negligible
 * first. */
static void slopes(const ovr_images *images, double a, double s, int n,
                   double row[])
{
    double u[OVR_IMAGES_MAX], v[OVR_IMAGES_MAX];
    double c[OVR_IMAGES_MAX], d[OVR_IMAGES_MAX];
    double angle = acos(s);
    int left = images->count;
    for (int m = 0; m < left; m++) {
        double complex z = s + I * (images->depth[m] / a);
        double complex root = csqrt(z * z - 1), zeta = z - root;
        if (cabs(zeta) > 1)
            zeta = z + root;
        u[m] = creal(zeta);
        v[m] = cimag(zeta);
        c[m] = u[m] * u[m] - v[m] * v[m];
        d[m] = 2 * u[m] * v[m];
    }
    for (int j = 0; j < n; j++) {
        row[j] = images->top * cos((2 * j + 1) * angle);
        for (int m = 0; m < left; m++) {
            double next = u[m] * c[m] - v[m] * d[m];
            row[j] += images->weight[m] * u[m];
            v[m] = u[m] * d[m] + v[m] * c[m];
            u[m] = next;
        }
        while (left && fabs(u[left - 1]) + fabs(v[left - 1]) < 1e-24)
            left--;
    }
}

/* Gauss elimination with pivoting; the solution is in the last column. */
static void eliminate(system *of, int n)
{
    double(*row)[MAX + 1] = of->row;
    for (int c = 0; c < n; c++) {
        int p = c;
        for (int i = c + 1; i < n; i++)
            p = fabs(row[i][c]) > fabs(row[p][c]) ? i : p;
        for (int j = c; j <= n; j++) {
            double kept = row[c][j];
            row[c][j] = row[p][j];
            row[p][j] = kept;
        }
        for (int i = c + 1; i < n; i++) {
            double share = row[i][c] / row[c][c];
            for (int j = c; j <= n; j++)
                row[i][j] -= share * row[c][j];
        }
    }
    for (int i = n - 1; i >= 0; i--) {
        for (int j = i + 1; j < n; j++)
            row[i][n] -= row[i][j] * row[j][n];
        row[i][n] /= row[i][i];
    }
}

/* Solves for the right-hand sides s: e = c_0, and all c_j divided by it. */
ovr_layered_hertz ovr_images_dry(const ovr_images *images, double a)
{
    const double pi = acos(-1.0);
    double thin = images->count ? images->depth[0] / 0.3 : a, middle = 0;
    int n = 12 + (int)fmin(4 * a / thin, MAX - 12);
    system of = {.row = {{0}}};
    for (int i = 0; i < n; i++) {
        double s = cos((2 * i + 1) * pi / (4 * n));
        slopes(images, a, s, n, of.row[i]);
        of.row[i][n] = s;
    }
    eliminate(&of, n);
    for (int j = 0; j < n; j++)
        middle += j % 2 ? -of.row[j][n] : of.row[j][n];
    return (ovr_layered_hertz){of.row[0][n], middle / of.row[0][n]};
}

/* 2 ln(a/b) + ln e(a) */
static double too_wide(const ovr_images *images, double log_a, double log_b)
{
    return 2 * (log_a - log_b) +
           log(ovr_images_dry(images, exp(log_a)).stiffness);
}

/* Finds a with a^2 e(a) = b^2 by the secant method in ln a. */
double ovr_images_half_width(const ovr_images *images, double b)
{
    enum { STEPS = 30 };
    const double enough = 1e-10, log_b = log(b);
    double x[2] = {log_b}, y[2];
    y[0] = too_wide(images, x[0], log_b);
    x[1] = x[0] - 0.5 * y[0];
    y[1] = too_wide(images, x[1], log_b);
    for (int k = 0; fabs(y[1]) > enough && y[1] != y[0] && k < STEPS; k++) {
        double next = x[1] - y[1] * (x[1] - x[0]) / (y[1] - y[0]);
        x[0] = x[1];
        y[0] = y[1];
        x[1] = fmin(fmax(next, x[0] - 1), x[0] + 1);
        y[1] = too_wide(images, x[1], log_b);
    }
    return exp(x[1]);
}

/* -------------------------------------------------------------------- heat */

static double effusivity(const ovr_thermal *of)
{
    return sqrt(of->conductivity * of->heat_capacity * of->density);
}

ovr_warmed ovr_warmed_of(int layers, const double *thickness,
                         const ovr_thermal *layer, const ovr_thermal *below)
{
    ovr_warmed body = {.layers = layers};
    for (int j = 0; j < layers; j++) {
        const ovr_thermal *of = &layer[j];
        body.effusivity[j] = effusivity(of);
        body.tau[j] = thickness[j] * thickness[j] * of->density *
                      of->heat_capacity / of->conductivity;
    }
    body.effusivity[layers] = effusivity(below);
    return body;
}

/* Y/sqrt(s) */
static double complex warmth_of(const ovr_warmed *body, double complex s)
{
    double complex root = csqrt(s), Y = 1 / body->effusivity[body->layers];
    for (int j = body->layers - 1; j >= 0; j--) {
        double e = body->effusivity[j];
        double complex E = cexp(-2 * root * sqrt(body->tau[j]));
        double complex g = (e * Y - 1) / (e * Y + 1) * E;
        Y = (1 + g) / (1 - g) / e;
    }
    return Y / root;
}

double ovr_warmed_at(const ovr_warmed *body, double t)
{
    enum { POINTS = 24 };
    const double pi = acos(-1.0), r = 2. * POINTS / (5 * t);
    double all = 0.5 * exp(r * t) * creal(warmth_of(body, r));
    for (int k = 1; k < POINTS; k++) {
        double angle = k * pi / POINTS, cot = 1 / tan(angle);
        double complex s = r * angle * (cot + I);
        double complex turn = 1 + I * (angle + (angle * cot - 1) * cot);
        all += creal(cexp(t * s) * warmth_of(body, s) * turn);
    }
    return body->effusivity[body->layers] * sqrt(pi * t) * r / POINTS * all;
}
