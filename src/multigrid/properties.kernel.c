/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Lubricant properties and the Reynolds coefficient at all nodes:
 *
 *     rho = (A + 1.34 P)/(A + P)              Dowson-Higginson
 *     eta = exp(alphabar P0/z [t^z - 1]),  t = 1 + P/P0   Roelands
 *     eps = rho H^3/(eta lambda)
 *     d eps/dP (H fixed) = eps (rho'/rho - eta'/eta)
 *     eta'/eta = alphabar t^(z-1)
 *
 * One logarithm and two exponentials a node; Barus and isoviscous are the
 * same loop without them.
 */
#include "multigrid/kernels.h"
#include "multigrid/vector.h"

/* 1/eta, and eta'/eta in *slope */
static inline vec fluidity(const ovr_lubricant *law, vec P, vec *slope)
{
    if (law->viscosity_law == OVR_ISOVISCOUS) {
        *slope = all(0);
        return all(1);
    }
    if (law->viscosity_law == OVR_BARUS) {
        *slope = all(law->alphabar);
        return exponential(-law->alphabar * P);
    }
    vec t = 1 + P / law->P0;
    vec tz = exponential(law->z * logarithm(t));
    *slope = law->alphabar * tz / t;
    return exponential(law->alphabar * law->P0 / law->z * (1 - tz));
}

static inline vec density(const ovr_lubricant *law, vec P, vec *slope)
{
    if (law->density_law == OVR_INCOMPRESSIBLE) {
        *slope = all(0);
        return all(1);
    }
    vec inverse = 1 / (law->A + P);
    *slope = 0.34 * law->A * inverse * inverse;
    return (law->A + 1.34 * P) * inverse;
}

static inline void evaluate(const ovr_lubricant *law, double lambda, size_t n,
                            const ovr_fields *f)
{
    for (size_t i = 0; i < n; i += VEC) {
        vec P = load(f->P + i), H = load(f->H + i);
        vec rho_slope, eta_slope;
        vec rho = density(law, P, &rho_slope);
        vec eps = fluidity(law, P, &eta_slope) * rho * (H * H * H) / lambda;
        store(f->rho + i, rho);
        store(f->drho + i, rho_slope);
        store(f->q + i, rho * H);
        store(f->eps + i, eps);
        store(f->deps + i, eps * (rho_slope / rho - eta_slope));
    }
}

/* The laws as constants let the compiler make one loop for each. */
void OVR_KERNEL(properties)(const ovr_fluid *fluid, size_t n,
                            const ovr_fields *f)
{
    ovr_lubricant law = fluid->lubricant;
    if (law.viscosity_law == OVR_ROELANDS &&
        law.density_law == OVR_DOWSON_HIGGINSON) {
        law.viscosity_law = OVR_ROELANDS;
        law.density_law = OVR_DOWSON_HIGGINSON;
        evaluate(&law, fluid->lambda, n, f);
    } else {
        evaluate(&law, fluid->lambda, n, f);
    }
}
