/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Writes as a page's data what has yielded below a surface. */
#ifndef OVR_PICTURES_VIEW_MATERIAL_H
#define OVR_PICTURES_VIEW_MATERIAL_H

#include "pictures/growing_text.h"
#include "pictures/stored.h"

/* Adds `"material":{...},` of the first body that yielded, as the run left it,
 * with the place of its reference at each of `shots` snapshots, each `every`-th
 * of the run; nothing for a run without [plastic] or without a feature. */
ovr_status ovr_view_material(ovr_text *to, const ovr_stored *run, size_t shots,
                             size_t every, ovr_arena *arena, ovr_error *err);

#endif
