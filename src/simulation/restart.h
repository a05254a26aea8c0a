/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The parts of a state in a checkpoint (restart.c). */
#ifndef OVR_SIMULATION_RESTART_H
#define OVR_SIMULATION_RESTART_H

#include "simulation/simulation.h"

/* Visitor of the parts of a state, each with a name (ovr_simulation_visit).
 * After a failure no further part is visited. */
typedef struct ovr_pieces {
    ovr_visit *visit;
    void *context;
    ovr_error *err;
    ovr_status status;
} ovr_pieces;
void ovr_show(ovr_pieces *state, const char *name, void *memory, size_t bytes);

/* Visits a number; or an array of the solution's nodes, named "NAME_3". */
#define OVR_SHOW(state, name, number)                                          \
    ovr_show(state, name, &(number), sizeof(number))
void ovr_show_nodes(const ovr_simulation *sim, ovr_pieces *state,
                    const char *name, int number, double *values);

#endif
