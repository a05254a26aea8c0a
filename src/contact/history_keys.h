/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Keys of a history section such as [load] or [supply]; included only by files
 * with tables of keys. */
#ifndef OVR_CONTACT_HISTORY_KEYS_H
#define OVR_CONTACT_HISTORY_KEYS_H

#include "base/rows.h"
#include "contact/history.h"

extern const ovr_word ovr_history_words[], ovr_time_unit_words[];

#define IN_CHANGE(base, field) ((base) + offsetof(ovr_change, field))

/* A history that varies needs the value it varies to. */
#define CHANGES                                                                \
    "history = ramp | step => from or to; history = sine => amplitude"

/* clang-format off */
#define HISTORY(base, initial, low, high, swing, when)                    \
    {"history", CHOICE(ovr_history_words), "constant",                    \
     IN_CHANGE(base, form.kind), true, when,                              \
     "time history relative to the reference value"},                     \
    {"from", PLAIN(low, high), initial, IN_CHANGE(base, form.from), true, \
     "history = ramp | step", "value before the start"},                  \
    {"to", PLAIN(low, high), initial, IN_CHANGE(base, form.to), true,     \
     "history = ramp | step", "value at the end"},                        \
    {"start", TIME(-1e6, 1e6), "0", IN_CHANGE(base, form.start), true,    \
     "history = ramp | step | sine", "time at which the change begins"},  \
    {"duration", TIME(0, 1e6), "0", IN_CHANGE(base, form.duration), true, \
     "history = ramp", "duration of the change (quintic smoothstep)"},    \
    {"amplitude", PLAIN(-(swing), swing), "0",                            \
     IN_CHANGE(base, form.amplitude), true, "history = sine",             \
     "amplitude about 1; of the sliding speed about slide_to_roll"},      \
    {"period", SPAN(NULL, 1e6), NULL, IN_CHANGE(base, form.period), true, \
     "history = sine", "period"},                                         \
    {"file", PATH, NULL, IN_CHANGE(base, file), true, "history = table",  \
     "text file of two columns, time and value"},                         \
    {"time_unit", CHOICE(ovr_time_unit_words), "b/um",                    \
     IN_CHANGE(base, time_unit), true, "history = table",                 \
     "unit of the times in the file"}
/* clang-format on */

#endif
