/* SPDX-License-Identifier: GPL-3.0-or-later */
/* [plastic]. */
#include "case/keys/keys.h"

static const ovr_word which_surface[] = {
    {"1", 1}, {"2", 2}, {"both", 3}, {NULL, 0}};
static const ovr_word by_body[] = {{"body", NAN}, {NULL, 0}};
static const ovr_word laws[] = {{"none", OVR_HARDENS_NOT},
                                {"linear", OVR_HARDENS_LINEAR},
                                {"kinematic", OVR_HARDENS_KINEMATIC},
                                {"swift", OVR_HARDENS_SWIFT},
                                {NULL, 0}};
static const ovr_word feature_window[] = {{"feature", 0}, {NULL, 0}};
static const ovr_word couplings[] = {{"step", 0}, {"pass", 1}, {NULL, 0}};

static const ovr_parameter plastic_keys[] = {
    {"surface", CHOICE(which_surface), NULL, AT(plastic.surface), true, ALWAYS,
     "whose material yields; 1 where the section is there and says nothing"},
    {"hardening", CHOICE(laws), "swift", AT(plastic.hardening), true,
     "[plastic]",
     "of the von Mises stress at which it flows: none, by modulus, along the "
     "strain by modulus (Prager), or a power of all that has flowed (Swift)"},
    {"yield", STRESS(by_body, 1e-3, 1e4), "body", AT(plastic.yield), true,
     "[plastic]",
     "von Mises stress at no plastic strain; body: of [body N]; with swift it "
     "takes the place of B C^n"},
    {"swift", TEXT, "945 MPa, 20, 0.121", AT(plastic.swift), true,
     "[plastic]; hardening = swift",
     "B, C, n of B (C + plastic strain in 1e-6)^n; as it stands that of "
     "bearing steel 52100"},
    {"modulus", STRESS(NULL, 0, 1e9), "0", AT(plastic.modulus), true,
     "[plastic]; hardening = linear | kinematic",
     "by which the yield stress rises, over the plastic strain"},
    {"passes", WHOLE(1, 1000), "1", AT(plastic.passes), true, "[plastic]",
     "overrollings of the same material, each from the steady smooth contact; "
     "they end once it has shaken down"},
    {"window", LIST(OVR_LENGTH, OVR_IN_B, -1e6, 1e6, feature_window), "feature",
     AT(plastic.window), true, "[plastic]",
     "material that may yield, FROM, TO about the first feature's centre; "
     "feature: 1 b beyond the features of the surface, 3 b at the least"},
    {"layers", WHOLE(4, 200), "24", AT(plastic.layers), true, "[plastic]",
     "layers of constant plastic strain, at most; the first a mesh thick"},
    {"depth_max", LENGTH(1e-3, 10), "0.5", AT(plastic.depth), true, "[plastic]",
     "depth that they reach"},
    {"iterations", WHOLE(1, 10000), "8", AT(plastic.iterations), true,
     "[plastic]", "of flow and equilibrium a step, at most"},
    {"coupling", CHOICE(couplings), "step", AT(plastic.once), true, "[plastic]",
     "when the profile changes: with each step, or between passes alone"},
    {"initial", PATH, NULL, AT(plastic.initial), true, "[plastic]",
     "result file of an earlier run, whose strains and hardening it begins "
     "with"},
    {"profiles", PATH, NULL, AT(plastic.profiles), false, "[plastic]",
     "STEM: the profile as it came and as it is left, in STEM-before.csv and "
     "STEM-after.csv, which [feature] shape = profile reads"},
    {"elastic", FLAG, "no", AT(plastic.elastic), true, "[plastic]",
     "one pass more, before the others, in which nothing yields: the report "
     "has its equivalent length and life beside those of the last"},
    {"anyway", FLAG, "no", AT(plastic.anyway), false, "[plastic]",
     "go on where the smooth contact never shakes down"},
};

const ovr_section ovr_plastic_section = {
    "plastic", false, NULL,
    "material that yields below a surface; needs [stress]", ROWS(plastic_keys)};
