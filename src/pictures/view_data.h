/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The data of a page: parts for one run, and how fields are packed. */
#ifndef OVR_PICTURES_VIEW_DATA_H
#define OVR_PICTURES_VIEW_DATA_H

#include <stdint.h>

#include "pictures/growing_text.h"
#include "pictures/stored.h"

/* The page holds every stride-th node of every so many snapshots. */
typedef struct ovr_view_run {
    ovr_text *to;
    ovr_arena *arena;
    const ovr_stored *run;
    const char *stress; /* field asked for; NULL: max_shear, or none */
    size_t stride, every, nodes, shots;
} ovr_view_run;

/* Appends "element":{...}, where the case of the run has one. */
void ovr_view_element(const ovr_view_run *view);

/* Adds "areal":{...}, the maps of a strip; nothing for a line contact. */
ovr_status ovr_view_areal(const ovr_view_run *view, ovr_error *err);

/* Adds "stress":{...}, below the snapshots, where `stress` or the case asks for
 * them. */
ovr_status ovr_view_stress(const ovr_view_run *view, ovr_error *err);

/* Adds "material":{...}, of the first body that yielded, as the run left it,
 * with the place of its reference at each snapshot; nothing for a run without
 * [plastic] or without a feature. */
ovr_status ovr_view_material(const ovr_view_run *view, ovr_error *err);

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
