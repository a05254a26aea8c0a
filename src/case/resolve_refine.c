/* SPDX-License-Identifier: GPL-3.0-or-later */
/* [domain] refine: what else of the case goes with patches. */
#include "case/resolve.h"

static const ovr_slot *slot_of(const ovr_resolved *r, const char *section,
                               const char *key)
{
    return ovr_block_get(ovr_block_of(r, section), key);
}

ovr_status ovr_resolve_refine(const ovr_resolved *r, ovr_error *err)
{
    const ovr_options *o = &r->values.options;
    const struct {
        const char *section, *key;
        bool refused;
        const char *right;
    } checks[] = {
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
    for (size_t k = 0; k < sizeof checks / sizeof *checks; k++)
        if (checks[k].refused) {
            const ovr_slot *slot = slot_of(r, checks[k].section, checks[k].key);
            return ovr_fail_slot(err, slot,
                                 "%s does not go with [domain] refine = "
                                 "spike; %s does",
                                 slot->text, checks[k].right);
        }
    return OVR_OK;
}
