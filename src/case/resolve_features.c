/* SPDX-License-Identifier: GPL-3.0-or-later */
/* [feature NAME], in the order of the case. */
#include <math.h>

#include "base/error.h"
#include "case/resolve.h"
#include "surface/surfaces.h"

static ovr_status fill_feature(ovr_resolved *r, const ovr_block *block,
                               ovr_feature_settings *to, ovr_error *err)
{
    ovr_feature_form *form = &to->form;
    ovr_status status;
    *to = (ovr_feature_settings){.form = ovr_feature_form_default(),
                                 .source = ovr_profile_source_default(),
                                 .conditioning = ovr_conditioning_default(),
                                 .roughness = ovr_roughness_default()};
    form->name = block->name;
    form->source = &to->source;
    form->conditioning = &to->conditioning;
    form->roughness = &to->roughness;
    if (!ovr_block_get(block, "shape")->given) {
        ovr_error why = {0};
        ovr_fail_about(&why, "shape", "[feature %s] needs a shape",
                       block->name);
        return ovr_fail_in(err, r->c, block, NULL, &why);
    }
    status = ovr_block_fill(r, block, to, err);
    to->source.spacing_scaled = true; /* like all lengths here: in b */
    if (form->shape == OVR_ROUGHNESS) {
        to->roughness.length = form->length;
        form->length = NAN;
    }
    return status;
}

/* Chooses the seed of roughness without one, so that no two such features have
 * the same heights: 1, 3, 5 ... on surface 1 and 2, 4, 6 ... on surface 2. */
static void choose_seed(ovr_feature_settings *s, const ovr_block *block,
                        int count[2])
{
    int side = s->form.surface == 2;
    if (s->form.shape != OVR_ROUGHNESS)
        return;
    if (!ovr_block_get(block, "seed")->given)
        s->roughness.seed = 2 * count[side] + side + 1;
    count[side]++;
}

ovr_status ovr_resolve_features(ovr_resolved *r, ovr_error *err)
{
    ovr_feature_settings *settings;
    const ovr_feature_form **form;
    size_t n = 0;
    int rough[2] = {0, 0};
    for (const ovr_block *b = r->c->blocks; b; b = b->next)
        n += ovr_block_is_feature(b);
    settings = ovr_arena_take(&r->arena, n, sizeof *settings, err);
    form = ovr_arena_take(&r->arena, n, sizeof *form, err);
    if (!settings || !form)
        return OVR_NO_MEMORY;
    r->feature = form;
    r->features = n;
    for (const ovr_block *b = r->c->blocks; b; b = b->next)
        if (ovr_block_is_feature(b)) {
            ovr_status status = fill_feature(r, b, settings, err);
            if (status)
                return status;
            choose_seed(settings, b, rough);
            *form++ = &settings++->form;
        }
    return OVR_OK;
}
