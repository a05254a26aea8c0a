/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Bonded elastic layers on the bodies, in plane strain. A pressure cos(kx) on a
 * body displaces its surface by S_11 cos(kx)/k. In each layer Airy's function
 * is f(kz)/k^2 with f = (A + B s) e^-s + (C + D s) e^s, s = kz, and
 *     (f, f')   = T1 (A, B) + T2 (C, D),  T1 = [1 0; -1 1],  T2 = [1 0; 1 1]
 *     k (W, U)  = D1 (A, B) + D2 (C, D)
 *     D1 = [1 1-2nu; 1 -2(1-nu)]/2G,  D2 = [-1 1-2nu; 1 2(1-nu)]/2G
 * The half-space below has S = D1 T1^-1; from the last layer up
 *     R = (D2 - S T2)^-1 (S T1 - D1)                    at its bottom,
 *     R <- e^-2kt [1 -kt; 0 1] R [1 kt; 0 1]            at its top,
 *     S = (D1 + D2 R)(T1 + T2 R)^-1
 * All exponentials decay, so that there is no overflow for large k.
 *
 * For both bodies, relative to the substrates alone,
 *     A(k) = (S_11 + S'_11)/(the same of the substrates),  A(0) = 1,
 *     w(k) = A(k) P(k)/|k|,
 * which is replaced by A_top and images of the surface at depths a_m,
 *     A(k) = A_top + sum_m w_m e^(-k a_m),  sum_m w_m = 1 - A_top
 *     K(X) = A_top ln|X| + sum_m w_m ln|X + i a_m|
 * The depths form a geometric series. The weights minimize the squared relative
 * error (Householder reflections); the number of images is increased until the
 * error is small enough.
 *
 * A dry contact with half width 1 has P = sum_j c_j sqrt(1 - s^2) U_2j(s) with
 *     sum_j c_j (A_top T_2j+1(s) + sum_m w_m Re zeta_m^(2j+1)) = e s,
 *     zeta = z - sqrt(z^2 - 1), |zeta| < 1, z = s + i a_m
 * at Chebyshev points, with c_0 = 1. e is the stiffness of homogeneous bodies
 * with the same contact width at the same load, relative to that of the
 * substrates.
 */
#ifndef OVR_CONTACT_LAYERS_H
#define OVR_CONTACT_LAYERS_H

#include <stdbool.h>

#include "contact/heat_numbers.h"

enum { OVR_LAYERS_MAX = 6, OVR_IMAGES_MAX = 64 };

typedef struct ovr_elastic {
    double modulus, poisson;
} ovr_elastic;

/* A body: layers from the surface down, and the substrate. */
typedef struct ovr_layered {
    int layers;
    double thickness[OVR_LAYERS_MAX];
    ovr_elastic layer[OVR_LAYERS_MAX], below;
    double yield[OVR_LAYERS_MAX]; /* yield stress of each layer, p_h; 0: unknown
                                   */
    /* fatigue limit of each layer as a Hertzian pressure, p_h; 0: unknown */
    double limit[OVR_LAYERS_MAX];
    /* shear strength of the interface below each layer, p_h; 0: unknown */
    double strength[OVR_LAYERS_MAX];
} ovr_layered;

/* Writes R at the top of each layer to `to`, by rows; in the substrate R is 0.
 */
void ovr_layered_reflections(const ovr_layered *body, double k,
                             double to[OVR_LAYERS_MAX + 1][4]);

/* A(k) of both bodies. */
double ovr_layers_softness(const ovr_layered body[2], double k);

/* Images; depths in the unit of the layer thicknesses. */
typedef struct ovr_images {
    int count;
    double top; /* A_top */
    double weight[OVR_IMAGES_MAX], depth[OVR_IMAGES_MAX];
    double error; /* maximum relative error of A(k) */
} ovr_images;

/* A body in a contact: residual stresses in its layers, along x and across, in
 * p_h. For both bodies: images, with depths in b and A relative to the
 * contact's E'; E' relative to that of the substrates; half-width and maximum
 * pressure of the dry contact; maximum strain of a layer. */
typedef struct ovr_coated {
    ovr_layered body;
    double residual[2 * OVR_LAYERS_MAX];
    ovr_images images;
    double stiffness, width, pressure, strain;
} ovr_coated;

void ovr_images_fit(const ovr_layered body[2], ovr_images *images);

/* Multiplies A by the stiffness and lengths by the unit. */
void ovr_images_scale(ovr_images *images, double stiffness, double unit);

/* A(k) computed from the images. */
double ovr_images_softness(const ovr_images *images, double k);

/* Dry contact with half-width a, in the unit of the depths. */
typedef struct ovr_layered_hertz {
    double stiffness; /* e */
    double pressure; /* pressure at X = 0, relative to the Hertzian pressure for
                        this stiffness */
} ovr_layered_hertz;
ovr_layered_hertz ovr_images_dry(const ovr_images *images, double a);

/*
 * Heat conduction into layers: after a unit heat pulse the surface temperature
 * at time t is M(t) times that of a half-space of the substrate.  With e =
 * sqrt(k rho c) and tau = d^2 rho c/k of a layer of thickness d, Y = sqrt(s)
 * times the ratio of surface temperature to heat flux, with s the Laplace
 * variable, from the substrate up
 *     Y = 1/e_0,
 *     Y <- (1 + g E)/(e (1 - g E)),
 *     g = (e Y - 1)/(e Y + 1),  E = e^(-2 sqrt(s tau))
 *     M(t) = e_0 sqrt(pi t) L^-1[Y/sqrt(s)](t)
 *
 * The inverse transform is computed along Talbot's contour.  For one layer M is
 * (e_0/e)(1 + 2 sum g^n e^(-n^2 tau/t)): initially e_0/e, finally 1.
 *
 * Source: Carslaw & Jaeger, Conduction of Heat in Solids, 1959, 12.8; J. Abate
 * & P. P. Valko, Int. J. Numer. Meth. Engng 60 (2004) 979.
 */
typedef struct ovr_warmed {
    int layers;
    double effusivity[OVR_LAYERS_MAX + 1]; /* effusivities of the layers, then
                                              of the substrate */
    double tau[OVR_LAYERS_MAX];
} ovr_warmed;

/* Thicknesses in m; tau in s. */
ovr_warmed ovr_warmed_of(int layers, const double *thickness,
                         const ovr_thermal *layer, const ovr_thermal *below);
double ovr_warmed_at(const ovr_warmed *body, double t);

/* Half-width of the dry contact at the load for which homogeneous bodies with
 * the stiffness of the substrates have the half-width b; in the same unit. */
double ovr_images_half_width(const ovr_images *images, double b);

#endif
