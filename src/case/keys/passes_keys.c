/* SPDX-License-Identifier: GPL-3.0-or-later */
/* [passes] belongs to no physical model, because lubricant and plastic strains
 * are carried from pass to pass and a bearing determines their number. */
#include "case/keys/keys.h"

#include <math.h>

static const ovr_word agains[] = {{"both", 3}, {"1", 1}, {"2", 2}, {NULL, 0}};
static const ovr_parameter passes_keys[] = {
    {"number", WHOLE(1, 100000), "1", AT(passes.number), false, ALWAYS,
     "number of passes, each supplied by the lubricant left by the preceding "
     "one; needs cavitation.model = conserving"},
    {"split", PLAIN(0, 1), "0.5", AT(passes.split), true,
     "number > 1 or roller_bearing.passes",
     "share of the outlet film thickness that stays on surface 1"},
    {"loss", PLAIN(0, 1), "0", AT(passes.loss), true,
     "number > 1 or roller_bearing.passes",
     "share of each layer that is lost between two passes"},
    {"side_flow", POSITIVE(100), NULL, AT(passes.side_flow), true,
     "number > 1 or roller_bearing.passes",
     "instead of loss: exponent g of x/(1 + x^g)^(1/g), where x is the layer "
     "relative to that of a flooded contact; 2 to 5 for point contacts"},
    {"replenish", HEIGHT, "0", AT(passes.replenish), true,
     "number > 1 or roller_bearing.passes",
     "thickness of lubricant added to each surface between two passes"},
    {"spacing", LENGTH(1e-3, 1e9), NULL, AT(passes.spacing), true,
     "number > 1 or roller_bearing.passes; recovery",
     "distance between rolling bodies along the surfaces"},
    {"recovery", OVR_NUMBER, OVR_DURATION, OVR_IN_TIME, 1e-6, 1e12, false,
     .words = NULL, NULL, AT(passes.recovery), true,
     "number > 1 or roller_bearing.passes",
     "time constant of replenishment: the difference to the layer of a "
     "flooded contact decreases by 1/e; needs spacing"},
    {"again", CHOICE(agains), "both", AT(passes.again), true,
     "number > 1 or roller_bearing.passes",
     "surfaces that return with their layers; the other surface is a new "
     "body in each pass, with a uniform layer"},
    {"loads", LIST(OVR_PURE, OVR_NOT_HERTZIAN, 1e-3, 1e3, NULL), NULL,
     AT(passes.loads), true, "number > 1 or roller_bearing.passes",
     "load of each pass relative to that of [contact], one value per pass "
     "(load zone)"},
};

const ovr_section ovr_passes_section = {
    "passes", false, "number",
    "several passes: each pass is supplied by the lubricant layers left by "
    "the preceding one",
    ROWS(passes_keys)};
