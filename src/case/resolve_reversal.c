/* SPDX-License-Identifier: GPL-3.0-or-later */
/* [speed] below zero: the domain of a mean speed that reverses
 * (simulation/mirror.h). */
#include <math.h>

#include "case/resolve.h"
#include "contact/reversal.h"

ovr_status ovr_symmetric_domain(ovr_resolved *r, bool inlet, bool outlet,
                                ovr_error *err)
{
    ovr_options *o = r->setup.options;
    double far = inlet ? -o->inlet : fmax(-o->inlet, o->outlet);
    if (!ovr_history_reverses(r->setup.speed))
        return OVR_OK;
    if (outlet && o->outlet != -o->inlet)
        return ovr_fail_slot(
            err, ovr_slot_of(r, "domain", "outlet"),
            "%g: inlet and outlet trade places where [speed] reverses: leave "
            "it out, or give both the same size, %g",
            o->outlet, far);
    o->inlet = -far;
    o->outlet = far;
    return OVR_OK;
}
