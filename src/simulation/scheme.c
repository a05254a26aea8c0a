/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "simulation/scheme.h"
#include "simulation/simulation.h"

static const ovr_discretization records[] = {
    [OVR_UPSTREAM1] = {"upstream1",
                       1,
                       {1, 0},
                       false,
                       ovr_backward_euler,
                       ovr_history_at_nodes,
                       ovr_linear_extrapolation},
    [OVR_UPSTREAM2] = {"upstream2",
                       2,
                       {1.5, -0.5},
                       false,
                       ovr_bdf2,
                       ovr_history_at_nodes,
                       ovr_quadratic_extrapolation},
    [OVR_CHARACTERISTIC] = {"characteristic",
                            2,
                            {1.5, -0.5},
                            true,
                            ovr_bdf2,
                            ovr_history_at_departures,
                            ovr_quadratic_extrapolation},
};

const ovr_discretization *ovr_scheme_record(ovr_scheme scheme)
{
    size_t k = (size_t)scheme;
    return k < sizeof records / sizeof *records ? &records[k] : NULL;
}

const char *ovr_smoother_name(ovr_smoother smoother)
{
    switch (smoother) {
    case OVR_LINE: return "line";
    case OVR_HYBRID: return "hybrid";
    case OVR_GAUSS_SEIDEL: return "gauss-seidel";
    case OVR_DIPOLE: return "dipole";
    }
    return "";
}

const char *ovr_scheme_name(ovr_scheme scheme)
{
    const ovr_discretization *record = ovr_scheme_record(scheme);
    return record ? record->name : NULL;
}
