/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Film, properties and Reynolds coefficient (equations in film.kernel.c). */
#include "multigrid/plain.h"

#include "contact/laws/fluid.h"
#include "contact/laws/law.h"

/* log2(1/eta), and the derivatives of ln eta with respect to P and H */
static double viscosity(const ovr_fluid *fluid, const fluid_laws *c, double P,
                        double H, double slope[2])
{
    ovr_viscosity_law law = fluid->lubricant.viscosity_law;
    double divisor = viscosity_divisor(c, law, P), power;
    slope[1] = 0;
    if (fluid->law) {
        const ovr_law_nodes node = {1, &P, &H, &power, slope, slope + 1};
        fluid->law->at(fluid->law, &node);
        return power;
    }
    power = viscosity_begin(c, law, P, divisor, 1 / divisor, slope);
    return viscosity_finish(c, law, power, slope);
}

void ovr_film_plain(const ovr_fluid *fluid, double H0, const ovr_lanes *g,
                    const double *gap, const double *w, const ovr_fields *f)
{
    fluid_laws c = {0};
    fluid_laws_make(&fluid->lubricant, &c);
    for (size_t i = 0; i < g->n; i++) {
        double P = f->P[i], H = H0 + gap[i] - w[i], by_pressure, slope[2];
        double rho = density_at(&c, fluid->lubricant.density_law, P,
                                &by_pressure);
        double power = viscosity(fluid, &c, P, H, slope), q = rho * H, flow;
        if (f->th) {
            power = f->th[i] * power + f->shift[i];
            slope[0] *= f->th[i];
        }
        if (f->swell) {
            rho *= f->swell[i];
            by_pressure *= f->swell[i];
            q = rho * H;
        }
        power = fmax(power, -900);
        if (f->log_fluidity) {
            f->log_fluidity[i] = power;
            f->log_slope[i] = -slope[0];
        }
        flow = H * H * exp2(power) / fluid->lambda;
        f->H[i] = H;
        f->rho[i] = rho;
        f->q[i] = q;
        f->dq[i] = by_pressure * H;
        f->eps[i] = q * flow;
        f->deps[i] = (f->dq[i] - q * slope[0]) * flow;
        if (f->deps_dH)
            f->deps_dH[i] = (3 * rho - q * slope[1]) * flow;
    }
}

double ovr_flow(const ovr_fluid *fluid, double P, double H)
{
    double value[6] = {P}, zero = 0;
    const ovr_fields f = {.P = value,
                          .H = value + 1,
                          .rho = value + 2,
                          .q = value + 3,
                          .dq = value + 4,
                          .eps = value + 5,
                          .deps = value + 4};
    ovr_film_plain(fluid, H, &(ovr_lanes){1, 1, 1}, &zero, &zero, &f);
    return *f.eps;
}
