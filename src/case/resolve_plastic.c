/* SPDX-License-Identifier: GPL-3.0-or-later */
/* [plastic]: laws of hardening in the units of the contact. */
#include <math.h>
#include <string.h>

#include "base/error.h"
#include "case/feed.h"
#include "case/plastic.h"
#include "case/resolve.h"
#include "case/setup.h"
#include "stress/stress.h"

extern const ovr_physics ovr_physics_plastic;

static const char section[] = "plastic";

static const ovr_slot *slot_of(const ovr_resolved *r, const char *key)
{
    return ovr_block_get(ovr_block_of(r, section), key);
}

/* "945 MPa, 20, 0.121" */
static ovr_status read_swift(const ovr_resolved *r, ovr_hardening *h,
                             ovr_error *err)
{
    const ovr_slot *slot = slot_of(r, "swift");
    ovr_quantity value[3];
    const char *text = r->values.plastic.swift;
    ovr_error why = {0};
    for (int k = 0; k < 3; k++) {
        char item[80];
        size_t length = strcspn(text, ",");
        bool last = text[length] == '\0';
        if (length >= sizeof item || last != (k == 2))
            return ovr_fail_slot(err, slot,
                                 "must be B, C, n: '945 MPa, 20, 0.121'");
        memcpy(item, text + strspn(text, " "), length);
        item[length - strspn(text, " ")] = '\0';
        while (*item && item[strlen(item) - 1] == ' ')
            item[strlen(item) - 1] = '\0';
        if (ovr_quantity_read(item, k ? OVR_PURE : OVR_PRESSURE, true,
                              &value[k], &why))
            return ovr_fail_slot(err, slot, "%s", why.message);
        text += length + !last;
    }
    if (value[0].unit && !isfinite(r->contact.ph))
        return ovr_fail_slot(err, slot,
                             "B in pascals needs ph, which is not known: give "
                             "B as a number over ph");
    h->strength = value[0].unit ? value[0].value / r->contact.ph
                                : value[0].value;
    h->offset = value[1].value;
    h->power = value[2].value;
    if (!(h->strength > 0) || !(h->offset > 0) ||
        !(h->power > 0 && h->power < 1))
        return ovr_fail_slot(err, slot,
                             "needs B and C above 0 and n between 0 and 1");
    return OVR_OK;
}

/* Y of the section, of Swift's law, of the body. */
static ovr_status resolve_law(const ovr_resolved *r, int k,
                              ovr_plastic_body *body, ovr_error *err)
{
    const ovr_plastic_setup *p = &r->values.plastic;
    ovr_hardening *h = &body->hardening;
    h->law = p->hardening;
    if (isnan(body->strain) && h->law != OVR_HARDENS_NOT)
        return ovr_fail_slot(err, slot_of(r, "hardening"),
                             "hardening goes by the strain, which needs b/R: a "
                             "modulus in [contact] or [body N] gives it, "
                             "hardening = none does without");
    h->yield = p->yield;
    if (h->law == OVR_HARDENS_SWIFT) {
        double slope;
        if (read_swift(r, h, err))
            return OVR_BAD_INPUT;
        h->microstrain = 1e6 * body->strain;
        if (!isnan(p->yield))
            h->strength *= p->yield / ovr_yield_stress(h, 0, &slope);
        h->yield = ovr_yield_stress(h, 0, &slope);
        return OVR_OK;
    }
    if (isnan(h->yield))
        h->yield = r->body[k].yield;
    if (!(h->yield > 0))
        return ovr_fail_slot(err, slot_of(r, "yield"),
                             "surface %d has no yield: give it here or in "
                             "[body %d]",
                             k + 1, k + 1);
    h->modulus = h->law == OVR_HARDENS_NOT ? 0 : p->modulus * body->strain;
    if (h->law != OVR_HARDENS_NOT && !(p->modulus > 0))
        return ovr_fail_slot(
            err, slot_of(r, "modulus"), "%s hardening needs a modulus above 0",
            h->law == OVR_HARDENS_LINEAR ? "linear" : "kinematic");
    return OVR_OK;
}

/* E* of a body over E' of both: 1 for equal ones. */
static double stiffness(const ovr_resolved *r, int k)
{
    const ovr_body_form *b = &r->body[k];
    double reduced = r->values.contact.modulus;
    double own = b->modulus / (1 - b->poisson * b->poisson);
    return own > 0 && reduced > 0 ? own / reduced : 1;
}

static ovr_status check_limit(const ovr_resolved *r, int k, double Y,
                              ovr_error *err)
{
    const ovr_plastic_setup *p = &r->values.plastic;
    const double close = 0.9;
    double limit = ovr_shakedown_limit() * Y;
    if (p->anyway)
        return OVR_OK;
    if (limit < 1)
        return ovr_fail_slot(err, slot_of(r, "yield"),
                             "Y = %.4g ph: ph is above the shakedown limit of "
                             "the smooth contact, %.4g ph, and surface %d "
                             "flows at every pass; anyway = yes goes on",
                             Y, limit, k + 1);
    if (p->hardening == OVR_HARDENS_NOT && close * limit < 1)
        return ovr_fail_slot(err, slot_of(r, "hardening"),
                             "none: without hardening a contact at %.2g of its "
                             "shakedown limit comes to rest too slowly to be "
                             "calculated; hardening = linear with modulus of "
                             "a hundredth of the elastic one, or anyway = yes",
                             1 / limit);
    return OVR_OK;
}

static ovr_status check_run(const ovr_resolved *r, ovr_error *err)
{
    const ovr_plastic_setup *p = &r->values.plastic;
    const ovr_block *block = ovr_block_of(r, section);
    unsigned seen = r->values.stress.surfaces;
    if ((unsigned)p->surface & ~seen)
        return ovr_fail_at(err, OVR_BAD_INPUT, r->c->name, block->line,
                           "[plastic]: surface %s yields, and needs [stress] "
                           "of it: surface = %s there",
                           p->surface & ~(int)seen & 1 ? "1" : "2",
                           p->surface == 3   ? "both"
                           : p->surface == 2 ? "2"
                                             : "1");
    return OVR_OK;
}

ovr_status ovr_resolve_plastic_time(const ovr_resolved *r, ovr_error *err)
{
    if (!r->values.plastic.surfaces || r->setup.transient)
        return OVR_OK;
    return ovr_fail_at(err, OVR_BAD_INPUT, r->c->name,
                       ovr_block_of(r, section)->line,
                       "[plastic]: in a steady contact no material goes "
                       "through its history: give [time] an end");
}

static ovr_status resolve_window(ovr_resolved *r, ovr_error *err)
{
    ovr_plastic_setup *p = &r->values.plastic;
    p->from = p->to = NAN;
    if (!p->window.count)
        return OVR_OK;
    if (p->window.count != 2 || !(p->window.values[0] < p->window.values[1]))
        return ovr_fail_slot(err, slot_of(r, "window"),
                             "must be FROM, TO with FROM below TO");
    p->from = p->window.values[0];
    p->to = p->window.values[1];
    return OVR_OK;
}

ovr_status ovr_resolve_plastic(ovr_resolved *r, ovr_error *err)
{
    ovr_plastic_setup *p = &r->values.plastic;
    const ovr_block *block = ovr_block_of(r, section);
    if (!ovr_block_is_there(block))
        return OVR_OK;
    p->surface = 1;
    if (ovr_block_fill(r, block, &r->values, err) || resolve_window(r, err) ||
        check_run(r, err))
        return OVR_BAD_INPUT;
    for (int k = 0; k < 2; k++) {
        ovr_plastic_body *body = &p->body[k];
        if (!(p->surface >> k & 1))
            continue;
        body->softness = 1 / (4 * stiffness(r, k));
        body->strain = r->contact.kappa * body->softness;
        if (resolve_law(r, k, body, err) ||
            check_limit(r, k, body->hardening.yield, err))
            return OVR_BAD_INPUT;
    }
    p->surfaces = (unsigned)p->surface;
    p->flooded = r->values.passes.number == 1;
    if (r->values.passes.number < p->passes)
        r->values.passes.number = p->passes;
    if (p->elastic && r->values.passes.loads.count)
        return ovr_fail_slot(err, slot_of(r, "elastic"),
                             "the pass in which nothing yields would take the "
                             "first of [passes] loads: compare with a run "
                             "without [plastic]");
    r->values.passes.number += p->elastic;
    ovr_resolved_turn_on(r, &ovr_physics_plastic, &r->setup);
    return OVR_OK;
}

const ovr_plastic_setup *ovr_setup_plastic(const ovr_setup *setup)
{
    const ovr_resolved *r = (const ovr_resolved *)setup;
    return r->values.plastic.surfaces ? &r->values.plastic : NULL;
}

bool ovr_setup_carries_oil(const ovr_setup *setup)
{
    return !((const ovr_resolved *)setup)->values.plastic.flooded;
}

void ovr_setup_go_on(ovr_setup *setup, const char *file)
{
    ((ovr_resolved *)setup)->values.plastic.initial = file;
}
