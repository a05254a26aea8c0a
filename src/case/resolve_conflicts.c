/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Refuses the features of a case that do not go together: of those that are
 * written, as what is not gives way. */
#include <math.h>
#include <stdio.h>

#include "case/resolve.h"
#include "contact/reversal.h"
#include "simulation/conflicts.h"

static bool is_given(const ovr_resolved *r, int feature)
{
    ovr_model_feature_info info = ovr_model_feature_at(feature);
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

/* Those of the options count where their keys are written; stop, smoother,
 * refine and the like are nothing unless written. */
#define BY_SETUP(NAME, words, section, key, whole, options, setup) setup,
static unsigned written(const ovr_resolved *r)
{
    const ovr_setup *s = &r->setup;
    const bool by_setup[] = {OVR_MODEL_FEATURE_ROWS(BY_SETUP)};
    unsigned by_options = ovr_model_features_of(&r->values.options);
    unsigned on = ovr_resolved_features(r);
    for (int feature = 0; feature < OVR_MODEL_FEATURES; feature++)
        if (by_setup[feature] ||
            (by_options >> feature & 1 && is_given(r, feature)))
            on |= 1U << feature;
    return on;
}

/* "[heat] model = lobatto". */
static void put_name(const ovr_resolved *r, int feature, size_t size,
                     char text[])
{
    ovr_model_feature_info info = ovr_model_feature_at(feature);
    const ovr_slot *slot = ovr_slot_of(r, info.section, info.key);
    if (slot->given && feature != OVR_MODEL_REVERSAL)
        snprintf(text, size, "[%s] %s = %s", info.section, info.key,
                 slot->text);
    else
        snprintf(text, size, "%s", info.name);
}

ovr_status ovr_resolve_conflicts(const ovr_resolved *r, ovr_error *err)
{
    const ovr_conflict *conflict = ovr_conflict_among(written(r));
    const ovr_slot *slot;
    ovr_model_feature_info feature;
    char beside[100];
    if (!conflict)
        return OVR_OK;
    feature = ovr_model_feature_at(conflict->feature);
    slot = ovr_slot_of(r, feature.section, feature.key);
    put_name(r, conflict->other, sizeof beside, beside);
    return ovr_fail_slot(err, slot, "%s does not go with %s; %s does",
                         slot->given ? slot->text : feature.name, beside,
                         conflict->instead);
}
