/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The pieces of a state in a checkpoint (restart.c). */
#ifndef OVR_SIMULATION_RESTART_H
#define OVR_SIMULATION_RESTART_H

#include "simulation/simulation.h"

/* The pieces of memory that make up a state, shown one after the other by name
 * (ovr_simulation_visit): once one of them failed no other is. */
typedef struct ovr_pieces {
    ovr_visit *visit;
    void *context;
    ovr_error *err;
    ovr_status status;
} ovr_pieces;
void ovr_show(ovr_pieces *state, const char *name, void *memory, size_t bytes);

/* A number; "NAME_3", an array of the solution's nodes. */
#define OVR_SHOW(state, name, number)                                          \
    ovr_show(state, name, &(number), sizeof(number))
void ovr_show_nodes(const ovr_simulation *sim, ovr_pieces *state,
                    const char *name, int number, double *values);

#endif
