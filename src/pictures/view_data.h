/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Data of a page: parts for one run, and packing of fields. */
#ifndef OVR_PICTURES_VIEW_DATA_H
#define OVR_PICTURES_VIEW_DATA_H

#include <stdint.h>

#include "pictures/growing_text.h"
#include "pictures/stored.h"

/* The page contains every stride-th node and every some-th snapshot. */
typedef struct ovr_view_run {
    ovr_text *to;
    ovr_arena *arena;
    const ovr_stored *run;
    const char *stress; /* requested field; NULL: max_shear, or none */
    size_t stride, every, nodes, snapshots;
} ovr_view_run;

/* Appends "element":{...} if the case has a machine element. */
void ovr_view_element(const ovr_view_run *view);

/* Appends "areal":{...}, the maps of a strip; nothing for a line contact. */
ovr_status ovr_view_areal(const ovr_view_run *view, ovr_error *err);

/* Appends "stress":{...}, the stresses of the snapshots, if `stress` or the
 * case requests them. */
ovr_status ovr_view_stress(const ovr_view_run *view, ovr_error *err);

/* Appends "material":{...} of the first body with plastic deformation at the
 * end of the run, with the position of its reference at each snapshot. Nothing
 * for a run without [plastic] or without a feature. */
ovr_status ovr_view_material(const ovr_view_run *view, ovr_error *err);

/*
 * Compression of fields for a page, which page_data.js reverses:
 *
 * 1. Values become levels 0..OVR_PACKED_LEVELS-1: uniform, or with a bend:
 * value = bend sinh(level step). These are uniform in relative value for large
 * values (film outside the contact) and fine for small ones.
 * 2. Each level minus its prediction from neighbours, left + before - (left,
 * before), which is small for moving and stationary patterns.
 * 3. Zigzag (0, -1, 1, -2, ...), low bytes before high bytes, deflate,
 * base64.
 */

enum { OVR_PACKED_LEVELS = 16384 };

typedef struct ovr_levels {
    double from, step, bend; /* bend 0: uniform */
} ovr_levels;

ovr_levels ovr_levels_even(double low, double high);

uint16_t ovr_level_of(const ovr_levels *levels, double value);

/* Performs steps 2 and 3 for rows of n levels, which are overwritten. */
ovr_status ovr_pack_levels(ovr_text *to, uint16_t *level, size_t n, size_t rows,
                           ovr_arena *arena, ovr_error *err);

/* Appends "key":"..." with numbers at full precision. */
void ovr_text_doubles(ovr_text *to, const char *key, const double *values,
                      size_t n);

#endif
