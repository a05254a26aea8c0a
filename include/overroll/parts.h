/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * What goes with what: the parts that a simulation is put together from, and
 * the pairs of them that are refused.  Every pair that is not refused works:
 * it marches, is resumed to the same bits and keeps mass and load
 * (tests/cli/pairs_slow_test.c walks them all).
 */
#ifndef OVERROLL_PARTS_H
#define OVERROLL_PARTS_H

#include "overroll/error.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef enum ovr_part {
    OVR_PART_TIME, /* marches; else the contact is steady */
    OVR_PART_UPSTREAM1,
    OVR_PART_UPSTREAM2,
    OVR_PART_CHARACTERISTIC,
    OVR_PART_ORDER_2,
    OVR_PART_ORDER_4,
    OVR_PART_PAPER_SMOOTHER, /* any but the line smoother */
    OVR_PART_PAPER_BALANCE,
    OVR_PART_FIXED_CYCLES,
    OVR_PART_ADAPTIVE,
    OVR_PART_LOAD, /* histories */
    OVR_PART_SPEED,
    OVR_PART_REVERSAL, /* a history of speed that passes through zero */
    OVR_PART_SLIDING,
    OVR_PART_RADIUS,
    OVR_PART_FLOW_LAW, /* any but Newton's */
    OVR_PART_HEAT,
    OVR_PART_CONSERVING,
    OVR_PART_SUPPLY, /* a film that arrives, and its history */
    OVR_PART_PASSES,
    OVR_PART_STRESS,
    OVR_PART_FATIGUE,
    OVR_PART_PATCHES,
    OVR_PARTS
} ovr_part;

/* One part, where a case has it: "heat", "heat", "model". */
typedef struct ovr_part_info {
    const char *name, *section, *key;
} ovr_part_info;
OVR_API ovr_part_info ovr_part_at(ovr_part part);

/* A pair that is refused. */
typedef struct ovr_refusal {
    ovr_part part, beside;
    const char *instead; /* what goes in place of `part` */
    const char *why;
} ovr_refusal;

/* The k-th of them; NULL behind the last. */
OVR_API const ovr_refusal *ovr_refusal_at(size_t k);

/* Why two parts, in either order, do not go together; NULL: they do. */
OVR_API const ovr_refusal *ovr_parts_refused(ovr_part a, ovr_part b);

#ifdef __cplusplus
}
#endif

#endif
