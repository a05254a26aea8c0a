/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The time loop: knows steps and an observer, nothing of files. */
#include <math.h>

#include "simulation/internal.h"

/* Nothing changes any more: a step moved film and pressure by less than the
 * algebraic tolerance, some steps in a row. */
enum { STILL = 20 };

static ovr_status observe(ovr_simulation *sim, const ovr_march *march,
                          ovr_error *err)
{
    return march->observe ? march->observe(march->data, sim, err) : OVR_OK;
}

ovr_status ovr_simulation_march(ovr_simulation *sim, const ovr_march *march,
                                ovr_error *err)
{
    double dT = march->dT > 0 ? march->dT : sim->finest->D;
    ovr_status status = OVR_OK;
    if (sim->state.step == 0)
        status = observe(sim, march, err);
    while (!status && sim->state.T < march->end - 1e-9 * dT) {
        /* the k-th time is k dT, without the rounding of a sum */
        double next = (double)(sim->state.step + 1) * dT;
        status = ovr_simulation_step(sim, next - sim->state.T, err);
        if (!status) {
            sim->state.T = sim->past.T[0] = next;
            status = observe(sim, march, err);
        }
    }
    return status;
}
