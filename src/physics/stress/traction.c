/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The film's shear stress as a traction on the body below it, along +X:
 *
 *     Q_1 = kappa tau_1,   Q_2 = -kappa tau_2      (p_h; kappa = b/R)
 *
 * tau_1, tau_2 being tau_xz in the film at the surfaces, z from 1 to 2: the
 * film lies above body 1 and below body 2, whose outward normals are z and -z.
 * In each body x goes along the surface and depth into it, so that the stresses
 * follow from P and Q in the same way.  At a node it is the mean of the half
 * nodes beside it, as files hold it: order 2.
 *
 * What a tangential load does to the gap is left out: for two bodies of the
 * same material it is nothing (K. L. Johnson, Contact Mechanics, 1985, section
 * 7.1).
 */
#include <string.h>

#include "physics/stress/stress.h"
#include "simulation/simulation.h"

static const char *name_of(const ovr_stress_plan *plan)
{
    return plan->surface == 1 ? "shear_stress_1" : "shear_stress_2";
}

const double *ovr_traction_now(const ovr_stress_plan *plan,
                               const ovr_simulation *sim, double *workspace)
{
    const ovr_observable *shear = ovr_observable_field(name_of(plan));
    size_t last = plan->options.nodes - 1;
    double before, *Q = workspace;
    if (!plan->options.traction)
        return NULL;
    const double *tau = shear->field(sim, workspace); /* may lie in workspace */
    before = tau[0];
    for (size_t i = 0; i <= last; i++) {
        double behind = i < last ? tau[i] : before;
        Q[i] = plan->traction * (before + behind) / 2;
        before = behind;
    }
    return Q;
}

ovr_status ovr_traction_stored(const ovr_stress_plan *plan, ovr_result *result,
                               size_t k, double *workspace, ovr_error *err)
{
    ovr_status status;
    if (!plan->options.traction)
        return OVR_OK;
    status = ovr_result_snapshot(result, name_of(plan), k, OVR_HERTZIAN,
                                 workspace, err);
    for (size_t i = 0; !status && i < plan->options.nodes; i++)
        workspace[i] *= plan->traction;
    return status;
}

bool ovr_traction_is_stored(const ovr_stress_plan *plan,
                            const ovr_result *result)
{
    return ovr_result_find(result, name_of(plan)) != NULL;
}
