/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Convergence to the truncation error, checked as the paper does: converged
 * solutions of successive levels against each other.  All in the norm
 *     |P| = D sum |P_i| / (pi/2),
 * the load that a pressure carries relative to the nominal one.
 *   difference  |P^l - P^(l-1)| at the nodes of level l-1: the discretization
 *               error of the coarser one, nearly;
 *   change      |dP| of the last cycle on level l;
 *   algebraic   change q/(1 - q), q the last cycle's factor on the residual:
 *               what all further cycles would change.
 * The arrays of the past are free while a steady solution is made.
 */
#include <math.h>

#include "simulation/internal.h"

static double distance(const double *a, size_t stride, const double *b,
                       size_t n, double D)
{
    double sum = 0;
    for (size_t i = 0; i < n; i++)
        sum += fabs(a[stride * i] - b[i]);
    return D * sum / OVR_NOMINAL_LOAD;
}

void ovr_refinement_coarse(ovr_simulation *sim, const ovr_level *level)
{
    ovr_level_read(&sim->grids, level, level->f.P, sim->past.P[2]);
}

void ovr_refinement_cycle(ovr_simulation *sim, const ovr_level *level)
{
    ovr_level_read(&sim->grids, level, level->f.P, sim->past.P[1]);
}

static double smallest(const double *H, size_t n)
{
    double least = H[1];
    for (size_t i = 2; i + 1 < n; i++)
        if (H[i] < least)
            least = H[i];
    return least;
}

void ovr_refinement_note(ovr_simulation *sim, const ovr_level *level,
                         int cycles, double factor, const ovr_defect *d)
{
    ovr_refinement *to = &sim->refinement[sim->refinements++];
    double q = factor < 0.95 ? factor : 0.95;
    *to = (ovr_refinement){.level = level->number,
                           .nodes = level->n,
                           .cycles = cycles,
                           .residual = d->imbalance,
                           .factor = factor,
                           .H_cen = d->centre};
    ovr_level_read(&sim->grids, level, level->f.H, sim->work);
    to->H_min = smallest(sim->work, level->n);
    ovr_level_read(&sim->grids, level, level->f.P, sim->work);
    to->change =
        cycles ? distance(sim->work, 1, sim->past.P[1], level->n, level->D) : 0;
    to->algebraic = to->change * q / (1 - q);
    to->difference = distance(sim->work, 2, sim->past.P[2], (level - 1)->n,
                              (level - 1)->D);
}

const ovr_refinement *ovr_simulation_refinements(const ovr_simulation *sim,
                                                 int *count)
{
    *count = sim->refinements;
    return sim->refinement;
}
