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
 */
#include <math.h>

#include "simulation/internal.h"

static double distance(const ovr_level *level, const double *a, size_t stride,
                       const double *b)
{
    return ovr_grid_distance(&level->grid, a, stride, b) / OVR_NOMINAL_LOAD;
}

static void note(ovr_simulation *sim, const ovr_level *level,
                 const ovr_full_status *status)
{
    ovr_refinement *to = &sim->refinement[sim->refinements++];
    double *now = sim->scratch[0], *before = sim->scratch[1];
    double q = status->factor < 0.95 ? status->factor : 0.95;
    *to = (ovr_refinement){.level = level->number,
                           .nodes = level->grid.n,
                           .cycles = status->cycles,
                           .residual = status->defect.imbalance,
                           .factor = status->factor,
                           .H_cen = status->defect.centre};
    ovr_level_read(&sim->grids, level, level->f.H, now);
    to->H_min =
        now[1 + sim->grids.kernels->extreme(level->grid.n - 2, 1, now + 1)];
    ovr_level_read(&sim->grids, level, level->f.P, now);
    ovr_level_read(&sim->grids, level, level->f.entry, before);
    if (status->cycles)
        to->change = distance(level, now, 1, before);
    to->algebraic = to->change * q / (1 - q);
    to->difference = distance(level - 1, now, 2, sim->saved);
}

void ovr_refinement_watch(void *data, const ovr_level *level,
                          ovr_full_event event, const ovr_full_status *status)
{
    ovr_simulation *sim = data;
    double *P = event == OVR_FULL_BEGINS ? sim->saved : sim->scratch[0];
    if (event == OVR_FULL_ENDS) {
        note(sim, level, status);
        return;
    }
    ovr_level_read(&sim->grids, level, level->f.P, P);
    if (event == OVR_FULL_CYCLES)
        ovr_level_write(&sim->grids, level, P, level->f.entry);
}

const ovr_refinement *ovr_simulation_refinements(const ovr_simulation *sim,
                                                 int *count)
{
    if (!sim || !count)
        return NULL;
    *count = sim->refinements;
    return sim->refinement;
}
