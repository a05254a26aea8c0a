/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Files used by a case: profiles, lift tables, flow curves. */
#ifndef OVR_CASE_INPUTS_H
#define OVR_CASE_INPUTS_H

#include "case/case.h"
#include "results/results.h"

typedef struct ovr_inputs {
    ovr_input *input;
    size_t count;
} ovr_inputs;

/* Lists the files that have an effect, in the order of the case's keys. Texts
 * and list are in the arena. */
ovr_status ovr_case_inputs(const ovr_case *c, ovr_arena *arena, ovr_inputs *to,
                           ovr_error *err);

/* True if the value of a key is the path of an input file. Paths of output
 * files do not affect the solution. */
bool ovr_key_is_input(const ovr_parameter *row);

/* Returns the path of a key relative to the working directory. Paths in a case
 * file are relative to that file. */
const char *ovr_slot_path(const ovr_case *c, const ovr_slot *slot,
                          ovr_arena *arena, ovr_error *err);

#endif
