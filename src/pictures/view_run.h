/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The part of a page for one run, with its additional data. */
#ifndef OVR_PICTURES_VIEW_RUN_H
#define OVR_PICTURES_VIEW_RUN_H

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

/* Adds "stress":{...}, below the snapshots. */
ovr_status ovr_view_stress(const ovr_view_run *view, ovr_error *err);

/* Adds "material":{...}, of the first body that yielded, as the run left it,
 * with the place of its reference at each snapshot; nothing for a run without
 * [plastic] or without a feature. */
ovr_status ovr_view_material(const ovr_view_run *view, ovr_error *err);

#endif
