/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "simulation/parts.h"

#include <stddef.h>

/* In the order of ovr_part. */
static const ovr_part_info parts[OVR_PARTS] = {
    {"a run in time", "time", "end"},
    {"scheme upstream1", "time", "scheme"},
    {"scheme upstream2", "time", "scheme"},
    {"scheme characteristic", "time", "scheme"},
    {"order 2", "domain", "order"},
    {"order 4", "domain", "order"},
    {"a smoother of the paper", "paper", "smoother"},
    {"the paper's balance", "paper", "paper_balance"},
    {"a fixed number of cycles", "solver", "stop"},
    {"adaptive steps", "time", "step"},
    {"a history of load", "load", "history"},
    {"a history of speed", "speed", "history"},
    {"a speed that reverses", "speed", "history"},
    {"a history of sliding", "sliding", "history"},
    {"a history of the radius", "radius", "history"},
    {"a flow law", "lubricant", "rheology"},
    {"heat", "heat", "model"},
    {"cavitation that conserves oil", "cavitation", "model"},
    {"a supply that is a film", "supply", "model"},
    {"several passes", "passes", "number"},
    {"stresses", "stress", "surface"},
    {"fatigue", "fatigue", "criterion"},
    {"patches", "domain", "refine"}};

static const char separate[] =
    "the filling is carried by a wedge and a squeeze term of their own";
static const char corrected[] =
    "its corrections are those of the line smoother's second-order row";
static const char flooded[] = "the paper's own means know no cavities";
static const char in_time[] =
    "the paper solves steady contacts; in time its means diverge on waves";
static const char base_row[] =
    "patches know the second-order row and the line smoother only";
static const char on_patches[] = "it has no form on composite grids";

static const ovr_refusal refusals[] = {
    {OVR_PART_ORDER_4, OVR_PART_UPSTREAM1, "2", corrected},
    {OVR_PART_ORDER_4, OVR_PART_PAPER_SMOOTHER, "2", corrected},
    {OVR_PART_ORDER_4, OVR_PART_PAPER_BALANCE, "2", corrected},
    {OVR_PART_ORDER_4, OVR_PART_FIXED_CYCLES, "2", corrected},
    {OVR_PART_ORDER_4, OVR_PART_CONSERVING, "2",
     "at a meniscus the film is of second order at most"},
    {OVR_PART_ORDER_4, OVR_PART_HEAT, "2", "temperatures are of second order"},
    {OVR_PART_CHARACTERISTIC, OVR_PART_CONSERVING, "upstream2 or upstream1",
     separate},
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
    {OVR_PART_STRESS, OVR_PART_PATCHES, "no [stress]", on_patches}};

enum { REFUSALS = sizeof refusals / sizeof *refusals };

ovr_part_info ovr_part_at(ovr_part part)
{
    return parts[part];
}

const ovr_refusal *ovr_refusal_at(size_t k)
{
    return k < REFUSALS ? &refusals[k] : NULL;
}

const ovr_refusal *ovr_parts_refused(ovr_part a, ovr_part b)
{
    return ovr_parts_conflict(ovr_part_bit(a, true) | ovr_part_bit(b, true));
}

unsigned ovr_parts_of(const ovr_options *o)
{
    return ovr_part_bit(OVR_PART_UPSTREAM1, o->scheme == OVR_UPSTREAM1) |
           ovr_part_bit(OVR_PART_UPSTREAM2, o->scheme == OVR_UPSTREAM2) |
           ovr_part_bit(OVR_PART_CHARACTERISTIC,
                        o->scheme == OVR_CHARACTERISTIC) |
           ovr_part_bit(OVR_PART_ORDER_2, o->order == 2) |
           ovr_part_bit(OVR_PART_ORDER_4, o->order == 4) |
           ovr_part_bit(OVR_PART_PAPER_SMOOTHER, o->smoother != OVR_LINE) |
           ovr_part_bit(OVR_PART_PAPER_BALANCE, o->paper_balance) |
           ovr_part_bit(OVR_PART_FIXED_CYCLES, o->stop == OVR_STOP_FIXED) |
           ovr_part_bit(OVR_PART_CONSERVING,
                        o->cavitation == OVR_CAVITATION_CONSERVING) |
           ovr_part_bit(OVR_PART_PATCHES, o->refine != OVR_REFINE_NONE);
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
