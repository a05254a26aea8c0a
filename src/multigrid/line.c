/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "multigrid/line.h"

#include "multigrid/content.h"

void ovr_relax_line(ovr_hierarchy *grids, ovr_level *level,
                    const ovr_smoothing *how)
{
    const ovr_kernels *run = grids->kernels;
    if (grids->conserving) {
        ovr_content_relax(grids, level, how->limit);
        return;
    }
    run->band_assemble(&level->lanes, &level->weights, level->k, &level->shares,
                       &level->f, &grids->band);
    run->band_solve(&level->lanes, &grids->band);
    run->distribute(&level->lanes, how->limit, &level->shares, &grids->band,
                    &level->f);
}
