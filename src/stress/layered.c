/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "stress/layered.h"

#include <complex.h>
#include <math.h>

#include "stress/stress.h"

static const double pi = 3.14159265358979323846;

/* k z beyond which waves are negligible. */
static const double GONE = 40;

int ovr_layered_at(const ovr_layered *body, double z)
{
    int j = 0;
    while (j < body->layers && z >= ovr_layered_bottom(body, j))
        j++;
    return j;
}

double ovr_layered_bottom(const ovr_layered *body, int j)
{
    double bottom = 0;
    for (int i = 0; i <= j; i++)
        bottom += body->thickness[i];
    return bottom;
}

ovr_at_rest ovr_layered_rest(const ovr_stress_options *o,
                             const ovr_material_range *range, double z)
{
    int j = o->layers ? ovr_layered_at(o->layers, z) : 0;
    const double *own = range->layer_residual;
    if (!o->layers || j == o->layers->layers) {
        ovr_at_rest at = {range->poisson, range->residual_x, range->residual_y};
        if (range->residuals)
            at.x = at.y = ovr_by_depth(range->residuals, range->residual_z,
                                       range->residual_s, z);
        return at;
    }
    return (ovr_at_rest){o->layers->layer[j].poisson, own ? own[2 * j] : 0,
                         own ? own[2 * j + 1] : 0};
}

/* f, f', f'' at s of (A + B s) e^-s + (C + D s) e^s */
static void at_depth(const double c[4], double s, double f[3])
{
    double down = exp(-s), up = c[2] == 0 && c[3] == 0 ? 0 : exp(s);
    double one = (c[0] + c[1] * s) * down, two = (c[2] + c[3] * s) * up;
    f[0] = one + two;
    f[1] = c[1] * down - one + c[3] * up + two;
    f[2] = one - 2 * c[1] * down + two + 2 * c[3] * up;
}

/* Computes (f, f') at the top of the layer. */
static void coefficients(const double f[2], const double R[4], double c[4])
{
    double a = 1 + R[0], b = R[1], d = -1 + R[0] + R[2], e = 1 + R[1] + R[3];
    double det = a * e - b * d;
    c[0] = (e * f[0] - b * f[1]) / det;
    c[1] = (a * f[1] - d * f[0]) / det;
    c[2] = R[0] * c[0] + R[1] * c[1];
    c[3] = R[2] * c[0] + R[3] * c[1];
}

void ovr_layered_wave(const ovr_layered *body, double k, double z, bool q,
                      double f[3])
{
    double R[OVR_LAYERS_MAX + 1][4] = {{0}}, c[4], at[3];
    double top[2] = {q ? 0 : 1, q ? 1 : 0}, above = 0;
    int last = ovr_layered_at(body, z), j = 0;
    f[0] = f[1] = f[2] = 0;
    if (k * z > GONE * 2)
        return;
    ovr_layered_reflections(body, k, R);
    for (; j < last; j++) {
        coefficients(top, R[j], c);
        at_depth(c, k * body->thickness[j], at);
        top[0] = at[0];
        top[1] = at[1];
        above += body->thickness[j];
    }
    coefficients(top, R[j], c);
    at_depth(c, k * (z - above), at);
    f[0] = at[2];
    f[1] = -at[0];
    f[2] = at[1];
}

/* Additions by layers to h, d and tau of a wave, without cos and sin. */
static void added(const ovr_layered_depth *of, double k, double G[3])
{
    double f[3], s = k * of->z, e = exp(-s);
    ovr_layered_wave(of->body, k, of->z, of->q, f);
    f[0] -= (of->q ? s - 2 : s - 1) * e;
    f[1] -= (of->q ? -s : -1 - s) * e;
    f[2] -= (of->q ? 1 - s : -s) * e;
    G[0] = -(f[0] + f[1]) / 2;
    G[1] = (f[0] - f[1]) / 2;
    G[2] = of->q ? -f[2] : f[2];
}

/* First four Taylor coefficients of G e^(ka) at k = 0, from a polynomial
 * through Chebyshev points. */
static void expand(ovr_layered_depth *of, double reach)
{
    enum { POINTS = 10 };
    double x[POINTS], v[3][POINTS];
    for (int i = 0; i < POINTS; i++) {
        double G[3];
        x[i] = 0.5 * (1 - cos(pi * (i + 0.5) / POINTS));
        added(of, x[i] * reach, G);
        for (int w = 0; w < 3; w++)
            v[w][i] = G[w] * exp(x[i] * reach * of->a);
    }
    for (int w = 0; w < 3; w++) {
        double c[POINTS + 1] = {0};
        for (int order = 1; order < POINTS; order++) /* divided differences */
            for (int i = POINTS - 1; i >= order; i--)
                v[w][i] = (v[w][i] - v[w][i - 1]) / (x[i] - x[i - order]);
        for (int i = POINTS - 1; i >= 0; i--) { /* Newton's form, expanded */
            for (int p = POINTS - 1; p > 0; p--)
                c[p] = c[p - 1] - x[i] * c[p];
            c[0] = v[w][i] - x[i] * c[0];
        }
        for (int p = 0; p < 4; p++)
            of->g[w][p] = c[p] / pow(reach, p);
    }
}

/* A stiff layer distributes a stretching load over a length of its thickness
 * times the ratio of its modulus to that below. */
static double carried_over(const ovr_layered *body)
{
    double length = 0;
    for (int j = 0; j < body->layers; j++)
        length += body->thickness[j] *
                  fmax(1, body->layer[j].modulus / body->below.modulus);
    return length;
}

ovr_layered_depth ovr_layered_depth_of(const ovr_layered *body, double z,
                                       double D, bool q, bool hats)
{
    double total = carried_over(body);
    ovr_layered_depth of = {.body = body,
                            .z = z,
                            .a = fmax(fmax(z, total), 4 * D),
                            .D = D,
                            .q = q,
                            .hats = hats};
    expand(&of, 0.3 / of.a);
    return of;
}

/* Transforms of k^p e^-ka: p!/(a - i x)^(p + 1); the real part belongs to cos,
 * the imaginary part to sin. */
void ovr_layered_near(const ovr_layered_depth *of, double x, double to[3])
{
    double complex one = 1 / (of->a - I * x), power = one;
    for (int p = 0; p < 4; p++) {
        for (int w = 0; w < 3; w++) {
            bool sine = (w == 2) != of->q;
            to[w] += of->D / pi * of->g[w][p] *
                     (sine ? cimag(power) : creal(power));
        }
        power *= (p + 1) * one;
    }
}

static double element(const ovr_layered_depth *of, double k)
{
    double x = 0.5 * k * of->D, sinc = x == 0 ? 1 : sin(x) / x;
    double square = sinc * sinc;
    return of->hats ? square : square * square * 3 / (2 + cos(2 * x));
}

/* Adds the wave k, which can have either direction along x. */
static void add_wave(const ovr_layered_depth *of, double k, double share,
                     double complex to[3])
{
    double G[3], size = fabs(k), e = exp(-size * of->a), S = element(of, k);
    added(of, size, G);
    for (int w = 0; w < 3; w++) {
        const double *g = of->g[w];
        bool sine = (w == 2) != of->q;
        double near = (g[0] + size * (g[1] + size * (g[2] + size * g[3]))) * e;
        double left = share * (S * G[w] - near);
        to[w] += sine ? (k < 0 ? I : -I) * left : left;
    }
}

void ovr_layered_bin(const ovr_layered_depth *of, size_t m, size_t N, double x,
                     double to[3][2])
{
    double complex sum[3] = {0};
    double whole = 2 * pi / of->D, k = whole * (double)m / (double)N;
    double slowest = of->z;
    if (ovr_layered_at(of->body, of->z) == 0)
        slowest = 2 * of->body->thickness[0] - of->z;
    slowest = fmin(slowest, of->a);
    int maximum = (int)fmin(GONE / (slowest * whole) + 1, 50);
    for (int l = -maximum; l <= maximum; l++)
        if (fabs(k + l * whole) * slowest < GONE)
            add_wave(of, k + l * whole, 1 / (double)N, sum);
    for (int w = 0; w < 3; w++) {
        double complex turned = sum[w] * cexp(I * k * x);
        to[w][0] = creal(turned);
        to[w][1] = cimag(turned);
    }
}
