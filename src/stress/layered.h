/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Stresses in and below layers (contact/layers.h), as additions to those of the
 * same load on a half plane (element.h).
 *
 * For loads p = cos kx, and q = cos kx with the sign of element.h, with f of
 * each layer,
 *     p:  sigma_x = f'' cos kx   sigma_z = -f cos kx   tau =  f' sin kx
 *     q:  sigma_x = f'' sin kx   sigma_z = -f sin kx   tau = -f' cos kx
 *     (A, B) = (T1 + T2 R)^-1 (f, f'),  (C, D) = R (A, B)
 * where (f, f') = (1, 0) at the surface for p and (0, 1) for q; f and f' are
 * continuous at interfaces.  In a half plane f = (1 + kz) e^-kz and kz e^-kz.
 *
 * G is the addition by layers to h, d or tau of a wave.  The kernel of an
 * element of the transform S, sampled on the mesh over N nodes, is the
 * transform of
 *     (1/N) sum_l S(k_m + 2 pi l/D) [G - g](k_m + 2 pi l/D)
 *     g = (g_0 + g_1 k + g_2 k^2 + g_3 k^3) e^-ka
 * where g has the first terms of G, because parts that are odd in k have a long
 * range. The kernel of g is known in closed form, by derivatives with respect
 * to -a of
 *     int_0 e^-ka cos kx dk = a/(a^2 + x^2),  of sin: x/(a^2 + x^2)
 * The remainder decreases as x^-5 and is negligible at the period of the
 * transform. S is that of hat functions or of cardinal splines, sinc^4(kD/2)
 * 3/(2 + cos kD).
 */
#ifndef OVR_STRESS_LAYERED_H
#define OVR_STRESS_LAYERED_H

#include <stddef.h>

#include "contact/layers.h"
#include "stress/stress.h"

/* Relative distance from an interface at which its two sides are evaluated. */
#define OVR_BESIDE 1e-6

/* sigma_x, sigma_z and tau of a wave under p or q at depth z, as above without
 * cos and sin. */
void ovr_layered_wave(const ovr_layered *body, double k, double z, bool q,
                      double f[3]);

/* Layer of a depth, counted from 0; the number of layers for depths below them.
 */
int ovr_layered_at(const ovr_layered *body, double z);

/* Stress without load at a depth of a body with or without the layers of
 * `options`, and Poisson's ratio there. */
typedef struct ovr_at_rest {
    double poisson, x, y;
} ovr_at_rest;
ovr_at_rest ovr_layered_rest(const ovr_stress_options *options,
                             const ovr_material_range *range, double z);

/* Bottom of layer j. */
double ovr_layered_bottom(const ovr_layered *body, int j);

/* Additions by the layers at one depth: g and a for h, d and tau. */
typedef struct ovr_layered_depth {
    const ovr_layered *body;
    double z, a, D;
    bool q, hats;
    double g[3][4];
} ovr_layered_depth;

ovr_layered_depth ovr_layered_depth_of(const ovr_layered *body, double z,
                                       double D, bool q, bool hats);

/* Adds the closed forms at x to h, d and tau of an element. */
void ovr_layered_near(const ovr_layered_depth *of, double x, double to[3]);

/* Bin m of N of h, d and tau, real and imaginary parts, for samples that start
 * at x. */
void ovr_layered_bin(const ovr_layered_depth *of, size_t m, size_t N, double x,
                     double to[3][2]);

/* Interpolates in a table over depth: linear between the increasing depths z,
 * constant beyond them. */
static inline double ovr_by_depth(size_t count, const double *z,
                                  const double *value, double at)
{
    size_t k = 1;
    if (at <= z[0])
        return value[0];
    while (k < count && z[k] < at)
        k++;
    if (k == count)
        return value[k - 1];
    return value[k - 1] +
           (at - z[k - 1]) / (z[k] - z[k - 1]) * (value[k] - value[k - 1]);
}

#endif
