/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Arrays over the nodes of a grid: aligned, zero, with OVR_FIELD_PAD zeros
 * before the first and after the last, so that stencils and whole vectors may
 * reach over the ends. */
#ifndef OVR_MULTIGRID_FIELD_H
#define OVR_MULTIGRID_FIELD_H

#include "base/arena.h"

enum { OVR_FIELD_PAD = 64 };

static inline double *ovr_field(ovr_arena *arena, size_t n, ovr_error *err)
{
    double *all = ovr_arena_take(arena, n + 2 * OVR_FIELD_PAD, sizeof(double),
                                 err);
    return all ? all + OVR_FIELD_PAD : NULL;
}

#endif
