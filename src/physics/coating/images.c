/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "physics/coating/images.h"

#include <math.h>

/* ------------------------------------------------------------ near a node */

/* I and J of the header file, with lengths in D. */
static double once(double x, double a)
{
    return 0.5 * x * log(x * x + a * a) - x + a * atan(x / a);
}

static double twice(double x, double a)
{
    double r = x * x + a * a;
    return 0.25 * (r * log(r) - x * x) - 0.5 * x * x + a * x * atan(x / a) -
           0.5 * a * a * log(r / (a * a));
}

static double close(double x, double a, bool linear)
{
    if (linear)
        return twice(x + 1, a) - 2 * twice(x, a) + twice(x - 1, a);
    return once(x + 0.5, a) - once(x - 0.5, a);
}

/* Re c (f_1 + c (f_2 + ...)), c = 1/(x + i a)^2. */
static double series(double x, double a, double r, bool linear)
{
    static const double box[] = {1. / 24,    1. / 320,    1. / 2688,
                                 1. / 18432, 1. / 112640, 1. / 638976};
    static const double hat[] = {1. / 12,  1. / 60,  1. / 168,
                                 1. / 360, 1. / 660, 1. / 1092};
    const double *f = linear ? hat : box;
    double re = (x * x - a * a) / (r * r), im = -2 * x * a / (r * r);
    double u = f[5], v = 0;
    for (int k = 4; k >= 0; k--) {
        double next = f[k] + u * re - v * im;
        v = u * im + v * re;
        u = next;
    }
    return u * re - v * im;
}

/* Mean of ln|z| over the pressure of a node, in units of D. */
static double image(double x, double a, bool linear)
{
    double r = x * x + a * a;
    if (r < 64)
        return close(x, a, linear);
    return 0.5 * log(r) - series(x, a, r, linear);
}

/* -------------------------------------------------------- far from a node */

/* Sum of all images at X. */
static double point(const ovr_image_sum *sum, double X)
{
    const ovr_images *of = &sum->images;
    double all = 0;
    for (int m = 0; m < of->count; m++)
        all += of->weight[m] * log(X * X + of->depth[m] * of->depth[m]);
    return 0.5 * all;
}

static void fill_octave(const ovr_image_sum *sum, double first, double *c)
{
    const double pi = acos(-1.0);
    double value[OVR_IMAGE_DEGREE];
    for (int i = 0; i < OVR_IMAGE_DEGREE; i++) {
        double s = cos(pi * (i + 0.5) / OVR_IMAGE_DEGREE);
        value[i] = point(sum, first * (1.5 + 0.5 * s));
    }
    for (int j = 0; j < OVR_IMAGE_DEGREE; j++) {
        c[j] = 0;
        for (int i = 0; i < OVR_IMAGE_DEGREE; i++)
            c[j] += value[i] * cos(pi * j * (i + 0.5) / OVR_IMAGE_DEGREE);
        c[j] *= (j ? 2. : 1.) / OVR_IMAGE_DEGREE;
    }
}

/* Returns the sum by interpolation in the table. */
static double tabled(const ovr_image_sum *sum, double X)
{
    int octave;
    double s = 4 * frexp(X / sum->minimum, &octave) - 3; /* -1 to 1 */
    const double *c = sum->octave[octave - 1];
    double u = 0, v = 0;
    for (int j = OVR_IMAGE_DEGREE - 1; j > 0; j--) {
        double next = c[j] + 2 * s * u - v;
        v = u;
        u = next;
    }
    return c[0] + s * u - v;
}

static bool in_table(const ovr_image_sum *sum, double X, double D)
{
    return X >= 64 * D && X - D >= sum->minimum &&
           X + D < ldexp(sum->minimum, sum->octaves);
}

static double far(const ovr_image_sum *sum, double X, double D, bool linear)
{
    double out = D * sqrt(linear ? 0.4 : 0.15);
    double share = linear ? 5. / 12 : 5. / 9;
    return (1 - share) * tabled(sum, X) +
           0.5 * share * (tabled(sum, X - out) + tabled(sum, X + out));
}

/* --------------------------------------------------- part of the influence */

static double add(const ovr_image_sum *sum, double X, double D, bool linear)
{
    const ovr_images *of = &sum->images;
    double x = fabs(X) / D, all = 0, plain, weights = 0;
    plain = linear ? ovr_deformation_linear(x, D)
                   : ovr_deformation_kernel(x, D);
    if (in_table(sum, fabs(X), D)) {
        all = far(sum, fabs(X), D, linear);
    } else {
        for (int m = 0; m < of->count; m++) {
            all += of->weight[m] * image(x, of->depth[m] / D, linear);
            weights += of->weight[m];
        }
        all += weights * log(D);
    }
    return (of->top - 1) * plain + D / acos(-1.0) * all;
}

static double constant(const void *data, double X, double D)
{
    return add(data, X, D, false);
}

static double between(const void *data, double X, double D)
{
    return add(data, X, D, true);
}

static double wave(const void *data, double k)
{
    return ovr_images_softness(&((const ovr_image_sum *)data)->images, k) - 1;
}

ovr_influence_part ovr_image_part(const ovr_image_sum *sum)
{
    return (ovr_influence_part){constant, sum, between, wave};
}

void ovr_image_sum_make(ovr_image_sum *sum, const ovr_images *images,
                        double stiffness, double unit, double minimum,
                        double maximum)
{
    sum->images = *images;
    ovr_images_scale(&sum->images, stiffness, unit);
    sum->minimum = minimum;
    sum->octaves = 0;
    while (images->count && sum->octaves < OVR_IMAGE_OCTAVES &&
           ldexp(minimum, sum->octaves) < maximum) {
        fill_octave(sum, ldexp(minimum, sum->octaves),
                    sum->octave[sum->octaves]);
        sum->octaves++;
    }
}
