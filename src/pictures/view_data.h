/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The runs of a page as JSON, in which nothing can end an element. */
#ifndef OVR_PICTURES_VIEW_DATA_H
#define OVR_PICTURES_VIEW_DATA_H

#include "pictures/picture.h"

/* Writes the field of stresses that is chosen too, or none where `stress` is
 * NULL. */
ovr_status ovr_view_data(ovr_text *to, const ovr_stored *runs, size_t count,
                         const char *stress, ovr_arena *arena, ovr_error *err);

#endif
