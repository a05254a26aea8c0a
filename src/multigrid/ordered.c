/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Fields of a level in the order of its nodes, out of the lanes and back. */
#include "multigrid/hierarchy.h"

void ovr_level_read(const ovr_hierarchy *grids, const ovr_level *level,
                    const double *values, double *ordered)
{
    grids->kernels->unpack(&level->lanes, values, ordered);
}

void ovr_level_write(const ovr_hierarchy *grids, const ovr_level *level,
                     const double *ordered, double *values)
{
    grids->kernels->pack(&level->lanes, ordered, values);
}

const ovr_fields *ovr_level_ordered(const ovr_hierarchy *grids,
                                    const ovr_level *level)
{
    for (size_t k = 0; k < OVR_FIELD_COUNT; k++)
        if (ovr_field_rows[k].ordered && level->f.all[k])
            ovr_level_read(grids, level, level->f.all[k],
                           grids->natural.all[k]);
    return &grids->natural;
}
