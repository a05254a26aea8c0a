/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Film, properties and Reynolds coefficient (equations in film.kernel.c). */
#include <math.h>

#include "multigrid/plain.h"

static double density_slope(const ovr_lubricant *law, double P)
{
    double A = law->A;
    if (law->density_law == OVR_DOWSON_HIGGINSON)
        return 0.34 * A / ((A + P) * (A + P));
    return 0;
}

/* ln eta and its derivative */
static double log_viscosity(const ovr_lubricant *law, double P, double *slope)
{
    double alphabar = law->alphabar, P0 = law->P0, z = law->z;
    switch (law->viscosity_law) {
    case OVR_ROELANDS:
        *slope = alphabar * pow(1 + P / P0, z - 1);
        return alphabar * P0 / z * expm1(z * log1p(P / P0));
    case OVR_BARUS: *slope = alphabar; return alphabar * P;
    case OVR_ISOVISCOUS: break;
    }
    *slope = 0;
    return 0;
}

void ovr_film_plain(const ovr_fluid *fluid, double H0, const ovr_lanes *g,
                    const double *gap, const double *w, const ovr_fields *f)
{
    const double solid = 900 * log(2); /* ln eta is held there */
    const ovr_lubricant *law = &fluid->lubricant;
    for (size_t i = 0; i < g->n; i++) {
        double P = f->P[i], H = H0 + gap[i] - w[i], slope;
        double rho = ovr_density(law, P), q = rho * H;
        double dq = density_slope(law, P) * H;
        double eta = exp(fmin(log_viscosity(law, P, &slope), solid));
        double flow = H * H / (eta * fluid->lambda);
        f->H[i] = H;
        f->rho[i] = rho;
        f->q[i] = q;
        f->dq[i] = dq;
        f->eps[i] = q * flow;
        f->deps[i] = (dq - q * slope) * flow;
        if (f->deps_dH)
            f->deps_dH[i] = 3 * rho * flow;
    }
}
