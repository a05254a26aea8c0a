/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Fourth order of the steady solution, and what a run keeps of it.
 *
 * A run adds the corrections of its steady start to the right-hand sides of
 * every step: they take the background's error of second order away, that of
 * what moves stays.  So they must not hold what moves: they are those of the
 * smooth surfaces with what stands still, fully grown.  They are right for
 * one load, speed and radius, with a flow law one sliding speed; where these
 * vary, start and run are of second order.
 */
#include <string.h>

#include "simulation/mirror.h"

void ovr_fourth_forget(ovr_simulation *sim)
{
    size_t bytes = sim->now.n * sizeof(double);
    sim->order = 2;
    if (sim->options.order != 4)
        return;
    memset(sim->F_fourth, 0, bytes);
    memset(sim->gap_fourth, 0, bytes);
}

void ovr_fourth_begin(ovr_simulation *sim)
{
    bool varies = ovr_history_varies(sim->load) ||
                  ovr_history_varies(sim->speed) ||
                  ovr_history_varies(sim->radius) ||
                  ovr_history_varies(sim->radius_1) ||
                  (sim->lubricant.rheology != OVR_NEWTONIAN &&
                   ovr_history_varies(sim->sliding));
    ovr_fourth_forget(sim);
    if (sim->scheme->order == 1)
        sim->order = 1;
    else if (!varies)
        sim->order = sim->options.order;
}

static void standing_heights(const ovr_simulation *sim, double *S)
{
    memset(S, 0, sim->now.n * sizeof *S);
    if (sim->standing)
        sim->standing(sim->standing_data, 0, sim->now.n, sim->now.X, S);
}

bool ovr_fourth_stands_apart(ovr_simulation *sim)
{
    size_t n = sim->now.n;
    double *S = sim->scratch[0];
    if (!sim->standing_given || !sim->heights)
        return false;
    sim->heights(sim->heights_data, 0, n, sim->now.X, sim->S);
    standing_heights(sim, S);
    return sim->grids.kernels->difference(n, S, sim->S) > 0;
}

void ovr_fourth_standing_gap(ovr_simulation *sim)
{
    const ovr_smooth smooth = ovr_simulation_smooth(sim, 0);
    double *gap = sim->scratch[0];
    standing_heights(sim, gap);
    for (size_t i = 0; i < sim->now.n; i++)
        gap[i] = ovr_smooth_at(&smooth, sim->now.X[i]) - gap[i];
    ovr_nodes_write(sim, sim->finest, gap, sim->finest->f.gap);
}

void ovr_simulation_standing(ovr_simulation *sim, ovr_heights *standing,
                             void *data)
{
    sim->standing = standing;
    sim->standing_data = data;
    sim->standing_given = true;
}

int ovr_simulation_order(const ovr_simulation *sim)
{
    return sim->order;
}
