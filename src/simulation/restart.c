/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The numbers and arrays that make up the state between two steps, by name.
 * What is observed of it is not among them but follows from them; of the step
 * just made stay how it was solved, and the totals.  The domain is among them
 * for who makes the simulation again. */
#include <math.h>
#include <stdio.h>

#include "simulation/heat_in_time.h"

typedef struct part {
    const char *name;
    void *memory;
    size_t bytes;
} part;

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

/* The corrections of fourth order, where the run has them. */
static ovr_status visit_corrections(ovr_simulation *sim, ovr_visit *visit,
                                    void *context, ovr_error *err)
{
    size_t bytes = sim->now.n * sizeof(double);
    ovr_status status = visit(context, "order", &sim->order, sizeof sim->order,
                              err);
    if (!status && sim->order == 4 && sim->options.order != 4)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "the state is of a run of order 4, this one is of "
                        "order %d",
                        sim->options.order);
    if (!status && sim->order == 4)
        status = visit(context, "F_fourth", sim->F_fourth, bytes, err);
    if (!status && sim->order == 4)
        status = visit(context, "gap_fourth", sim->gap_fourth, bytes, err);
    return status;
}

ovr_status ovr_simulation_visit(ovr_simulation *sim, ovr_visit *visit,
                                void *context, ovr_error *err)
{
    ovr_past *past = &sim->past;
    ovr_observation *o = &sim->observation;
    ovr_statistics *total = &sim->statistics;
    ovr_status status = visit_past(sim, visit, context, err);
    if (!status)
        status = visit_corrections(sim, visit, context, err);
    if (!status && sim->heated)
        status = ovr_heat_visit(sim, visit, context, err);
#define PART(name, member)                                                     \
    {                                                                          \
        name, &(member), sizeof(member)                                        \
    }
    const part parts[] = {
        PART("H0_past", past->H0),
        PART("T_past", past->T),
        PART("dT", past->dT),
        PART("steps_past", past->steps),
        PART("still", past->still),
        PART("dT_next", past->dT_next),
        PART("change", past->change),
        PART("step", sim->state.step),
        PART("T", sim->state.T),
        PART("time_step", o->dT),
        PART("residual", o->residual),
        PART("cycles", o->cycles),
        PART("retries", o->retries),
        PART("converged", o->converged),
        PART("marked", o->marked),
        PART("total_steps", total->steps),
        PART("total_cycles", total->cycles),
        PART("total_retries", total->retries),
        PART("total_substeps", total->substeps),
        PART("total_marked", total->marked),
        PART("least_film", total->H_min),
        PART("least_film_place", total->X_H_min),
        PART("least_film_time", total->T_H_min),
        PART("largest_pressure", total->P_max),
        PART("largest_pressure_place", total->X_P_max),
        PART("largest_pressure_time", total->T_P_max),
        PART("largest_load_error", total->load_error),
        PART("largest_load_error_time", total->T_load_error),
        PART("largest_sliding_friction", total->mu_slide),
        PART("largest_sliding_friction_time", total->T_mu_slide),
        PART("largest_rise", total->T_rise),
        PART("largest_rise_1", total->T_1_rise),
        PART("largest_rise_2", total->T_2_rise),
        PART("largest_energy_defect", total->energy_defect),
        PART("settled", total->settled),
        PART("inlet", sim->options.inlet),
        PART("outlet", sim->options.outlet),
        PART("level", sim->options.level),
        PART("oil_waiting", sim->arrival.waiting),
        PART("inlet_closed", sim->arrival.closed),
        PART("flooded_film", sim->arrival.flooded),
        PART("flooded_flow", sim->arrival.flow),
        PART("mass_defect", o->mass_defect)};
    for (size_t k = 0; !status && k < sizeof parts / sizeof *parts; k++)
        status = visit(context, parts[k].name, parts[k].memory, parts[k].bytes,
                       err);
    return status;
}

/* Film and properties follow from the pressure, and what is observed from
 * these; without a least film so far it is the one of now. */
void ovr_simulation_restored(ovr_simulation *sim)
{
    const ovr_observation seen = sim->observation;
    const ovr_outcome outcome = {.defect.imbalance = seen.residual,
                                 .cycles = seen.cycles,
                                 .retries = seen.retries,
                                 .converged = seen.converged,
                                 .marked = seen.marked};
    sim->grids.fluid = sim->wanted.fluid;
    if (!sim->order) /* version 0.1.0 */
        ovr_fourth_forget(sim);
    if (!(sim->statistics.H_min > 0))
        sim->statistics.H_min = INFINITY;
    if (ovr_conserves(sim))
        ovr_supply_step(sim, 0);
    if (sim->heated)
        ovr_heat_restored(sim);
    ovr_simulation_step_back(sim);
    ovr_observe(sim, seen.dT, &outcome);
    sim->observation.mass_defect = seen.mass_defect;
    sim->started = true;
}
