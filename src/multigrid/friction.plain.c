/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Mean shear stress and friction (equations in friction.h). */
#include "multigrid/plain.h"

static bool wet(const ovr_sheared *f, size_t i)
{
    return f->P[i] > 0 || f->P[i + 1] > 0;
}

void ovr_mean_stress_plain(const ovr_sheared *f, double V, double *t)
{
    for (size_t i = 0; i + 1 < f->n; i++) {
        double drag = f->q[i] * f->H[i] + f->q[i + 1] * f->H[i + 1];
        t[i] = wet(f, i) ? -V / 12 * drag / (f->eps[i] + f->eps[i + 1]) : 0;
    }
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
        sum.poiseuille += (f->eps[i] + f->eps[i + 1]) / 2 / rho * dP * dP / dX;
    }
    return sum;
}
