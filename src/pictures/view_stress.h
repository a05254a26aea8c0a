/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The stresses below the film, as a page's data. */
#ifndef OVR_PICTURES_VIEW_STRESS_H
#define OVR_PICTURES_VIEW_STRESS_H

#include "pictures/growing_text.h"
#include "pictures/stored.h"

/* Adds `"stress":{...},` of `shots` snapshots, each `every`-th of the run;
 * `field` NULL: max_shear. */
ovr_status ovr_view_stress(ovr_text *to, const ovr_stored *run,
                           const char *field, size_t shots, size_t every,
                           ovr_arena *arena, ovr_error *err);

#endif
