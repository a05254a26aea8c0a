/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The indent of a ball, or of a hard particle that stays whole, by its depth d
 * and the diameter 2 s_c of its rim, from crest to crest.
 *
 * The bowl is that of the ball, the rim a bell; where they meet they are
 * rounded over a height k = h by a cubic, so that slope and curvature are
 * continuous and the crest is at s_c, h high, exactly:
 *
 *     bowl = -d + (d + h)(s/a)^2,          a^2 = s_c^2 (d + h)/(d + h + k)
 *     rim  = h exp(-((|s| - s_c)/l)^2)
 *     S    = min(bowl, rim) - k g^3/6,     g = max(1 - |bowl - rim|/k, 0)
 *
 * Without a rim_height h = (c^2 - 1) d, c^2 = 5 (2 - n)/(2 (4 + n)) being the
 * square of contact radius over that without pile-up (Hill, Storakers & Zdunek,
 * Proc. R. Soc. Lond. A 423 (1989) 301), for a hardening exponent n = 0.1 as of
 * hardened steel: h = 0.159 d; quoted at second hand, the paper was not at
 * hand.  It assumes full plasticity and neglects springback; a measured rim
 * height can be set.
 *     a^2 (d - h)/4 = h ((s_c^2 - a^2)/2 + sqrt(pi)/2 l s_c + l^2/2),
 * by convention, but is s_c/4 at least, for rims higher than that allows; the
 * line contact uses the section through its middle.
 */
#include <math.h>

#include "surface/feature.h"

static const double PILED_UP = 0.158536585365853659; /* c^2 - 1 */
static const double HALF_ROOT_PI = 0.8862269254527580137;
static const double NARROWEST = 0.25; /* l/s_c */

void ovr_ball_sizes(ovr_feature *f, double rim_diameter, double rim_height)
{
    double d = -f->A, h = isnan(rim_height) ? PILED_UP * d : rim_height;
    double crest = rim_diameter / 2, part = (d + h) / (d + 2 * h);
    double volume = part * (d - h) / (2 * h) - (1 - part);
    double wide = sqrt(fmax(HALF_ROOT_PI * HALF_ROOT_PI + volume, 0)) -
                  HALF_ROOT_PI;
    f->ball = true;
    f->shoulder = h;
    f->shoulder_at = crest;
    f->shoulder_width = crest * fmax(wide, NARROWEST);
    f->width = crest * sqrt(part);
}

double ovr_ball_height(const ovr_feature *f, double s)
{
    double h = f->shoulder,
           out = (fabs(s) - f->shoulder_at) / f->shoulder_width;
    double part = s / f->width, bowl = f->A + (h - f->A) * part * part;
    double rim = h * exp(-out * out), gap = 1 - fabs(bowl - rim) / h;
    return fmin(bowl, rim) - (gap > 0 ? gap * gap * gap * h / 6 : 0);
}
