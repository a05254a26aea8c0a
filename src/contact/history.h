/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Time histories for higher layers: input from keys, minimum, and direction. */
#ifndef OVR_CONTACT_HISTORY_H
#define OVR_CONTACT_HISTORY_H

#include "contact/contact.h"

/* Values of the keys of a history section (contact/history_keys.h). */
typedef struct ovr_change {
    ovr_history_form form; /* without the points of a table */
    const char *file;      /* file of the table */
    int time_unit;
} ovr_change;

/* A history with negative entrainment speed moves towards -x. */

/* Minimum over all times. */
double ovr_history_min(const ovr_history *history);

/* True if the value is negative at any time. */
bool ovr_history_reverses(const ovr_history *history);

/* True if the value is negative at T = 0, or becomes negative from zero at T =
 * 0. */
bool ovr_history_begins_backward(const ovr_history *history);

/* Multiplies the history by a factor in place; NULL becomes a constant history.
 */
ovr_status ovr_history_scale(ovr_history **history, double factor,
                             const ovr_allocator *allocator, ovr_error *err);

#endif
