/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Refuses the parts of a case that do not go together: of those that are
 * written, as what is not gives way. */
#include <stdio.h>

#include "case/resolve.h"
#include "contact/turning.h"
#include "simulation/parts.h"

static bool is_given(const ovr_resolved *r, ovr_part part)
{
    ovr_part_info info = ovr_part_at(part);
    return ovr_slot_of(r, info.section, info.key)->given;
}

/* Those of the options whose keys are written; stop, smoother, refine and the
 * like are nothing unless written. */
static unsigned of_options(const ovr_resolved *r)
{
    unsigned on = ovr_parts_of(&r->values.options);
    for (unsigned part = 0; part < OVR_PARTS; part++)
        if (on >> part & 1 && !is_given(r, (ovr_part)part))
            on &= ~(1U << part);
    return on;
}

static unsigned written(const ovr_resolved *r)
{
    const ovr_setup *s = &r->setup;
    return of_options(r) | ovr_part_bit(OVR_PART_TIME, s->transient) |
           ovr_part_bit(OVR_PART_ADAPTIVE, s->march->adaptive) |
           ovr_part_bit(OVR_PART_LOAD, s->load != NULL) |
           ovr_part_bit(OVR_PART_SPEED, s->speed != NULL) |
           ovr_part_bit(OVR_PART_REVERSAL, ovr_history_turns(s->speed)) |
           ovr_part_bit(OVR_PART_SLIDING, s->sliding != NULL) |
           ovr_part_bit(OVR_PART_RADIUS, s->radius != NULL) |
           ovr_part_bit(OVR_PART_FLOW_LAW,
                        r->lubricant.rheology != OVR_NEWTONIAN) |
           ovr_part_bit(OVR_PART_HEAT, s->heat != NULL) |
           ovr_part_bit(OVR_PART_SUPPLY, s->supply->film) |
           ovr_part_bit(OVR_PART_PASSES, s->passes->number > 1) |
           ovr_part_bit(OVR_PART_STRESS, s->stress->surfaces != 0) |
           ovr_part_bit(OVR_PART_FATIGUE, s->stress->fatigue);
}

/* "[heat] model = lobatto". */
static void put_name(const ovr_resolved *r, ovr_part part, size_t size,
                     char text[])
{
    ovr_part_info info = ovr_part_at(part);
    const ovr_slot *slot = ovr_slot_of(r, info.section, info.key);
    if (slot->given && part != OVR_PART_REVERSAL)
        snprintf(text, size, "[%s] %s = %s", info.section, info.key,
                 slot->text);
    else
        snprintf(text, size, "%s", info.name);
}

ovr_status ovr_resolve_parts(const ovr_resolved *r, ovr_error *err)
{
    const ovr_refusal *refusal = ovr_parts_conflict(written(r));
    const ovr_slot *slot;
    ovr_part_info part;
    char beside[100];
    if (!refusal)
        return OVR_OK;
    part = ovr_part_at(refusal->part);
    slot = ovr_slot_of(r, part.section, part.key);
    put_name(r, refusal->beside, sizeof beside, beside);
    return ovr_fail_slot(err, slot, "%s does not go with %s; %s does",
                         slot->given ? slot->text : part.name, beside,
                         refusal->instead);
}
