/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "simulation/step_cycles.h"

#include <math.h>

#include "multigrid/film_end.h"
#include "multigrid/spot.h"
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
    double minimum = ovr_negligible_tolerance(sim, D, H);
    if (sim->options.tolerance > 0)
        return sim->options.tolerance;
    return tolerance > minimum ? tolerance : minimum;
}

/* Allows a share of the nominal load, or of the load where that is larger: half
 * of what a run may be off by (overroll(1)). */
static bool carries(const ovr_simulation *sim, const ovr_defect *defect)
{
    const double maximum = 5e-5;
    double ratio = sim->finest->force / OVR_NOMINAL_LOAD;
    return defect->load * fmin(ratio, 1) <= maximum;
}

/*
 * Where the guess is far off, features move by a good part of their width in a
 * step, and the step's own error is as large (Milne's device: both are the
 * order's next difference).  R need not fall below 1e-4 of what it was at the
 * guess, nor beyond 300 times that of smooth features: on rough surfaces at
 * level 9 that moves the film by 7e-6, where mesh and step make 5e-4.
 */
static double tolerance_by_guess(const ovr_simulation *sim, double guess)
{
    const double share = 1e-4, maximum = 300, on_any_mesh = 1e-3;
    if (sim->options.tolerance > 0)
        return 0;
    return fmin(fmin(share * guess, on_any_mesh),
                maximum * tolerance_of(sim, true));
}

/* Where a guess is far off, or the first cycle has left it so. */
static void settle_spots(const ovr_hierarchy *grids, ovr_level *finest,
                         int times)
{
    while (!grids->touch.at && times-- > 0 && ovr_spots(grids, finest))
        continue;
}

static void settle_ends(const ovr_hierarchy *grids, ovr_level *finest)
{
    if (!grids->conserving && !grids->touch.at)
        ovr_film_ends(grids, finest);
}

/*
 * Sweeps after the coarse correction are left out where they spoil it.  In
 * thick films (H of 4 and more on an inlet some 30 b long, M below 1) long
 * smooth changes of the pressure grow in a sweep, as what it leaves out of the
 * derivatives, d eps/dH and the wedge's farthest column, is not small beside
 * what it has: cycles with a sweep after the correction reduce R to 0.96 or
 * make it grow, those without to 0.12.  Elsewhere R falls to a hundredth a
 * cycle.  Where R is above 10, spikes settle that are slow without it.
 */
typedef struct slowness {
    double last;
    int cycles; /* running, that were slow */
} slowness;

static bool is_spoilt(slowness *s, double R)
{
    const double spiky = 10, slow = 0.7;
    bool was = R < spiky && R > slow * s->last;
    s->cycles = was ? s->cycles + 1 : 0;
    s->last = R;
    return s->cycles >= 2;
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
    double loose = 0;
    slowness slow = {.last = INFINITY};
    ovr_level_refresh(grids, sim->finest);
    settle_spots(grids, sim->finest, 2);
    settle_ends(grids, sim->finest);
    for (int cycle = 0, after = c.sweeps_after;; cycle++) {
        double target = tolerance_of(sim, c.sweeps_after > 0);
        outcome->defect = ovr_cycle_defect(grids, sim->finest);
        if (!cycle)
            loose = tolerance_by_guess(sim, outcome->defect.imbalance);
        target = fmax(target, loose);
        solved = cycle && carries(sim, &outcome->defect) &&
                 ovr_below(outcome->defect,
                           target > how.tolerance ? target : how.tolerance);
        if (solved || cycle == how.maximum ||
            !(outcome->defect.imbalance < how.hopeless))
            break;
        if (is_spoilt(&slow, outcome->defect.imbalance))
            after = 0;
        c.sweeps_after = how.close && cycle < SHORT_CYCLES ? 0 : after;
        ovr_cycle(grids, sim->finest, c);
        if (!cycle)
            settle_spots(grids, sim->finest, 1);
        settle_ends(grids, sim->finest);
        OVR_EACH_PHYSICS(sim, p, anew)
            p->is->anew(sim, p->own);
        outcome->cycles++;
    }
    ovr_simulation_read(sim);
    return solved && ovr_surfaces_apart(sim);
}
