/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Oil that is still before the inlet. */
#include "contact/contact.h"
#include "simulation/internal.h"

bool ovr_conserves(const ovr_simulation *sim)
{
    return sim->options.cavitation == OVR_CAVITATION_CONSERVING;
}

/* The time when what is `way` before the inlet at T comes to it; while all
 * stands, some time later. */
static double time_of_arrival(const ovr_simulation *sim, double T, double way)
{
    enum { DOUBLINGS = 10, HALVINGS = 50 };
    double to = ovr_history_integral(sim->speed, T) + way;
    double low = T, high = T + way, Cu = ovr_history_value(sim->speed, T);
    if (!ovr_history_varies(sim->speed))
        return T + way / Cu;
    for (int k = 0; k < DOUBLINGS; k++)
        if (ovr_history_integral(sim->speed, high) < to)
            high = T + 2 * (high - T);
    for (int k = 0; k < HALVINGS; k++) {
        double middle = 0.5 * (low + high);
        *(ovr_history_integral(sim->speed, middle) < to ? &low
                                                        : &high) = middle;
    }
    return 0.5 * (low + high);
}

bool ovr_arrival_closes(const ovr_simulation *sim)
{
    const ovr_arrival *a = &sim->arrival;
    return a->supply && (a->closed || a->reservoir < 0);
}

void ovr_arrival_ghosts(const ovr_simulation *sim, double T, size_t ghosts,
                        double *last)
{
    const ovr_arrival *a = &sim->arrival;
    for (size_t g = 0; g < ghosts; g++) {
        double way = (double)(g + 1) * ovr_mesh(sim);
        last[-(ptrdiff_t)g] = a->supply(a->data, time_of_arrival(sim, T, way));
    }
}
