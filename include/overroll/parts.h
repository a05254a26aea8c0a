/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The parts that a simulation is put together from, and the pairs of them that
 * are refused.  Every pair that is not refused works: it marches,
 * is resumed to the same bits and keeps mass and load
 * (tests/cli/pairs_slow_test.c walks them all).
 */
#ifndef OVERROLL_PARTS_H
#define OVERROLL_PARTS_H

#include <stdbool.h>

#include "overroll/error.h"

#ifdef __cplusplus
extern "C" {
#endif

/* One part, where a case has it: "heat", "heat", "model". */
typedef struct ovr_part_info {
    const char *name, *section, *key;
    bool whole; /* its section is there or not, whatever it holds */
} ovr_part_info;

/* A pair that is refused. */
typedef struct ovr_refusal {
    int part, beside;    /* numbers of parts */
    const char *instead; /* what goes in place of `part` */
    const char *why;
} ovr_refusal;

/* The k-th of them; NULL behind the last. */
OVR_API const ovr_refusal *ovr_refusal_at(size_t k);
OVR_API ovr_part_info ovr_part_at(int part);

#ifdef __cplusplus
}
#endif

#endif
