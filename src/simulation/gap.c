/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The mesh, and what is on it before anything is solved: the smooth surfaces
 * at T, the heights on them, the gap. */
#include <math.h>
#include <string.h>

#include "contact/contact.h"
#include "simulation/mirror.h"
#include "simulation/physics.h"
#include "simulation/simulation.h"

double ovr_mesh(const ovr_simulation *sim)
{
    return ovr_grid_mesh(&sim->finest->grid);
}

ovr_smooth ovr_simulation_smooth(const ovr_simulation *sim, double T)
{
    const ovr_contact *c = &sim->contact;
    return ovr_smooth_of(&(ovr_curving){sim->radius,
                                        sim->radius_1,
                                        sim->speed,
                                        sim->sliding,
                                        {c->u1_ratio, c->u2_ratio},
                                        sim->convected},
                         T);
}

ovr_status ovr_smooth_check(const ovr_simulation *sim, double T, ovr_error *err)
{
    const ovr_options *o = &sim->options;
    ovr_smooth smooth = ovr_simulation_smooth(sim, T);
    if (ovr_smooth_opens(&smooth, fmax(-o->inlet, o->outlet)))
        return OVR_OK;
    if (!(ovr_history_value(sim->radius, T) > 0))
        return ovr_fail(err, OVR_BAD_INPUT,
                        "radius ratio %g at T = %g: must be positive",
                        ovr_history_value(sim->radius, T), T);
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
    if (sim->heights)
        sim->heights(sim->heights_data, T, n, X, S);
    else
        memset(S, 0, n * sizeof *S);
    OVR_EACH_PHYSICS(sim, p, heights)
        p->is->heights(sim, p->own, 0, T, n, X, S);
}

/* Returns the features of a surface; if their surface is unknown, all are on
 * one. */
static ovr_heights *features_of(const ovr_simulation *sim, int surface)
{
    const ovr_contact *c = &sim->contact;
    bool known = (sim->sides[0] || sim->sides[1]) &&
                 sim->heights == sim->sides_of &&
                 sim->heights_data == sim->sides_data;
    if (!sim->heights || known)
        return sim->heights ? sim->sides[surface - 1] : NULL;
    bool second = fabs(sim->moving - c->u2_ratio) <
                  fabs(sim->moving - c->u1_ratio);
    return second == (surface == 2) ? sim->heights : NULL;
}

bool ovr_heights_of(const ovr_simulation *sim, int surface, double *S)
{
    ovr_heights *features = features_of(sim, surface);
    OVR_LAST_PHYSICS(sim, adds, heights);
    const double *X = sim->now.X, T = sim->state.T;
    size_t n = sim->now.n;
    if (features)
        features(sim->heights_data, T, n, X, S);
    else
        memset(S, 0, n * sizeof *S);
    OVR_EACH_PHYSICS(sim, p, heights)
        p->is->heights(sim, p->own, surface, T, n, X, S);
    return features || adds->is;
}

bool ovr_has_heights(const ovr_simulation *sim)
{
    OVR_LAST_PHYSICS(sim, p, heights);
    return sim->heights || p->is;
}

void ovr_simulation_gap(ovr_simulation *sim, double T)
{
    const ovr_smooth smooth = ovr_simulation_smooth(sim, T);
    double *restrict gap = sim->scratch[0];
    const double *restrict X = sim->now.X, *restrict S = sim->S;
    size_t n = sim->now.n;
    if (ovr_has_heights(sim)) {
        memcpy(sim->S_past, S, n * sizeof *S);
        ovr_surface_heights(sim, T, n, X, sim->S);
    }
    for (size_t i = 0; i < n; i++)
        gap[i] = ovr_smooth_at(&smooth, X[i]) - S[i];
    OVR_EACH_PHYSICS(sim, p, gap)
        p->is->gap(sim, p->own, gap);
    ovr_nodes_write(sim, sim->finest, gap, sim->finest->f.gap);
}
