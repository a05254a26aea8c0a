/* SPDX-License-Identifier: GPL-3.0-or-later */
/* [output]. */
#include <math.h>

#include "case/resolve.h"

ovr_status ovr_resolve_output(ovr_resolved *r, ovr_error *err)
{
    ovr_output *out = &r->values.output;
    out->from = out->to = NAN;
    if (ovr_section_fill(r, "output", err))
        return OVR_BAD_INPUT;
    if (!ovr_slot_of(r, "output", "fields")->given)
        out->fields |= ovr_resolved_fields(r);
    out->every = r->values.every;
    out->single = r->values.precision == 1;
    if (out->from >= out->to)
        return ovr_fail_slot(err, ovr_slot_of(r, "output", "from"),
                             "%g must be below to = %g", out->from, out->to);
    return OVR_OK;
}
