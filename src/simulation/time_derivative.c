/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Time in the discrete Reynolds equation (multigrid/reynolds.h): the operator
 * and the history term of a step.
 *
 * Backward Euler:  cT = 1/dT,   F = -q^k/dT
 * BDF2, s = dT/dT_old:
 *     cT dT = (1 + 2s)/(1 + s),  F dT = -(1 + s) q^k + s^2/(1 + s) q^{k-1}
 * At the first step the past is the steady solution, whatever its spacing.
 *
 * Along the characteristic dX/dT = Cu (after Venner & Lubrecht) wedge and
 * squeeze together are the derivative of q seen by a particle: no wedge on
 * the left, and q^k, q^{k-1} at the departure points X - a1, X - a2 of the
 * characteristic on the right.  With dT = D and Cu = 1 the departure points are
 * nodes.
 */
#include "simulation/scheme.h"

#include <math.h>

#include "contact/contact.h"
#include "simulation/mirror.h"
#include "simulation/physics.h"
#include "simulation/simulation.h"

/* -------------------------------------------------------------- Differences */

void ovr_backward_euler(double dT, double dT_old, double *cT, double c[2])
{
    (void)dT_old;
    *cT = 1 / dT;
    c[0] = -1 / dT;
    c[1] = 0;
}

void ovr_bdf2(double dT, double dT_old, double *cT, double c[2])
{
    double s = dT_old > 0 ? dT / dT_old : 1;
    *cT = (1 + 2 * s) / (1 + s) / dT;
    c[0] = -(1 + s) / dT;
    c[1] = s * s / (1 + s) / dT;
}

void ovr_history_term(ovr_simulation *sim, double *F)
{
    OVR_EACH_PHYSICS(sim, p, sides)
        p->is->sides(sim, p->own, F);
    ovr_nodes_write(sim, sim->finest, F, sim->finest->f.F);
}

void ovr_history_at_nodes(ovr_simulation *sim, const double c[2], double T)
{
    (void)T;
    double *F = sim->scratch[0];
    sim->grids.kernels->combine(sim->now.n, c[0], sim->past.q[0], c[1],
                                sim->past.q[1], F);
    ovr_history_term(sim, F);
}

void ovr_history_at_departures(ovr_simulation *sim, const double c[2], double T)
{
    const double a[2] = {ovr_travel_since(sim, 0, T),
                         ovr_travel_since(sim, 1, T)};
    ovr_inflow_history(sim, c, a);
    ovr_history_term(sim, sim->scratch[0]);
}

void ovr_time_derivative(ovr_simulation *sim, double dT)
{
    const ovr_discretization *scheme = sim->scheme;
    OVR_LAST_PHYSICS(sim, p, history);
    double T = sim->past.T[0] + dT, c[2];
    ovr_operator op = {.speed = fabs(ovr_history_value(sim->speed, T)),
                       .transient = true,
                       .characteristic = scheme->characteristic};
    scheme->difference(dT, sim->past.dT, &op.cT, c);
    if (!scheme->characteristic)
        ovr_reynolds_wedge(&op, scheme->order == 2, op.speed);
    OVR_EACH_PHYSICS(sim, each, operate)
        each->is->operate(sim, each->own, dT, &op);
    if (p->is)
        p->is->history(sim, p->own, dT, c);
    else
        scheme->history(sim, c, T);
    ovr_hierarchy_operator(&sim->grids, &op);
}

/* ------------------------------------------------------------------ Records */

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
