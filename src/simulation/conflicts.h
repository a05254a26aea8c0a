/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Features of a model, and pairs of features that cannot be combined
 * (overroll/conflicts.h). */
#ifndef OVR_SIMULATION_CONFLICTS_H
#define OVR_SIMULATION_CONFLICTS_H

#include <stdbool.h>

#include "overroll/conflicts.h"
#include "overroll/simulation.h"

/*
 * Rows of the feature table: name; text for users; section and key in a case,
 * and whether the whole section selects the feature; condition, in terms of the
 * options `o` of a simulation (which count in a case only if their key is
 * written), the setup `s` of the case `r` (case/resolve.c), or the physical
 * model it belongs to (`features` in physics.h).
 */
#define OVR_MODEL_FEATURE_ROWS(FEATURE)                                        \
    FEATURE(TIME, "a run in time", "time", "end", true, false,                 \
            s->transient && (!r->ran || ovr_slot_of(r, "time", "end")->given)) \
    FEATURE(UPSTREAM1, "scheme upstream1", "time", "scheme", false,            \
            o->scheme == OVR_UPSTREAM1, false)                                 \
    FEATURE(UPSTREAM2, "scheme upstream2", "time", "scheme", false,            \
            o->scheme == OVR_UPSTREAM2, false)                                 \
    FEATURE(CHARACTERISTIC, "scheme characteristic", "time", "scheme", false,  \
            o->scheme == OVR_CHARACTERISTIC, false)                            \
    FEATURE(ORDER_2, "order 2", "domain", "order", false, o->order == 2,       \
            false)                                                             \
    FEATURE(ORDER_4, "order 4", "domain", "order", false, o->order == 4,       \
            false)                                                             \
    FEATURE(PAPER_SMOOTHER, "a smoother of the paper", "paper", "smoother",    \
            false, o->smoother != OVR_LINE, false)                             \
    FEATURE(PAPER_BALANCE, "the paper's balance", "paper", "paper_balance",    \
            false, o->paper_balance, false)                                    \
    FEATURE(FIXED_CYCLES, "a fixed number of cycles", "solver", "stop", false, \
            o->stop == OVR_STOP_FIXED, false)                                  \
    FEATURE(ADAPTIVE, "adaptive steps", "time", "step", false, false,          \
            s->march->adaptive)                                                \
    FEATURE(LOAD, "a history of load", "load", "history", false, false,        \
            s->load != NULL)                                                   \
    FEATURE(SPEED, "a history of speed", "speed", "history", false, false,     \
            s->speed != NULL)                                                  \
    FEATURE(REVERSAL, "a speed that reverses", "speed", "history", false,      \
            false, ovr_history_reverses(s->speed))                             \
    FEATURE(SLIDING, "a history of sliding", "sliding", "history", false,      \
            false, s->sliding != NULL)                                         \
    FEATURE(RADIUS, "a history of the radius", "radius", "history", false,     \
            false, s->radius != NULL)                                          \
    FEATURE(FLOW_LAW, "a flow law", "lubricant", "rheology", false, false,     \
            s->lubricant->rheology != OVR_NEWTONIAN)                           \
    FEATURE(HEAT, "heat", "heat", "model", false, false, false)                \
    FEATURE(CONSERVING, "mass-conserving cavitation", "cavitation", "model",   \
            false, o->cavitation == OVR_CAVITATION_CONSERVING, false)          \
    FEATURE(SUPPLY, "supplied lubricant layers", "supply", "model", false,     \
            false, false)                                                      \
    FEATURE(PASSES, "several passes", "passes", "number", false, false,        \
            s->passes->number > 1)                                             \
    FEATURE(STRESS, "stresses", "stress", "surface", true, false, false)       \
    FEATURE(FATIGUE, "fatigue", "fatigue", "criterion", true, false, false)    \
    FEATURE(PLASTIC, "plastic deformation", "plastic", "surface", true, false, \
            false)                                                             \
    FEATURE(PATCHES, "patches", "domain", "refine", false,                     \
            o->refine != OVR_REFINE_NONE, false)                               \
    FEATURE(COATING, "a coating", "coating", "thickness", true, false, false)  \
    FEATURE(OTHER_MODULI, "a coating with another modulus on that body",       \
            "coating", "modulus", false, false, false)                         \
    FEATURE(BOUNDARY, "surfaces that touch", "boundary", "law", true, false,   \
            false)                                                             \
    FEATURE(MEAN_FILM, "a contact model of all roughness", "boundary", "of",   \
            false, false, false)                                               \
    FEATURE(WEAR, "running-in", "boundary", "passes", false, false, false)     \
    FEATURE(STRIP, "a strip", "strip", "width", true, false, false)            \
    FEATURE(ROUGHNESS, "roughness on the grid", "feature", "shape", false,     \
            false, has_roughness(r))

#define OVR_MODEL_NUMBER(NAME, words, section, key, whole, options, setup)     \
    OVR_MODEL_##NAME,
typedef enum ovr_model_feature {
    OVR_MODEL_FEATURE_ROWS(OVR_MODEL_NUMBER) OVR_MODEL_FEATURES
} ovr_model_feature;
#undef OVR_MODEL_NUMBER

static inline unsigned ovr_model_feature_bit(ovr_model_feature feature, bool on)
{
    return on ? 1U << feature : 0;
}

/* Features selected by the options; order 4 only if it is set explicitly. */
unsigned ovr_model_features_of(const ovr_options *o);

/* Returns the first conflicting pair in the table, or NULL. */
const ovr_conflict *ovr_conflict_among(unsigned on);

/* Fails if two features conflict; the error names the key. */
ovr_status ovr_conflict_check(unsigned on, ovr_error *err);

#endif
