/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Histories for the floors above: the settings that make one, its least value
 * and its direction. */
#ifndef OVR_CONTACT_HISTORY_H
#define OVR_CONTACT_HISTORY_H

#include "contact/contact.h"

/* The keys of a history fill this (contact/history_keys.h). */
typedef struct ovr_change {
    ovr_history_form form; /* without the points of a table */
    const char *file;      /* of the table */
    int time_unit;
} ovr_change;

/* A history with a mean speed below zero runs towards -x. */

/* The least value that it ever takes. */
double ovr_history_min(const ovr_history *history);

/* True if it is ever below zero. */
bool ovr_history_reverses(const ovr_history *history);

/* True if it begins below zero, or goes there from zero at T = 0. */
bool ovr_history_begins_backward(const ovr_history *history);

/* The history times a factor, in its place; of NULL a constant one. */
ovr_status ovr_history_scale(ovr_history **history, double factor,
                             const ovr_allocator *allocator, ovr_error *err);

#endif
