/* SPDX-License-Identifier: GPL-3.0-or-later */

#include "simulation/solution.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "contact/contact.h"
#include "simulation/fourth.h"
#include "simulation/internal.h"
#include "simulation/mirror.h"
#include "simulation/observe.h"
#include "simulation/physics.h"
#include "simulation/simulation.h"

/* ------------------------------------------------------------ Interpolation */

size_t ovr_node_after(const ovr_solution *s, double X)
{
    size_t low = 0, high = s->n - 1;
    while (high - low > 1) {
        size_t middle = low + (high - low) / 2;
        *(s->X[middle] <= X ? &low : &high) = middle;
    }
    return high;
}

double ovr_value_at(const ovr_solution *s, const double *f, double X)
{
    size_t after = ovr_node_after(s, X), first = after < 2 ? 0 : after - 2;
    double value = 0;
    if (first + 4 > s->n)
        first = s->n - 4;
    for (size_t k = first; k < first + 4; k++) {
        double weight = 1;
        for (size_t j = first; j < first + 4; j++)
            if (j != k)
                weight *= (X - s->X[j]) / (s->X[k] - s->X[j]);
        value += weight * f[k];
    }
    return value;
}

/* -------------------------------------------------------------------- Nodes */

/* Arrays of the solution: memory, values read from the finest level, integrals,
 * output state. */

ovr_status ovr_simulation_take(ovr_simulation *sim, double **const to[],
                               ovr_error *err)
{
    for (; *to; to++)
        **to = ovr_arena_take(&sim->arena, sim->now.n, sizeof ***to, err);
    return ovr_arena_status(&sim->arena);
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
    if (!sim->asperity_P)
        return P;
    ovr_nodes_read(sim, sim->finest, sim->finest->asperity_P, workspace);
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
    state->S = sim->shapes.S;
    state->H0 = sim->grids.H0;
    state->Y = ovr_simulation_lines(sim, &state->lines, &state->line);
}

/* ---------------------------------------------------------------------- Gap */

/* Mesh size, and the geometry before a solution: smooth surfaces at T, heights
 * of the features, gap. */

double ovr_mesh(const ovr_simulation *sim)
{
    return ovr_grid_mesh(&sim->finest->grid);
}

ovr_smooth ovr_simulation_smooth(const ovr_simulation *sim, double T)
{
    const ovr_contact *c = &sim->contact;
    return ovr_smooth_of(&(ovr_curving){sim->histories.radius,
                                        sim->histories.radius_1,
                                        sim->histories.speed,
                                        sim->histories.sliding,
                                        {c->u1_ratio, c->u2_ratio},
                                        sim->histories.convected},
                         T);
}

ovr_status ovr_smooth_check(const ovr_simulation *sim, double T, ovr_error *err)
{
    const ovr_options *o = &sim->options;
    ovr_smooth smooth = ovr_simulation_smooth(sim, T);
    if (ovr_smooth_opens(&smooth, fmax(-o->inlet, o->outlet)))
        return OVR_OK;
    if (!(ovr_history_value(sim->histories.radius, T) > 0))
        return ovr_fail(err, OVR_BAD_INPUT,
                        "radius ratio %g at T = %g: must be positive",
                        ovr_history_value(sim->histories.radius, T), T);
    return ovr_fail(
        err, OVR_BAD_INPUT,
        "the curvature at T = %g changes too fast, or a surface "
        "moves too slowly, for it to be convected with the material all "
        "over the domain",
        T);
}

void ovr_surface_heights(const ovr_simulation *sim, double T, size_t n,
                         const double *X, double *S)
{
    if (sim->shapes.heights)
        sim->shapes.heights(sim->shapes.data, T, n, X, S);
    else
        memset(S, 0, n * sizeof *S);
    OVR_EACH_PHYSICS(sim, p, in_solve, heights)
        p->is->in_solve->heights(sim, p->own, 0, T, n, X, S);
}

/* Returns the features of a surface; if their surface is unknown, all are on
 * one. */
static ovr_heights *features_of(const ovr_simulation *sim, int surface)
{
    const ovr_contact *c = &sim->contact;
    bool known = (sim->shapes.sides[0] || sim->shapes.sides[1]) &&
                 sim->shapes.heights == sim->shapes.sides_of &&
                 sim->shapes.data == sim->shapes.sides_data;
    if (!sim->shapes.heights || known)
        return sim->shapes.heights ? sim->shapes.sides[surface - 1] : NULL;
    bool second = fabs(sim->shapes.moving - c->u2_ratio) <
                  fabs(sim->shapes.moving - c->u1_ratio);
    return second == (surface == 2) ? sim->shapes.heights : NULL;
}

bool ovr_heights_of(const ovr_simulation *sim, int surface, double *S)
{
    ovr_heights *features = features_of(sim, surface);
    OVR_LAST_PHYSICS(sim, adds, in_solve, heights);
    const double *X = sim->now.X, T = sim->state.T;
    size_t n = sim->now.n;
    if (features && sim->shapes.across)
        sim->shapes.across(sim->shapes.data, surface, T, n, X, 1,
                           &sim->shapes.Y, 1, S);
    else if (features)
        features(sim->shapes.data, T, n, X, S);
    else
        memset(S, 0, n * sizeof *S);
    OVR_EACH_PHYSICS(sim, p, in_solve, heights)
        p->is->in_solve->heights(sim, p->own, surface, T, n, X, S);
    return features || adds->is;
}

bool ovr_has_heights(const ovr_simulation *sim)
{
    OVR_LAST_PHYSICS(sim, p, in_solve, heights);
    return sim->shapes.heights || p->is;
}

void ovr_simulation_gap(ovr_simulation *sim, double T)
{
    const ovr_smooth smooth = ovr_simulation_smooth(sim, T);
    double *restrict gap = ovr_work_take(sim);
    const double *restrict X = sim->now.X, *restrict S = sim->shapes.S;
    size_t n = sim->now.n;
    if (ovr_has_heights(sim)) {
        memcpy(sim->shapes.S_past, S, n * sizeof *S);
        ovr_surface_heights(sim, T, n, X, sim->shapes.S);
    }
    for (size_t i = 0; i < n; i++)
        gap[i] = ovr_smooth_at(&smooth, X[i]) - S[i];
    ovr_fourth_gap(sim, gap);
    ovr_nodes_write(sim, sim->finest, gap, sim->finest->f.gap);
    ovr_work_give(sim, gap);
}

/* -------------------------------------------------------- Pieces of a state */

void ovr_show(ovr_pieces *state, const char *name, void *memory, size_t bytes)
{
    if (!state->status)
        state->status = state->visit(state->context, name, memory, bytes,
                                     state->err);
}

void ovr_show_nodes(const ovr_simulation *sim, ovr_pieces *state,
                    const char *name, int number, double *values)
{
    char text[40];
    snprintf(text, sizeof text, "%s_%d", name, number);
    ovr_show(state, text, values, sim->now.n * sizeof *values);
}
