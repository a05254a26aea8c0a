/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The share of its pressure that the film carries as shear stress, at the end
 * of a run: the largest ratio of both where the pressure is a fifth of Hertz's
 * at least, and the share of those nodes where it is above a tenth, which oils
 * do not carry.  A Newtonian isothermal film has such stresses wherever it is
 * pressed and slides; its thickness and pressure are none the worse for it, so
 * this belongs beside its friction.
 */
#include <math.h>

#include "run/internal.h"
#include "simulation/simulation.h"

static const double CARRIED = 0.1, CARRIES = 0.2;

void ovr_run_shear(ovr_run *run)
{
    const ovr_state *state = ovr_simulation_state(run->sim);
    const double *stress = ovr_film_stress(run->sim);
    double kappa = run->setup->contact->kappa;
    double maximum = 0, count = 0, beyond = 0;
    for (size_t i = 0; i + 1 < state->n; i++) {
        double P = (state->P[i] + state->P[i + 1]) / 2;
        double t = kappa * fabs(stress[i]);
        if (P < CARRIES)
            continue;
        count++;
        beyond += t > CARRIED * P;
        maximum = fmax(maximum, t / P);
    }
    run->info.shear_over_pressure = isnan(kappa) ? NAN : maximum;
    run->info.unbearable_share = isnan(kappa) || count == 0 ? NAN
                                                            : beyond / count;
}
