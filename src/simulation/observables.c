/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The list of observed quantities. */
#include <stddef.h>

#include "overroll/simulation.h"

#define ROW(name, kind, field, text)                                           \
    {                                                                          \
        name, text, kind, offsetof(ovr_observation, field)                     \
    }

const ovr_observable *ovr_observables(void)
{
    static const ovr_observable table[] = {
        ROW("time", 'T', T, "time"),
        ROW("time_step", 'T', dT, "length of the step"),
        ROW("min_film_thickness", 'H', H_min_located,
            "minimum film thickness, located between nodes"),
        ROW("x_min_film_thickness", 'X', X_min_located,
            "where the film is thinnest"),
        ROW("central_film_thickness", 'H', H_cen,
            "film thickness at the centre of the contact"),
        ROW("central_pressure", 'P', P_cen,
            "pressure at the centre of the contact"),
        ROW("max_pressure", 'P', P_max, "maximum pressure"),
        ROW("x_max_pressure", 'X', X_P_max, "where the pressure is largest"),
        ROW("spike_pressure", 'P', P_spike_located,
            "pressure of the spike, located between nodes"),
        ROW("x_spike", 'X', X_spike_located, "where the spike is"),
        ROW("pressure_maxima", 'i', maxima, "local maxima of the pressure"),
        ROW("rigid_approach", 'H', H0, "H0 of the film equation"),
        ROW("load", '1', load, "integral of P, pi/2 at nominal load"),
        ROW("load_ratio", '1', load_ratio, "wanted load over nominal load"),
        ROW("load_error", '1', load_error,
            "integral of P less the wanted one, relative to the nominal"),
        ROW("speed_ratio", '1', speed_ratio,
            "entrainment speed over nominal speed"),
        ROW("mass_flow", '1', mass_flow,
            "mean mass flow rho H - eps dP/dX through the film"),
        ROW("mass_balance", '1', mass_balance,
            "inflow - outflow - stored change, relative to the inflow"),
        ROW("x_cavitation", 'X', X_cavitation,
            "first node without pressure behind the last with"),
        ROW("residual", '1', residual, "relative mass-flow imbalance"),
        ROW("cycles", 'i', cycles, "multigrid cycles of the step"),
        ROW("retries", 'i', retries, "attempts after the first"),
        ROW("converged", 'b', converged, "below tolerance"),
        ROW("marked", 'b', marked, "accepted above tolerance"),
        {NULL, NULL, 0, 0}};
    return table;
}

double ovr_observable_value(const ovr_observable *which,
                            const ovr_observation *from)
{
    const char *at = (const char *)from + which->offset;
    switch (which->kind) {
    case 'i': return *(const int *)(const void *)at;
    case 'b': return *(const bool *)(const void *)at;
    default: return *(const double *)(const void *)at;
    }
}
