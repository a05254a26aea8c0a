/* SPDX-License-Identifier: GPL-3.0-or-later */
/* [output]. */
#include "case/keys/keys.h"

#include <math.h>

#include "simulation/observables.h"

static const ovr_word precisions[] = {{"f64", 0}, {"f32", 1}, {NULL, 0}};
#define FIELD(name, ...) {#name, 0},
static const ovr_word fields[] = {OVR_FIELD_ROWS(FIELD){NULL, 0}};

static const ovr_parameter output_keys[] = {
    {"file", PATH, NULL, AT(output.file), false, ALWAYS, "result file"},
    {"title", TEXT, NULL, AT(output.title), false, ALWAYS,
     "title in the result file and pictures; default: name of the case file"},
    {"every", WHOLE(1, 1000000000), NULL, AT(output.every), false, IN_TIME,
     "store a snapshot every N steps"},
    {"interval", SPAN(NULL, 1e6), NULL, AT(output.interval), false, IN_TIME,
     "store snapshots at multiples of this time"},
    {"at", LIST(OVR_DURATION, OVR_IN_TIME, 0, 1e6, NULL), NULL, AT(output.at),
     false, IN_TIME, "store snapshots at these times"},
    {"feature_at", LIST(OVR_LENGTH, OVR_IN_B, -1e6, 1e6, NULL), NULL,
     AT(output.feature_at), false, IN_TIME,
     "store snapshots when the centre of a feature is at these X"},
    {"fields", WORDS(fields), "pressure, film_thickness, roughness",
     AT(output.fields), false, ALWAYS, "fields of a snapshot"},
    {"precision", CHOICE(precisions), "f64", AT(precision), false, ALWAYS,
     "precision of the stored numbers; default of a strip: f32"},
    {"from", LENGTH(-1e6, 1e6), NULL, AT(output.from), false, ALWAYS,
     "X of the first stored node"},
    {"to", LENGTH(-1e6, 1e6), NULL, AT(output.to), false, ALWAYS,
     "X of the last stored node"},
    {"stride", WHOLE(1, 1000000), "1", AT(output.stride), false, ALWAYS,
     "store every Nth node"},
    {"compression", WHOLE(0, 9), "1", AT(output.compression), false, ALWAYS,
     "0: none, 9: most"},
    {"checkpoint", WITH_UNIT(OVR_DURATION, 0, 1e7), "30 s",
     AT(output.checkpoint), false, IN_TIME,
     "wall-clock time between restart files; 0 s: at the end only"},
};

const ovr_section ovr_output_section = {
    "output", false, NULL, "fields, window and times of the stored results",
    ROWS(output_keys)};
