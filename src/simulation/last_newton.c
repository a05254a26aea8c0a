/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The last attempt of a step: Newton's method on the finest grid with the films
 * as unknowns of their own, which stay above nothing (multigrid/touching.h), of
 * surfaces that bear nothing where they would touch, A = 0.  Rough films below
 * lambda 1 by a flow law, that no cycles find, are found so.
 *
 * What it works in is taken when a step asks for it first, and out of the
 * finest level again when it is done: other steps know nothing of it.
 */
#include "multigrid/coarsest.h"
#include "multigrid/field.h"
#include "multigrid/touching.h"
#include "simulation/mirror.h"
#include "simulation/step_cycles.h"

#include <string.h>

static void bears_nothing(const void *law, double H, double *A, double *slope)
{
    (void)law, (void)H;
    *A = *slope = 0;
}

/* Films by Reynolds on one grid, and workspace. */
static bool can(ovr_simulation *sim)
{
    ovr_hierarchy *grids = &sim->grids;
    return sim->options.smoother == OVR_LINE && !grids->touch.at &&
           !grids->content && !sim->finest->borne &&
           !sim->options.paper_balance;
}

/* Exchanges what the finest level has only meanwhile: puts it in, or takes it
 * out. */
static void exchange(ovr_simulation *sim)
{
    ovr_last_newton *own = &sim->last_newton;
    ovr_level *level = sim->finest;
    for (size_t k = 0; k < OVR_FIELD_COUNT; k++)
        if (own->mine[k])
            ovr_swap(&level->f.all[k], &own->field[k]);
    ovr_swap(&level->borne, &own->borne);
    ovr_swap(&level->pressed, &own->pressed);
}

/* Leaves all of it in the level. */
static bool take(ovr_simulation *sim)
{
    ovr_last_newton *own = &sim->last_newton;
    ovr_error err = {0};
    double *before[OVR_FIELD_COUNT];
    if (own->taken) {
        exchange(sim);
        return true;
    }
    memcpy(before, sim->finest->f.all, sizeof before);
    if (ovr_hierarchy_touch(&sim->grids, &sim->arena, &err))
        return false;
    for (size_t k = 0; k < OVR_FIELD_COUNT; k++)
        own->mine[k] = sim->finest->f.all[k] != before[k];
    ovr_newton_fill(&sim->grids);
    return own->taken = true;
}

bool ovr_step_newton(ovr_simulation *sim, const ovr_cycling *how,
                     ovr_outcome *outcome)
{
    enum { STEPS = 60 };
    const double far = 1e15;
    ovr_touch *touch = &sim->grids.touch;
    ovr_level *level = sim->finest;
    if (!can(sim) || !take(sim))
        return false;
    touch->at = bears_nothing;
    touch->share = 1;
    ovr_level_clear(level, level->borne);
    ovr_touch_settle(&sim->grids);
    bool solved = ovr_step_cycles(
        sim, (ovr_step_cycling){*how, false, STEPS, far, 0}, outcome);
    touch->at = NULL;
    exchange(sim);
    ovr_level_refresh(&sim->grids, level);
    ovr_simulation_read(sim);
    return solved && ovr_surfaces_apart(sim);
}
