/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The numbers and arrays that define the state between two steps, by name.
 * Observations are not included, because they are computed from the state;
 * exceptions are solver statistics of the last step and totals. The domain is
 * included for programs that recreate the simulation. */
#include <math.h>
#include <stddef.h>
#include <stdio.h>

#include "base/given.h"
#include "simulation/observe.h"
#include "simulation/physics.h"
#include "simulation/simulation.h"
#include "simulation/steady.h"

/* Numbers of the state and their addresses in a simulation. */
#define PART(name, member)                                                     \
    {                                                                          \
        name, offsetof(ovr_simulation, member),                                \
            sizeof(((ovr_simulation *)0)->member)                              \
    }
static const struct {
    const char *name;
    size_t offset, bytes;
} parts[] = {PART("H0_past", past.H0),
             PART("T_past", past.T),
             PART("dT", past.dT),
             PART("steps_past", past.steps),
             PART("still", past.still),
             PART("dT_next", past.dT_next),
             PART("change", past.change),
             PART("failures", past.failures),
             PART("step", state.step),
             PART("T", state.T),
             PART("time_step", observation.dT),
             PART("residual", observation.residual),
             PART("cycles", observation.cycles),
             PART("retries", observation.retries),
             PART("converged", observation.converged),
             PART("marked", observation.marked),
             PART("step_order", observation.order),
             PART("total_steps", statistics.steps),
             PART("total_cycles", statistics.cycles),
             PART("total_retries", statistics.retries),
             PART("total_substeps", statistics.substeps),
             PART("total_marked", statistics.marked),
             PART("total_uncorrected", statistics.uncorrected),
             PART("flagged_extremes", statistics.flagged_extremes),
             PART("total_lagging", statistics.lagging),
             PART("last_across", statistics.last_cross_film),
             PART("mean_until", statistics.averaged),
             PART("unresolved_pressure", statistics.P_max_unresolved),
             PART("unresolved_height", statistics.P_unresolved),
             PART("unresolved_X", statistics.X_unresolved),
             PART("unresolved_T", statistics.T_unresolved),
             PART("finer_T_max", statistics.T_max_finer),
             PART("finer_T_max_T", statistics.T_T_max_finer),
             PART("defect_at_T_max", statistics.defect_at_T_max),
             PART("mean_film_at_least", statistics.H_mean_at_H_min),
             PART("settled", statistics.settled),
             PART("strategy", start.strategy),
             PART("inlet", options.inlet),
             PART("outlet", options.outlet),
             PART("level", options.level)};

static void visit_past(ovr_simulation *sim, ovr_pieces *state)
{
    for (size_t k = 0; k < OVR_FIELD_COUNT; k++)
        for (int ago = 0; ago < ovr_field_rows[k].past; ago++)
            ovr_show_nodes(sim, state, ovr_field_rows[k].name, ago + 1,
                           sim->past.all[k][ago]);
    for (int k = 0; k < OVR_GUESSES; k++) {
        char name[32];
        snprintf(name, sizeof name, "guess_error_%d", k + 1);
        OVR_SHOW(state, name, sim->past.guess_error[k]);
    }
}

/* The order of the run, which determines the other contents of the state. */
static void visit_order(ovr_simulation *sim, ovr_pieces *state)
{
    OVR_SHOW(state, "order", sim->order);
    if (!state->status && sim->order > sim->options.order)
        state->status = ovr_fail(state->err, OVR_BAD_INPUT,
                                 "the state is from a run of order %d, but "
                                 "this run is of order %d",
                                 sim->order, sim->options.order);
}

static void visit_asperity_P(ovr_simulation *sim, ovr_pieces *state)
{
    size_t bytes = sim->now.n * sizeof *sim->asperity_P;
    ovr_show(state, "borne", sim->asperity_P, bytes);
    ovr_show(state, "borne_1", sim->asperity_P_before[0], bytes);
    ovr_show(state, "borne_2", sim->asperity_P_before[1], bytes);
}

ovr_status ovr_simulation_visit(ovr_simulation *sim, ovr_visit *visit,
                                void *context, ovr_error *err)
{
    if (!sim || !visit)
        return ovr_fail_null(err, __func__);
    ovr_pieces state = {visit, context, err, OVR_OK};
    ovr_extreme e;
    visit_past(sim, &state);
    visit_order(sim, &state);
    if (sim->asperity_P)
        visit_asperity_P(sim, &state);
    OVR_EACH_PHYSICS(sim, p, in_step, visit)
        p->is->in_step->visit(sim, p->own, &state);
    for (size_t k = 0; k < sizeof parts / sizeof *parts; k++)
        ovr_show(&state, parts[k].name, (char *)sim + parts[k].offset,
                 parts[k].bytes);
    /* extremes and means over the run */
    for (size_t k = 0; ovr_extreme_at(k, &e); k++)
        ovr_show(&state, e.key, ovr_kept_number(&e, &sim->statistics),
                 sizeof(double));
    return state.status;
}

ovr_status ovr_simulation_visit_heights(ovr_simulation *sim, ovr_visit *visit,
                                        void *context, ovr_error *err)
{
    return visit(context, "S", sim->shapes.S, sim->now.n * sizeof(double), err);
}

/* Computes film thickness and properties from the pressure, and the observation
 * from these. */
void ovr_simulation_restored(ovr_simulation *sim)
{
    if (!sim)
        return;
    const ovr_observation seen = sim->observation;
    const ovr_outcome outcome = {.defect.imbalance = seen.residual,
                                 .cycles = seen.cycles,
                                 .retries = seen.retries,
                                 .converged = seen.converged,
                                 .marked = seen.marked,
                                 .uncorrected = seen.order > 0 &&
                                                seen.order < sim->order};
    ovr_steady_conditions(sim);
    ovr_steady_restored(sim);
    sim->grids.fluid = sim->target.fluid;
    OVR_EACH_PHYSICS(sim, p, in_step, restored)
        p->is->in_step->restored(sim, p->own);
    ovr_simulation_step_back(sim);
    ovr_observe(sim, seen.dT, &outcome);
    OVR_EACH_PHYSICS(sim, p, in_step, recalled)
        p->is->in_step->recalled(&sim->observation, &seen);
    sim->started = sim->restored = true;
}
