/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The nodes of the solution: memory, what is read from the finest level,
 * integrals, the state that is shown. */
#include "simulation/mirror.h"

ovr_status ovr_simulation_take(ovr_simulation *sim, double **const to[],
                               ovr_error *err)
{
    for (; *to; to++)
        if (!(**to = ovr_arena_take(&sim->arena, sim->now.n, sizeof ***to,
                                    err)))
            return OVR_NO_MEMORY;
    return OVR_OK;
}

void ovr_whole_domain(ovr_simulation *sim)
{
    sim->now.n = sim->finest->grid.n;
    sim->now.D = ovr_mesh(sim);
    sim->now.X = sim->finest->grid.X;
    ovr_grid_weights(&sim->finest->grid, sim->now.weights);
}

/* The grid is known before anything is solved. */
void ovr_simulation_fill(ovr_simulation *sim)
{
    ovr_hierarchy_fill(&sim->grids);
    ovr_whole_domain(sim);
    ovr_inflow_fill(sim);
    ovr_publish_state(sim);
}

double ovr_integral(const ovr_simulation *sim, const double *f)
{
    return sim->grids.kernels->gain(sim->now.n, sim->now.weights, f, NULL);
}

const double *ovr_solid_pressure(const ovr_simulation *sim, double *workspace)
{
    const double *P = sim->now.P;
    if (!sim->borne)
        return P;
    ovr_nodes_read(sim, sim->finest, sim->finest->borne, workspace);
    sim->grids.kernels->combine(sim->now.n, 1, workspace, 1, P, workspace);
    return workspace;
}

void ovr_simulation_read(ovr_simulation *sim)
{
    for (size_t k = 0; k < OVR_FIELD_COUNT; k++)
        if (ovr_field_rows[k].shown && sim->finest->f.all[k])
            ovr_nodes_read(sim, sim->finest, sim->finest->f.all[k],
                           sim->now.all[k]);
}

void ovr_publish_state(ovr_simulation *sim)
{
    ovr_state *state = &sim->state;
    state->n = sim->now.n;
    state->D = sim->now.D;
    state->X = sim->now.X;
    state->weights = sim->now.weights;
    state->q = sim->now.q;
    state->eps = sim->now.eps;
    state->P = sim->now.P;
    state->H = sim->now.H;
    state->S = sim->S;
    state->H0 = sim->grids.H0;
}
