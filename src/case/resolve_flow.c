/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The flow law of [lubricant]; its points from a file. */
#include "case/resolve.h"
#include "case/two_columns.h"
#include "contact/contact.h"

/* The stress that scales it: where the film has thinned to 0.7 of what it was
 * (the last one if it never does), that the law's table is fine there. */
static double knee(const ovr_two_columns *p)
{
    const double *rate = p->x, *shear = p->y;
    size_t k = 0;
    while (k + 1 < p->count && shear[k] / rate[k] > 0.7 * shear[0] / rate[0])
        k++;
    return p->count ? shear[k] : 1;
}

static ovr_status table(ovr_resolved *r, ovr_error *err)
{
    ovr_flow_form *form = &r->values.flow;
    const ovr_block *block = ovr_block_of(r, "lubricant");
    const char *file = r->values.rheology_file;
    ovr_two_columns p = {.name = {"rate", "stress"},
                         .header = {OVR_SHEAR_RATE, OVR_PRESSURE},
                         .example = "rate [1/s], stress [MPa]"};
    if (!file)
        return ovr_fail_slot(err, ovr_block_get(block, "rheology"),
                             "table needs 'rheology_file' in [lubricant]");
    if (ovr_two_columns_read(&p, file, ovr_block_get(block, "rheology_file"),
                             &r->arena, err))
        return OVR_BAD_INPUT;
    form->points = p.count;
    form->shear = p.y;
    form->rate = p.x;
    form->stress = knee(&p);
    return OVR_OK;
}

ovr_status ovr_resolve_flow(ovr_resolved *r, ovr_error *err)
{
    ovr_flow_form *form = &r->values.flow;
    const ovr_block *block = ovr_block_of(r, "lubricant");
    ovr_error why = {0};
    form->rheology = (ovr_rheology)r->values.rheology;
    if (form->rheology == OVR_CARREAU) {
        form->rheology = (ovr_rheology)r->values.carreau_form;
        form->stress = r->values.carreau_stress;
        form->number = r->values.carreau_number;
    }
    if (form->rheology == OVR_FLOW_TABLE && table(r, err))
        return err ? err->status : OVR_BAD_INPUT;
    if (form->rheology > OVR_EYRING) {
        form->law = r->flow_law = ovr_flow_law_create(form, &r->arena.allocator,
                                                      &why);
        if (!form->law)
            return ovr_fail_in(err, r->c, block, NULL, &why);
    }
    if (ovr_lubricant_flow(&r->contact, form, &r->lubricant, &why))
        return ovr_fail_in(err, r->c, block, NULL, &why);
    return OVR_OK;
}
