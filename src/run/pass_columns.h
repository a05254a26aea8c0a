/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The columns of the file of several passes: of the quantities whose rows say
 * so, over the pass; behind them what is known of a pass beside these. */
#ifndef OVR_RUN_PASS_COLUMNS_H
#define OVR_RUN_PASS_COLUMNS_H

#include "overroll/simulation.h"

enum { OVR_PASS_MAX = 64 };

/* Those beside the quantities, by their numbers. */
typedef enum ovr_pass_beside {
    OVR_PASS_LOST,
    OVR_PASS_STEPS,
    OVR_PASS_FILM_ERROR, /* from here on where they are known */
    OVR_PASS_MIN_ERROR,
    OVR_PASS_PRESSURE_ERROR,
    OVR_PASS_MENISCUS_ERROR,
    OVR_PASS_LENGTH, /* of the stresses below a surface */
    OVR_PASS_RISK,
    OVR_PASS_RATIO,
    OVR_PASS_TOGETHER,
    OVR_PASS_BESIDE
} ovr_pass_beside;

typedef struct ovr_pass_column {
    char name[64], long_name[160];
    ovr_unit_kind kind;
    const ovr_observable *of; /* NULL: none of the quantities */
    unsigned how;             /* of that: one of OVR_PASS_MEAN, ... */
    /* Its place in the table that people read, 0: none, its head there and the
     * physics without which it is left out, as rows of quantities have them. */
    int place;
    const char *head;
    unsigned with;
} ovr_pass_column;

/* Column k: first the OVR_PASS_BESIDE, then those of the quantities.  false
 * past the end. */
bool ovr_pass_column_at(size_t k, ovr_pass_column *to);

/* Finds a column by its name, which is one of them. */
size_t ovr_pass_column_named(const char *name);

#endif
