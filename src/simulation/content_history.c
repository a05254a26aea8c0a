/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The history term where cavitation is mass-conserving (multigrid/content.h),
 * with s = dT/dT_old, kappa = s/(1 + s), b2 = s^2/(1 + s):
 *
 *     F = -(B + kappa q^k)/dT,   B = (1 + b2) q^k - b2 q^{k-1},
 *     where the node was dry  B = max(B, q^k/2)
 *
 * which is BDF2's wherever nothing is limited.  With equal steps B is what the
 * last step ended with, A, so that what is stored telescopes.
 */
#include "simulation/internal.h"

void ovr_content_history(ovr_simulation *sim, double dT, const double c[2])
{
    const double *const *q = (const double *const *)sim->past.q;
    const double *P = sim->past.P[0];
    double *F = sim->scratch[0], *kept = sim->scratch[1];
    if (sim->scheme->characteristic) {
        ovr_carriage_history(sim, dT, c);
        return;
    }
    double b2 = c[1] * dT, kappa = -c[0] * dT - 1 - b2;
    if (sim->scheme->order == 1)
        kappa = 0;
    double half = -(0.5 + kappa) / dT, keeps = kappa / dT;
    for (size_t i = 0; i < sim->now.n; i++) {
        double linear = (1 + b2) * q[0][i] - b2 * q[1][i];
        bool limited = !(P[i] > 0) && linear < 0.5 * q[0][i];
        F[i] = limited ? half * q[0][i] : c[0] * q[0][i] + c[1] * q[1][i];
        kept[i] = keeps * q[0][i];
    }
    ovr_level_write(&sim->grids, sim->finest, F, sim->finest->f.F);
    ovr_level_write(&sim->grids, sim->finest, kept, sim->finest->f.kept);
}
