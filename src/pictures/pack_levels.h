/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Fields made small for a page, to be undone by page_data.js:
 *
 * 1. Values become levels 0..OVR_PACKED_LEVELS-1: evenly spaced, or, with a
 * bend, value = bend sinh(level step), which is even relative to the value
 * where it is large (film outside of the contact) and fine where it is small.
 * 2. Each level minus its prediction from neighbours, left + before - (left,
 *    before): next to nothing where a pattern travels or stands.
 * 3. Zigzag (0, -1, 1, -2, ...), low bytes first and then high ones, deflate,
 *    base64.
 */
#ifndef OVR_PICTURES_PACK_LEVELS_H
#define OVR_PICTURES_PACK_LEVELS_H

#include <stdint.h>

#include "pictures/growing_text.h"

enum { OVR_PACKED_LEVELS = 16384 };

typedef struct ovr_levels {
    double from, step, bend; /* bend 0: even */
} ovr_levels;

ovr_levels ovr_levels_even(double low, double high);
/* Relative error small from values of about `small` on. */
ovr_levels ovr_levels_bent(double small, double high);

uint16_t ovr_level_of(const ovr_levels *levels, double value);

/* Steps 2 and 3 of rows of n levels; the levels are overwritten. */
ovr_status ovr_pack_levels(ovr_text *to, uint16_t *level, size_t n, size_t rows,
                           ovr_arena *arena, ovr_error *err);

/* "key":"...", of numbers as they are. */
void ovr_text_doubles(ovr_text *to, const char *key, const double *values,
                      size_t n);

#endif
