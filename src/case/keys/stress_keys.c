/* SPDX-License-Identifier: GPL-3.0-or-later */
/* [stress] and [fatigue]. */
#include "case/keys/keys.h"

#include <math.h>

static const ovr_word which_surface[] = {
    {"1", 1}, {"2", 2}, {"both", 3}, {NULL, 0}};
static const ovr_word tractions[] = {{"auto", OVR_TRACTION_AUTO},
                                     {"yes", OVR_TRACTION_YES},
                                     {"no", OVR_TRACTION_NO},
                                     {NULL, 0}};
static const ovr_word feature_window[] = {{"feature", 0}, {NULL, 0}};
static const ovr_word stress_fields[] = {
    {"sigma_x", 0}, {"sigma_z", 0},     {"tau_xz", 0},
    {"sigma_y", 0}, {"von_mises", 0},   {"max_shear", 0},
    {"tresca", 0},  {"hydrostatic", 0}, {NULL, 0}};
static const ovr_word criteria[] = {
    {"circle", OVR_CRITERION_CIRCLE},
    {"orthogonal", OVR_CRITERION_ORTHOGONAL},
    {"critical-plane", OVR_CRITERION_CRITICAL_PLANE},
    {"dang-van", OVR_CRITERION_DANG_VAN},
    {"von-mises", OVR_CRITERION_VON_MISES},
    {"tresca", OVR_CRITERION_TRESCA},
    {NULL, 0}};
static const ovr_word no_limit[] = {{"none", 0}, {NULL, 0}};
static const ovr_word risk_exponents[] = {{"31/3", 31. / 3}, {NULL, 0}};
static const ovr_word depth_exponents[] = {{"7/3", 7. / 3}, {NULL, 0}};
static const ovr_word weibull_slopes[] = {
    {"9/8", 9. / 8}, {"10/9", 10. / 9}, {NULL, 0}};
static const ovr_word auto_zero[] = {{"auto", 0}, {NULL, 0}};

static const ovr_parameter stress_keys[] = {
    {"surface", CHOICE(which_surface), NULL, AT(stress_surface), true, ALWAYS,
     "below which surface; 1 where the section is there and says nothing"},
    {"depth_min", LENGTH_OR(auto_zero, 1e-9, 1e3), "auto", AT(stress.depth_min),
     true, ALWAYS,
     "least depth of the history of the material; auto: 4 meshes"},
    {"depth_max", LENGTH(1e-6, 1e3), "2.5", AT(stress.depth_max), true, ALWAYS,
     "largest depth"},
    {"depths_per_octave", PLAIN(1, 100), "5", AT(stress.per_octave), true,
     ALWAYS, "depths, geometric"},
    {"every", WHOLE(0, 1000000000), "0", AT(stress_every), true, ALWAYS,
     "store stress fields at every so many snapshots; 0: none"},
    {"fields", WORDS(stress_fields), "sigma_x, sigma_z, tau_xz",
     AT(stress.fields), true, "every > 0", "stress fields to store"},
    {"window", LIST(OVR_LENGTH, OVR_IN_B, -1e6, 1e6, feature_window), "feature",
     AT(window), true, ALWAYS,
     "material whose history is kept, FROM, TO about the first feature's "
     "centre; feature: 2 b beyond the features of the surface"},
    {"traction", CHOICE(tractions), "auto", AT(stress_traction), true, ALWAYS,
     "the film's shear stress as a load on the surface beside the pressure; "
     "auto: with a flow law or limiting_shear, where b/R is known"},
};

const ovr_section ovr_stress_section = {
    "stress", false, NULL,
    "stresses below a surface; without this section there are none",
    ROWS(stress_keys)};

static const ovr_parameter fatigue_keys[] = {
    {"criterion", CHOICE(criteria), "circle", AT(criterion), false, ALWAYS,
     "amplitude that does harm: radius of the smallest circle round the path "
     "of the shear stress, half range of the orthogonal shear stress, that on "
     "the worst plane, Dang Van's with one line, or static maxima"},
    {"alpha", PLAIN(0, 1), "0.3", AT(stress.alpha), false,
     "criterion = circle | dang-van",
     "of the hydrostatic stress; circle: in tension only"},
    {"limit_pressure", STRESS(no_limit, 0, 1e3), "1.5 GPa",
     AT(stress.limit_pressure), false, ALWAYS,
     "Hertz pressure of a smooth contact below which amplitudes do no harm"},
    {"limit_table", PATH, NULL, AT(limit_table), true, ALWAYS,
     "file of depth and limiting amplitude, of hardened bodies, instead of "
     "limit_pressure; its first line names the units, 'depth [um], limit "
     "[MPa]'"},
    {"exponent", PLAIN_OR(risk_exponents, 1, 100), "31/3", AT(life.exponent),
     false, ALWAYS, "c of the amplitude in the risk"},
    {"depth_exponent", PLAIN_OR(depth_exponents, 0, 10), "7/3",
     AT(life.depth_exponent), false, ALWAYS, "h of the depth in the risk"},
    {"weibull", PLAIN_OR(weibull_slopes, 0.1, 10), "9/8", AT(life.weibull),
     false, ALWAYS, "e, Weibull slope"},
    {"least_depth", LENGTH_OR(auto_zero, 1e-9, 1e3), "auto",
     AT(life.least_depth), true, ALWAYS,
     "from which risk and largest values are counted; auto: 8 meshes"},
    {"raceway", OVR_NUMBER, OVR_LENGTH, OVR_IN_B, 0, 1e9, false, .words = NULL,
     "0", AT(stress.raceway), false, ALWAYS,
     "length of the raceway, for a ratio of lives; 0: none is given; left out "
     "with [roller_bearing]: its circumference"},
    {"count", PLAIN(0, 1e9), "1", AT(stress.count), false,
     "raceway or roller_bearing.rollers",
     "how often the features are on that raceway"},
    {"residual_x", STRESS(NULL, -10, 10), "0", AT(stress.residual_x), true,
     "no residual_table",
     "residual stress along the surface, tension positive"},
    {"residual_y", STRESS(NULL, -10, 10), "0", AT(stress.residual_y), true,
     "no residual_table", "residual stress across"},
    {"residual_table", PATH, NULL, AT(residual_table), true, ALWAYS,
     "file of depth and residual stress, along and across alike, of hardened "
     "bodies, below their layers; its first line names the units, 'depth [um], "
     "stress [MPa]'"},
};

const ovr_section ovr_fatigue_section = {
    "fatigue", false, NULL, "what they do to the material; needs [stress]",
    ROWS(fatigue_keys)};
