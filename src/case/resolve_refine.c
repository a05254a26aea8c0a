/* SPDX-License-Identifier: GPL-3.0-or-later */
/* [domain] refine: what else of the case goes with patches. */
#include "case/resolve.h"

ovr_status ovr_resolve_refine(const ovr_resolved *r, ovr_error *err)
{
    const ovr_options *o = &r->values.options;
    const ovr_pairing pairs[] = {
        {"time", "end", r->setup.transient,
         "a steady contact, without [time],"},
        {"lubricant", "rheology", r->lubricant.rheology != OVR_NEWTONIAN,
         "newtonian"},
        {"heat", "model", r->setup.heat != NULL, "none"},
        {"stress", "surface", r->setup.stress->surfaces != 0, "no [stress]"},
        {"cavitation", "model", o->cavitation != OVR_CAVITATION_REYNOLDS,
         "reynolds"},
        {"time", "scheme", r->values.scheme == OVR_UPSTREAM1, "upstream2"},
        {"paper", "smoother", o->smoother != OVR_LINE, "line"},
        {"paper", "paper_balance", o->paper_balance, "no"},
        {"solver", "stop", o->stop == OVR_STOP_FIXED,
         "negligible or truncation"}};
    if (o->refine == OVR_REFINE_NONE)
        return OVR_OK;
    return ovr_refuse(r, sizeof pairs / sizeof *pairs, pairs,
                      "[domain] refine = spike", err);
}
