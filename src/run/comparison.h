/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A condition on a number of a run, such as "H_min_overall at least 0.05" or
 * "P_max <= 2 GPa". */
#ifndef OVR_RUN_COMPARISON_H
#define OVR_RUN_COMPARISON_H

#include "base/arena.h"

enum { OVR_QUANTITY_CAPACITY = 80 };

typedef struct ovr_comparison {
    const char *quantity; /* the quantity in SI if the target has a unit */
    int sense;            /* 0: equal; 1: at least; -1: at most */
    double target;        /* in SI or dimensionless */
} ovr_comparison;

/* Reads the number of "0.1 um". Returns the unit as written; NULL if there is
 * no number. */
const char *ovr_amount_read(const char *text, double *number);

/* Returns the quantity of a condition as written, or NULL. */
const char *ovr_comparison_quantity(const char *text, ovr_arena *arena,
                                    ovr_error *err);

ovr_status ovr_comparison_read(const char *text, ovr_comparison *c,
                               ovr_arena *arena, ovr_error *err);

/* Returns, in `buffer`, the key in Hertzian units that corresponds to a key in
 * SI; the same key if there is none. */
const char *ovr_quantity_bare(const char *quantity,
                              char buffer[OVR_QUANTITY_CAPACITY]);

/* The full name of a number of a summary for people ("minimum film thickness
 * over the run"), or its key if it has no name.  `unit` is the unit in SI, or
 * the scale of a dimensionless number ("b^2/R"), or "". */
typedef struct ovr_quantity_name {
    char text[200];
    const char *unit;
} ovr_quantity_name;
ovr_quantity_name ovr_quantity_named(const char *key);

/* The full name of a key of the case in a table ("slide-to-roll ratio" of
 * "slide_to_roll"); of other keys their words, without underscores. */
ovr_quantity_name ovr_key_named(const char *key);

/* Returns the symbol with which a full name ends ("p_h"), in the markup of
 * gnuplot, and in *length the length of the name before it; NULL: no symbol. */
const char *ovr_name_symbol(const char *name, size_t *length);

#endif
