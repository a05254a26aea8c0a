/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Functions of a setup (overroll/case.h) for the program, not exported. */
#ifndef OVR_CASE_SETUP_H
#define OVR_CASE_SETUP_H

#include "base/given.h"
#include "contact/layers.h"
#include "elements/elements.h"
#include "overroll/case.h"

/* Return the gear pair, cam or bearing of a case; NULL: none. */
const ovr_gear *ovr_setup_gear(const ovr_setup *setup);
const ovr_cam *ovr_setup_cam(const ovr_setup *setup);
const ovr_bearing *ovr_setup_bearing(const ovr_setup *setup);

/* Returns the layers on a body, 0 or 1; NULL: none. */
const ovr_coated *ovr_setup_layers(const ovr_setup *setup, int body);

/* Replaces the load by that of a pass, multiplied by its time history. */
ovr_status ovr_setup_load(ovr_setup *setup, int pass,
                          const ovr_allocator *allocator, ovr_error *err);

/* Sets step = auto to one mesh size after a start that did not reach the order
 * of its options. */
void ovr_setup_step_reached(ovr_setup *setup, int order);

/* Returns the time step in b/u_m, unless it is adaptive. */
double ovr_setup_step(const ovr_setup *setup);

/* Returns the reason for steps of one mesh size with step = auto; NULL if the
 * step is longer or given. */
const char *ovr_setup_step_reason(const ovr_setup *setup);

/* Returns the data of the physical model that has this section, resolved also
 * if it is off; NULL if no model has it. */
void *ovr_setup_form(const ovr_setup *setup, const char *section);

/* Returns the active physical models as bits; quantities of other models are
 * not available. */
unsigned ovr_setup_physics(const ovr_setup *setup);

/* Returns the memory of the simulation in bytes; INFINITY if it exceeds the
 * address space of the process. */
double ovr_setup_memory(const ovr_setup *setup);

/* Returns the number of lines of a strip; 1 for a line contact. */
size_t ovr_setup_lines(const ovr_setup *setup);

/* Returns the width of a strip in b; 0 for a line contact. */
double ovr_setup_width(const ovr_setup *setup);

/* Returns the relative film thickness error per b/u_m of step length that
 * physical models add in transient runs. */
double ovr_setup_lag(const ovr_setup *setup);

/* Estimates the computing time in seconds that physical models need per pass in
 * addition to the film, for a number of nodes times steps. */
double ovr_setup_seconds_of_physics(const ovr_setup *setup, double node_steps);

/* Estimates the computing time in seconds of a steady cycle of a strip. */
double ovr_setup_strip_cycle(const ovr_setup *setup);

/* Issues a warning to the listener of a run or setup. */
void ovr_warn(ovr_listener *say, void *data, const char *format, ...)
    OVR_PRINTF(3, 4);

#endif
