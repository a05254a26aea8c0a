/* SPDX-License-Identifier: GPL-3.0-or-later */
/* [passes], and how they go together with the rest. */
#include <math.h>

#include "case/resolve.h"
#include "case/resolve_element.h"

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

ovr_status ovr_resolve_passes(ovr_resolved *r, ovr_error *err)
{
    const ovr_passes_setup *p = &r->values.passes;
    double left = p->split * fmax(0, r->contact.u1_ratio) +
                  (1 - p->split) * fmax(0, r->contact.u2_ratio);
    ovr_status status = ovr_resolve_element_passes(r, err);
    if (status || p->number == 1)
        return status;
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
