/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Limits of a body with von Mises yield stress Y.
 *
 * First yield of the smooth dry contact: the p_h at which its largest von Mises
 * stress is Y.  Shakedown in free rolling: p_h = 4 k, k = Y/sqrt 3, above which
 * plastic flow continues in every pass (K. L. Johnson, Contact Mechanics, 1985,
 * section 9.2). A strip of uniform pressure penetrates the body without limit
 * if it exceeds the surrounding pressure by (1 + pi/2) 2 k (Prandtl; R. Hill,
 * Plasticity, 1950, section IX.5): the slip lines emerge next to it within the
 * width of the strip, on the side with the lower pressure. Therefore for every
 * strip of nodes
 *
 *     excess = mean of P in it - the smaller mean of its two neighbours,
 *
 * all three with the same width. Cumulative sums of P yield each mean. Widths
 * increase by a third of an octave, positions by a sixteenth of the width.
 * Strips narrower than `minimum` are not resolved by the mesh and are omitted.
 */
#include <math.h>

#include "stress/stress.h"
#include "stress/yield.h"

static const double widths_of_octave = 3, places_of_width = 16;

double ovr_first_yield(double poisson)
{
    return 1 / ovr_hertz_criterion(OVR_CRITERION_VON_MISES, 0, poisson, NULL);
}

double ovr_shakedown_limit(void)
{
    return 4 / sqrt(3);
}

double ovr_strip_collapse(void)
{
    return (1 + acos(0)) * 2 / sqrt(3);
}

/* Sum of P before node i; P is zero outside. */
static double before(const ovr_pressure_sums *s, long i)
{
    return s->sum[i < 0 ? 0 : i > (long)s->nodes ? (long)s->nodes : i];
}

static double sum_of(const ovr_pressure_sums *s, long from, long width)
{
    return before(s, from + width) - before(s, from);
}

/* Strips whose mean exceeds the known maximum contain a node that exceeds it.
 * They begin between `first` - width + 1 and `last`. */
static void search_width(const ovr_pressure_sums *s, long width, long first,
                         long last, ovr_strip *worst)
{
    long step = (long)fmax(1, floor((double)width / places_of_width));
    long begin = first - width + 1 > 0 ? first - width + 1 : 0;
    long end = last + width <= (long)s->nodes ? last : (long)s->nodes - width;
    double w = (double)width;
    for (long i = begin; i <= end; i += step) {
        double inside = s->sum[i + width] - s->sum[i];
        if (!(inside > worst->excess * w))
            continue;
        double beside = fmin(sum_of(s, i - width, width),
                             sum_of(s, i + width, width));
        if (inside - beside > worst->excess * w)
            *worst = (ovr_strip){(inside - beside) / w, (double)i + (w - 1) / 2,
                                 w};
    }
}

bool ovr_strip_find(ovr_pressure_sums *s, const double *P, double minimum,
                    double maximum, ovr_strip *worst)
{
    double old = worst->excess;
    long n = (long)s->nodes, first = 0, last = n - 1;
    while (first < n && !(P[first] > old))
        first++;
    if (first == n)
        return false;
    while (!(P[last] > old))
        last--;
    for (long i = 0; i < n; i++)
        s->sum[i + 1] = s->sum[i] + P[i];
    for (double w = fmax(minimum, 1); w <= maximum;
         w *= exp2(1 / widths_of_octave))
        search_width(s, lround(w), first, last, worst);
    return worst->excess > old;
}
