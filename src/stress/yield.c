/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The limits of a body that yields at a von Mises stress Y.
 *
 * First yield of the smooth dry contact: the p_h at which its largest von Mises
 * stress is Y.  Shakedown in free rolling: p_h = 4 k, k = Y/sqrt 3, above which
 * every pass flows again (K. L. Johnson, Contact Mechanics, 1985, section 9.2).
 * A strip of uniform pressure sinks in freely at (1 + pi/2) 2 k above the
 * pressure around it (Prandtl; R. Hill, Plasticity, 1950, section IX.5): its
 * slip lines come up in the width of a strip beside it, on the side that bears
 * less.  So of every strip of nodes
 *
 *     excess = mean of P in it - the smaller mean of its two neighbours,
 *
 * all three of one width.  Sums of P from the left give each mean at once;
 * widths are thirds of an octave, places a sixteenth of the width apart.  What
 * is narrower than `minimum` is left to the mesh.
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

/* Sums of P before node 0 ... n; beyond the ends there is none. */
static double before(const ovr_pressure_sums *s, long i)
{
    return s->sum[i < 0 ? 0 : i > (long)s->nodes ? (long)s->nodes : i];
}

static double sum_of(const ovr_pressure_sums *s, long from, long width)
{
    return before(s, from + width) - before(s, from);
}

/* Strips whose mean is above what is known hold a node that is: they begin from
 * `first` - width + 1 to `last`. */
static void look_at_width(const ovr_pressure_sums *s, long width, long first,
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
        look_at_width(s, lround(w), first, last, worst);
    return worst->excess > old;
}
