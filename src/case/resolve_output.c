/* SPDX-License-Identifier: GPL-3.0-or-later */
/* [output]. */
#include <math.h>

#include "case/resolve.h"
#include "results/layout.h"
#include "simulation/physics.h"

/* Fields that have no values are refused; where the section of their physics
 * stands in the case, but off, the rest is stored, which a note says: a study
 * may turn it on and off. */
static ovr_status leave_out(ovr_resolved *r, const ovr_slot *slot,
                            ovr_error *err)
{
    ovr_output *out = &r->values.output;
    const ovr_physics *off = NULL;
    unsigned none = ovr_resolved_no_fields(r, &off);
    if (!none || slot->stored)
        return OVR_OK;
    const char *section = off->section->name;
    const ovr_observable *row[OVR_FIELDS_MAX];
    ovr_layout_fields(none, row);
    if (none == out->fields ||
        !ovr_block_is_there(ovr_case_find_block(r->c, section, NULL)))
        return ovr_fail_slot(err, slot,
                             "%s has no values without [%s]: leave it out",
                             row[0]->name, section);
    out->fields &= ~none;
    return OVR_OK;
}

ovr_status ovr_resolve_output(ovr_resolved *r, ovr_error *err)
{
    ovr_output *out = &r->values.output;
    out->from = out->to = NAN;
    if (ovr_section_fill(r, "output", err))
        return OVR_BAD_INPUT;
    const ovr_slot *fields = ovr_slot_of(r, "output", "fields");
    if (!fields->given)
        out->fields |= ovr_resolved_fields(r);
    else if (leave_out(r, fields, err))
        return OVR_BAD_INPUT;
    out->every = r->values.every;
    out->single = r->values.precision == 1;
    if (out->from >= out->to)
        return ovr_fail_slot(err, ovr_slot_of(r, "output", "from"),
                             "%g must be below to = %g", out->from, out->to);
    return OVR_OK;
}
