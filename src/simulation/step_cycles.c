/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "simulation/step_cycles.h"

#include <math.h>

#include "multigrid/film_end.h"
#include "simulation/physics.h"

/*
 * A twentieth of the steady one: errors of many steps meet in one film.  The
 * exact discrete series of level 7 are then met to 3e-7.
 * A residual that nothing has relaxed since the last correction is rough and
 * moves the film less: with three times the tolerance the series of dents,
 * waves and ramps are nearer to the converged ones than relaxed ones are.
 */
static double tolerance_of(const ovr_simulation *sim, bool relaxed)
{
    double D = ovr_mesh(sim), H = sim->observation.H_cen;
    double share = relaxed ? 0.05 : 0.15;
    double tolerance = share * ovr_truncation_tolerance(sim, D, H);
    double least = ovr_negligible_tolerance(sim, D, H);
    if (sim->options.tolerance > 0)
        return sim->options.tolerance;
    return tolerance > least ? tolerance : least;
}

/* Of the nominal load, or of the load where that is larger: half of what a run
 * may be off by (overroll(1)). */
static bool carries(const ovr_simulation *sim, const ovr_defect *defect)
{
    const double most = 5e-5;
    double ratio = sim->finest->force / OVR_NOMINAL_LOAD;
    return defect->load * fmin(ratio, 1) <= most;
}

static void settle_ends(const ovr_hierarchy *grids, ovr_level *finest)
{
    if (!grids->conserving)
        ovr_film_ends(grids, finest);
}

/* One cycle at least: the extrapolated guess satisfies the equations to some
 * tolerance at best, and a load that ramps would drift within it. */
bool ovr_step_cycles(ovr_simulation *sim, ovr_step_cycling how,
                     ovr_outcome *outcome)
{
    enum { SHORT_CYCLES = 3 };
    ovr_hierarchy *grids = &sim->grids;
    ovr_cycling c = how.cycle;
    bool solved;
    ovr_level_refresh(grids, sim->finest);
    settle_ends(grids, sim->finest);
    for (int cycle = 0, after = c.sweeps_after;; cycle++) {
        double wanted = tolerance_of(sim, c.sweeps_after > 0);
        outcome->defect = ovr_cycle_defect(grids, sim->finest);
        solved = cycle && carries(sim, &outcome->defect) &&
                 ovr_below(outcome->defect,
                           wanted > how.tolerance ? wanted : how.tolerance);
        if (solved || cycle == how.most ||
            !(outcome->defect.imbalance < how.hopeless))
            break;
        c.sweeps_after = how.close && cycle < SHORT_CYCLES ? 0 : after;
        ovr_cycle(grids, sim->finest, c);
        settle_ends(grids, sim->finest);
        OVR_EACH_PHYSICS(sim, p, anew)
            p->is->anew(sim, p->own);
        outcome->cycles++;
    }
    ovr_simulation_read(sim);
    return solved && ovr_surfaces_apart(sim);
}
