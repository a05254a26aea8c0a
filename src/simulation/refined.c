/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "simulation/refined.h"
#include "multigrid/flow.h"
#include "simulation/physics.h"
#include "simulation/quantity_row.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Half-width of a patch around the spike in parent mesh sizes; with larger
 * patches the spike height changes by less than between two levels (measured).
 */
static double half_width(const ovr_simulation *sim)
{
    double M = sim->contact.M;
    return M <= 50 ? 24 : M <= 150 ? 48 : M <= 500 ? 64 : 96;
}

/* Last level of automatic refinement. A uniform grid of level 18 has 2 million
 * nodes; with patches a level costs 10 microseconds per cycle. */
enum { LAST_LEVEL = 22 };

static int last_level(const ovr_options *o)
{
    return o->refine_level ? o->refine_level : LAST_LEVEL;
}

static bool chosen(const ovr_options *o)
{
    return o->refine != OVR_REFINE_NONE;
}

/* Patches require a pressure that is linear between nodes. */
static void prepare(ovr_hierarchy *grids)
{
    grids->influence.linear = true;
}

static ovr_status create(ovr_simulation *sim, const void *form, void **own,
                         ovr_error *err)
{
    size_t maximum[OVR_LEVELS], n = sim->finest->grid.n;
    int patches = last_level(&sim->options) - sim->options.level;
    ovr_refined *r = ovr_arena_take(&sim->arena, 1, sizeof *r, err);
    (void)form;
    if (!r)
        return OVR_NO_MEMORY;
    *own = r;
    r->maximum = n;
    for (int k = 0; k < patches; k++) {
        maximum[k] = ovr_spike_max(k + 1, half_width(sim), &sim->finest->grid);
        r->maximum += maximum[k];
    }
    sim->maximum = r->maximum;
    r->X = ovr_arena_take(&sim->arena, r->maximum, sizeof *r->X, err);
    r->whole = ovr_arena_take(&sim->arena, n, sizeof *r->whole, err);
    return ovr_composite_prepare(&r->composite, &sim->grids, maximum, patches,
                                 &sim->arena, err);
}

static void forget(ovr_simulation *sim, void *own)
{
    (void)own;
    ovr_whole_domain(sim);
}

/* X^2/2 - S at T = 0. */
static void rigid(void *data, size_t n, const double *X, double *gap)
{
    ovr_simulation *sim = data;
    const ovr_smooth smooth = ovr_simulation_smooth(sim, 0);
    ovr_surface_heights(sim, 0, n, X, gap);
    for (size_t i = 0; i < n; i++)
        gap[i] = ovr_smooth_at(&smooth, X[i]) - gap[i];
}

/* ------------------------------------------------------------------ leaves */

/* Copies leaf i of a part to node n of the solution. */
static void copy_leaf(ovr_simulation *sim, ovr_refined *r,
                      const ovr_patch *part, size_t i, const double *H)
{
    size_t n = sim->now.n++;
    r->X[n] = part->level->grid.X[i];
    sim->now.P[n] = part->P[i];
    sim->now.H[n] = H[i];
    sim->now.q[n] = part->q[i];
    sim->now.eps[n] = part->eps[i];
}

/* Collects the nodes `from` to `to` of a part that are not covered by the next
 * patch. */
static void copy_leaves(ovr_simulation *sim, ovr_refined *r, int k, size_t from,
                        size_t to)
{
    ovr_composite *c = &r->composite;
    const ovr_patch *part = &c->part[k];
    double *H = part->outer_w; /* unused after the solve */
    ovr_level_read(&sim->grids, part->level, part->level->f.H, H);
    for (size_t i = from; i <= to; i++) {
        if (ovr_composite_leaf(c, k, i)) {
            copy_leaf(sim, r, part, i, H);
            continue;
        }
        copy_leaves(sim, r, k + 1, part[1].from, part[1].to);
        i = ovr_patch_end(part + 1) - 1;
    }
}

static void weigh(ovr_solution *now)
{
    memset(now->weights, 0, now->n * sizeof *now->weights);
    for (size_t i = 1; i < now->n; i++) {
        double half = 0.5 * ovr_spacing(now, i);
        now->weights[i - 1] += half;
        now->weights[i] += half;
    }
}

/* 2 E between neighbouring leaves, if the solution contains the flow. */
static void join(ovr_simulation *sim)
{
    const ovr_solution *now = &sim->now;
    for (size_t i = 0; now->flow && i + 1 < now->n; i++) {
        const ovr_pair nodes = {.H = {now->H[i], now->H[i + 1]},
                                .q = {now->q[i], now->q[i + 1]},
                                .eps = {now->eps[i], now->eps[i + 1]}};
        now->flow[i] = 2 * ovr_flow_between(&sim->grids.fluid, 1, &nodes);
    }
}

static void read_leaves(ovr_simulation *sim, ovr_refined *r)
{
    for (int k = 0; k <= r->composite.patches; k++)
        ovr_patch_read(&sim->grids, &r->composite.part[k]);
    sim->now.n = 0;
    sim->now.X = r->X;
    sim->now.D = r->found.D;
    copy_leaves(sim, r, 0, 0, sim->finest->grid.n - 1);
    weigh(&sim->now);
    join(sim);
    ovr_surface_heights(sim, 0, sim->now.n, r->X, sim->shapes.S);
}

/* Uses the fluxes of the patches in the pressurized region, because those of
 * the grid of the whole domain are of second order only. */
static double mean_flow(const ovr_simulation *sim, const ovr_composite *c)
{
    double sum = 0, length = 0;
    for (int k = c->patches > 0; k <= c->patches; k++) {
        const ovr_patch *part = &c->part[k];
        const double *X = part->level->grid.X;
        for (size_t i = part->from; i < part->to; i++)
            if (part->P[i] > 0 && part->P[i + 1] > 0 &&
                ovr_composite_leaf(c, k, i) &&
                ovr_composite_leaf(c, k, i + 1)) {
                double mesh = X[i + 1] - X[i];
                sum += mesh * ovr_patch_flux(&sim->grids, part, i);
                length += mesh;
            }
    }
    return length > 0 ? -sum / length : 0;
}

/* Convected content for nodes that are not equidistant; row 1 and reverse flow
 * are as on a uniform grid. */
static double carried(const ovr_simulation *sim, const void *own, size_t i,
                      double flow)
{
    const double *q = sim->now.q;
    (void)own;
    if (i == 0 || sim->histories.backward)
        return flow;
    return q[i] + 0.5 * (q[i] - q[i - 1]) * ovr_spacing(&sim->now, i + 1) /
                      ovr_spacing(&sim->now, i);
}

static void unknown(ovr_observation *o)
{
    o->refined_level = 0;
    o->spike_change = NAN;
}

static void observe(ovr_simulation *sim, void *own, ovr_observation *o)
{
    const ovr_refined *r = own;
    (void)sim;
    o->refined_level = r->found.level;
    o->spike_change = r->found.change;
}

/* ----------------------------------------------------------------- solving */

static void finish(ovr_simulation *sim, void *own, const ovr_full *how,
                   ovr_outcome *outcome)
{
    const ovr_options *o = &sim->options;
    ovr_refined *r = own;
    ovr_error err = {0};
    double change = o->refine_change > 0 ? o->refine_change : OVR_REFINE_CHANGE;
    const ovr_spike_search search = {
        .cycling = how->cycling,
        .level = last_level(o),
        .change = o->refine_level ? 0 : change,
        .half = half_width(sim),
        .tolerance = ovr_negligible_tolerance(sim, ovr_mesh(sim),
                                              outcome->defect.centre),
        .max_cycles = how->max_cycles,
        .fourth = sim->order == 4,
        .rigid = rigid,
        .data = sim};
    ovr_composite_begin(&r->composite, sim->target.force);
    if (ovr_spike_solve(&r->composite, &search, &r->found, &outcome->cycles,
                        &err))
        outcome->defect.imbalance = INFINITY; /* cannot happen, because the
                                               * memory has been reserved */
    else
        outcome->defect = r->found.defect;
    read_leaves(sim, r);
}

/* Reports patches that did not reach the requested accuracy. */
static void review(const ovr_simulation *sim, const void *own,
                   ovr_physics_message *say, void *data)
{
    const ovr_options *target = &sim->options;
    const ovr_observation *o = &sim->observation;
    double change = ((const ovr_refined *)own)->found.change;
    char text[200];
    if (o->refined_level == target->level)
        snprintf(text, sizeof text,
                 "refine: no space for a patch around X = %.4g in this domain; "
                 "move domain.outlet further out or use a higher level",
                 isfinite(o->X_spike) ? o->X_spike : o->X_cavitation);
    else if (!isfinite(o->P_spike))
        snprintf(text, sizeof text,
                 "refine: the pressure has no spike; its sharpest bend was "
                 "refined to level %d",
                 o->refined_level);
    else if (!target->refine_level && change > target->refine_change)
        snprintf(text, sizeof text,
                 "the spike's height still changes by %.2g at level %d, where "
                 "the patches end",
                 change, o->refined_level);
    else
        return;
    say(data, o->refined_level == target->level || isfinite(o->P_spike), text);
}

static const ovr_observable quantities[] = {
    OVR_NUMBER_ROW(NULL, "refined_level", NULL, COUNT, refined_level,
                   OVR_PHYSICS_REFINED,
                   "level of the finest patch about the spike"),
    OVR_NUMBER_ROW(NULL, "spike_change", NULL, NUMBER, spike_change,
                   OVR_PHYSICS_REFINED,
                   "relative change of the spike's height by the last level")};

static const ovr_physics_in_solve in_solve = {.makes_nodes = true,
                                              .chosen = chosen,
                                              .prepare = prepare,
                                              .take = create,
                                              .forget = forget,
                                              .finish = finish};

static const ovr_physics_in_output in_output = {.review = review,
                                                .carried = carried,
                                                .unknown = unknown,
                                                OVR_QUANTITIES(quantities),
                                                .observe = observe};

const ovr_physics ovr_physics_patches = {.name = "patches (refine)",
                                         .bit = OVR_PHYSICS_REFINED,
                                         .in_solve = &in_solve,
                                         .in_output = &in_output};

bool ovr_refined_mean_flow(const ovr_simulation *sim, double *flow)
{
    for (const ovr_present *p = sim->physics.on; p->is; p++)
        if (p->is == &ovr_physics_patches) {
            *flow = mean_flow(sim, &((const ovr_refined *)p->own)->composite);
            return true;
        }
    return false;
}
