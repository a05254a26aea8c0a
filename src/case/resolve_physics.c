/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The physics of a case (simulation/physics.h): their sections fill their
 * forms, and what those mean says which are on. */
#include <math.h>

#include "case/resolve.h"

static ovr_physics_case about(ovr_resolved *r)
{
    return (ovr_physics_case){&r->contact, &r->lubricant, &r->values.options,
                              r->setup.transient};
}

static ovr_status resolve(ovr_resolved *r, const ovr_physics *p,
                          ovr_resolved_physics *to, ovr_error *err)
{
    const ovr_physics_case of = about(r);
    const ovr_block *block = ovr_block_of(r, p->section->name);
    ovr_error why = {0};
    to->form = ovr_arena_take(&r->arena, 1, p->form, err);
    if (!to->form)
        return OVR_NO_MEMORY;
    if (ovr_block_fill(r, block, to->form, err))
        return OVR_BAD_INPUT;
    if (p->resolve(&of, to->form, &to->on, &why))
        return ovr_fail_in(err, r->c, block, NULL, &why);
    return OVR_OK;
}

ovr_status ovr_resolve_physics(ovr_resolved *r, ovr_error *err)
{
    ovr_status status = OVR_OK;
    for (int k = 0; !status && ovr_physics_list[k]; k++)
        if (ovr_physics_list[k]->section)
            status = resolve(r, ovr_physics_list[k], &r->physics[k], err);
    return status;
}

void ovr_resolved_turn_on(ovr_resolved *r, const ovr_physics *physics,
                          void *form)
{
    for (int k = 0; ovr_physics_list[k]; k++)
        if (ovr_physics_list[k] == physics)
            r->physics[k] = (ovr_resolved_physics){form, true};
}

static bool is_on(const ovr_resolved *r, int k)
{
    const ovr_physics *p = ovr_physics_list[k];
    return r->physics[k].on || (p->chosen && p->chosen(r->setup.options));
}

unsigned ovr_setup_physics(const ovr_setup *setup)
{
    if (!setup)
        return 0;
    const ovr_resolved *r = (const ovr_resolved *)setup;
    unsigned bits = setup->features ? OVR_PHYSICS_FEATURES : 0;
    for (int k = 0; ovr_physics_list[k]; k++)
        if (is_on(r, k))
            bits |= ovr_physics_list[k]->bit;
    return bits;
}

ovr_status ovr_setup_add_physics(const ovr_setup *setup, ovr_simulation *sim,
                                 ovr_error *err)
{
    const ovr_resolved *r = (const ovr_resolved *)setup;
    for (int k = 0; ovr_physics_list[k]; k++)
        if (r->physics[k].on &&
            ovr_physics_add(sim, ovr_physics_list[k], r->physics[k].form, err))
            return err ? err->status : OVR_BAD_INPUT;
    return OVR_OK;
}

bool ovr_setup_has(const ovr_setup *setup, int k)
{
    return is_on((const ovr_resolved *)setup, k);
}

const ovr_physics *ovr_setup_makes_nodes(const ovr_setup *setup)
{
    for (int k = 0; ovr_physics_list[k]; k++)
        if (ovr_physics_list[k]->makes_nodes && ovr_setup_has(setup, k))
            return ovr_physics_list[k];
    return NULL;
}

/* Once the grid is known, of what stands beside the simulation too. */
static double beside(const ovr_setup *setup)
{
    const ovr_resolved *r = (const ovr_resolved *)setup;
    double bytes = 0;
    for (int k = 0; setup->nodes && ovr_physics_list[k]; k++)
        if (r->physics[k].on && ovr_physics_list[k]->memory)
            bytes += ovr_physics_list[k]->memory(r->physics[k].form);
    return bytes;
}

double ovr_setup_memory(const ovr_setup *setup)
{
    if (!setup)
        return NAN;
    ovr_simulation *sim = ovr_simulation_counted(setup->options);
    double bytes = INFINITY;
    if (sim && !ovr_setup_add_physics(setup, sim, NULL))
        bytes = (double)sim->arena.bytes + beside(setup);
    ovr_simulation_free(sim);
    return bytes;
}

void ovr_setup_tell(const ovr_setup *setup, ovr_setup_line *line, void *data)
{
    if (!line)
        return;
    if (!setup)
        return;
    ovr_resolved *r = (ovr_resolved *)setup;
    const ovr_physics_case of = about(r);
    for (int k = 0; ovr_physics_list[k]; k++)
        if (is_on(r, k) && ovr_physics_list[k]->tell)
            ovr_physics_list[k]->tell(&of, r->physics[k].form, line, data);
}
