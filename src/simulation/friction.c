/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Friction as it is observed (equations in multigrid/friction.h).
 *
 *     u1, u2 = Cu +- V/2, V = (u1 - u2)/um0
 *     mu = kappa F/int P dX,  kappa = b/R
 *     put in      -(F_1 u1 + F_2 u2) = -V F_slide + 2 Cu F_roll
 *     dissipated  -V F_slide + int (eps/rho) P_X^2 dX
 *
 * The load is the asked for one, Cw pi/2.  The rolling friction is the small
 * difference of two large forces: it comes from its own integral.  In a steady
 * film both powers are equal; else compression and squeeze stand between.
 */
#include <math.h>

#include "contact/contact.h"
#include "simulation/physics.h"
#include "simulation/simulation.h"

double ovr_sliding(const ovr_simulation *sim, double T)
{
    return ovr_slip_at(&sim->contact, sim->speed, sim->sliding, T);
}

void ovr_simulation_sliding(ovr_simulation *sim, const ovr_history *sliding)
{
    if (!sim)
        return;
    sim->sliding = sliding;
}

void ovr_observe_friction(ovr_simulation *sim, ovr_observation *o)
{
    const ovr_kernels *run = sim->grids.kernels;
    const ovr_solution *now = &sim->now;
    const ovr_sheared film = {now->n, now->X,   now->P,   now->H,
                              now->q, now->eps, now->flow};
    double V = ovr_sliding(sim, sim->state.T),
           load = OVR_NOMINAL_LOAD * o->load_ratio;
    double coefficient = load > 0 ? sim->contact.kappa / load : NAN;
    ovr_fluid fluid = sim->grids.fluid;
    OVR_LAST_PHYSICS(sim, own, stress);
    fluid.sliding = V;
    o->sliding = V;
    if (own->is)
        own->is->stress(sim, own->own, &film, &fluid, sim->stress);
    else
        run->mean_stress(&film, &fluid, sim->stress);
    if (sim->lubricant.limiting_shear > 0)
        o->limiting_share = run->limit_stress(
            &film, sim->lubricant.limiting_shear / sim->contact.kappa,
            sim->stress);
    OVR_EACH_PHYSICS(sim, p, friction)
        p->is->friction(sim, p->own, sim->stress);
    ovr_friction f = run->friction(&film, sim->stress);
    o->F_slide = f.slide;
    o->F_roll = f.roll;
    o->F_1 = f.slide - f.roll;
    o->F_2 = -f.slide - f.roll;
    o->mu_1 = coefficient * o->F_1;
    o->mu_2 = coefficient * o->F_2;
    o->mu_slide = copysign(coefficient * f.slide, V);
    o->mu_roll = coefficient * f.roll;
    o->power_in = 2 * o->speed_ratio * f.roll - V * f.slide;
    o->power_dissipated = f.poiseuille - V * f.slide;
}

/* t -+ H P_X/2 */
const double *ovr_wall_stress(const ovr_simulation *sim, int surface,
                              double *workspace)
{
    const double *X = sim->now.X, *P = sim->now.P, *H = sim->now.H;
    double side = surface == 1 ? -0.25 : 0.25;
    for (size_t i = 0; i + 1 < sim->now.n; i++)
        workspace[i] = sim->stress[i] + side * (H[i] + H[i + 1]) *
                                            (P[i + 1] - P[i]) /
                                            (X[i + 1] - X[i]);
    return workspace;
}
