/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "multigrid/line.h"

void ovr_relax_line(ovr_hierarchy *grids, ovr_level *level)
{
    const ovr_kernels *run = grids->kernels;
    run->band_assemble(level->n, &level->weights, level->k, level->minus,
                       level->plus, grids->op.transient, &level->f,
                       &grids->band);
    run->band_solve(level->n, &grids->band);
    run->distribute(level->n, grids->limit, &grids->band, level->f.P);
}
