/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Elastic influence of bodies with layers: the images of contact/layers.h,
 * added to the logarithmic kernel of influence.h,
 *
 *     R(X) = (A_top - 1) ln|X| + sum_m w_m ln|X + i a_m|
 *
 * for a pressure that is constant around a node, or linear between nodes. Near
 * a node, |X + i a| < 8 D, the contribution of an image is the first or second
 * difference of
 *     I = x/2 ln(x^2 + a^2) - x + a atan(x/a)
 *     J = (r ln r - x^2)/4 - x^2/2 + a x atan(x/a) - a^2/2 ln(r/a^2),
 *         r = x^2 + a^2,
 * and further away, with z = X + i a and c = (D/z)^2, the series
 *     ln|z| - Re sum_k c^k/(4^k 2k (2k + 1)),
 *     ln|z| - Re sum_k 2 c^k/(2k (2k + 1)(2k + 2)),  k = 1..6,
 * with an error below 1e-15. Every image is smoother than the logarithm at the
 * same distance, so the MLMI error is not larger.
 *
 * Far from a node, X >= 64 D, the sum of all images is one smooth function: a
 * Chebyshev series for every octave of X, averaged over the node by a
 * three-point rule of fifth degree.
 */
#ifndef OVR_PHYSICS_COATING_IMAGES_H
#define OVR_PHYSICS_COATING_IMAGES_H

#include "contact/layers.h"
#include "multigrid/deformation.h"

enum { OVR_IMAGE_OCTAVES = 20, OVR_IMAGE_DEGREE = 20 };

typedef struct ovr_image_sum {
    ovr_images images; /* weights in the contact's scaling, depths in b */
    double minimum;    /* lower end of the table, which contains all images
                        * except ln|X| */
    int octaves;
    double octave[OVR_IMAGE_OCTAVES][OVR_IMAGE_DEGREE];
} ovr_image_sum;

/* Computes the sum of images in units of the bodies: A times `stiffness`,
 * depths times b. The table extends from `minimum` to `maximum`. */
void ovr_image_sum_make(ovr_image_sum *sum, const ovr_images *images,
                        double stiffness, double unit, double minimum,
                        double maximum);

ovr_influence_part ovr_image_part(const ovr_image_sum *sum);

#endif
