/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "simulation/conflicts.h"
#include "base/error.h"

#include <stddef.h>

#define INFO(NAME, words, section, key, whole, options, setup)                 \
    {words, section, key, whole},
static const ovr_model_feature_info features[OVR_MODEL_FEATURES] = {
    OVR_MODEL_FEATURE_ROWS(INFO)};

static const char corrected[] =
    "the corrections are defined for the second-order equation of the line "
    "smoother only";
static const char flooded[] =
    "the averages of the paper do not model mass-conserving cavitation";
static const char in_time[] =
    "the paper solves steady contacts; its averages diverge for waves in time";
static const char base_row[] =
    "patches use the second-order equation and the line smoother only";
static const char on_patches[] = "not implemented on composite grids";

static const char one_grid[] =
    "asperity contact is solved by Newton's method on the finest grid";
static const char kinks[] = "the derivative of the asperity contact model "
                            "jumps at film rupture";
static const char two_unknowns[] = "a cavitated node in asperity contact has "
                                   "both a film fraction and a pressure";

static const char stays[] = "running-in requires constant operating "
                            "conditions";
static const char long_steps[] =
    "running-in is computed in steps in which the film becomes steady";
static const char summits[] = "the asperity summits would yield first";
static const char once[] = "roughness on the grid would be counted twice";

static const char of_line[] =
    "the solver of a strip, whose film varies across rolling, does not "
    "support this";

static const ovr_conflict conflicts[] = {
    {OVR_MODEL_HEAT, OVR_MODEL_STRIP, "none", of_line},
    {OVR_MODEL_CONSERVING, OVR_MODEL_STRIP, "reynolds", of_line},
    {OVR_MODEL_SUPPLY, OVR_MODEL_STRIP, "flooded", of_line},
    {OVR_MODEL_PASSES, OVR_MODEL_STRIP, "1", of_line},
    {OVR_MODEL_BOUNDARY, OVR_MODEL_STRIP, "no [boundary]", of_line},
    {OVR_MODEL_COATING, OVR_MODEL_STRIP, "no [coating]", of_line},
    {OVR_MODEL_PLASTIC, OVR_MODEL_STRIP, "no [plastic]", of_line},
    {OVR_MODEL_STRESS, OVR_MODEL_STRIP, "no [stress]", of_line},
    {OVR_MODEL_FATIGUE, OVR_MODEL_STRIP, "no [fatigue]", of_line},
    {OVR_MODEL_PATCHES, OVR_MODEL_STRIP, "none", of_line},
    {OVR_MODEL_ORDER_4, OVR_MODEL_STRIP, "2", of_line},
    {OVR_MODEL_UPSTREAM1, OVR_MODEL_STRIP, "upstream2", of_line},
    {OVR_MODEL_PAPER_SMOOTHER, OVR_MODEL_STRIP, "line", of_line},
    {OVR_MODEL_PAPER_BALANCE, OVR_MODEL_STRIP, "no", of_line},
    {OVR_MODEL_FIXED_CYCLES, OVR_MODEL_STRIP, "negligible or truncation",
     of_line},
    {OVR_MODEL_ADAPTIVE, OVR_MODEL_STRIP, "auto", of_line},
    {OVR_MODEL_REVERSAL, OVR_MODEL_STRIP, "a speed that keeps its direction",
     of_line},
    {OVR_MODEL_MEAN_FILM, OVR_MODEL_ROUGHNESS, "unresolved", once},
    {OVR_MODEL_WEAR, OVR_MODEL_TIME, "0", stays},
    {OVR_MODEL_WEAR, OVR_MODEL_LOAD, "0", stays},
    {OVR_MODEL_WEAR, OVR_MODEL_REVERSAL, "0", stays},
    {OVR_MODEL_WEAR, OVR_MODEL_SPEED, "0", stays},
    {OVR_MODEL_WEAR, OVR_MODEL_SLIDING, "0", stays},
    {OVR_MODEL_WEAR, OVR_MODEL_RADIUS, "0", stays},
    {OVR_MODEL_ADAPTIVE, OVR_MODEL_WEAR, "no step", long_steps},
    {OVR_MODEL_CHARACTERISTIC, OVR_MODEL_WEAR, "upstream2", long_steps},
    {OVR_MODEL_HEAT, OVR_MODEL_WEAR, "none", long_steps},
    {OVR_MODEL_PLASTIC, OVR_MODEL_BOUNDARY, "no [plastic]", summits},
    {OVR_MODEL_STRESS, OVR_MODEL_WEAR, "no [stress]", long_steps},
    {OVR_MODEL_SUPPLY, OVR_MODEL_BOUNDARY, "flooded", two_unknowns},
    {OVR_MODEL_PASSES, OVR_MODEL_BOUNDARY, "1", two_unknowns},
    {OVR_MODEL_ORDER_4, OVR_MODEL_BOUNDARY, "2", kinks},
    {OVR_MODEL_PAPER_SMOOTHER, OVR_MODEL_BOUNDARY, "line", one_grid},
    {OVR_MODEL_PAPER_BALANCE, OVR_MODEL_BOUNDARY, "no", one_grid},
    {OVR_MODEL_FIXED_CYCLES, OVR_MODEL_BOUNDARY, "negligible or truncation",
     one_grid},
    {OVR_MODEL_CONSERVING, OVR_MODEL_BOUNDARY, "reynolds", two_unknowns},
    {OVR_MODEL_PATCHES, OVR_MODEL_BOUNDARY, "none", one_grid},
    {OVR_MODEL_ORDER_4, OVR_MODEL_UPSTREAM1, "2", corrected},
    {OVR_MODEL_ORDER_4, OVR_MODEL_PAPER_SMOOTHER, "2", corrected},
    {OVR_MODEL_ORDER_4, OVR_MODEL_PAPER_BALANCE, "2", corrected},
    {OVR_MODEL_ORDER_4, OVR_MODEL_FIXED_CYCLES, "2", corrected},
    {OVR_MODEL_PAPER_SMOOTHER, OVR_MODEL_CONSERVING, "line", flooded},
    {OVR_MODEL_PAPER_BALANCE, OVR_MODEL_CONSERVING, "no", flooded},
    {OVR_MODEL_FIXED_CYCLES, OVR_MODEL_CONSERVING, "negligible or truncation",
     "cavities need cycles until they no longer change"},
    {OVR_MODEL_PAPER_SMOOTHER, OVR_MODEL_TIME, "line", in_time},
    {OVR_MODEL_PAPER_BALANCE, OVR_MODEL_TIME, "no", in_time},
    {OVR_MODEL_CONSERVING, OVR_MODEL_REVERSAL, "reynolds",
     "with mass-conserving cavitation the inlet is always on the left"},
    {OVR_MODEL_TIME, OVR_MODEL_PATCHES, "a steady contact, without [time],",
     "moving features would leave the patches"},
    {OVR_MODEL_UPSTREAM1, OVR_MODEL_PATCHES, "upstream2", base_row},
    {OVR_MODEL_PAPER_SMOOTHER, OVR_MODEL_PATCHES, "line", base_row},
    {OVR_MODEL_PAPER_BALANCE, OVR_MODEL_PATCHES, "no", base_row},
    {OVR_MODEL_FIXED_CYCLES, OVR_MODEL_PATCHES, "negligible or truncation",
     base_row},
    {OVR_MODEL_FLOW_LAW, OVR_MODEL_PATCHES, "newtonian", on_patches},
    {OVR_MODEL_HEAT, OVR_MODEL_PATCHES, "none", on_patches},
    {OVR_MODEL_CONSERVING, OVR_MODEL_PATCHES, "reynolds", on_patches},
    {OVR_MODEL_PAPER_SMOOTHER, OVR_MODEL_PLASTIC, "line", in_time},
    {OVR_MODEL_PAPER_BALANCE, OVR_MODEL_PLASTIC, "no", in_time},
    {OVR_MODEL_PLASTIC, OVR_MODEL_PATCHES, "no [plastic]", on_patches},
    {OVR_MODEL_PLASTIC, OVR_MODEL_OTHER_MODULI, "no [plastic]",
     "residual stresses of plastic strain are computed for one material only; "
     "a coating with the moduli of the body is possible"},
    {OVR_MODEL_STRESS, OVR_MODEL_PATCHES, "no [stress]", on_patches}};

enum { CONFLICTS = sizeof conflicts / sizeof *conflicts };

ovr_model_feature_info ovr_model_feature_at(int feature)
{
    return features[feature];
}

const ovr_conflict *ovr_conflict_at(size_t k)
{
    return k < CONFLICTS ? &conflicts[k] : NULL;
}

#define BIT(NAME, words, section, key, whole, options, setup)                  \
    | ovr_model_feature_bit(OVR_MODEL_##NAME, options)
unsigned ovr_model_features_of(const ovr_options *o)
{
    return 0U OVR_MODEL_FEATURE_ROWS(BIT);
}

const ovr_conflict *ovr_conflict_among(unsigned on)
{
    for (size_t k = 0; k < CONFLICTS; k++)
        if (on >> conflicts[k].feature & on >> conflicts[k].other & 1)
            return &conflicts[k];
    return NULL;
}

ovr_status ovr_conflict_check(unsigned on, ovr_error *err)
{
    const ovr_conflict *r = ovr_conflict_among(on);
    if (!r)
        return OVR_OK;
    return ovr_fail_about(err, features[r->feature].key,
                          "%s cannot be combined with %s; use %s = %s",
                          features[r->feature].name, features[r->other].name,
                          features[r->feature].key, r->instead);
}
