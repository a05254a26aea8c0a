/* SPDX-License-Identifier: GPL-3.0-or-later */
/* [domain], [solver], [paper] and the numbers of [time] and [passes]: the
 * options of a simulation. */
#include <math.h>

#include "case/resolve.h"
#include "multigrid/hierarchy.h"

static int nodes_of(int level)
{
    return (int)ovr_level_nodes(level);
}

static ovr_status resolve_level(ovr_resolved *r, ovr_error *err)
{
    const ovr_slot *nodes = ovr_slot_of(r, "domain", "nodes");
    const ovr_slot *level = ovr_slot_of(r, "domain", "level");
    int k = 1, target = r->values.nodes;
    if (!nodes->given)
        return OVR_OK;
    if (level->given)
        return ovr_fail_slot(err, nodes, "level is given too: leave one out");
    while (k < OVR_LEVELS - 1 && nodes_of(k) < target)
        k++;
    if (k > 1 && nodes_of(k) - target > target - nodes_of(k - 1))
        k--;
    if (nodes_of(k) != target)
        return ovr_fail_slot(err, nodes,
                             "%d must be 7 2^k + 1; the nearest is %d "
                             "(level %d)",
                             target, nodes_of(k), k);
    r->values.options.level = k;
    return OVR_OK;
}

static ovr_status check_solver(const ovr_resolved *r, ovr_error *err)
{
    const ovr_options *o = &r->values.options;
    if (o->mlmi_order % 2 || o->mlmi_range % 2) {
        const char *key = o->mlmi_order % 2 ? "mlmi_order" : "mlmi_range";
        const ovr_slot *slot = ovr_slot_of(r, "paper", key);
        return ovr_fail_slot(err, slot, "%s must be even", slot->text);
    }
    if (o->level > 0 && o->coarsest_level > o->level)
        return ovr_fail_slot(err, ovr_slot_of(r, "solver", "coarsest_level"),
                             "%d must not be above the level "
                             "%d",
                             o->coarsest_level, o->level);
    return OVR_OK;
}

ovr_status ovr_resolve_options(ovr_resolved *r, ovr_error *err)
{
    ovr_status status;
    r->values.options = ovr_options_default();
    if (ovr_section_fill(r, "domain", err) ||
        ovr_section_fill(r, "solver", err) ||
        ovr_section_fill(r, "paper", err) || ovr_section_fill(r, "time", err))
        return OVR_BAD_INPUT;
    r->values.passes.side_flow = NAN;
    r->values.passes.spacing = r->values.passes.recovery = NAN;
    if (ovr_section_fill(r, "passes", err))
        return OVR_BAD_INPUT;
    status = ovr_resolve_forms(r, err);
    if (!status)
        status = resolve_level(r, err);
    if (!status)
        status = check_solver(r, err);
    r->setup.confirm = r->values.options.level == OVR_GRID_AUTO;
    r->setup.accuracy_of = (ovr_accuracy)r->values.accuracy_of;
    r->setup.accuracy = r->setup.confirm ? r->values.accuracy : 0;
    return status;
}
