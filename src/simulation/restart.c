/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The memory that makes up the state between two steps. */
#include "simulation/internal.h"

ovr_status ovr_simulation_visit(ovr_simulation *sim, ovr_visit *visit,
                                void *context, ovr_error *err)
{
    ovr_past *past = &sim->past;
    size_t bytes = sim->finest->n * sizeof(double);
    const struct {
        const char *name;
        void *memory;
        size_t bytes;
    } parts[] = {{"q_1", past->q[0], bytes},
                 {"q_2", past->q[1], bytes},
                 {"q_3", past->q[2], bytes},
                 {"P_1", past->P[0], bytes},
                 {"P_2", past->P[1], bytes},
                 {"P_3", past->P[2], bytes},
                 {"P_4", past->P[3], bytes},
                 {"H0_past", past->H0, sizeof past->H0},
                 {"T_past", past->T, sizeof past->T},
                 {"dT", &past->dT, sizeof past->dT},
                 {"steps_past", &past->steps, sizeof past->steps},
                 {"still", &past->still, sizeof past->still},
                 {"dT_next", &past->dT_next, sizeof past->dT_next},
                 {"change", &past->change, sizeof past->change},
                 {"step", &sim->state.step, sizeof sim->state.step},
                 {"T", &sim->state.T, sizeof sim->state.T},
                 {"observation", &sim->observation, sizeof sim->observation},
                 {"statistics", &sim->statistics, sizeof sim->statistics}};
    for (size_t k = 0; k < sizeof parts / sizeof *parts; k++) {
        ovr_status status = visit(context, parts[k].name, parts[k].memory,
                                  parts[k].bytes, err);
        if (status)
            return status;
    }
    return OVR_OK;
}

/* Film and properties follow from the pressure. */
void ovr_simulation_restored(ovr_simulation *sim)
{
    sim->grids.fluid = sim->wanted.fluid;
    ovr_simulation_return(sim);
    ovr_publish_state(sim);
    sim->started = true;
}
