/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "contact/history_keys.h"

#include "overroll/contact.h"

const ovr_word ovr_history_words[] = {
    {"constant", OVR_HISTORY_CONSTANT}, {"ramp", OVR_HISTORY_RAMP},
    {"sine", OVR_HISTORY_SINE},         {"step", OVR_HISTORY_STEP},
    {"table", OVR_HISTORY_TABLE},       {NULL, 0}};
const ovr_word ovr_time_unit_words[] = {
    {"b/um", 0}, {"s", 1}, {"ms", 2}, {"us", 3}, {NULL, 0}};
