/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "run/cost.h"
#include "case/setup.h"
#include "contact/film_formula.h"
#include "run/run.h"
#include "surface/surfaces.h"

#include <math.h>

/* Measured at level 8 on one core: the program's start, a node in a step, one
 * of a film that shears thin, the steady start in steps, and a node in a cycle.
 */
static const double START = 0.015, NODE_STEP = 1.6e-7, THINNING = 1e-7;
static const double STEADY_STEPS = 20, SECONDS_A_NODE = 5e-8;

/* Time of a run with adaptive steps relative to steps of one mesh size (cam of
 * init, levels 7 to 9). */
static const double ADAPTIVE = 0.3;

/* One cycle a patch down to the grid of the level, some more at the end; of
 * patches that go on until the spike changes little, eight. */
static double refine_seconds(const ovr_options *o, double nodes)
{
    const double nodes_a_patch = 300, usual = 8, last = 4;
    double levels = o->refine_level ? o->refine_level - o->level : usual;
    if (!o->refine)
        return 0;
    return 2 * SECONDS_A_NODE * (levels + last) *
           (nodes + levels * nodes_a_patch);
}

/* Steps in time of the steady start.  Features at rest that are higher than the
 * film grow: 20 to 1500 steps in 60 random contacts.  Grids that do not
 * resolve the inlet: up to 4000. */
static double growing_steps(const ovr_setup *setup)
{
    const double steps = 300, unresolved = 1000;
    double film = ovr_film_central_moes(setup->contact->M, setup->contact->L);
    if (setup->mesh > ovr_resolving_mesh(setup->contact->M, film))
        return unresolved;
    for (size_t k = 0, n = ovr_surfaces_count(setup->surfaces); k < n; k++) {
        ovr_feature_info info = ovr_surfaces_info(setup->surfaces, k);
        if (info.speed == 0 && !info.grows && info.amplitude > film)
            return steps;
    }
    return 0;
}

ovr_cost ovr_setup_cost(const ovr_setup *setup, double live)
{
    const ovr_march *march = setup->march;
    double dT = ovr_setup_step(setup);
    ovr_cost cost = {0};
    cost.nodes = (double)setup->nodes;
    cost.mesh = setup->mesh;
    cost.bytes = live + ovr_setup_memory(setup) +
                 ovr_setup_output_memory(setup);
    if (setup->transient)
        cost.steps = ceil(march->end / dT);
    cost.passes = setup->passes->number;
    cost.stored = ovr_setup_storage(setup);
    cost.stored.bytes *= cost.passes;
    double node_steps = cost.nodes *
                        (STEADY_STEPS +
                         (march->adaptive ? ADAPTIVE : 1) * cost.steps);
    bool thins = setup->lubricant->rheology != OVR_NEWTONIAN;
    double pass = node_steps * (NODE_STEP + (thins ? THINNING : 0)) +
                  ovr_setup_seconds_beside(setup, node_steps);
    pass += growing_steps(setup) * cost.nodes * NODE_STEP;
    cost.seconds = START + cost.passes * pass;
    cost.seconds += refine_seconds(setup->options, cost.nodes);
    return cost;
}
