/* SPDX-License-Identifier: GPL-3.0-or-later */
/* [cavitation], [supply] and [passes]: the film that arrives. */
#include <math.h>

#include "case/resolve.h"
#include "case/resolve_element.h"
#include "surface/layer.h"

static ovr_status check_film(const ovr_resolved *r, ovr_error *err)
{
    const ovr_slot *model = ovr_slot_of(r, "supply", "model");
    if (r->values.options.cavitation != OVR_CAVITATION_CONSERVING)
        return ovr_fail_slot(err, model,
                             "film needs [cavitation] model = conserving");
    if (!ovr_slot_of(r, "supply", "thickness_1")->given &&
        !ovr_slot_of(r, "supply", "thickness_2")->given &&
        !ovr_slot_of(r, "supply", "profile_1")->given &&
        !ovr_slot_of(r, "supply", "profile_2")->given)
        return ovr_fail_slot(err, model,
                             "film needs thickness_1, thickness_2 or both in "
                             "[supply], or a profile");
    return OVR_OK;
}

static ovr_status read_layers(ovr_resolved *r, const ovr_allocator *allocator,
                              ovr_error *err)
{
    static const char *const profiles[] = {"profile_1", "profile_2"};
    static const char *const thick[] = {"thickness_1", "thickness_2"};
    for (int k = 0; k < 2; k++) {
        const ovr_slot *slot = ovr_slot_of(r, "supply", profiles[k]);
        ovr_error why = {0};
        if (!r->values.layer_file[k])
            continue;
        if (ovr_slot_of(r, "supply", thick[k])->given)
            return ovr_fail_slot(err, slot, "%s is given too: leave one out",
                                 thick[k]);
        r->supply.layer[k] = ovr_layer_read(r->values.layer_file[k],
                                            &r->contact, allocator, &why);
        if (!r->supply.layer[k])
            return ovr_fail_slot(err, slot, "%s", why.message);
    }
    return OVR_OK;
}

/* Time from one rolling body to the next; a load for each of them. */
static ovr_status check_bodies(const ovr_resolved *r, ovr_error *err)
{
    const ovr_passes_setup *p = &r->values.passes;
    const ovr_slot *recovery = ovr_slot_of(r, "passes", "recovery");
    const double speed[] = {r->contact.u1_ratio, r->contact.u2_ratio};
    if (recovery->given && !(p->spacing > 0))
        return ovr_fail_slot(err, recovery,
                             "needs spacing, which tells how long a layer has");
    for (int k = 0; k < 2; k++)
        if (recovery->given && p->again & 1 << k && !(speed[k] > 0))
            return ovr_fail_slot(err, recovery,
                                 "surface %d does not move, so no time passes "
                                 "on it between passes: leave recovery out",
                                 k + 1);
    if (p->loads.count && p->loads.count != (size_t)p->number)
        return ovr_fail_slot(
            err, ovr_slot_of(r, "passes", "loads"),
            "%zu loads are given for %d passes: each pass needs one",
            p->loads.count, p->number);
    return OVR_OK;
}

static ovr_status check_passes(const ovr_resolved *r, ovr_error *err)
{
    const ovr_passes_setup *p = &r->values.passes;
    double left = p->split * fmax(0, r->contact.u1_ratio) +
                  (1 - p->split) * fmax(0, r->contact.u2_ratio);
    if (p->number == 1)
        return OVR_OK;
    if (r->values.options.cavitation != OVR_CAVITATION_CONSERVING)
        return ovr_fail_slot(err, ovr_slot_of(r, "passes", "number"),
                             "several passes need [cavitation] model = "
                             "conserving");
    if (ovr_slot_of(r, "passes", "loss")->given && isfinite(p->side_flow))
        return ovr_fail_slot(err, ovr_slot_of(r, "passes", "side_flow"),
                             "loss is given too: leave one out");
    if (!(left > 0))
        return ovr_fail_slot(
            err, ovr_slot_of(r, "passes", "split"),
            "%g leaves all oil on a surface that stands still and carries none "
            "off: choose a share between 0 and 1",
            p->split);
    return check_bodies(r, err);
}

ovr_status ovr_resolve_supply(ovr_resolved *r, const ovr_allocator *allocator,
                              ovr_error *err)
{
    ovr_settings *v = &r->values;
    ovr_supply_setup *s = &r->supply;
    ovr_status status;
    s->film = v->supply_model != 0;
    status = ovr_resolve_element_passes(r, err);
    if (!status)
        status = s->film ? check_film(r, err) : OVR_OK;
    if (!status)
        status = ovr_resolve_history(r, "supply", &v->supply, allocator,
                                     &s->history, err);
    if (!status)
        status = read_layers(r, allocator, err);
    if (!status)
        status = check_passes(r, err);
    s->thickness[0] = v->thickness[0];
    s->thickness[1] = v->thickness[1];
    s->reservoir = v->reservoir;
    s->start = NAN;
    return status;
}
