/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Keys of [time], of the histories and of [passes]. [passes] belongs to no
 * physical model: lubricant and plastic strains are carried from pass to pass,
 * and the number of passes may follow from a bearing. */
#include "case/keys/keys.h"

#include <math.h>

#include "contact/history_keys.h"

static const ovr_word schemes[] = {{"auto", -1},
                                   {"upstream1", OVR_UPSTREAM1},
                                   {"upstream2", OVR_UPSTREAM2},
                                   {"characteristic", OVR_CHARACTERISTIC},
                                   {NULL, 0}};
static const ovr_word steps[] = {{"auto", OVR_STEP_AUTO},
                                 {"grid", 0},
                                 {"adaptive", OVR_STEP_ADAPTIVE},
                                 {NULL, 0}};
static const ovr_word curvatures[] = {{"auto", OVR_CURVATURE_AUTO},
                                      {"rides", OVR_CURVATURE_CONVECTED},
                                      {"imposed", OVR_CURVATURE_IMPOSED},
                                      {NULL, 0}};
static const ovr_word auto_end[] = {{"auto", OVR_END_AUTO}, {NULL, 0}};

static const ovr_parameter time_keys[] = {
    {"end", SPAN(auto_end, 1e5), NULL, AT(march.end), false, ALWAYS,
     "end of the run, which starts at 0; auto: when all features have left, "
     "load and speed do not change any more and the film is steady again; "
     "without an end the case is steady"},
    {"step", SPAN(steps, 1e3), "auto", AT(step), true, IN_TIME,
     "time step; grid: the mesh size; auto: twice that where it costs no "
     "accuracy (order 4 along the characteristic), the mesh size else; "
     "adaptive: by the scheme's own error"},
    {"scheme", CHOICE(schemes), "auto", AT(scheme), true, ALWAYS,
     "discretization in X and T: upstream1 with backward Euler, upstream2 "
     "with BDF2, or narrow second order along the characteristic; auto: "
     "characteristic in runs with step = auto, grid or at most 0.05 b/um "
     "(0.02 where load, speed or radius vary; with a limited supply or "
     "several passes shorter for M > 20); upstream2 else"},
    {"error", PLAIN(1e-9, 0.1), "1e-3", AT(march.error), true,
     IN_TIME "; step = adaptive",
     "relative error of the film thickness due to the time steps during one "
     "passage of the contact"},
    {"until_steady", FLAG, "no", AT(march.until_steady), false, IN_TIME,
     "end the run when the contact is steady again"},
};

const ovr_section ovr_time_section = {
    "time", false, "end",
    "the run in time, and the scheme (also of steady cases)", ROWS(time_keys)};

static const ovr_parameter load_keys[] = {
    HISTORY(AT(load), "1", 0, 100, 1, CHANGES),
};

const ovr_section ovr_load_section = {
    "load", false, NULL, "load against time, relative to that of [contact]",
    ROWS(load_keys)};

static const ovr_parameter speed_keys[] = {
    HISTORY(AT(speed), "1", -100, 100, 100, CHANGES " or mean"),
    {"mean", PLAIN(-100, 100), "1", IN_CHANGE(AT(speed), form.mean), true,
     "history = sine", "mean value of the oscillation; 0: the motion reverses"},
};

const ovr_section ovr_speed_section = {
    "speed", false, NULL,
    "mean speed against time, relative to that of [contact]", ROWS(speed_keys)};

static const ovr_parameter sliding_keys[] = {
    HISTORY(AT(sliding), NULL, -1e3, 1e3, 1e3, CHANGES),
};

const ovr_section ovr_sliding_section = {
    "sliding", false, NULL,
    "sliding speed (u1 - u2)/um against time, relative to the reference um, of "
    "any sign; from and to default to slide_to_roll",
    ROWS(sliding_keys)};

static const ovr_parameter radius_keys[] = {
    HISTORY(AT(radius), "1", 0.01, 100, 0.99, CHANGES),
    {"curvature", CHOICE(curvatures), "auto", AT(curvature), true,
     "history = ramp | sine | step | table",
     "imposed; or rides: convected with the material, as on gear teeth and "
     "cams; auto: rides if the surfaces are fast enough and the radius changes "
     "smoothly"},
};

const ovr_section ovr_radius_section = {
    "radius", false, NULL,
    "reduced radius against time, relative to that of [contact], which stays "
    "the scale",
    ROWS(radius_keys)};

static const ovr_parameter radius_1_keys[] = {
    HISTORY(AT(radius_1), "1", -1e3, 1e3, 1e3, CHANGES),
};

const ovr_section ovr_radius_1_section = {
    "radius_1", false, NULL,
    "radius of surface 1 against time, relative to the reduced one of "
    "[contact], negative: concave; the rest of the curvature is surface 2's; "
    "without it all of it moves at the mean speed",
    ROWS(radius_1_keys)};

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
