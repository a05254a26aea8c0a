/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A history with a mean speed below zero runs towards -x. */
#ifndef OVR_CONTACT_REVERSAL_H
#define OVR_CONTACT_REVERSAL_H

#include "overroll/contact.h"

/* The least value that it ever takes. */
double ovr_history_min(const ovr_history *history);

/* True if it is ever below zero. */
bool ovr_history_reverses(const ovr_history *history);

/* True if it begins below zero, or goes there from zero at T = 0. */
bool ovr_history_begins_backward(const ovr_history *history);

#endif
