/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The pieces of a state, one after the other. */
#include <stdio.h>

#include "simulation/internal.h"

void ovr_show(ovr_pieces *state, const char *name, void *memory, size_t bytes)
{
    if (!state->status)
        state->status = state->visit(state->context, name, memory, bytes,
                                     state->err);
}

void ovr_show_nodes(const ovr_simulation *sim, ovr_pieces *state,
                    const char *name, int number, double *values)
{
    char text[40];
    snprintf(text, sizeof text, "%s_%d", name, number);
    ovr_show(state, text, values, sim->now.n * sizeof *values);
}
