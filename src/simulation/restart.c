/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The numbers and arrays that make up the state between two steps, by name.
 * What is observed of it is not among them but follows from them; of the step
 * just made stay how it was solved, and the totals.  The domain is among them
 * for who makes the simulation again. */
#include <math.h>
#include <stddef.h>
#include <stdio.h>

#include "base/given.h"
#include "simulation/physics.h"
#include "simulation/simulation.h"

/* The numbers, wherever a simulation has them. */
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
             PART("step", state.step),
             PART("T", state.T),
             PART("time_step", observation.dT),
             PART("residual", observation.residual),
             PART("cycles", observation.cycles),
             PART("retries", observation.retries),
             PART("converged", observation.converged),
             PART("marked", observation.marked),
             PART("total_steps", statistics.steps),
             PART("total_cycles", statistics.cycles),
             PART("total_retries", statistics.retries),
             PART("total_substeps", statistics.substeps),
             PART("total_marked", statistics.marked),
             PART("total_lagging", statistics.lagging),
             PART("last_across", statistics.last_cross_film),
             PART("mean_until", statistics.averaged),
             PART("mean_film_at_least", statistics.H_mean_at_H_min),
             PART("settled", statistics.settled),
             PART("strategy", strategy),
             PART("inlet", options.inlet),
             PART("outlet", options.outlet),
             PART("level", options.level)};

static ovr_status visit_past(ovr_simulation *sim, ovr_visit *visit,
                             void *context, ovr_error *err)
{
    size_t bytes = sim->now.n * sizeof(double);
    ovr_status status = OVR_OK;
    for (size_t k = 0; k < OVR_FIELD_COUNT; k++)
        for (int ago = 0; !status && ago < ovr_field_rows[k].past; ago++) {
            char name[32];
            snprintf(name, sizeof name, "%s_%d", ovr_field_rows[k].name,
                     ago + 1);
            status = visit(context, name, sim->past.all[k][ago], bytes, err);
        }
    for (int k = 0; !status && k < OVR_GUESSES; k++) {
        char name[32];
        snprintf(name, sizeof name, "guess_error_%d", k + 1);
        status = visit(context, name, &sim->past.guess_error[k],
                       sizeof sim->past.guess_error[k], err);
    }
    return status;
}

/* The order that the run has, which says what else it has. */
static ovr_status visit_order(ovr_simulation *sim, ovr_visit *visit,
                              void *context, ovr_error *err)
{
    ovr_status status = visit(context, "order", &sim->order, sizeof sim->order,
                              err);
    if (!status && sim->order > sim->options.order)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "the state is of a run of order %d, this one is of "
                        "order %d",
                        sim->order, sim->options.order);
    return status;
}

/* Extremes and means over the run. */
static ovr_status visit_kept(ovr_simulation *sim, ovr_visit *visit,
                             void *context, ovr_error *err)
{
    ovr_status status = OVR_OK;
    ovr_extreme e;
    for (size_t k = 0; !status && ovr_extreme_at(k, &e); k++)
        status = visit(context, e.saved, ovr_kept_number(&e, &sim->statistics),
                       sizeof(double), err);
    return status;
}

static ovr_status visit_borne(ovr_simulation *sim, ovr_visit *visit,
                              void *context, ovr_error *err)
{
    size_t bytes = sim->now.n * sizeof *sim->borne;
    ovr_status status = visit(context, "borne", sim->borne, bytes, err);
    if (!status)
        status = visit(context, "borne_1", sim->borne_before[0], bytes, err);
    if (!status)
        status = visit(context, "borne_2", sim->borne_before[1], bytes, err);
    return status;
}

ovr_status ovr_simulation_visit(ovr_simulation *sim, ovr_visit *visit,
                                void *context, ovr_error *err)
{
    if (!sim || !visit)
        return ovr_fail_null(err, __func__);
    ovr_status status = visit_past(sim, visit, context, err);
    if (!status)
        status = visit_order(sim, visit, context, err);
    if (!status && sim->borne)
        status = visit_borne(sim, visit, context, err);
    OVR_EACH_PHYSICS(sim, p, visit)
        if (!status)
            status = p->is->visit(sim, p->own, visit, context, err);
    for (size_t k = 0; !status && k < sizeof parts / sizeof *parts; k++)
        status = visit(context, parts[k].name, (char *)sim + parts[k].offset,
                       parts[k].bytes, err);
    return status ? status : visit_kept(sim, visit, context, err);
}

/* Film and properties follow from the pressure, and what is observed from
 * these. */
void ovr_simulation_restored(ovr_simulation *sim)
{
    if (!sim)
        return;
    const ovr_observation seen = sim->observation;
    const ovr_outcome outcome = {.defect.imbalance = seen.residual,
                                 .cycles = seen.cycles,
                                 .retries = seen.retries,
                                 .converged = seen.converged,
                                 .marked = seen.marked};
    ovr_steady_conditions(sim);
    sim->grids.fluid = sim->target.fluid;
    if (!sim->order) /* version 0.1.0 */
        sim->order = 2;
    OVR_EACH_PHYSICS(sim, p, restored)
        p->is->restored(sim, p->own);
    ovr_simulation_step_back(sim);
    ovr_observe(sim, seen.dT, &outcome);
    OVR_EACH_PHYSICS(sim, p, recalled)
        p->is->recalled(&sim->observation, &seen);
    sim->started = sim->restored = true;
}
