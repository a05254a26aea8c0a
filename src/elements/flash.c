/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Blok's flash temperature; the formula and its source stand in the header. */
#include "elements/elements.h"

#include <math.h>

double ovr_flash_temperature(const ovr_element_moment *moment, double b,
                             double mu, double B_1, double B_2)
{
    if (!moment)
        return NAN;
    /* Largest value of the integral over the half ellipse, for the whole width
     * 2 b; the uniform source has 2/sqrt(pi) = 1.1284. */
    const double half_ellipse = 1.1115;
    double slip = fabs(moment->u1 - moment->u2);
    double carried = B_1 * sqrt(fabs(moment->u1)) +
                     B_2 * sqrt(fabs(moment->u2));
    return half_ellipse * mu * moment->load * slip / (carried * sqrt(2 * b));
}
