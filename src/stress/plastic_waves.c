/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Plane plastic strains e_x, e_z, e_xz = -i s, e_y = -e_x - e_z, of waves e^ikx
 * in a half plane z > 0 with a free surface, in units of p_h/E*.  With
 *
 *     X = (1 - nu) e_x - nu e_z,  Z = (1 - nu) e_z - nu e_x
 *     sx = -[G22 X - k^2 G20 Z + 2 k G21 s]
 *     sz = k^2 [G02 X - k^2 G00 Z + 2 k G01 s]
 *     t = k [G12 X - k^2 G10 Z + 2 k G11 s],  tau_xz = i t
 *     sy = nu (sx + sz) + (1 - nu^2)(e_x + e_z)
 *     Gmn = int d^m/dz^m d^n/dzeta^n G(z, zeta) dzeta
 *     G = g(z - zeta) - [1 + k(z + zeta) + 2 k^2 z zeta] e^-k(z+zeta)/4 k^3
 *     g(d) = (1 + a) e^-a/4 k^3,  a = k|d|
 *
 * G is the biharmonic Green's function of Airy's stress that vanishes with its
 * slope on the surface (T. Mura, Micromechanics of Defects in Solids, 1987,
 * defines eigenstrains).  Everything is a derivative or an antiderivative
 * of g, and of (linear) e^-kz times (linear) e^-kzeta: integrals over the layer
 * that is strained, and means over the one that receives, are differences at
 * their ends, exactly.  With means the operator is symmetric and lies in
 * [-2G, 0); sampled in the middle of layers it has positive eigenvalues, and
 * plastic flow grows without bound.
 *
 * Reciprocity with a unit load on the surface gives its displacement
 *     w = int e^-kz [-(1 - kz) e_x - (1 + kz) e_z - 2 nu e_y - 2 kz s] dz
 */
#include <math.h>

#include "stress/plastic_waves.h"

/* Derivative -2 ... 3 of g over k^(order - 3), at a = k d of either sign; what
 * is linear in d of the antiderivatives is left in, constants are not. */
static double whole_space(int order, double a)
{
    double sign = a < 0 ? -1 : 1, m = fabs(a), e = exp(-m);
    switch (order) {
    case -2: return (2 * m + (3 + m) * e) / 4;
    case -1: return sign * (2 - (2 + m) * e) / 4;
    case 0: return (1 + m) * e / 4;
    case 1: return -a * e / 4;
    case 2: return -(1 - m) * e / 4;
    default: return sign * (2 - m) * e / 4;
    }
}

/* (c + d u) e^-u, its derivative of order -1 ... 2. */
static void derive(int order, double *c, double *d)
{
    for (; order > 0; order--) {
        *c = *d - *c;
        *d = -*d;
    }
    if (order < 0) {
        *c = -(*c + *d);
        *d = -*d;
    }
}

/* Derivatives of order p in u = kz and q in v = k zeta of
 * [1 + u + v + 2 u v] e^-(u + v). */
static double image(int p, int q, double u, double v)
{
    double c0 = 1, d0 = 1, c1 = 1, d1 = 2; /* (c0 + d0 u) + (c1 + d1 u) v */
    derive(p, &c0, &d0);
    derive(p, &c1, &d1);
    double c = c0 + d0 * u, d = c1 + d1 * u;
    derive(q, &c, &d);
    return (c + d * v) * exp(-u - v);
}

/* Gmn over k^(m + n - 4) at u, by its antiderivative in z where `less` is 1
 * (over k^(m + n - 5)). */
static double influence(int m, int n, int less, double u, const double v[2])
{
    double sum = 0, odd = n % 2 ? -1 : 1;
    for (int end = 0; end < 2; end++) {
        double side = end ? 1 : -1;
        sum -= side * (odd * whole_space(m + n - 1 - less, u - v[end]) +
                       image(m - less, n - 1, u, v[end]) / 4);
    }
    return sum;
}

typedef struct influences {
    double of[3][3];
} influences;

static ovr_residual_stress stress(const influences *g, double poisson,
                                  ovr_plastic_strain e)
{
    double X = (1 - poisson) * e.x - poisson * e.z;
    double Z = (1 - poisson) * e.z - poisson * e.x;
    ovr_residual_stress s;
    s.x = -(g->of[2][2] * X - g->of[2][0] * Z + 2 * g->of[2][1] * e.xz);
    s.z = g->of[0][2] * X - g->of[0][0] * Z + 2 * g->of[0][1] * e.xz;
    s.xz = g->of[1][2] * X - g->of[1][0] * Z + 2 * g->of[1][1] * e.xz;
    s.y = poisson * (s.x + s.z);
    return s;
}

/* A strain changes stresses in its own place by this, which equilibrium along x
 * and z does not see, over a share of the layer. */
static double across(double poisson, ovr_plastic_strain e, double share)
{
    return share * (1 - poisson * poisson) * (e.x + e.z);
}

/* k = 0: nothing but what holds the strain back along x. */
static ovr_residual_stress uniform(double poisson, ovr_plastic_strain e,
                                   double share)
{
    ovr_residual_stress s = {0};
    s.x = -share * ((1 - poisson) * e.x - poisson * e.z);
    s.y = poisson * s.x + across(poisson, e, share);
    return s;
}

ovr_residual_stress ovr_residual_at(double k, double poisson,
                                    ovr_strained_layer source,
                                    ovr_plastic_strain strain, double z)
{
    double share = z > source.top && z < source.bottom;
    if (k == 0)
        return uniform(poisson, strain, share);
    const double v[] = {k * source.top, k * source.bottom};
    influences g;
    for (int m = 0; m < 3; m++)
        for (int n = 0; n < 3; n++)
            g.of[m][n] = influence(m, n, 0, k * z, v);
    ovr_residual_stress s = stress(&g, poisson, strain);
    s.y += across(poisson, strain, share);
    return s;
}

ovr_residual_stress ovr_residual_mean(double k, double poisson,
                                      ovr_strained_layer source,
                                      ovr_plastic_strain strain,
                                      ovr_strained_layer receiver)
{
    double height = receiver.bottom - receiver.top;
    double common = fmin(source.bottom, receiver.bottom) -
                    fmax(source.top, receiver.top);
    double share = fmax(common, 0) / height;
    if (k == 0)
        return uniform(poisson, strain, share);
    const double v[] = {k * source.top, k * source.bottom};
    influences g;
    for (int m = 0; m < 3; m++)
        for (int n = 0; n < 3; n++)
            g.of[m][n] = (influence(m, n, 1, k * receiver.bottom, v) -
                          influence(m, n, 1, k * receiver.top, v)) /
                         (k * height);
    ovr_residual_stress s = stress(&g, poisson, strain);
    s.y += across(poisson, strain, share);
    return s;
}

double ovr_plastic_sinking(double k, double poisson, ovr_strained_layer source,
                           ovr_plastic_strain strain)
{
    double u = k * source.top, v = k * source.bottom;
    double plain = (exp(-u) - exp(-v)) / k;                      /* e^-kz */
    double sloped = ((1 + u) * exp(-u) - (1 + v) * exp(-v)) / k; /* kz e^-kz */
    double y = -strain.x - strain.z;
    return -(plain - sloped) * strain.x - (plain + sloped) * strain.z -
           2 * poisson * plain * y - 2 * sloped * strain.xz;
}
