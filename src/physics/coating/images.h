/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The elastic influence of bodies with layers: the images of contact/layers.h
 * as a part beside the logarithm of influence.h,
 *
 *     R(X) = (A_top - 1) ln|X| + sum_m w_m ln|X + i a_m|
 *
 * of a pressure that is constant about a node, or linear between nodes.  Near a
 * node, |X + i a| < 8 D, an image is the first or second difference of
 *     I = x/2 ln(x^2 + a^2) - x + a atan(x/a)
 *     J = (r ln r - x^2)/4 - x^2/2 + a x atan(x/a) - a^2/2 ln(r/a^2),
 *         r = x^2 + a^2,
 * beyond that with z = X + i a and c = (D/z)^2 by the series
 *     ln|z| - Re sum_k c^k/(4^k 2k (2k + 1)),
 *     ln|z| - Re sum_k 2 c^k/(2k (2k + 1)(2k + 2)),  k = 1..6,
 * which leaves less than 1e-15.  Every image is smoother than the logarithm at
 * the same distance, so what MLMI leaves of it is no larger than that.
 *
 * Far from a node, X >= 64 D, the sum of all images is one smooth function: a
 * Chebyshev series for every octave of X, averaged by three points that are
 * exact up to the fifth power.
 */
#ifndef OVR_PHYSICS_COATING_IMAGES_H
#define OVR_PHYSICS_COATING_IMAGES_H

#include "contact/layers.h"
#include "multigrid/deformation.h"

enum { OVR_IMAGE_OCTAVES = 20, OVR_IMAGE_DEGREE = 20 };

typedef struct ovr_image_sum {
    ovr_images images; /* weights in the contact's scaling, depths in b */
    double minimum;    /* of the table, which is of all images but ln|X| */
    int octaves;
    double octave[OVR_IMAGE_OCTAVES][OVR_IMAGE_DEGREE];
} ovr_image_sum;

/* Makes the sum of images in units of the bodies: A times the stiffness, depths
 * times b; the table from `minimum` to `maximum`. */
void ovr_image_sum_make(ovr_image_sum *sum, const ovr_images *images,
                        double stiffness, double unit, double minimum,
                        double maximum);

ovr_influence_part ovr_image_part(const ovr_image_sum *sum);

#endif
