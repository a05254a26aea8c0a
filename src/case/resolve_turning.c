/* SPDX-License-Identifier: GPL-3.0-or-later */
/* [speed] below zero: what goes with a mean speed that reverses, and the
 * domain for it (simulation/mirror.h). */
#include <math.h>

#include "case/resolve.h"
#include "contact/turning.h"

ovr_status ovr_resolve_turning(const ovr_resolved *r, ovr_error *err)
{
    const ovr_options *o = &r->values.options;
    const ovr_pairing pairs[] = {
        {"cavitation", "model", o->cavitation != OVR_CAVITATION_REYNOLDS,
         "reynolds"},
        {"heat", "model", r->setup.heat != NULL, "none"}};
    if (!ovr_history_turns(r->setup.speed))
        return OVR_OK;
    return ovr_refuse(r, sizeof pairs / sizeof *pairs, pairs,
                      "a [speed] that reverses", err);
}

ovr_status ovr_symmetric_domain(ovr_resolved *r, bool inlet, bool outlet,
                                ovr_error *err)
{
    ovr_options *o = r->setup.options;
    double far = inlet ? -o->inlet : fmax(-o->inlet, o->outlet);
    if (!ovr_history_turns(r->setup.speed))
        return OVR_OK;
    if (outlet && o->outlet != -o->inlet)
        return ovr_fail_slot(err, ovr_slot_of(r, "domain", "outlet"),
                             "%g: where [speed] reverses inlet and outlet "
                             "trade places: leave it out, or give inlet and "
                             "outlet of the same size, %g",
                             o->outlet, far);
    o->inlet = -far;
    o->outlet = far;
    return OVR_OK;
}
