/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef OVR_CONTACT_CHANGE_H
#define OVR_CONTACT_CHANGE_H

/* The keys of a history fill this (contact/history_keys.h). */
typedef struct ovr_change {
    int history; /* ovr_history_kind */
    double from, to, start, duration, amplitude, period, mean;
    const char *file;
    int time_unit;
} ovr_change;

#endif
