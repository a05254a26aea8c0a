/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A step by continuation: where a load jumps, or a film fills the outlet, the
 * solution is tenths of ph from the past, and cycles find it from within some
 * 1/alphabar.  Between them lies a path (Keller's global homotopy)
 *
 *     N(P) = F - (1 - s) r(P^k),   D sum P = w_s,   s = 0..1
 *
 * r(P^k) the residual that the last solution P^k leaves in the equations of
 * the step, w_s between its load and the one that is asked for: at s = 0 it is
 * the solution, at s = 1 nothing is added any more.  Where cavitation is
 * mass-conserving the rows of cavitated nodes are on the path as all others,
 * with their contents q, which are a solution's at both of its ends.  Each
 * solution on the path begins from the line through the two before it; a
 * stretch that fails is halved, from the last solution's pressure, contents and
 * inlet.
 */
#include <math.h>
#include <string.h>

#include "simulation/mirror.h"
#include "simulation/physics.h"
#include "simulation/step_cycles.h"

typedef struct path {
    ovr_simulation *sim;
    double load[2];
    double s;          /* of the equations as they are */
    double at, before; /* of the last two solutions */
    double H0, H0_before;
} path;

/* The equations at s. */
static void set_equations(path *p, double s)
{
    ovr_simulation *sim = p->sim;
    ovr_level *finest = sim->finest;
    double *F = ovr_work_take(sim);
    ovr_nodes_read(sim, finest, finest->f.F, F);
    sim->grids.kernels->combine(finest->grid.n, 1, F, s - p->s,
                                sim->start.lacking, F);
    ovr_nodes_write(sim, finest, F, finest->f.F);
    ovr_work_give(sim, F);
    finest->force = p->load[0] + s * (p->load[1] - p->load[0]);
    if (s == 1)
        finest->force = p->load[1];
    p->s = s;
}

/* P and H0 for s by the line through the last two solutions, where wet. */
static void begin_from(const path *p, double s)
{
    ovr_simulation *sim = p->sim;
    double stretch = p->at - p->before;
    double factor = stretch > 0 ? (s - p->at) / stretch : 0;
    const double weight[] = {1 + factor, -factor};
    const double *const from[] = {sim->start.saved, sim->start.saved_before};
    double *P = ovr_work_take(sim);
    sim->grids.kernels->extrapolate(sim->finest->grid.n, 2, weight, from, P);
    ovr_nodes_write(sim, sim->finest, P, sim->finest->f.P);
    ovr_work_give(sim, P);
    OVR_EACH_PHYSICS(sim, each, in_step, go_back)
        each->is->in_step->go_back(sim, each->own, sim->start.saved);
    sim->grids.H0 = p->H0 + factor * (p->H0 - p->H0_before);
}

static void keep(path *p)
{
    ovr_simulation *sim = p->sim;
    size_t bytes = sim->now.n * sizeof(double);
    memcpy(sim->start.saved_before, sim->start.saved, bytes);
    memcpy(sim->start.saved, sim->now.P, bytes);
    OVR_EACH_PHYSICS(sim, each, in_step, keep)
        each->is->in_step->keep(sim, each->own);
    p->before = p->at;
    p->H0_before = p->H0;
    p->at = p->s;
    p->H0 = sim->grids.H0;
}

static path begin(ovr_simulation *sim)
{
    ovr_level *finest = sim->finest;
    double H0 = sim->past.H0[0];
    path p = {sim, {0, finest->force}, 1, 0, 0, H0, H0};
    ovr_level_refresh(&sim->grids, finest);
    ovr_nodes_read(sim, finest, finest->f.P, sim->start.saved);
    OVR_EACH_PHYSICS(sim, each, in_step, keep)
        each->is->in_step->keep(sim, each->own);
    ovr_nodes_read(sim, finest, finest->f.r, sim->start.lacking);
    p.load[0] = ovr_level_load(&sim->grids, finest);
    return p;
}

bool ovr_step_continued(ovr_simulation *sim, const ovr_cycling *cycle,
                        ovr_outcome *outcome)
{
    enum { MAX = 400, A_POINT = 10, THE_LAST = 40 };
    const double minimum = 1. / 256, loose = 1e-3, hopeless = 1e5;
    int maximum = outcome->cycles + MAX;
    bool failed = false;
    double ds = 0.25;
    path p = begin(sim);
    while (p.at < 1 && ds >= minimum && outcome->cycles < maximum) {
        double s = fmin(1, p.at + ds);
        ovr_step_cycling how = {*cycle, false, s < 1 ? A_POINT : THE_LAST,
                                hopeless, s < 1 ? loose : 0};
        begin_from(&p, s);
        set_equations(&p, s);
        bool found = ovr_step_cycles(sim, how, outcome);
        if (found)
            keep(&p);
        ds *= !found ? 0.5 : failed ? 1 : 2;
        failed = !found;
    }
    set_equations(&p, 1);
    return p.at == 1;
}
