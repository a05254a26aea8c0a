/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "contact/flow_factor.h"

#include <math.h>

double ovr_flow_factor_at(const ovr_flow_factor *f, double h, double *slope)
{
    static const double C[] = {0, 0.9, 1.48, 0.87};
    static const double r[] = {0, 0.56, 0.42, 1.5};
    static const double minimum[] = {0, 0.5, 1, 0.5};
    double x = h / f->sigma, held = fmax(x, minimum[f->ridges]), part;
    *slope = 0;
    if (f->ridges == OVR_RIDGES_NONE)
        return 1;
    if (f->ridges == OVR_RIDGES_LONGITUDINAL) {
        part = C[f->ridges] * pow(held, -r[f->ridges]);
        *slope = x < held ? 0 : -r[f->ridges] * part / held / f->sigma;
        return 1 + part;
    }
    part = C[f->ridges] * exp(-r[f->ridges] * held);
    *slope = x < held ? 0 : r[f->ridges] * part / f->sigma;
    return 1 - part;
}

double ovr_flow_factor_film(const ovr_flow_factor *f, double lambda)
{
    enum { STEPS = 200 };
    double grown = 1, slope;
    for (int k = 0; k < STEPS; k++) {
        double phi = ovr_flow_factor_at(f, 2 * lambda * grown * f->sigma,
                                        &slope);
        grown = 0.5 * (grown + pow(phi, -0.7));
    }
    return grown;
}
