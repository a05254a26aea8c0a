/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Makes of a case what runs: first the contact, which gives the scales, then
 * everything else in its units, each in a file of its own.
 */
#include "case/resolve.h"

#include <math.h>

#include "base/given.h"
#include "case/resolve_element.h"
#include "contact/contact.h"
#include "contact/flow_law.h"
#include "contact/oil.h"
#include "surface/surfaces.h"

static const double ALPHA_PAPER = 1.7e-8; /* 1/Pa */

/* ---------------------------------------------------------------- contact */

/* viscosity and alpha may stand in [contact] or in [lubricant]. */
static ovr_status check_twice(const ovr_resolved *r, const char *key,
                              ovr_error *err)
{
    const ovr_slot *one = ovr_slot_of(r, "contact", key);
    const ovr_slot *other = ovr_slot_of(r, "lubricant", key);
    if (!one->given || !other->given)
        return OVR_OK;
    return ovr_fail_slot(err, other,
                         "is given in [contact] too: give it in one place");
}

static ovr_status resolve_contact(ovr_resolved *r, ovr_error *err)
{
    ovr_conditions *given = &r->values.contact;
    const ovr_block *contact = ovr_block_of(r, "contact");
    const ovr_block *lubricant = ovr_block_of(r, "lubricant");
    ovr_error why = {0};
    bool numbers;
    *given = ovr_conditions_default();
    r->values.flow = ovr_flow_form_default();
    r->values.carreau_stress = r->values.carreau_number = NAN;
    if (check_twice(r, "viscosity", err) || check_twice(r, "alpha", err))
        return OVR_BAD_INPUT;
    r->values.oil = ovr_oil_default();
    r->values.iso_vg = NAN;
    if (ovr_section_fill(r, "contact", err) ||
        ovr_section_fill(r, "lubricant", err))
        return OVR_BAD_INPUT;
    r->setup.bearable = r->values.bearable;
    if (ovr_resolve_element_keys(r, err) || ovr_resolve_bodies(r, err) ||
        ovr_resolve_element(r, err) || ovr_resolve_oil(r, err))
        return err ? err->status : OVR_BAD_INPUT;
    numbers = !isnan(given->M) || !isnan(given->L) || !isnan(given->lambda) ||
              !isnan(given->alphabar);
    if (numbers && isnan(given->alpha) && isnan(given->hertz_pressure))
        given->alpha = ALPHA_PAPER;
    if (ovr_contact_resolve(given, &r->contact, &why))
        return ovr_fail_in(err, r->c, contact, lubricant, &why);
    if (ovr_resolve_stiffness(r, err))
        return err ? err->status : OVR_BAD_INPUT;
    if (ovr_oil_scale(&r->values.oil, &r->contact, &r->lubricant, &why))
        return ovr_fail_in(err, r->c, contact, lubricant, &why);
    return OVR_OK;
}

/* -------------------------------------------------------------- all of it */

ovr_setup *ovr_case_resolve(const ovr_case *c, const ovr_allocator *allocator,
                            ovr_error *err)
{
    if (!c)
        return ovr_null(err, __func__);
    ovr_arena arena = ovr_arena_make(allocator);
    ovr_resolved *r = ovr_arena_take(&arena, 1, sizeof *r, err);
    ovr_status status;
    if (!r)
        return NULL;
    r->arena = arena;
    r->c = c;
    r->setup.contact = &r->contact;
    r->setup.lubricant = &r->lubricant;
    r->setup.options = &r->values.options;
    r->setup.march = &r->march;
    r->setup.passes = &r->values.passes;
    r->setup.output = &r->values.output;
    status = ovr_case_check_idle(c, err);
    if (!status)
        status = resolve_contact(r, err);
    if (!status)
        status = ovr_resolve_flow(r, err);
    if (!status)
        status = ovr_resolve_options(r, err);
    if (!status)
        status = ovr_resolve_time(r, err);
    if (!status)
        status = ovr_resolve_features(r, err);
    if (!status)
        status = ovr_resolve_yield(r, err);
    if (!status)
        status = ovr_resolve_physics(r, err);
    if (!status)
        status = ovr_resolve_output(r, err);
    if (!status)
        status = ovr_resolve_conflicts(r, err);
    if (!status)
        return &r->setup;
    ovr_setup_free(&r->setup);
    return NULL;
}

void ovr_setup_free(ovr_setup *setup)
{
    ovr_arena arena;
    if (!setup)
        return;
    ovr_surfaces_free(setup->surfaces);
    ovr_history_free(setup->load);
    ovr_history_free(setup->radius);
    ovr_history_free(setup->radius_1);
    ovr_history_free(setup->speed);
    ovr_history_free(setup->sliding);
    ovr_flow_law_free(((ovr_resolved *)setup)->flow_law);
    ovr_resolved_drop((ovr_resolved *)setup);
    for (int k = 0; k < 2; k++)
        ovr_law_table_free(((ovr_resolved *)setup)->tables[k]);
    ovr_resolved_element_free((ovr_resolved *)setup);
    arena = ((ovr_resolved *)setup)->arena;
    ovr_arena_release(&arena);
}
