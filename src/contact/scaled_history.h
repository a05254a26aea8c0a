/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef OVR_CONTACT_SCALED_HISTORY_H
#define OVR_CONTACT_SCALED_HISTORY_H

#include "overroll/contact.h"

/* The history times a factor, in its place; of NULL a constant one. */
ovr_status ovr_history_scale(ovr_history **history, double factor,
                             const ovr_allocator *allocator, ovr_error *err);

#endif
