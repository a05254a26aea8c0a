/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The film of a steady solve, for the strategy that steady.c tries and for the
 * physics that solve in their own way. */
#include "simulation/steady.h"

#include <math.h>

#include "multigrid/starved.h"
#include "simulation/step_cycles.h"

/*
 * The tolerance of a level with film H at X = 0 so far.  On the way up a level
 * need not be better solved than its mesh is fine: fifty times the tolerance is
 * most often one cycle, and leaves less than the discretization error there.
 * The finest level ends in the same place (algebraic over discretization error
 * at M = 20, L = 10, levels 8, 10 and 12: 0.020, 0.022, 0.006 after two cycles
 * on it, 0.015, 0.017, 0.000 when all levels had two), a fifth sooner.  Rough
 * surfaces have waves of a few meshes: what is negligible beside the mesh's
 * error of a smooth film is far below that of theirs.
 */
double ovr_steady_tolerance(const void *data, const ovr_level *level, double H)
{
    const ovr_simulation *sim = data;
    const double on_the_way = 50, rough = 1e-6;
    const ovr_options *o = &sim->options;
    double truncation = ovr_truncation_tolerance(
        sim, ovr_grid_mesh(&level->grid), H);
    if (level != sim->finest)
        return on_the_way * truncation;
    if (o->tolerance > 0)
        return o->tolerance;
    if (o->stop == OVR_STOP_TRUNCATION)
        return truncation;
    return fmax(sim->grown ? rough : 0,
                ovr_negligible_tolerance(sim, ovr_grid_mesh(&level->grid), H));
}

int ovr_steady_max_cycles(const ovr_simulation *sim, int unless_given)
{
    return sim->options.max_cycles ? sim->options.max_cycles : unless_given;
}

ovr_defect ovr_steady_cycles(ovr_simulation *sim, const ovr_full *how,
                             int *cycles)
{
    ovr_full last = *how;
    last.fixed = false;
    if (sim->grown)
        return ovr_steady_settled(sim, how, cycles);
    if (sim->grids.conserving)
        return ovr_content_cycles(&sim->grids, &last, sim->finest, cycles);
    ovr_level_refresh(&sim->grids, sim->finest);
    return ovr_full_cycles(&sim->grids, sim->finest, &last, cycles);
}

ovr_defect ovr_steady_film(ovr_simulation *sim, const ovr_full *how,
                           int *cycles)
{
    if (sim->grown)
        return ovr_steady_grown(sim, how, cycles);
    return ovr_full_multigrid(&sim->grids, &sim->target, *how, cycles);
}

/* A fixed number of cycles has to reach the discretization error. */
bool ovr_steady_found(const ovr_simulation *sim, const ovr_outcome *outcome)
{
    int done = sim->refinements;
    if (!ovr_surfaces_apart(sim))
        return false;
    if (sim->options.stop == OVR_STOP_FIXED && done)
        return sim->refinement[done - 1].algebraic <=
               sim->refinement[done - 1].difference;
    return ovr_below(
        outcome->defect,
        ovr_steady_tolerance(sim, sim->finest, outcome->defect.centre));
}
