/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The floors above ask a setup these. */
#ifndef OVR_CASE_SETUP_H
#define OVR_CASE_SETUP_H

#include "base/given.h"
#include "contact/layers.h"
#include "overroll/case.h"

/* The gear pair, cam or bearing of a case; NULL: it has none. */
const ovr_gear *ovr_setup_gear(const ovr_setup *setup);
const ovr_cam *ovr_setup_cam(const ovr_setup *setup);
const ovr_bearing *ovr_setup_bearing(const ovr_setup *setup);

/* The layers on a body, 0 or 1; NULL: it has none. */
const ovr_coated *ovr_setup_layers(const ovr_setup *setup, int body);

/* Replaces the load by that of a pass, multiplied by its time history. */
ovr_status ovr_setup_load(ovr_setup *setup, int pass,
                          const ovr_allocator *allocator, ovr_error *err);

/* Sets step = auto to one mesh size after a start that did not reach the order
 * of its options. */
void ovr_setup_step_reached(ovr_setup *setup, int order);

/* The length of its steps, b/um, where they are not adaptive. */
double ovr_setup_step(const ovr_setup *setup);

/* The reason, with step = auto, why a step is one mesh; why a step is one mesh;
 * NULL: it is longer, or given. */
const char *ovr_setup_step_reason(const ovr_setup *setup);

/* The form of the physics that has a section, resolved whether that is on or
 * not; NULL: none has it. */
void *ovr_setup_form(const ovr_setup *setup, const char *section);

/* The physics of its runs, as bits: quantities that need others are none of
 * theirs. */
unsigned ovr_setup_physics(const ovr_setup *setup);

/* Memory that its simulation takes, bytes; INFINITY: more than this process may
 * address. */
double ovr_setup_memory(const ovr_setup *setup);

/* Lines across rolling of a strip; 1 of a line contact. */
size_t ovr_setup_lines(const ovr_setup *setup);

/* Width of a strip, b; 0 of a line contact. */
double ovr_setup_width(const ovr_setup *setup);

/* The relative error that they add to the film per b/um of step, in a run. */
double ovr_setup_lag(const ovr_setup *setup);

/* Seconds that its physics take a pass beside the film, about, for so many
 * nodes times steps. */
double ovr_setup_seconds_of_physics(const ovr_setup *setup, double node_steps);

/* Warns whoever listens to a run or a setup. */
void ovr_warn(ovr_listener *say, void *data, const char *format, ...)
    OVR_PRINTF(3, 4);

#endif
