/* SPDX-License-Identifier: GPL-3.0-or-later */
/* [load] and [speed] become histories; tables are read from their files. */
#include <math.h>
#include <string.h>

#include "case/resolve.h"
#include "case/two_columns.h"
#include "contact/contact.h"

static ovr_status missing(ovr_resolved *r, const ovr_block *block,
                          const char *key, ovr_error *err)
{
    const ovr_slot *history = ovr_block_get(block, "history");
    (void)r;
    return ovr_fail_slot(err, history, "%s needs '%s' in [%s]", history->text,
                         key, block->section->name);
}

/* ----------------------------------------------------------------- tables */

/* b/um for one unit of the table's times. */
static ovr_status time_unit(const ovr_resolved *r, const ovr_block *block,
                            int unit, double *value, ovr_error *err)
{
    static const double seconds[] = {1, 1, 1e-3, 1e-6};
    *value = unit ? seconds[unit] / r->contact.time : 1;
    if (!isnan(*value))
        return OVR_OK;
    return ovr_fail_slot(err, ovr_block_get(block, "time_unit"),
                         "needs a physical contact: add radius, "
                         "modulus and viscosity (or speeds)");
}

static ovr_status load_table(ovr_resolved *r, const ovr_block *block,
                             const ovr_change *change, ovr_history_form *form,
                             ovr_error *err)
{
    const ovr_parameter *to = ovr_parameter_find(block->section, "to");
    ovr_two_columns p = {.name = {"time", "value"},
                         .minimum = to->minimum,
                         .maximum = to->maximum,
                         .of = " (of the nominal one)",
                         .unit = {1, 1}};
    ovr_status status;
    if (!change->file)
        return missing(r, block, "file", err);
    if (time_unit(r, block, change->time_unit, &p.unit[0], err))
        return OVR_BAD_INPUT;
    status = ovr_two_columns_read(&p, change->file,
                                  ovr_block_get(block, "file"), &r->arena, err);
    form->points = p.count;
    form->T = p.x;
    form->value = p.y;
    return status;
}

/* -------------------------------------------------------------------- all */

/* It begins, swings about and ends at the slide_to_roll of the contact. */
static void of_sliding(const ovr_resolved *r, ovr_history_form *form)
{
    form->mean = r->contact.u1_ratio - r->contact.u2_ratio;
    if (isnan(form->from))
        form->from = form->mean;
    if (isnan(form->to))
        form->to = form->mean;
}

ovr_status ovr_resolve_history(ovr_resolved *r, const char *section,
                               const ovr_change *change, ovr_history **history,
                               ovr_error *err)
{
    const ovr_block *block = ovr_case_find_block(r->c, section, NULL);
    ovr_history_form form = ovr_history_form_default();
    ovr_error why = {0};
    form.kind = (ovr_history_kind)change->history;
    form.from = change->from;
    form.to = change->to;
    form.start = change->start;
    form.duration = change->duration;
    form.amplitude = change->amplitude;
    form.period = change->period;
    if (strcmp(section, "sliding") == 0)
        of_sliding(r, &form);
    if (strcmp(section, "speed") == 0)
        form.mean = change->mean;
    if (form.kind == OVR_HISTORY_CONSTANT)
        return OVR_OK;
    if (form.kind == OVR_HISTORY_SINE && !ovr_block_get(block, "period")->given)
        return missing(r, block, "period", err);
    if (form.kind == OVR_HISTORY_TABLE) {
        ovr_status status = load_table(r, block, change, &form, err);
        if (status)
            return status;
    }
    *history = ovr_history_create(&form, &r->arena.allocator, &why);
    return *history ? OVR_OK : ovr_fail_in(err, r->c, block, NULL, &why);
}
