/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Mean shear stress and friction (equations in friction.h). */
#include <math.h>

#include "multigrid/plain.h"

#include "multigrid/faces.h"
#include "multigrid/flow.h"

static bool wet(const ovr_sheared *f, size_t i)
{
    return f->P[i] > 0 || f->P[i + 1] > 0;
}

/* H P_X/2 */
static double slope(const ovr_sheared *f, size_t i)
{
    double dX = f->X[i + 1] - f->X[i], dP = f->P[i + 1] - f->P[i];
    return (f->H[i] + f->H[i + 1]) / 4 * dP / dX;
}

static double thinning(const ovr_fluid *fluid, double c, double g)
{
    if (fluid->lubricant.rheology != OVR_EYRING)
        return copysign(fluid->lubricant.Sigma0 *
                            ovr_flow_stress(fluid->lubricant.flow_law, c, g),
                        -fluid->sliding);
    double B = fabs(g) > 1e-8 ? g / sinh(g) : 1,
           Sigma0 = fluid->lubricant.Sigma0;
    return copysign(Sigma0 * asinh(B * c), -fluid->sliding);
}

/* psi_c rho H^2 divided by eps */
static double slid(const ovr_sheared *f, bool gap, size_t i)
{
    const double *H = f->H + i, *q = f->q + i, *eps = f->eps + i;
    if (!gap)
        return (q[0] * H[0] + q[1] * H[1]) / fmax(eps[0] + eps[1], 1e-290);
    double a = face_film(H[0]), b = face_film(H[1]); /* H may be negative */
    double left = fmax(eps[0] / (a * a * a), 1e-290);
    double right = fmax(eps[1] / (b * b * b), 1e-290);
    double phi = f->P[i] > 0 && f->P[i + 1] > 0 ? 2 * sqrt(left) * sqrt(right)
                                                : left + right;
    return fmax(q[0] / a + q[1] / b, 0) /
           fmax(phi * face_sliding(a, b), 1e-290);
}

void ovr_mean_stress_plain(const ovr_sheared *f, const ovr_fluid *fluid,
                           double *t)
{
    double V = fluid->sliding, Sigma0 = fluid->lubricant.Sigma0;
    for (size_t i = 0; i + 1 < f->n; i++) {
        double ratio = slid(f, fluid->by_gap, i);
        t[i] = -V / 12 * ratio;
        if (ovr_flow_is_shear_thinning(fluid) && V != 0)
            t[i] = thinning(fluid, ovr_flow_slide(fluid) * ratio,
                            slope(f, i) / Sigma0);
        if (!wet(f, i))
            t[i] = 0;
    }
}

double ovr_limit_stress_plain(const ovr_sheared *f, double limit, double *t)
{
    double all = 0, cut = 0;
    for (size_t i = 0; i + 1 < f->n; i++) {
        double P = (f->P[i] + f->P[i + 1]) / 2;
        double maximum = fmax(limit * P - fabs(slope(f, i)), 0);
        double carried = P * (f->X[i + 1] - f->X[i]);
        all += carried;
        cut += fabs(t[i]) > maximum ? carried : 0;
        t[i] = fmax(-maximum, fmin(maximum, t[i]));
    }
    return all > 0 ? cut / all : 0;
}

ovr_friction ovr_friction_plain(const ovr_sheared *f, const double *t)
{
    ovr_friction sum = {0};
    for (size_t i = 0; i + 1 < f->n; i++) {
        double dX = f->X[i + 1] - f->X[i], dP = f->P[i + 1] - f->P[i];
        double H = (f->H[i] + f->H[i + 1]) / 2;
        double rho = (f->q[i] + f->q[i + 1]) / (2 * H);
        if (!wet(f, i))
            continue;
        sum.slide += t[i] * dX;
        sum.roll += H * dP / 2;
        double twice = f->flow ? f->flow[i] : f->eps[i] + f->eps[i + 1];
        sum.poiseuille += twice / 2 / rho * dP * dP / dX;
    }
    return sum;
}
