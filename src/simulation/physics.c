/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "simulation/physics.h"

#include <string.h>

#include "simulation/mirror.h"

static int place_of(const ovr_simulation *sim, const ovr_physics *physics)
{
    int k = 0;
    while (sim->physics.list[k] && sim->physics.list[k] != physics)
        k++;
    return k;
}

/* Active models are stored in the order of the list; an active one keeps its
 * place. */
static ovr_present *place_for(ovr_simulation *sim, const ovr_physics *physics)
{
    ovr_present *all = sim->physics.on;
    int at = 0, last;
    while (all[at].is && place_of(sim, all[at].is) < place_of(sim, physics))
        at++;
    if (all[at].is == physics)
        return &all[at];
    for (last = at; all[last].is;)
        last++;
    if (last == OVR_MAX_PHYSICS)
        return NULL;
    for (; last > at; last--)
        all[last] = all[last - 1];
    return &all[at];
}

/* Copies the pressure to the grids, which may contain the mirror image
 * (mirror.h). */
static void set_asperity_pressure(ovr_simulation *sim, const double *along_x)
{
    double *image = ovr_work_take(sim);
    if (sim->histories.mirrored)
        ovr_mirror(sim->finest->grid.n, along_x, image);
    ovr_level_set_asperity_pressure(&sim->grids, sim->finest,
                                    sim->histories.mirrored ? image : along_x);
    ovr_work_give(sim, image);
}

void ovr_physics_clear_asperity_pressure(ovr_simulation *sim)
{
    if (!sim->asperity_P)
        return;
    double *none = ovr_work_take(sim);
    memset(none, 0, sim->finest->grid.n * sizeof *none);
    set_asperity_pressure(sim, none);
    ovr_work_give(sim, none);
}

void ovr_physics_keep_asperity_pressure(ovr_simulation *sim)
{
    size_t bytes = sim->now.n * sizeof *sim->asperity_P;
    if (!sim->asperity_P)
        return;
    memcpy(sim->asperity_P_before[1], sim->asperity_P_before[0], bytes);
    memcpy(sim->asperity_P_before[0], sim->asperity_P, bytes);
    ovr_nodes_read(sim, sim->finest, sim->finest->asperity_P, sim->asperity_P);
}

void ovr_physics_restore_asperity_pressure(ovr_simulation *sim)
{
    if (sim->asperity_P)
        set_asperity_pressure(sim, sim->asperity_P);
}

ovr_status ovr_physics_take_asperity_pressure(ovr_simulation *sim,
                                              ovr_error *err)
{
    double **const all[] = {&sim->asperity_P, &sim->asperity_P_before[0],
                            &sim->asperity_P_before[1]};
    for (size_t k = 0; k < sizeof all / sizeof *all; k++)
        *all[k] = ovr_arena_take(&sim->arena, sim->maximum, sizeof **all[k],
                                 err);
    return ovr_arena_status(&sim->arena);
}

static ovr_status add(ovr_simulation *sim, const ovr_physics *physics,
                      const void *form, ovr_error *err)
{
    void *own = NULL;
    ovr_present *at;
    const ovr_physics_in_solve *solve = physics->in_solve;
    if (solve && solve->take) {
        ovr_status status = solve->take(sim, form, &own, err);
        if (status)
            return status;
    }
    at = place_for(sim, physics);
    if (!at)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "a simulation supports at most %d physical models",
                        OVR_MAX_PHYSICS);
    *at = (ovr_present){physics, own};
    sim->physics.solver = NULL;
    OVR_EACH_PHYSICS(sim, p, in_solve, solver)
        sim->physics.solver = p;
    if (solve && solve->influence)
        solve->influence(sim, own, &sim->grids.influence);
    return OVR_OK;
}

void ovr_physics_prepare(ovr_simulation *sim)
{
    for (int k = 0; sim->physics.list[k]; k++) {
        const ovr_physics_in_solve *p = sim->physics.list[k]->in_solve;
        if (p && p->chosen && p->chosen(&sim->options) && p->prepare)
            p->prepare(&sim->grids);
    }
}

ovr_status ovr_physics_choose(ovr_simulation *sim, ovr_error *err)
{
    for (int k = 0; sim->physics.list[k]; k++) {
        const ovr_physics_in_solve *p = sim->physics.list[k]->in_solve;
        if (p && p->chosen && p->chosen(&sim->options) &&
            add(sim, sim->physics.list[k], NULL, err))
            return OVR_NO_MEMORY;
    }
    return OVR_OK;
}

ovr_status ovr_physics_add(ovr_simulation *sim, const ovr_physics *physics,
                           const void *form, ovr_error *err)
{
    ovr_status status = add(sim, physics, form, err);
    if (!status && physics->in_solve && physics->in_solve->influence &&
        !sim->arena.blank)
        ovr_simulation_fill(sim);
    return status;
}

ovr_status ovr_physics_check(const ovr_simulation *sim, ovr_error *err)
{
    OVR_EACH_PHYSICS(sim, p, in_step, check)
        if (p->is->in_step->check(sim, p->own, err))
            return OVR_BAD_INPUT;
    return OVR_OK;
}

void ovr_physics_review(const ovr_simulation *sim, ovr_physics_message *say,
                        void *data)
{
    OVR_EACH_PHYSICS(sim, p, in_output, review)
        p->is->in_output->review(sim, p->own, say, data);
}
