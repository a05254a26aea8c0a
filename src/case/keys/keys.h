/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The sections of a case with the rows of their keys: a file for what belongs
 * together.  Where the values go is ovr_settings; of a feature and a body their
 * own forms. */
#ifndef OVR_CASE_KEYS_H
#define OVR_CASE_KEYS_H

#include "base/rows.h"
#include "case/settings.h"

#define AT(field) offsetof(ovr_settings, field)

extern const ovr_section ovr_contact_section;
extern const ovr_section ovr_lubricant_section;
extern const ovr_section ovr_domain_section;
extern const ovr_section ovr_solver_section;
extern const ovr_section ovr_time_section;
extern const ovr_section ovr_load_section;
extern const ovr_section ovr_speed_section;
extern const ovr_section ovr_sliding_section;
extern const ovr_section ovr_radius_section;
extern const ovr_section ovr_radius_1_section;
extern const ovr_section ovr_cavitation_section;
extern const ovr_section ovr_supply_section;
extern const ovr_section ovr_passes_section;
extern const ovr_section ovr_feature_section;
extern const ovr_section ovr_output_section;
extern const ovr_section ovr_paper_section;
extern const ovr_section ovr_stress_section;
extern const ovr_section ovr_fatigue_section;
extern const ovr_section ovr_plastic_section;
extern const ovr_section ovr_body_section;
extern const ovr_section ovr_gear_section;
extern const ovr_section ovr_cam_section;
extern const ovr_section ovr_roller_bearing_section;

extern const ovr_word ovr_history_words[], ovr_time_unit_words[];

/* A run in time: it has an end, or an element of a machine with a way of its
 * own. */
#define IN_TIME "time.end or gear.teeth_1 or cam.base_radius"

#define IN_CHANGE(base, field) ((base) + offsetof(ovr_change, field))

/* A history that changes has something to change by. */
#define CHANGES                                                                \
    "history = ramp | step => from or to; history = sine => amplitude"

/* clang-format off */
#define HISTORY(base, initial, low, high, swing, when)                        \
    {"history", CHOICE(ovr_history_words), "constant",                        \
     IN_CHANGE(base, history), true, when,                                    \
     "how it changes in time, relative to nominal"},                          \
    {"from", PLAIN(low, high), initial, IN_CHANGE(base, from), true,          \
     "history = ramp | step", "value up to the start"},                       \
    {"to", PLAIN(low, high), initial, IN_CHANGE(base, to), true,              \
     "history = ramp | step", "value at the end"},                            \
    {"start", TIME(-1e6, 1e6), "0", IN_CHANGE(base, start), true,             \
     "history = ramp | step | sine", "time at which the change begins"},      \
    {"duration", TIME(0, 1e6), "0", IN_CHANGE(base, duration), true,          \
     "history = ramp", "how long it takes (quintic smoothstep)"},             \
    {"amplitude", PLAIN(-(swing), swing), "0", IN_CHANGE(base, amplitude),    \
     true, "history = sine",                                                  \
     "amplitude about 1, of the sliding about slide_to_roll"},                \
    {"period", SPAN(NULL, 1e6), NULL, IN_CHANGE(base, period), true,          \
     "history = sine", "period"},                                             \
    {"file", PATH, NULL, IN_CHANGE(base, file), true, "history = table",      \
     "text file of two columns, time and value"},                             \
    {"time_unit", CHOICE(ovr_time_unit_words), "b/um",                        \
     IN_CHANGE(base, time_unit), true, "history = table", "unit of its times"}
/* clang-format on */

#endif
