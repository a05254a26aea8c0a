/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Checks the input values of gears, cams and bearings, and computes Blok's
 * flash temperature (formula and source in elements.h). */
#include <math.h>

#include "base/error.h"
#include "elements/elements.h"

ovr_status ovr_check_needed(const ovr_needed *all, size_t count, ovr_error *err)
{
    for (size_t k = 0; k < count; k++)
        if (!isfinite(all[k].value) || all[k].value < 0 ||
            (all[k].value <= 0 && !all[k].zero))
            return ovr_fail_about(
                err, all[k].about, "%s: must be %s", all[k].about,
                all[k].zero ? "zero or positive" : "positive");
    return OVR_OK;
}

double ovr_flash_temperature(const ovr_element_moment *moment, double b,
                             double mu, double B_1, double B_2)
{
    if (!moment)
        return NAN;
    /* Maximum of the integral over the half ellipse, for the full width 2 b; a
     * uniform source has 2/sqrt(pi) = 1.1284. */
    const double half_ellipse = 1.1115;
    double slip = fabs(moment->u1 - moment->u2);
    double carried = B_1 * sqrt(fabs(moment->u1)) +
                     B_2 * sqrt(fabs(moment->u2));
    return half_ellipse * mu * moment->load * slip / (carried * sqrt(2 * b));
}
