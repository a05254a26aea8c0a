/* SPDX-License-Identifier: GPL-3.0-or-later */
/* [output]. */
#include <math.h>

#include "case/resolve.h"
#include "case/setup.h"
#include "results/results.h"

/* The fields that the physics that is on adds where none are given. */
static unsigned fields_of_physics(const ovr_resolved *r)
{
    unsigned fields = 0;
    if (r->values.options.cavitation == OVR_CAVITATION_CONSERVING)
        fields |= ovr_field_bit("filling") | ovr_field_bit("oil_content");
    if (r->setup.heat)
        fields |= ovr_field_bit("temperature_1") |
                  ovr_field_bit("temperature_2") |
                  ovr_field_bit("temperature_middle");
    if (ovr_setup_physics(&r->setup) & OVR_PHYSICS_BOUNDARY)
        fields |= ovr_field_bit("contact_pressure") |
                  ovr_field_bit("fluid_pressure");
    return fields;
}

ovr_status ovr_resolve_output(ovr_resolved *r, ovr_error *err)
{
    ovr_output *out = &r->values.output;
    out->from = out->to = NAN;
    if (ovr_section_fill(r, "output", err))
        return OVR_BAD_INPUT;
    if (!ovr_slot_of(r, "output", "fields")->given)
        out->fields |= fields_of_physics(r);
    out->every = r->values.every;
    out->single = r->values.precision == 1;
    if (out->from >= out->to)
        return ovr_fail_slot(err, ovr_slot_of(r, "output", "from"),
                             "%g must be below to = %g", out->from, out->to);
    return OVR_OK;
}
