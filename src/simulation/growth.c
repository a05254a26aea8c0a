/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Steady contacts of rough surfaces, which full multigrid does not find, by
 * growing them out of smooth ones:
 *
 *     gap(s) = X^2/2 - s S,  s = 0..1
 *
 * Each solution on the way begins from the line through the two before it; a
 * stretch that fails is halved.  It finds measured profiles on both surfaces
 * within the contact at up to twice the height that full multigrid does.  Where
 * the film breaks up behind the contact, a patch of some nodes may be left in a
 * limit cycle, R at 1e-6 to 1e-3.
 */
#include <math.h>
#include <string.h>

#include "simulation/mirror.h"
#include "simulation/step_cycles.h"

typedef struct growth {
    ovr_simulation *sim;
    const double *gap; /* at s = 1 */
    double at, before; /* of the last two solutions */
    double H0, H0_before;
} growth;

/* R and load on the way. */
static const double enough = 1e-3;

static double loose(const void *data, const ovr_level *level, double H)
{
    (void)data, (void)level, (void)H;
    return enough;
}

static void set_gap(const growth *g, double s)
{
    ovr_simulation *sim = g->sim;
    double *gap = sim->scratch[0];
    for (size_t i = 0; i < sim->now.n; i++) {
        double smooth = 0.5 * sim->now.X[i] * sim->now.X[i];
        gap[i] = s < 1 ? smooth + s * (g->gap[i] - smooth) : g->gap[i];
    }
    ovr_nodes_write(sim, sim->finest, gap, sim->finest->f.gap);
}

static void keep(growth *g, double s)
{
    ovr_simulation *sim = g->sim;
    size_t bytes = sim->now.n * sizeof(double);
    memcpy(sim->saved_before, sim->saved, bytes);
    ovr_nodes_read(sim, sim->finest, sim->finest->f.P, sim->saved);
    g->before = g->at;
    g->H0_before = g->H0;
    g->at = s;
    g->H0 = sim->grids.H0;
}

static void begin_from(const growth *g, double s)
{
    ovr_simulation *sim = g->sim;
    double stretch = g->at - g->before;
    double factor = stretch > 0 ? (s - g->at) / stretch : 0;
    const double weight[] = {1 + factor, -factor};
    const double *const from[] = {sim->saved, sim->saved_before};
    double *P = sim->scratch[0];
    sim->grids.kernels->extrapolate(sim->now.n, 2, weight, from, P);
    ovr_nodes_write(sim, sim->finest, P, sim->finest->f.P);
    sim->grids.H0 = g->H0 + factor * (g->H0 - g->H0_before);
}

/* Cycles at s, which reach more than a point on the way where it is 1. */
static ovr_defect solve_at(const growth *g, double s, const ovr_full *how,
                           int *cycles)
{
    enum { A_POINT = 40 };
    ovr_simulation *sim = g->sim;
    ovr_full own = *how;
    if (s < 1) {
        own.tolerance = loose;
        own.most_cycles = A_POINT;
    }
    own.fixed = false;
    begin_from(g, s);
    set_gap(g, s);
    ovr_level_refresh(&sim->grids, sim->finest);
    return ovr_full_cycles(&sim->grids, sim->finest, &own, cycles);
}

static ovr_defect smooth(const growth *g, const ovr_full *how, int *cycles)
{
    ovr_full own = *how;
    own.watch = NULL;
    set_gap(g, 0);
    return ovr_full_multigrid(&g->sim->grids, &g->sim->wanted, own, cycles);
}

static bool found_at(const growth *g, double s, const ovr_full *how,
                     ovr_defect d)
{
    ovr_level *finest = g->sim->finest;
    double wanted = how->tolerance(how->data, finest, d.centre);
    return ovr_below(d, s < 1 ? fmax(enough, wanted) : wanted);
}

ovr_defect ovr_steady_grown(ovr_simulation *sim, const ovr_full *how,
                            int *cycles)
{
    const double least = 1. / 1024;
    double ds = 0.25;
    growth g = {.sim = sim, .gap = sim->lacking};
    ovr_nodes_read(sim, sim->finest, sim->finest->f.gap, sim->lacking);
    if (found_at(&g, 0, how, smooth(&g, how, cycles)))
        keep(&g, 0);
    else
        ds = 0;
    while (g.at < 1 && ds >= least && !ovr_hierarchy_stops(&sim->grids)) {
        double s = fmin(1, g.at + ds);
        bool found = found_at(&g, s, how, solve_at(&g, s, how, cycles));
        if (found)
            keep(&g, s);
        ds *= found ? 1.5 : 0.5;
    }
    set_gap(&g, 1); /* whatever was reached */
    ovr_level_refresh(&sim->grids, sim->finest);
    return ovr_cycle_defect(&sim->grids, sim->finest);
}
