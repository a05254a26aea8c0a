/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "simulation/parts.h"
#include "base/error.h"

#include <stddef.h>

#define INFO(NAME, words, section, key, whole, options, setup)                 \
    {words, section, key, whole},
static const ovr_part_info parts[OVR_PARTS] = {OVR_PART_ROWS(INFO)};

static const char corrected[] =
    "its corrections are those of the line smoother's second-order row";
static const char flooded[] = "the paper's own means know no cavities";
static const char in_time[] =
    "the paper solves steady contacts; in time its means diverge on waves";
static const char base_row[] =
    "patches know the second-order row and the line smoother only";
static const char on_patches[] = "it has no form on composite grids";

static const char one_grid[] =
    "surfaces that touch are solved by Newton's method on the finest grid";
static const char kinks[] = "the law of touching surfaces kinks at the rupture";
static const char two_unknowns[] =
    "a dry node where surfaces touch has a filling and a pressure";

static const char stays[] = "running-in is of a contact that stays as it is";
static const char long_steps[] =
    "running-in goes in steps in which the film settles";
static const char summits[] = "summits would yield first";
static const char once[] = "on the mesh it would count a second time";

static const ovr_refusal refusals[] = {
    {OVR_PART_MEAN_FILM, OVR_PART_ROUGHNESS, "unresolved", once},
    {OVR_PART_WEAR, OVR_PART_TIME, "0", stays},
    {OVR_PART_WEAR, OVR_PART_LOAD, "0", stays},
    {OVR_PART_WEAR, OVR_PART_REVERSAL, "0", stays},
    {OVR_PART_WEAR, OVR_PART_SPEED, "0", stays},
    {OVR_PART_WEAR, OVR_PART_SLIDING, "0", stays},
    {OVR_PART_WEAR, OVR_PART_RADIUS, "0", stays},
    {OVR_PART_ADAPTIVE, OVR_PART_WEAR, "no step", long_steps},
    {OVR_PART_UPSTREAM2, OVR_PART_WEAR, "upstream1", long_steps},
    {OVR_PART_CHARACTERISTIC, OVR_PART_WEAR, "upstream1", long_steps},
    {OVR_PART_HEAT, OVR_PART_WEAR, "none", long_steps},
    {OVR_PART_PLASTIC, OVR_PART_BOUNDARY, "no [plastic]", summits},
    {OVR_PART_STRESS, OVR_PART_WEAR, "no [stress]", long_steps},
    {OVR_PART_SUPPLY, OVR_PART_BOUNDARY, "flooded", two_unknowns},
    {OVR_PART_PASSES, OVR_PART_BOUNDARY, "1", two_unknowns},
    {OVR_PART_ORDER_4, OVR_PART_BOUNDARY, "2", kinks},
    {OVR_PART_PAPER_SMOOTHER, OVR_PART_BOUNDARY, "line", one_grid},
    {OVR_PART_PAPER_BALANCE, OVR_PART_BOUNDARY, "no", one_grid},
    {OVR_PART_FIXED_CYCLES, OVR_PART_BOUNDARY, "negligible or truncation",
     one_grid},
    {OVR_PART_CONSERVING, OVR_PART_BOUNDARY, "reynolds", two_unknowns},
    {OVR_PART_PATCHES, OVR_PART_BOUNDARY, "none", one_grid},
    {OVR_PART_ORDER_4, OVR_PART_UPSTREAM1, "2", corrected},
    {OVR_PART_ORDER_4, OVR_PART_PAPER_SMOOTHER, "2", corrected},
    {OVR_PART_ORDER_4, OVR_PART_PAPER_BALANCE, "2", corrected},
    {OVR_PART_ORDER_4, OVR_PART_FIXED_CYCLES, "2", corrected},
    {OVR_PART_PAPER_SMOOTHER, OVR_PART_CONSERVING, "line", flooded},
    {OVR_PART_PAPER_BALANCE, OVR_PART_CONSERVING, "no", flooded},
    {OVR_PART_FIXED_CYCLES, OVR_PART_CONSERVING, "negligible or truncation",
     "cavities need cycles until they stand"},
    {OVR_PART_PAPER_SMOOTHER, OVR_PART_TIME, "line", in_time},
    {OVR_PART_PAPER_BALANCE, OVR_PART_TIME, "no", in_time},
    {OVR_PART_CONSERVING, OVR_PART_REVERSAL, "reynolds",
     "conserved oil keeps its inlet on the left"},
    {OVR_PART_TIME, OVR_PART_PATCHES, "a steady contact, without [time],",
     "what moves would leave them"},
    {OVR_PART_UPSTREAM1, OVR_PART_PATCHES, "upstream2", base_row},
    {OVR_PART_PAPER_SMOOTHER, OVR_PART_PATCHES, "line", base_row},
    {OVR_PART_PAPER_BALANCE, OVR_PART_PATCHES, "no", base_row},
    {OVR_PART_FIXED_CYCLES, OVR_PART_PATCHES, "negligible or truncation",
     base_row},
    {OVR_PART_FLOW_LAW, OVR_PART_PATCHES, "newtonian", on_patches},
    {OVR_PART_HEAT, OVR_PART_PATCHES, "none", on_patches},
    {OVR_PART_CONSERVING, OVR_PART_PATCHES, "reynolds", on_patches},
    {OVR_PART_PAPER_SMOOTHER, OVR_PART_PLASTIC, "line", in_time},
    {OVR_PART_PAPER_BALANCE, OVR_PART_PLASTIC, "no", in_time},
    {OVR_PART_PLASTIC, OVR_PART_PATCHES, "no [plastic]", on_patches},
    {OVR_PART_PLASTIC, OVR_PART_OTHER_MODULI, "no [plastic]",
     "residual stresses are those of one material; a coating that has the "
     "body's moduli goes"},
    {OVR_PART_STRESS, OVR_PART_PATCHES, "no [stress]", on_patches}};

enum { REFUSALS = sizeof refusals / sizeof *refusals };

ovr_part_info ovr_part_at(int part)
{
    return parts[part];
}

const ovr_refusal *ovr_refusal_at(size_t k)
{
    return k < REFUSALS ? &refusals[k] : NULL;
}

#define BIT(NAME, words, section, key, whole, options, setup)                  \
    | ovr_part_bit(OVR_PART_##NAME, options)
unsigned ovr_parts_of(const ovr_options *o)
{
    return 0U OVR_PART_ROWS(BIT);
}

const ovr_refusal *ovr_parts_conflict(unsigned on)
{
    for (size_t k = 0; k < REFUSALS; k++)
        if (on >> refusals[k].part & on >> refusals[k].beside & 1)
            return &refusals[k];
    return NULL;
}

ovr_status ovr_parts_check(unsigned on, ovr_error *err)
{
    const ovr_refusal *r = ovr_parts_conflict(on);
    if (!r)
        return OVR_OK;
    return ovr_fail_about(err, parts[r->part].key,
                          "%s does not go with %s; %s = %s does",
                          parts[r->part].name, parts[r->beside].name,
                          parts[r->part].key, r->instead);
}
