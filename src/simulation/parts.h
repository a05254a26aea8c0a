/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The parts, and refusing what does not go together (overroll/parts.h). */
#ifndef OVR_SIMULATION_PARTS_H
#define OVR_SIMULATION_PARTS_H

#include <stdbool.h>

#include "overroll/parts.h"
#include "overroll/simulation.h"

/*
 * A part in a row: its name and what people call it, where a case has it and
 * whether as a whole section, and when it is on: by the options `o` of a
 * simulation, which count in a case where their key is written, or by the setup
 * `s` of the case `r` (case/resolve_parts.c).
 */
#define OVR_PART_ROWS(PART)                                                    \
    PART(TIME, "a run in time", "time", "end", true, false,                    \
         s->transient &&                                                       \
             (!ovr_runs_in(r) || ovr_slot_of(r, "time", "end")->given))        \
    PART(UPSTREAM1, "scheme upstream1", "time", "scheme", false,               \
         o->scheme == OVR_UPSTREAM1, false)                                    \
    PART(UPSTREAM2, "scheme upstream2", "time", "scheme", false,               \
         o->scheme == OVR_UPSTREAM2, false)                                    \
    PART(CHARACTERISTIC, "scheme characteristic", "time", "scheme", false,     \
         o->scheme == OVR_CHARACTERISTIC, false)                               \
    PART(ORDER_2, "order 2", "domain", "order", false, o->order == 2, false)   \
    PART(ORDER_4, "order 4", "domain", "order", false, o->order == 4, false)   \
    PART(PAPER_SMOOTHER, "a smoother of the paper", "paper", "smoother",       \
         false, o->smoother != OVR_LINE, false)                                \
    PART(PAPER_BALANCE, "the paper's balance", "paper", "paper_balance",       \
         false, o->paper_balance, false)                                       \
    PART(FIXED_CYCLES, "a fixed number of cycles", "solver", "stop", false,    \
         o->stop == OVR_STOP_FIXED, false)                                     \
    PART(ADAPTIVE, "adaptive steps", "time", "step", false, false,             \
         s->march->adaptive)                                                   \
    PART(LOAD, "a history of load", "load", "history", false, false,           \
         s->load != NULL)                                                      \
    PART(SPEED, "a history of speed", "speed", "history", false, false,        \
         s->speed != NULL)                                                     \
    PART(REVERSAL, "a speed that reverses", "speed", "history", false, false,  \
         ovr_history_reverses(s->speed))                                       \
    PART(SLIDING, "a history of sliding", "sliding", "history", false, false,  \
         s->sliding != NULL)                                                   \
    PART(RADIUS, "a history of the radius", "radius", "history", false, false, \
         s->radius != NULL)                                                    \
    PART(FLOW_LAW, "a flow law", "lubricant", "rheology", false, false,        \
         s->lubricant->rheology != OVR_NEWTONIAN)                              \
    PART(HEAT, "heat", "heat", "model", false, false, s->heat != NULL)         \
    PART(CONSERVING, "cavitation that conserves oil", "cavitation", "model",   \
         false, o->cavitation == OVR_CAVITATION_CONSERVING, false)             \
    PART(SUPPLY, "a supply that is a film", "supply", "model", false, false,   \
         s->supply->film)                                                      \
    PART(PASSES, "several passes", "passes", "number", false, false,           \
         s->passes->number > 1)                                                \
    PART(STRESS, "stresses", "stress", "surface", true, false,                 \
         s->stress->surfaces != 0)                                             \
    PART(FATIGUE, "fatigue", "fatigue", "criterion", false, false,             \
         s->stress->fatigue)                                                   \
    PART(PLASTIC, "a body that yields", "plastic", "surface", true, false,     \
         r->values.plastic.surfaces != 0)                                      \
    PART(PATCHES, "patches", "domain", "refine", false,                        \
         o->refine != OVR_REFINE_NONE, false)                                  \
    PART(COATING, "a coating", "coating", "thickness", true, false,            \
         ovr_case_find_block(r->c, "coating", NULL) != NULL)                   \
    PART(OTHER_MODULI, "a layer of other moduli on that body", "coating",      \
         "modulus", false, false, yields_below_others(r))                      \
    PART(BOUNDARY, "surfaces that touch", "boundary", "law", true, false,      \
         ovr_case_find_block(r->c, "boundary", NULL) &&                        \
             ovr_slot_of(r, "boundary", "law")->given)                         \
    PART(MEAN_FILM, "a law of all roughness", "boundary", "of", false, false,  \
         ovr_case_find_block(r->c, "boundary", NULL) &&                        \
             ovr_slot_of(r, "boundary", "law")->given &&                       \
             ovr_slot_of(r, "boundary", "of")->number == 0)                    \
    PART(WEAR, "running-in", "boundary", "passes", false, false,               \
         ovr_runs_in(r))                                                       \
    PART(ROUGHNESS, "roughness on the mesh", "feature", "shape", false, false, \
         has_roughness(r))

#define OVR_PART_NUMBER(NAME, words, section, key, whole, options, setup)      \
    OVR_PART_##NAME,
typedef enum ovr_part { OVR_PART_ROWS(OVR_PART_NUMBER) OVR_PARTS } ovr_part;
#undef OVR_PART_NUMBER

static inline unsigned ovr_part_bit(ovr_part part, bool on)
{
    return on ? 1U << part : 0;
}

/* Those of the options; order 4 where it is written. */
unsigned ovr_parts_of(const ovr_options *o);

/* The first pair of the table of which both are on, or NULL. */
const ovr_refusal *ovr_parts_conflict(unsigned on);

/* Fails with it, about its key. */
ovr_status ovr_parts_check(unsigned on, ovr_error *err);

#endif
