/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A run's simulation, from its case. */
#include <math.h>

#include "base/error.h"
#include "case/resolve.h"
#include "results/results.h"
#include "run/internal.h"
#include "run/pass_series.h"
#include "run/run.h"

void ovr_run_surface(const ovr_run *run, ovr_simulation *sim)
{
    if (!run->how.heights)
        return;
    ovr_simulation_surface(sim, run->how.heights, run->how.data);
    ovr_simulation_moving(sim, NAN);
    ovr_simulation_sides(sim, NULL, NULL);
}

/* Replaces the domain that the case describes by the one of the checkpoint: a
 * resumed run keeps its grid even if a changed key would choose another. */
static void set_recorded_domain(ovr_setup *setup, const ovr_restart_info *of)
{
    ovr_options *o = setup->options;
    ((ovr_resolved *)setup)->recorded = true;
    if (!of->has_state || of->level <= 0)
        return;
    o->inlet = of->inlet;
    o->outlet = of->outlet;
    o->level = of->level;
}

ovr_status ovr_run_set_up(ovr_run *run, ovr_error *err)
{
    const ovr_allocator *allocator = &run->arena.allocator;
    if (!run->setup)
        run->setup = ovr_case_resolve(run->c, allocator, err);
    if (!run->setup)
        return OVR_BAD_INPUT;
    if (run->restart)
        set_recorded_domain(run->setup, ovr_restart_about(run->restart));
    if (run->resumed && !run->passes && run->setup->passes->number > 1)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "%s: is one of several passes; 'overroll resume' goes "
                        "on with the file of all of them",
                        run->info.output);
    if (run->passes && ovr_passes_feed(run, err))
        return OVR_BAD_INPUT;
    run->sim = ovr_setup_simulation(run->setup, allocator, err);
    if (!run->sim)
        return OVR_BAD_INPUT;
    ovr_run_surface(run, run->sim);
    run->info.transient = run->setup->transient && !run->how.steady;
    run->info.setup = run->setup;
    run->info.lambda_ratio = run->info.life_together = NAN;
    run->info.elastic_length = run->info.elastic_ratio = NAN;
    run->info.shear_over_pressure = run->info.unbearable_share = NAN;
    run->info.sim = run->sim;
    if (ovr_setup_rough_film(run->setup, allocator, &run->foreseen, err))
        return OVR_NO_MEMORY;
    return run->how.steady ? OVR_OK : ovr_companions_make(run, err);
}
