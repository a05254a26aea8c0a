/* SPDX-License-Identifier: GPL-3.0-or-later */
/* [stress] and [fatigue]. */
#include <math.h>
#include <string.h>

#include "base/error.h"
#include "case/resolve.h"
#include "case/two_columns.h"
#include "contact/contact.h"
#include "elements/elements.h"
#include "results/results.h"
#include "stress/stress.h"

static ovr_status resolve_window(ovr_resolved *r, ovr_error *err)
{
    ovr_stress_setup *s = &r->values.stress;
    const ovr_list *window = &r->values.window;
    const ovr_slot *slot = ovr_block_get(ovr_block_of(r, "stress"), "window");
    s->from = s->to = NAN;
    if (!window->count)
        return OVR_OK;
    if (window->count != 2 || !(window->values[0] < window->values[1]))
        return ovr_fail_slot(err, slot, "must be FROM, TO with FROM below TO");
    s->from = window->values[0];
    s->to = window->values[1];
    return OVR_OK;
}

/* A surface that stands still has no material history; one that changes its
 * speed may later, but not as it begins. */
static ovr_status check_motion(const ovr_resolved *r, ovr_error *err)
{
    const ovr_contact *contact = r->setup.contact;
    const ovr_block *stress = ovr_block_of(r, "stress");
    const ovr_slot *slot = ovr_block_get(stress, "surface");
    double ratio[] = {contact->u1_ratio, contact->u2_ratio};
    double Cu = ovr_history_value(r->setup.speed, 0);
    for (int k = 0; r->setup.sliding && Cu != 0 && k < 2; k++)
        ratio[k] = Cu +
                   (k ? -0.5 : 0.5) * ovr_history_value(r->setup.sliding, 0);
    for (int k = 0; k < 2; k++) {
        if (!(r->values.stress.surfaces >> k & 1) || ratio[k] != 0)
            continue;
        if (slot->given)
            return ovr_fail_slot(
                err, slot,
                "surface %d stands still, so its material does not pass the "
                "contact: choose the other surface",
                k + 1);
        return ovr_fail_at(
            err, OVR_BAD_INPUT, r->c->name, stress->line,
            "[stress]: surface %d stands still, so its material does not pass "
            "the contact: choose the other surface",
            k + 1);
    }
    return OVR_OK;
}

/* Of a bearing it is the circumference. */
static void resolve_raceway(ovr_resolved *r, const ovr_block *block)
{
    const ovr_bearing_geometry *g = ovr_bearing_of(r->element.bearing);
    if (g && !ovr_block_get(block, "raceway")->given)
        r->values.stress.raceway = g->spacing *
                                   r->values.element.bearing.rollers /
                                   r->contact.b;
}

static ovr_status check_depths(const ovr_two_columns *c, const char *file,
                               bool limits, ovr_error *err)
{
    if (!c->count)
        return ovr_fail_at(
            err, OVR_BAD_INPUT, file, 0,
            "has no points: it needs at least one line of depth and value");
    for (size_t k = 0; k < c->count; k++)
        if ((limits && !(c->y[k] > 0)) || !(c->x[k] >= 0) ||
            (k && !(c->x[k] > c->x[k - 1])))
            return ovr_fail_at(
                err, OVR_BAD_INPUT, file, 0,
                "point %zu: depths must be at least 0 and rise%s", k + 1,
                limits ? ", limits be above 0" : "");
    return OVR_OK;
}

/* A table against the depth, in p_h and b. */
static ovr_status read_depths(ovr_resolved *r, const ovr_slot *slot,
                              const char *file, ovr_two_columns *c,
                              ovr_error *err)
{
    bool limits = !strcmp(c->name[1], "limit");
    if (!isfinite(r->contact.b) || !isfinite(r->contact.ph))
        return ovr_fail_slot(err, slot,
                             "needs a case with units: b and ph are not known");
    ovr_status status = ovr_two_columns_read(c, file, slot, &r->arena, err);
    if (!status)
        status = check_depths(c, file, limits, err);
    for (size_t k = 0; !status && k < c->count; k++) {
        c->x[k] /= r->contact.b;
        c->y[k] /= r->contact.ph;
    }
    return status;
}

static ovr_status resolve_residual(ovr_resolved *r, const ovr_block *block,
                                   ovr_error *err)
{
    const char *file = r->values.residual_table;
    ovr_two_columns c = {.name = {"depth", "stress"},
                         .header = {OVR_LENGTH, OVR_PRESSURE},
                         .example = "depth [um], stress [MPa]"};
    if (!file)
        return OVR_OK;
    ovr_status status = read_depths(r, ovr_block_get(block, "residual_table"),
                                    file, &c, err);
    r->values.stress.residuals = c.count;
    r->values.stress.residual_z = c.x;
    r->values.stress.residual_s = c.y;
    return status;
}

static ovr_status resolve_limits(ovr_resolved *r, const ovr_block *block,
                                 ovr_error *err)
{
    const char *file = r->values.limit_table;
    const ovr_slot *slot = ovr_block_get(block, "limit_table");
    ovr_two_columns c = {.name = {"depth", "limit"},
                         .header = {OVR_LENGTH, OVR_PRESSURE},
                         .example = "depth [um], limit [MPa]"};
    if (!file)
        return OVR_OK;
    if (ovr_block_get(block, "limit_pressure")->given)
        return ovr_fail_slot(err, slot,
                             "limit_pressure is given too: leave one out");
    ovr_status status = read_depths(r, slot, file, &c, err);
    r->values.life.limits = c.count;
    r->values.life.limit_z = c.x;
    r->values.life.limit_A = c.y;
    return status;
}

static ovr_status resolve_fatigue(ovr_resolved *r, ovr_error *err)
{
    const ovr_block *block = ovr_block_of(r, "fatigue");
    ovr_stress_setup *s = &r->values.stress;
    s->fatigue = ovr_block_is_there(block);
    r->values.life = ovr_life_options_default();
    s->life = &r->values.life;
    if (!s->fatigue)
        return OVR_OK;
    if (!s->surfaces)
        return ovr_fail_at(err, OVR_BAD_INPUT, r->c->name, block->line,
                           "[fatigue] needs [stress]: add that section");
    if (ovr_block_fill(r, block, &r->values, err))
        return OVR_BAD_INPUT;
    s->criterion = (ovr_criterion)r->values.criterion;
    if (resolve_limits(r, block, err) || resolve_residual(r, block, err))
        return OVR_BAD_INPUT;
    resolve_raceway(r, block);
    return OVR_OK;
}

/* A Newtonian film's shear stress may be many times what any oil carries:
 * nothing to load a body with unasked. */
static const char *no_traction(const ovr_resolved *r)
{
    const ovr_lubricant *l = &r->lubricant;
    int target = r->values.stress_traction;
    if (target == OVR_TRACTION_NO)
        return "[stress] traction = no";
    if (isnan(r->contact.kappa))
        return "b/R is not known: a modulus or contact.G gives it";
    if (target == OVR_TRACTION_AUTO && l->rheology == OVR_NEWTONIAN &&
        !(l->limiting_shear > 0))
        return "Newtonian film; a rheology, limiting_shear or [stress] "
               "traction = yes brings its shear stress in";
    return NULL;
}

/* It is stored for `overroll stress`, the second pass and the pictures. */
static ovr_status resolve_traction(ovr_resolved *r, const ovr_block *block,
                                   ovr_error *err)
{
    ovr_stress_setup *s = &r->values.stress;
    const ovr_block *output = ovr_block_of(r, "output");
    s->no_traction = no_traction(r);
    s->traction = !s->no_traction;
    if (!s->traction && r->values.stress_traction == OVR_TRACTION_YES)
        return ovr_fail_slot(err, ovr_block_get(block, "traction"), "%s",
                             s->no_traction);
    if (!s->traction || ovr_block_get(output, "fields")->given)
        return OVR_OK;
    if (s->surfaces & 1)
        r->values.output.fields |= ovr_field_bit("shear_stress_1");
    if (s->surfaces & 2)
        r->values.output.fields |= ovr_field_bit("shear_stress_2");
    return OVR_OK;
}

ovr_status ovr_resolve_stress(ovr_resolved *r, ovr_error *err)
{
    const ovr_block *block = ovr_block_of(r, "stress");
    ovr_stress_setup *s = &r->values.stress;
    r->values.stress_surface = 1;
    if (ovr_resolve_yield(r, err))
        return OVR_BAD_INPUT;
    for (int k = 0; k < 2; k++) {
        s->poisson[k] = r->body[k].poisson;
        s->yield[k] = r->body[k].yield;
    }
    if (ovr_block_is_there(block)) {
        if (ovr_block_fill(r, block, &r->values, err) || resolve_window(r, err))
            return OVR_BAD_INPUT;
        s->surfaces = (unsigned)r->values.stress_surface;
        s->every = r->values.stress_every;
        if (resolve_traction(r, block, err))
            return OVR_BAD_INPUT;
    }
    if (s->surfaces)
        ovr_resolved_turn_on(r, &ovr_physics_stress, &r->setup);
    if (check_motion(r, err) || resolve_fatigue(r, err))
        return OVR_BAD_INPUT;
    return OVR_OK;
}
