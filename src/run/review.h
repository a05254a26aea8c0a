/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Warnings and notes about a case or a finished run, in addition to its
 * result. */
#ifndef OVR_RUN_REVIEW_H
#define OVR_RUN_REVIEW_H

#include "overroll/run.h"
#include "physics/companion.h"
#include "simulation/internal.h"

typedef struct ovr_review {
    const ovr_case *c;
    const ovr_setup *setup;
    ovr_listener *say;
    void *data;
} ovr_review;

void ovr_review_add(const ovr_review *r, ovr_message_kind kind,
                    const char *format, ...) OVR_PRINTF(3, 4);

/* Warns if the inlet is fully flooded although lubricant is supplied as
 * layers. */
void ovr_review_inlet(const ovr_review *r, const ovr_state *state,
                      double H_cen);

#endif
