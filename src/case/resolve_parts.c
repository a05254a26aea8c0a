/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Refuses the parts of a case that do not go together: of those that are
 * written, as what is not gives way. */
#include <math.h>
#include <stdio.h>

#include "case/coats.h"
#include "case/resolve.h"
#include "contact/reversal.h"
#include "simulation/parts.h"

bool ovr_runs_in(const ovr_resolved *r)
{
    return ovr_case_find_block(r->c, "boundary", NULL) &&
           ovr_slot_of(r, "boundary", "passes")->number > 0;
}

static bool is_given(const ovr_resolved *r, int part)
{
    ovr_part_info info = ovr_part_at(part);
    return ovr_slot_of(r, info.section, info.key)->given;
}

/* True if a feature on the mesh is rough. */
static bool has_roughness(const ovr_resolved *r)
{
    for (size_t k = 0; k < r->setup.features; k++)
        if (r->setup.feature[k]->shape == OVR_PROFILE ||
            r->setup.feature[k]->shape == OVR_ROUGHNESS)
            return true;
    return false;
}

/* True if a body that yields has a layer of other moduli than its own. */
static bool yields_below_others(const ovr_resolved *r)
{
    const double same = 1e-9;
    for (int k = 0; k < 2; k++) {
        const ovr_coated *on = ovr_setup_layers(&r->setup, k);
        if (!on || !(r->values.plastic.surfaces >> k & 1))
            continue;
        const ovr_elastic *below = &on->body.below;
        for (int j = 0; j < on->body.layers; j++)
            if (fabs(on->body.layer[j].modulus / below->modulus - 1) > same ||
                fabs(on->body.layer[j].poisson - below->poisson) > same)
                return true;
    }
    return false;
}

/* Those of the options count where their keys are written; stop, smoother,
 * refine and the like are nothing unless written. */
#define BY_SETUP(NAME, words, section, key, whole, options, setup) setup,
static unsigned written(const ovr_resolved *r)
{
    const ovr_setup *s = &r->setup;
    const bool by_setup[] = {OVR_PART_ROWS(BY_SETUP)};
    unsigned by_options = ovr_parts_of(&r->values.options), on = 0;
    for (int part = 0; part < OVR_PARTS; part++)
        if (by_setup[part] || (by_options >> part & 1 && is_given(r, part)))
            on |= 1U << part;
    return on;
}

/* "[heat] model = lobatto". */
static void put_name(const ovr_resolved *r, int part, size_t size, char text[])
{
    ovr_part_info info = ovr_part_at(part);
    const ovr_slot *slot = ovr_slot_of(r, info.section, info.key);
    if (slot->given && part != OVR_PART_REVERSAL)
        snprintf(text, size, "[%s] %s = %s", info.section, info.key,
                 slot->text);
    else
        snprintf(text, size, "%s", info.name);
}

ovr_status ovr_resolve_parts(const ovr_resolved *r, ovr_error *err)
{
    const ovr_refusal *refusal = ovr_parts_conflict(written(r));
    const ovr_slot *slot;
    ovr_part_info part;
    char beside[100];
    if (!refusal)
        return OVR_OK;
    part = ovr_part_at(refusal->part);
    slot = ovr_slot_of(r, part.section, part.key);
    put_name(r, refusal->beside, sizeof beside, beside);
    return ovr_fail_slot(err, slot, "%s does not go with %s; %s does",
                         slot->given ? slot->text : part.name, beside,
                         refusal->instead);
}
