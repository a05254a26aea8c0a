/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A short list, until the simulation brings its own (weak: that one wins). */
#include "overroll/simulation.h"

#pragma weak ovr_observables
#pragma weak ovr_observable_value

#define ROW(name, kind, field)                                                 \
    {                                                                          \
        name, name, kind, offsetof(ovr_observation, field)                     \
    }
const ovr_observable *ovr_observables(void)
{
    static const ovr_observable list[] = {
        ROW("time", 'T', T),
        ROW("min_film_thickness", 'H', H_min_located),
        ROW("central_film_thickness", 'H', H_cen),
        ROW("max_pressure", 'P', P_max),
        ROW("spike_pressure", 'P', P_spike),
        ROW("rigid_approach", 'H', H0),
        ROW("load", '1', load),
        ROW("residual", '1', residual),
        ROW("cycles", 'i', cycles),
        ROW("converged", 'b', converged),
        {NULL, NULL, 0, 0}};
    return list;
}

double ovr_observable_value(const ovr_observable *o, const ovr_observation *v)
{
    const char *at = (const char *)v + o->offset;
    if (o->kind == 'i')
        return *(const int *)(const void *)at;
    if (o->kind == 'b')
        return *(const bool *)(const void *)at;
    return *(const double *)(const void *)at;
}
