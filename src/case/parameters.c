/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/parameters.h"
#include "base/sized.h"

#include <math.h>
#include <string.h>

#include "simulation/observables.h"

/* ------------------------------------------------------------------ words */

static const ovr_word viscosity_laws[] = {{"roelands", OVR_ROELANDS},
                                          {"barus", OVR_BARUS},
                                          {"isoviscous", OVR_ISOVISCOUS},
                                          {"doolittle", OVR_DOOLITTLE},
                                          {"yasutomi", OVR_YASUTOMI},
                                          {"table", OVR_VISCOSITY_TABLE},
                                          {NULL, 0}};
static const ovr_word density_laws[] = {
    {"dowson-higginson", OVR_DOWSON_HIGGINSON},
    {"incompressible", OVR_INCOMPRESSIBLE},
    {"tait", OVR_TAIT},
    {"table", OVR_DENSITY_TABLE},
    {NULL, 0}};
static const ovr_word materials[] = {{"steel", OVR_STEEL},
                                     {"silicon-nitride", OVR_SILICON_NITRIDE},
                                     {"tungsten-carbide", OVR_TUNGSTEN_CARBIDE},
                                     {"bronze", OVR_BRONZE},
                                     {"glass", OVR_GLASS},
                                     {"sapphire", OVR_SAPPHIRE},
                                     {NULL, 0}};
static const ovr_word heats[] = {{"none", 0}, {"lobatto", 1}, {NULL, 0}};
static const ovr_word heat_points[] = {{"5", 5}, {"7", 7}, {NULL, 0}};
static const ovr_word flat[] = {{"flat", INFINITY}, {NULL, 0}};
static const ovr_word rheologies[] = {{"newtonian", OVR_NEWTONIAN},
                                      {"eyring", OVR_EYRING},
                                      {"carreau", OVR_CARREAU},
                                      {"table", OVR_FLOW_TABLE},
                                      {NULL, 0}};
static const ovr_word carreau_forms[] = {
    {"rate", OVR_CARREAU}, {"stress", OVR_CARREAU_STRESS}, {NULL, 0}};
static const ovr_word schemes[] = {{"auto", -1},
                                   {"upstream1", OVR_UPSTREAM1},
                                   {"upstream2", OVR_UPSTREAM2},
                                   {"characteristic", OVR_CHARACTERISTIC},
                                   {NULL, 0}};
static const ovr_word smoothers[] = {{"line", OVR_LINE},
                                     {"hybrid", OVR_HYBRID},
                                     {"gauss-seidel", OVR_GAUSS_SEIDEL},
                                     {"dipole", OVR_DIPOLE},
                                     {NULL, 0}};
static const ovr_word orders[] = {{"auto", 0}, {"2", 2}, {"4", 4}, {NULL, 0}};
static const ovr_word refines[] = {
    {"none", OVR_REFINE_NONE}, {"spike", OVR_REFINE_SPIKE}, {NULL, 0}};
static const ovr_word accuracies[] = {{"H_cen", OVR_ACCURACY_H_CEN},
                                      {"H_min", OVR_ACCURACY_H_MIN},
                                      {"features", OVR_ACCURACY_FEATURES},
                                      {NULL, 0}};
static const ovr_word cycles[] = {{"V", 1}, {"W", 2}, {NULL, 0}};
static const ovr_word stops[] = {{"negligible", OVR_STOP_NEGLIGIBLE},
                                 {"truncation", OVR_STOP_TRUNCATION},
                                 {"fixed", OVR_STOP_FIXED},
                                 {NULL, 0}};
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
static const ovr_word agains[] = {{"both", 3}, {"1", 1}, {"2", 2}, {NULL, 0}};
static const ovr_word no_limit[] = {{"none", 0}, {NULL, 0}};
static const ovr_word risk_exponents[] = {{"31/3", 31. / 3}, {NULL, 0}};
static const ovr_word depth_exponents[] = {{"7/3", 7. / 3}, {NULL, 0}};
static const ovr_word weibull_slopes[] = {
    {"9/8", 9. / 8}, {"10/9", 10. / 9}, {NULL, 0}};
static const ovr_word auto_nan[] = {{"auto", NAN}, {NULL, 0}};
static const ovr_word inlets[] = {{"usual", 0}, {"auto", NAN}, {NULL, 0}};
static const ovr_word auto_zero[] = {{"auto", 0}, {NULL, 0}};
static const ovr_word cavitations[] = {
    {"reynolds", OVR_CAVITATION_REYNOLDS},
    {"conserving", OVR_CAVITATION_CONSERVING},
    {NULL, 0}};
static const ovr_word supplies[] = {{"flooded", 0}, {"film", 1}, {NULL, 0}};
static const ovr_word endless_oil[] = {{"endless", INFINITY}, {NULL, 0}};
static const ovr_word steps[] = {
    {"grid", 0}, {"adaptive", OVR_STEP_ADAPTIVE}, {NULL, 0}};
static const ovr_word histories[] = {
    {"constant", OVR_HISTORY_CONSTANT}, {"ramp", OVR_HISTORY_RAMP},
    {"sine", OVR_HISTORY_SINE},         {"step", OVR_HISTORY_STEP},
    {"table", OVR_HISTORY_TABLE},       {NULL, 0}};
static const ovr_word curvatures[] = {{"auto", OVR_CURVATURE_AUTO},
                                      {"rides", OVR_CURVATURE_RIDES},
                                      {"imposed", OVR_CURVATURE_IMPOSED},
                                      {NULL, 0}};
static const ovr_word time_units[] = {
    {"b/um", 0}, {"s", 1}, {"ms", 2}, {"us", 3}, {NULL, 0}};
static const ovr_word precisions[] = {{"f64", 0}, {"f32", 1}, {NULL, 0}};
#define FIELD(name, kind, axes, text) {#name, 0},
static const ovr_word fields[] = {OVR_FIELD_ROWS(FIELD){NULL, 0}};
static const ovr_word shapes[] = {
    {"dent", OVR_DENT},           {"bump", OVR_BUMP},
    {"indent", OVR_INDENT},       {"ridge", OVR_RIDGE},
    {"step", OVR_STEP},           {"groove", OVR_GROOVE},
    {"wave", OVR_WAVE},           {"chirp", OVR_CHIRP},
    {"texture", OVR_TEXTURE},     {"profile", OVR_PROFILE},
    {"roughness", OVR_ROUGHNESS}, {NULL, 0}};
static const ovr_word auto_end[] = {{"auto", OVR_END_AUTO}, {NULL, 0}};
static const ovr_word at_inlet[] = {{"inlet", -INFINITY}, {NULL, 0}};
static const ovr_word endless[] = {{"endless", 0}, {NULL, 0}};
static const ovr_word levellings[] = {
    {"none", OVR_LEVEL_NONE}, {"mean", OVR_LEVEL_MEAN},
    {"line", OVR_LEVEL_LINE}, {"polynomial", OVR_LEVEL_POLYNOMIAL},
    {"ends", OVR_LEVEL_ENDS}, {"circle", OVR_LEVEL_CIRCLE},
    {"auto", OVR_LEVEL_AUTO}, {NULL, 0}};
static const ovr_word extensions[] = {{"none", OVR_EXTEND_NONE},
                                      {"periodic", OVR_EXTEND_PERIODIC},
                                      {"mirror", OVR_EXTEND_MIRROR},
                                      {NULL, 0}};
static const ovr_word spectra[] = {{"self-affine", OVR_SELF_AFFINE},
                                   {"exponential", OVR_EXPONENTIAL},
                                   {NULL, 0}};

/* ------------------------------------------------------------------ table */

#define AT(field) offsetof(ovr_settings, field)
#define IN_FORM(field) offsetof(ovr_feature_settings, form.field)
#define IN_FEATURE(field) offsetof(ovr_feature_settings, field)

/* kind, dimension, bare unit, least, most, above, words */
#define PLAIN(least, most)                                                     \
    OVR_NUMBER, OVR_PURE, OVR_NOT_HERTZIAN, least, most, false, NULL
#define PLAIN_OR(words, least, most)                                           \
    OVR_NUMBER, OVR_PURE, OVR_NOT_HERTZIAN, least, most, false, words
#define POSITIVE(most)                                                         \
    OVR_NUMBER, OVR_PURE, OVR_NOT_HERTZIAN, 0, most, true, NULL
#define WITH_UNIT(dimension, least, most)                                      \
    OVR_NUMBER, dimension, OVR_NOT_HERTZIAN, least, most, false, NULL
#define LENGTH(least, most)                                                    \
    OVR_NUMBER, OVR_LENGTH, OVR_IN_B, least, most, false, NULL
#define LENGTH_OR(words, least, most)                                          \
    OVR_NUMBER, OVR_LENGTH, OVR_IN_B, least, most, false, words
#define SIZE OVR_NUMBER, OVR_LENGTH, OVR_IN_B, 1e-6, 1e4, false, NULL
#define HEIGHT OVR_NUMBER, OVR_LENGTH, OVR_IN_HEIGHT, 0, 1e3, false, NULL
#define SHIFT OVR_NUMBER, OVR_LENGTH, OVR_IN_HEIGHT, -1e3, 1e3, false, NULL
#define TIME(least, most)                                                      \
    OVR_NUMBER, OVR_DURATION, OVR_IN_TIME, least, most, false, NULL
#define SPAN(words, most)                                                      \
    OVR_NUMBER, OVR_DURATION, OVR_IN_TIME, 1e-6, most, false, words
#define STRESS(words, least, most)                                             \
    OVR_NUMBER, OVR_PRESSURE, OVR_IN_PRESSURE, least, most, false, words
#define AREA_OR(words, most)                                                   \
    OVR_NUMBER, OVR_AREA, OVR_IN_AREA, 0, most, false, words
#define WHOLE(least, most)                                                     \
    OVR_INTEGER, OVR_PURE, OVR_NOT_HERTZIAN, least, most, false, NULL
#define WHOLE_OR(words, least, most)                                           \
    OVR_INTEGER, OVR_PURE, OVR_NOT_HERTZIAN, least, most, false, words
#define CHOICE(words)                                                          \
    OVR_CHOICE, OVR_PURE, OVR_NOT_HERTZIAN, NAN, NAN, false, words
#define WORDS(words)                                                           \
    OVR_WORDS, OVR_PURE, OVR_NOT_HERTZIAN, NAN, NAN, false, words
#define FLAG OVR_FLAG, OVR_PURE, OVR_NOT_HERTZIAN, NAN, NAN, false, NULL
#define TEXT OVR_TEXT, OVR_PURE, OVR_NOT_HERTZIAN, NAN, NAN, false, NULL
#define PATH OVR_PATH, OVR_PURE, OVR_NOT_HERTZIAN, NAN, NAN, false, NULL

/* clang-format off */
#define IN_CHANGE(base, field) ((base) + offsetof(ovr_change, field))
#define HISTORY(section, base, initial, least, most, swing)                   \
    {section, "history", CHOICE(histories), "constant",                       \
     IN_CHANGE(base, history), true,                                          \
     "how it changes in time, relative to nominal"},                          \
    {section, "from", PLAIN(least, most), initial, IN_CHANGE(base, from),     \
     true,                                                                    \
     "ramp, step: value up to the start"},                                    \
    {section, "to", PLAIN(least, most), initial, IN_CHANGE(base, to), true,   \
     "ramp, step: value at the end"},                                         \
    {section, "start", TIME(-1e6, 1e6), "0", IN_CHANGE(base, start), true,    \
     "time at which the change begins"},                                      \
    {section, "duration", TIME(0, 1e6), "0", IN_CHANGE(base, duration), true, \
     "ramp: how long it takes (quintic smoothstep)"},                         \
    {section, "amplitude", PLAIN(-(swing), swing), "0",                       \
     IN_CHANGE(base, amplitude), true,                                        \
     "sine: amplitude about 1, of the sliding about slide_to_roll"},          \
    {section, "period", SPAN(NULL, 1e6), NULL, IN_CHANGE(base, period), true, \
     "sine: period"},                                                         \
    {section, "file", PATH, NULL, IN_CHANGE(base, file), true,                \
     "table: text file of two columns, time and value"},                      \
    {section, "time_unit", CHOICE(time_units), "b/um",                        \
     IN_CHANGE(base, time_unit), true,                                        \
     "table: unit of its times"}
/* clang-format on */

static const ovr_parameter table[] = {
    {"contact", "M", PLAIN(1e-3, 1e6), NULL, AT(contact.M), true,
     "Moes load parameter W/sqrt(2U)"},
    {"contact", "L", PLAIN(0, 1e3), NULL, AT(contact.L), true,
     "Moes material parameter G (2U)^(1/4); 0: isoviscous, incompressible"},
    {"contact", "lambda", PLAIN(1e-12, 1e7), NULL, AT(contact.lambda), true,
     "3 pi^2/(8 M^2), with alphabar instead of M and L"},
    {"contact", "alphabar", PLAIN(0, 1e5), NULL, AT(contact.alphabar), true,
     "alpha times the Hertzian pressure, with lambda"},
    {"contact", "load", WITH_UNIT(OVR_LOAD, 1e-6, 1e10), NULL, AT(contact.load),
     true, "load per unit width, w; as a force with width given"},
    {"contact", "width", WITH_UNIT(OVR_LENGTH, 1e-7, 1e4), NULL,
     AT(contact.width), false,
     "length of the contact along the rollers' axes: for a load in N, and for "
     "forces in N"},
    {"contact", "hertz_pressure", WITH_UNIT(OVR_PRESSURE, 1e2, 1e12), NULL,
     AT(contact.hertz_pressure), true,
     "maximum Hertzian pressure ph, instead of load (or of alpha)"},
    {"contact", "radius", WITH_UNIT(OVR_LENGTH, 1e-7, 1e4), NULL,
     AT(contact.radius), true,
     "reduced radius R, 1/R = 1/R1 + 1/R2; or from [body 1] and [body 2]"},
    {"contact", "modulus", WITH_UNIT(OVR_PRESSURE, 1e3, 1e13), NULL,
     AT(contact.modulus), true,
     "reduced modulus E', 2/E' = (1-nu1^2)/E1 + (1-nu2^2)/E2; or from [body "
     "1] and [body 2]"},
    {"contact", "viscosity", WITH_UNIT(OVR_DYNAMIC_VISCOSITY, 1e-7, 1e7), NULL,
     AT(contact.viscosity), true, "the same as viscosity in [lubricant]"},
    {"contact", "alpha", WITH_UNIT(OVR_PER_PRESSURE, 0, 1e-5), NULL,
     AT(contact.alpha), true, "the same as alpha in [lubricant]"},
    {"contact", "speed_1", WITH_UNIT(OVR_SURFACE_SPEED, -1e4, 1e4), NULL,
     AT(contact.speed_1), true, "speed of surface 1 along +x, u1"},
    {"contact", "speed_2", WITH_UNIT(OVR_SURFACE_SPEED, -1e4, 1e4), NULL,
     AT(contact.speed_2), true, "speed of surface 2 along +x, u2"},
    {"contact", "mean_speed", WITH_UNIT(OVR_SPEED, 1e-12, 1e4), NULL,
     AT(contact.mean_speed), true,
     "um = (u1 + u2)/2, instead of the two speeds"},
    {"contact", "slide_to_roll", WITH_UNIT(OVR_SHARE, -1e3, 1e3), NULL,
     AT(contact.slide_to_roll), true,
     "(u1 - u2)/um, may be in %; 0 unless given"},
    {"contact", "G", PLAIN(1, 1e7), NULL, AT(contact.G), true,
     "alpha E', with M and L: instead of modulus, for coefficients of "
     "friction"},
    {"contact", "bearable_pressure", WITH_UNIT(OVR_PRESSURE, 1, 1e13), "4 GPa",
     AT(bearable), false,
     "above it a run is warned of: hardened steel yields there"},

    {"lubricant", "viscosity_law", CHOICE(viscosity_laws), "roelands",
     AT(viscosity_law), true, "viscosity against pressure"},
    {"lubricant", "density_law", CHOICE(density_laws), "dowson-higginson",
     AT(density_law), true, "density against pressure"},
    {"lubricant", "viscosity", WITH_UNIT(OVR_DYNAMIC_VISCOSITY, 1e-7, 1e7),
     NULL, AT(contact.viscosity), true, "at ambient pressure, eta0"},
    {"lubricant", "alpha", WITH_UNIT(OVR_PER_PRESSURE, 0, 1e-5), NULL,
     AT(contact.alpha), true,
     "pressure-viscosity index; with M and L 17 1/GPa unless given"},
    {"lubricant", "p0", WITH_UNIT(OVR_PRESSURE, 1e5, 1e11), "198 MPa",
     AT(oil.p0), true, "Roelands' p0"},
    {"lubricant", "z", PLAIN_OR(auto_nan, 1e-3, 2), "auto", AT(oil.z), true,
     "Roelands' index; auto: alpha p0/(ln eta0 + 9.67) where alpha and "
     "viscosity are known, else 0.68"},
    {"lubricant", "rheology", CHOICE(rheologies), "newtonian", AT(rheology),
     true, "shear stress against shear rate"},
    {"lubricant", "eyring_stress", WITH_UNIT(OVR_PRESSURE, 1, 1e12), NULL,
     AT(flow.stress), true, "eyring: tau0, above which the film shears thin"},
    {"lubricant", "eyring_number", POSITIVE(1e12), NULL, AT(flow.number), true,
     "eyring: tau0 over ph b/R, instead of eyring_stress"},
    {"lubricant", "carreau_stress", WITH_UNIT(OVR_PRESSURE, 1, 1e12), NULL,
     AT(carreau_stress), true, "carreau: tau0 (G), where the film shears thin"},
    {"lubricant", "carreau_number", POSITIVE(1e12), NULL, AT(carreau_number),
     true, "carreau: tau0 over ph b/R, instead of carreau_stress"},
    {"lubricant", "carreau_n", PLAIN(0.05, 1), "0.5", AT(flow.n), true,
     "carreau: exponent at high rates, of the stress"},
    {"lubricant", "carreau_a", PLAIN(0.1, 10), "2", AT(flow.a), true,
     "carreau: Yasuda's exponent of the change"},
    {"lubricant", "carreau_form", CHOICE(carreau_forms), "rate",
     AT(carreau_form), true,
     "carreau: stress by the rate, as in textbooks, or rate by the stress"},
    {"lubricant", "rheology_file", PATH, NULL, AT(rheology_file), true,
     "table: file of shear stresses and rates at ambient pressure"},
    {"lubricant", "limiting_shear", PLAIN(0, 1), "0", AT(flow.limiting_shear),
     true,
     "most mean shear stress over pressure, in friction and heat; 0: no limit"},

    {"lubricant", "temperature", WITH_UNIT(OVR_TEMPERATURE, 150, 800), NULL,
     AT(oil.temperature), true,
     "of oil and bodies, at which the laws hold; for viscosity_40 and the like "
     "and for Yasutomi's law"},
    {"lubricant", "viscosity_40", WITH_UNIT(OVR_KINEMATIC_VISCOSITY, 1e-7, 1),
     NULL, AT(oil.nu_40), true,
     "kinematic viscosity at 40 degC, from a data sheet"},
    {"lubricant", "viscosity_100", WITH_UNIT(OVR_KINEMATIC_VISCOSITY, 1e-7, 1),
     NULL, AT(oil.nu_100), true, "kinematic viscosity at 100 degC"},
    {"lubricant", "iso_vg", PLAIN(2, 5000), NULL, AT(iso_vg), true,
     "ISO VG grade: viscosity_40 in mm2/s, the middle of the grade"},
    {"lubricant", "viscosity_index", PLAIN(-200, 500), NULL,
     AT(oil.viscosity_index), true,
     "viscosity index, instead of viscosity_100"},
    {"lubricant", "density_15", WITH_UNIT(OVR_MASS_DENSITY, 400, 3000), NULL,
     AT(oil.density_15), true,
     "density at 15 degC, with viscosity_40 or iso_vg"},
    {"lubricant", "viscosity_file", PATH, NULL, AT(viscosity_file), true,
     "viscosity_law = table: file of pressures and viscosities"},
    {"lubricant", "density_file", PATH, NULL, AT(density_file), true,
     "density_law = table: file of pressures and densities"},
    {"lubricant", "tait_K0", WITH_UNIT(OVR_PRESSURE, 1e6, 1e12), NULL,
     AT(oil.tait_K0), true,
     "Tait, and Doolittle: bulk modulus at p = 0 and the temperature"},
    {"lubricant", "tait_K0_slope", PLAIN(0.1, 100), NULL, AT(oil.tait_K0_slope),
     true, "Tait, and Doolittle: its slope K0' there, near 11"},
    {"lubricant", "doolittle_B", POSITIVE(1e3), NULL, AT(oil.doolittle_B), true,
     "Doolittle's B"},
    {"lubricant", "doolittle_R0", POSITIVE(1), NULL, AT(oil.doolittle_R0), true,
     "Doolittle: occupied share of the volume at p = 0"},
    {"lubricant", "yasutomi_Tg0", WITH_UNIT(OVR_TEMPERATURE, 50, 800), NULL,
     AT(oil.yasutomi.Tg0), true, "Yasutomi: glass transition at p = 0"},
    {"lubricant", "yasutomi_A1", WITH_UNIT(OVR_KELVINS, 1e-3, 1e4), NULL,
     AT(oil.yasutomi.A1), true, "Yasutomi: A1 of the glass transition"},
    {"lubricant", "yasutomi_A2", WITH_UNIT(OVR_PER_PRESSURE, 1e-13, 1e-5), NULL,
     AT(oil.yasutomi.A2), true, "Yasutomi: A2 of the glass transition"},
    {"lubricant", "yasutomi_b1", WITH_UNIT(OVR_PER_PRESSURE, 0, 1e-5), NULL,
     AT(oil.yasutomi.b1), true, "Yasutomi: b1 of the factor F"},
    {"lubricant", "yasutomi_b2", PLAIN(-10, 0), NULL, AT(oil.yasutomi.b2), true,
     "Yasutomi: b2 of the factor F"},
    {"lubricant", "yasutomi_C1", POSITIVE(100), NULL, AT(oil.yasutomi.C1), true,
     "Yasutomi: C1, 16.04 where the glass viscosity is 1e12 Pa s"},
    {"lubricant", "yasutomi_C2", WITH_UNIT(OVR_KELVINS, 1e-3, 1e4), NULL,
     AT(oil.yasutomi.C2), true, "Yasutomi: C2"},
    {"lubricant", "glass_viscosity", WITH_UNIT(OVR_DYNAMIC_VISCOSITY, 1, 1e15),
     NULL, AT(oil.glass_viscosity), true,
     "Yasutomi: viscosity at the glass transition, where viscosity is not "
     "given"},

    {"lubricant", "S0", PLAIN(0, 10), NULL, AT(heat.S0), true,
     "Roelands: fall of viscosity with temperature, in heat; by the data "
     "sheet's "
     "two viscosities, or 1.1, unless given"},
    {"lubricant", "beta", WITH_UNIT(OVR_PER_KELVIN, 0, 1), NULL, AT(heat.beta),
     true,
     "instead of S0, and for other laws: -d ln eta/dT at p = 0; by the data "
     "sheet's two viscosities unless given"},

    {"heat", "model", CHOICE(heats), "none", AT(heat_model), true,
     "lobatto: temperatures by collocation across the film"},
    {"heat", "points", CHOICE(heat_points), "5", AT(heat.points), true,
     "across the film; 7 as a check"},
    {"heat", "temperature", WITH_UNIT(OVR_TEMPERATURE, 150, 800), NULL,
     AT(heat.temperature), true,
     "of the supplied oil, at which viscosity and alpha are given, and of the "
     "bodies; or temperature in [lubricant]"},
    {"heat", "temperature_1", WITH_UNIT(OVR_TEMPERATURE, 150, 800), NULL,
     AT(heat.bulk[0]), true, "of body 1 far from the contact"},
    {"heat", "temperature_2", WITH_UNIT(OVR_TEMPERATURE, 150, 800), NULL,
     AT(heat.bulk[1]), true, "of body 2 far from the contact"},
    {"heat", "conductivity", WITH_UNIT(OVR_CONDUCTIVITY, 1e-3, 1e3),
     "0.14 W/m.K", AT(heat.oil.conductivity), true, "of the oil"},
    {"heat", "heat_capacity", WITH_UNIT(OVR_HEAT_CAPACITY, 1, 1e30),
     "2000 J/kg.K", AT(heat.oil.heat_capacity), true, "of the oil"},
    {"heat", "density", WITH_UNIT(OVR_MASS_DENSITY, 100, 1e5), "870 kg/m3",
     AT(heat.oil.density), true, "of the oil at p = 0"},
    {"heat", "expansion", WITH_UNIT(OVR_PER_KELVIN, 0, 0.1), "6.5e-4 1/K",
     AT(heat.expansion), true,
     "of the oil by volume at p = 0, less under pressure: heats it where it is "
     "compressed; of an incompressible oil none"},
    {"heat", "density_expansion", FLAG, "yes", AT(heat.density_expands), true,
     "no: density is that at the supply's temperature"},

    {"domain", "inlet", LENGTH_OR(inlets, -1e6, -1.05), "usual",
     AT(options.inlet), true,
     "X of the first node; usual: -4, or farther out where that would cost "
     "more than 0.5 % of the central film; auto: where it costs 1e-4"},
    {"domain", "outlet", LENGTH_OR(auto_nan, 1.05, 1e6), "1.5",
     AT(options.outlet), true, "X of the last node"},
    {"domain", "level", WHOLE_OR(auto_zero, 1, 23), "8", AT(options.level),
     true,
     "finest grid: 7 2^level + 1 nodes; auto: what brings accuracy_of to "
     "accuracy, 14 at most"},
    {"domain", "accuracy", PLAIN(1e-9, 0.5), "1e-3", AT(accuracy), true,
     "with level = auto: relative error of discretization that is wanted"},
    {"domain", "accuracy_of", CHOICE(accuracies), "H_cen", AT(accuracy_of),
     true,
     "with level = auto: of the central film, of the smallest, or of what "
     "the features do to the film"},
    {"domain", "nodes", WHOLE(15, 58720257), NULL, AT(nodes), true,
     "instead of level: 7 2^k + 1"},
    {"domain", "order", CHOICE(orders), "auto", AT(options.order), true,
     "of the steady solution, and of what a run keeps of it: 4 corrects film, "
     "Poiseuille flow and wedge on the finest grid; auto: 4 where it applies"},
    {"domain", "refine", CHOICE(refines), "none", AT(options.refine), true,
     "spike: patches of ever finer mesh about the pressure spike, the first "
     "three to behind the rupture of the film; of steady contacts only"},
    {"domain", "refine_level", WHOLE(7, 22), NULL, AT(options.refine_level),
     true, "of the finest patch; else as many as refine_change takes"},
    {"domain", "refine_change", PLAIN(1e-9, 0.5), "1e-3",
     AT(options.refine_change), true,
     "patches until two levels running change the spike's height by less"},

    {"solver", "cycle", CHOICE(cycles), "V", AT(options.cycle_index), true,
     "multigrid cycle"},
    {"solver", "sweeps_before", WHOLE_OR(auto_zero, 0, 100), "auto",
     AT(options.sweeps_before), true, "relaxations before the coarse grid"},
    {"solver", "sweeps_after", WHOLE_OR(auto_zero, 0, 100), "auto",
     AT(options.sweeps_after), true, "relaxations after the coarse grid"},
    {"solver", "coarsest_level", WHOLE_OR(auto_zero, 1, 7), "auto",
     AT(options.coarsest_level), true, "coarsest grid; the paper's is 1"},
    {"solver", "stop", CHOICE(stops), "negligible", AT(options.stop), true,
     "when a steady solve is done: algebraic error negligible, a fraction of "
     "the discretization error, or a fixed number of cycles"},
    {"solver", "max_cycles", WHOLE_OR(auto_zero, 1, 100000), "auto",
     AT(options.max_cycles), true, "steady: most cycles on each level"},
    {"solver", "tolerance", PLAIN_OR(auto_zero, 1e-16, 0.1), "auto",
     AT(options.tolerance), true, "on the relative mass-flow imbalance"},

    {"time", "end", SPAN(auto_end, 1e5), NULL, AT(end), false,
     "end of the run, which starts at 0; auto: when all features have left, "
     "load and speed do not change any more and the film is steady again; "
     "without an end the case is steady"},
    {"time", "step", SPAN(steps, 1e3), "grid", AT(step), true,
     "time step; grid: the mesh size; adaptive: by the scheme's own error"},
    {"time", "scheme", CHOICE(schemes), "auto", AT(scheme), true,
     "discretization in X and T: upstream1 with backward Euler, upstream2 "
     "with BDF2, or narrow second order along the characteristic; auto: "
     "characteristic in runs with step = grid at constant load and speed, "
     "upstream2 else"},
    {"time", "error", PLAIN(1e-9, 0.1), "1e-3", AT(error), true,
     "adaptive: relative error that the steps add to the film on its way "
     "through the contact"},
    {"time", "until_steady", FLAG, "no", AT(until_steady), false,
     "stop when nothing changes any more"},

    HISTORY("load", AT(load), "1", 0, 100, 1),
    HISTORY("speed", AT(speed), "1", -100, 100, 100),
    {"speed", "mean", PLAIN(-100, 100), "1", IN_CHANGE(AT(speed), mean), true,
     "sine: what it swings about; 0: it goes to and fro"},
    HISTORY("sliding", AT(sliding), NULL, -1e3, 1e3, 1e3),
    HISTORY("radius", AT(radius), "1", 0.01, 100, 0.99),
    {"radius", "curvature", CHOICE(curvatures), "auto", AT(curvature), true,
     "imposed, or rides with the material that comes by, as on gear teeth and "
     "cams; auto: rides where the surfaces move fast enough for it"},
    HISTORY("radius_1", AT(radius_1), "1", -1e3, 1e3, 1e3),

    {"cavitation", "model", CHOICE(cavitations), "reynolds",
     AT(options.cavitation), true,
     "reynolds: a gap without pressure counts as full; conserving: it holds "
     "the oil that came, with upstream2 or upstream1 and order 2"},

    {"supply", "model", CHOICE(supplies), "flooded", AT(supply_model), true,
     "flooded, or the film that arrives on the surfaces; needs model = "
     "conserving"},
    {"supply", "thickness_1", HEIGHT, "0", AT(thickness[0]), true,
     "film on surface 1 as it arrives"},
    {"supply", "thickness_2", HEIGHT, "0", AT(thickness[1]), true,
     "film on surface 2 as it arrives"},
    {"supply", "profile_1", PATH, NULL, AT(layer_file[0]), true,
     "file of thickness along surface 1, whose largest x arrives at T = 0, "
     "instead of thickness_1"},
    {"supply", "profile_2", PATH, NULL, AT(layer_file[1]), true,
     "the same of surface 2"},
    {"supply", "waiting", AREA_OR(endless_oil, 1e9), "0.1", AT(waiting), true,
     "oil that waits before the inlet at the start, where the contact is "
     "flooded then"},
    HISTORY("supply", AT(supply), "1", 0, 100, 1),

    {"passes", "number", WHOLE(1, 100000), "1", AT(passes.number), false,
     "how often the surfaces pass, each time with the oil that lies on them "
     "since; needs [cavitation] model = conserving"},
    {"passes", "split", PLAIN(0, 1), "0.5", AT(passes.split), true,
     "share of the thickness leaving that stays on surface 1"},
    {"passes", "loss", PLAIN(0, 1), "0", AT(passes.loss), true,
     "share of each layer that is lost between two passes"},
    {"passes", "side_flow", POSITIVE(100), NULL, AT(passes.side_flow), true,
     "instead of loss: exponent g of x/(1 + x^g)^(1/g), x the layer over the "
     "one that a flooded contact leaves; some 2 to 5 for point contacts"},
    {"passes", "replenish", HEIGHT, "0", AT(passes.replenish), true,
     "thickness that comes to each surface between two passes"},
    {"passes", "spacing", LENGTH(1e-3, 1e9), NULL, AT(passes.spacing), true,
     "from one rolling body to the next, along the surfaces"},
    {"passes", "recovery", OVR_NUMBER, OVR_DURATION, OVR_IN_TIME, 1e-6, 1e12,
     false, NULL, NULL, AT(passes.recovery), true,
     "time in which a layer regains 1 - 1/e of what lacks to that of a flooded "
     "contact; needs spacing"},
    {"passes", "again", CHOICE(agains), "both", AT(passes.again), true,
     "surfaces that come back with their layers; the other is each time "
     "another body of its kind, with the even layer of before the features"},
    {"passes", "loads", OVR_NUMBERS, OVR_PURE, OVR_NOT_HERTZIAN, 1e-3, 1e3,
     false, NULL, NULL, AT(passes.loads), true,
     "load of each pass over that of [contact], as many as passes: a load "
     "zone"},

    {"feature", "surface", WHOLE(1, 2), "1", IN_FORM(surface), true,
     "surface it is on: 1 moves at u1, 2 at u2"},
    {"feature", "shape", CHOICE(shapes), NULL, IN_FORM(shape), true,
     "what it is"},
    {"feature", "start", LENGTH_OR(at_inlet, -1e6, 1e6), NULL, IN_FORM(start),
     true,
     "X of its centre at T = 0 (of a step its edge, of a profile or "
     "roughness its leading end); inlet, as without any place: just ahead of "
     "the film, to come in at once"},
    {"feature", "centre", LENGTH(-1e6, 1e6), NULL, IN_FORM(centre), true,
     "X of its centre at T = 0, profiles included"},
    {"feature", "edge", LENGTH(-1e6, 1e6), NULL, IN_FORM(edge), true,
     "X of its leading end at T = 0"},
    {"feature", "arrival", TIME(-1e6, 1e6), NULL, IN_FORM(arrival), true,
     "T at which its centre is at X = 0"},
    {"feature", "origin", LENGTH(-1e6, 1e6), NULL, IN_FORM(origin), true,
     "wave, texture: X of a crest (dimple) at T = 0"},
    {"feature", "depth", HEIGHT, NULL, IN_FORM(depth), true,
     "dent, indent, ridge, step, groove, texture: depth, a positive number"},
    {"feature", "height", HEIGHT, NULL, IN_FORM(height), true,
     "bump, ridge, step, groove, texture: height"},
    {"feature", "amplitude", HEIGHT, NULL, IN_FORM(amplitude), true,
     "wave, chirp: amplitude"},
    {"feature", "width", SIZE, NULL, IN_FORM(width), true,
     "dent, bump, indent, ridge, groove, texture: width in the shape's "
     "formula"},
    {"feature", "diameter", SIZE, NULL, IN_FORM(diameter), true,
     "instead of width: full width at half depth"},
    {"feature", "half_width", SIZE, NULL, IN_FORM(half_width), true,
     "instead of width: half the width at half depth"},
    {"feature", "rim_diameter", SIZE, NULL, IN_FORM(rim_diameter), true,
     "indent, instead of width and shoulders: diameter of its rim, crest to "
     "crest; the bowl is a ball's or a hard particle's"},
    {"feature", "rim_height", HEIGHT, NULL, IN_FORM(rim_height), true,
     "indent: height of that rim; unless given 0.159 of the depth, as in "
     "hardened steel"},
    {"feature", "wavelength", SIZE, NULL, IN_FORM(wavelength), true,
     "wave; chirp: at its rear; texture: distance of two dimples"},
    {"feature", "wavelength_end", SIZE, NULL, IN_FORM(wavelength_end), true,
     "chirp: at its leading end"},
    {"feature", "length", SIZE, NULL, IN_FORM(length), true,
     "chirp, step, roughness: length along x"},
    {"feature", "shoulder", HEIGHT, NULL, IN_FORM(shoulder), true,
     "indent: height of its shoulders"},
    {"feature", "shoulder_at", SIZE, NULL, IN_FORM(shoulder_at), true,
     "indent: distance of the shoulders from its centre"},
    {"feature", "shoulder_width", SIZE, NULL, IN_FORM(shoulder_width), true,
     "indent: width of the shoulders"},
    {"feature", "flank", SIZE, NULL, IN_FORM(flank), true,
     "step, groove: width of the flank; chirp: of the fades at its ends"},
    {"feature", "radius", SIZE, NULL, IN_FORM(radius), true,
     "step, groove: radius of the edges, instead of flank"},
    {"feature", "grow", TIME(0, 1e6), NULL, IN_FORM(grow), true,
     "grows in place over this time (quintic smoothstep)"},
    {"feature", "grow_from", TIME(-1e6, 1e6), "0", IN_FORM(grow_from), true,
     "when it begins to grow"},
    {"feature", "repeat", SIZE, NULL, IN_FORM(repeat), true,
     "copies follow at this distance"},
    {"feature", "copies", WHOLE_OR(endless, 1, 1000000), "endless",
     IN_FORM(copies), true, "how many there are with repeat"},
    {"feature", "file", PATH, NULL, IN_FEATURE(source.file), true,
     "profile: file of heights"},
    {"feature", "unit_x", TEXT, NULL, IN_FEATURE(source.unit_x), true,
     "profile: unit of its lengths where the file does not say it"},
    {"feature", "unit_z", TEXT, NULL, IN_FEATURE(source.unit_z), true,
     "profile: unit of its heights where the file does not say it"},
    {"feature", "spacing", SIZE, NULL, IN_FEATURE(source.spacing), true,
     "profile: distance of samples where the file has heights only"},
    {"feature", "column_x", WHOLE(1, 1000), NULL, IN_FEATURE(source.column_x),
     true, "profile: column of the lengths"},
    {"feature", "column_z", WHOLE(1, 1000), NULL, IN_FEATURE(source.column_z),
     true, "profile: column of the heights"},
    {"feature", "line", WHOLE(1, 10000000), NULL, IN_FEATURE(source.line), true,
     "profile: line of an areal file"},
    {"feature", "from", LENGTH(-1e6, 1e6), NULL, IN_FEATURE(conditioning.from),
     true, "profile: start of the part used, in its own x"},
    {"feature", "to", LENGTH(-1e6, 1e6), NULL, IN_FEATURE(conditioning.to),
     true, "profile: end of the part used"},
    {"feature", "scale", PLAIN(0, 1e6), "1", IN_FEATURE(conditioning.scale),
     true, "profile: heights times this"},
    {"feature", "invert", FLAG, "no", IN_FEATURE(conditioning.invert), true,
     "profile: peaks become valleys"},
    {"feature", "stretch", POSITIVE(1e6), "1", IN_FEATURE(conditioning.stretch),
     true, "profile: lengths times this"},
    {"feature", "reverse", FLAG, "no", IN_FEATURE(conditioning.reverse), true,
     "profile: its x runs the other way"},
    {"feature", "max_gap", SIZE, NULL, IN_FEATURE(conditioning.max_gap), true,
     "profile: longest gap to fill; else 5 % of its length"},
    {"feature", "max_missing", PLAIN(0, 0.95), "0.2",
     IN_FEATURE(conditioning.max_missing), true,
     "profile: largest missing fraction"},
    {"feature", "outliers", PLAIN(1, 1e3), NULL,
     IN_FEATURE(conditioning.outliers), true,
     "profile: replace points so many robust deviations from their "
     "neighbours"},
    {"feature", "level", CHOICE(levellings), "line",
     IN_FEATURE(conditioning.level), true,
     "profile: what is taken off it; ends: the line through its outer tenths"},
    {"feature", "degree", WHOLE(0, 12), "2", IN_FEATURE(conditioning.degree),
     true, "profile: degree of the polynomial"},
    {"feature", "lambda_c", SIZE, NULL, IN_FEATURE(conditioning.lambda_c), true,
     "profile: Gaussian cut-off above which waves are taken out"},
    {"feature", "lambda_s", SIZE, NULL, IN_FEATURE(conditioning.lambda_s), true,
     "profile: Gaussian cut-off below which waves are taken out"},
    {"feature", "offset", SHIFT, "0", IN_FEATURE(conditioning.offset), true,
     "profile: added to its heights"},
    {"feature", "taper", LENGTH(0, 1e4), NULL, IN_FEATURE(conditioning.taper),
     true,
     "profile: blended into the smooth surface over this; else 5 % of "
     "its length"},
    {"feature", "extend", CHOICE(extensions), "none",
     IN_FEATURE(conditioning.extend), true, "profile: beyond its ends"},
    {"feature", "Rq", HEIGHT, NULL, IN_FEATURE(roughness.Rq), true,
     "roughness: root mean square height"},
    {"feature", "spectrum", CHOICE(spectra), "self-affine",
     IN_FEATURE(roughness.spectrum), true, "roughness: its spectrum"},
    {"feature", "hurst", PLAIN(0, 1), "0.8", IN_FEATURE(roughness.hurst), true,
     "roughness: Hurst exponent"},
    {"feature", "rolloff", SIZE, NULL, IN_FEATURE(roughness.rolloff), true,
     "roughness: wavelength above which the spectrum is flat"},
    {"feature", "shortest", SIZE, NULL, IN_FEATURE(roughness.shortest), true,
     "roughness: shortest wavelength"},
    {"feature", "correlation", SIZE, NULL, IN_FEATURE(roughness.correlation),
     true, "roughness: correlation length"},
    {"feature", "skewness", PLAIN(-10, 10), NULL,
     IN_FEATURE(roughness.skewness), true,
     "roughness: skewness of the heights"},
    {"feature", "kurtosis", PLAIN(1, 100), NULL, IN_FEATURE(roughness.kurtosis),
     true, "roughness: kurtosis of the heights (3: Gaussian)"},
    {"feature", "seed", WHOLE(0, 2147483647), "1", IN_FEATURE(roughness.seed),
     true, "roughness: another seed is another surface"},

    {"output", "file", PATH, NULL, AT(output.file), false, "result file"},
    {"output", "title", TEXT, NULL, AT(output.title), false,
     "title in the result file and pictures"},
    {"output", "every", WHOLE(1, 1000000000), NULL, AT(every), false,
     "store every so many steps"},
    {"output", "interval", SPAN(NULL, 1e6), NULL, AT(output.interval), false,
     "store in steps of this time"},
    {"output", "at", OVR_NUMBERS, OVR_DURATION, OVR_IN_TIME, 0, 1e6, false,
     NULL, NULL, AT(output.at), false, "store at these times"},
    {"output", "feature_at", OVR_NUMBERS, OVR_LENGTH, OVR_IN_B, -1e6, 1e6,
     false, NULL, NULL, AT(output.feature_at), false,
     "store when a feature's centre is at these X"},
    {"output", "fields", WORDS(fields), "pressure, film_thickness, roughness",
     AT(output.fields), false, "what a snapshot holds"},
    {"output", "precision", CHOICE(precisions), "f64", AT(precision), false,
     "of the stored numbers"},
    {"output", "from", LENGTH(-1e6, 1e6), NULL, AT(output.from), false,
     "X of the first stored node"},
    {"output", "to", LENGTH(-1e6, 1e6), NULL, AT(output.to), false,
     "X of the last stored node"},
    {"output", "stride", WHOLE(1, 1000000), "1", AT(output.stride), false,
     "store every so many nodes"},
    {"output", "compression", WHOLE(0, 9), "1", AT(output.compression), false,
     "0: none, 9: most"},
    {"output", "checkpoint", WITH_UNIT(OVR_DURATION, 0, 1e7), "30 s",
     AT(output.checkpoint), false,
     "wall-clock time between restart files; 0 s: at the end only"},

    {"paper", "smoother", CHOICE(smoothers), "line", AT(options.smoother), true,
     "line: distributive line relaxation; hybrid: the paper's, for steady "
     "solutions"},
    {"paper", "switch", PLAIN(1e-9, 1e9), "3", AT(options.switch_value), true,
     "hybrid: eps/D^2 above which Gauss-Seidel is used"},
    {"paper", "relax_seidel", PLAIN(0.5, 1), "0.8", AT(options.relax_seidel),
     true, "hybrid: under-relaxation, Gauss-Seidel"},
    {"paper", "relax_dipole", PLAIN(0.3, 0.6), "0.5", AT(options.relax_dipole),
     true, "hybrid: under-relaxation, dipole"},
    {"paper", "paper_balance", FLAG, "no", AT(options.paper_balance), true,
     "force balance by the paper's relaxation of H0 on the coarsest grid "
     "instead of dense Newton steps"},
    {"paper", "cycles", WHOLE(1, 1000), "2", AT(options.cycles), true,
     "with stop = fixed: cycles on each level"},
    {"paper", "mlmi_order", WHOLE_OR(auto_zero, 4, 12), "auto",
     AT(options.mlmi_order), true,
     "order of the transfers in the deformation integrals, even"},
    {"paper", "mlmi_range", WHOLE_OR(auto_zero, 2, 24), "auto",
     AT(options.mlmi_range), true,
     "corrections within so many meshes of the singularity"},

    {"stress", "surface", CHOICE(which_surface), NULL, AT(stress_surface), true,
     "below which surface; 1 where the section is there and says nothing"},
    {"stress", "depth_min", LENGTH_OR(auto_zero, 1e-9, 1e3), "auto",
     AT(stress.depth_min), true,
     "least depth of the history of the material; auto: 4 meshes"},
    {"stress", "depth_max", LENGTH(1e-6, 1e3), "2.5", AT(stress.depth_max),
     true, "largest depth"},
    {"stress", "depths_per_octave", PLAIN(1, 100), "5", AT(stress.per_octave),
     true, "depths, geometric"},
    {"stress", "every", WHOLE(0, 1000000000), "0", AT(stress_every), true,
     "store stress fields at every so many snapshots; 0: none"},
    {"stress", "fields", WORDS(stress_fields), "sigma_x, sigma_z, tau_xz",
     AT(stress.fields), true, "stress fields to store"},
    {"stress", "window", OVR_NUMBERS, OVR_LENGTH, OVR_IN_B, -1e6, 1e6, false,
     feature_window, "feature", AT(window), true,
     "material whose history is kept, FROM, TO about the first feature's "
     "centre; feature: 2 b beyond the features of the surface"},
    {"stress", "traction", CHOICE(tractions), "auto", AT(stress_traction), true,
     "the film's shear stress as a load on the surface beside the pressure; "
     "auto: with a flow law or limiting_shear, where b/R is known"},

    {"fatigue", "criterion", CHOICE(criteria), "circle", AT(criterion), false,
     "amplitude that does harm: radius of the smallest circle round the path "
     "of the shear stress, half range of the orthogonal shear stress, that on "
     "the worst plane, Dang Van's with one line, or static maxima"},
    {"fatigue", "alpha", PLAIN(0, 1), "0.3", AT(stress.alpha), false,
     "of the hydrostatic stress; circle: in tension only"},
    {"fatigue", "limit_pressure", STRESS(no_limit, 0, 1e3), "1.5 GPa",
     AT(stress.limit_pressure), false,
     "Hertz pressure of a smooth contact below which amplitudes do no harm"},
    {"fatigue", "exponent", PLAIN_OR(risk_exponents, 1, 100), "31/3",
     AT(life.exponent), false, "c of the amplitude in the risk"},
    {"fatigue", "depth_exponent", PLAIN_OR(depth_exponents, 0, 10), "7/3",
     AT(life.depth_exponent), false, "h of the depth in the risk"},
    {"fatigue", "weibull", PLAIN_OR(weibull_slopes, 0.1, 10), "9/8",
     AT(life.weibull), false, "e, Weibull slope"},
    {"fatigue", "least_depth", LENGTH_OR(auto_zero, 1e-9, 1e3), "auto",
     AT(life.least_depth), true,
     "from which risk and largest values are counted; auto: 8 meshes"},
    {"fatigue", "raceway", OVR_NUMBER, OVR_LENGTH, OVR_IN_B, 0, 1e9, false,
     NULL, "0", AT(stress.raceway), false,
     "length of the raceway, for a ratio of lives; 0: none is given"},
    {"fatigue", "count", PLAIN(0, 1e9), "1", AT(stress.count), false,
     "how often the features are on that raceway"},
    {"fatigue", "residual_x", STRESS(NULL, -10, 10), "0", AT(stress.residual_x),
     true, "residual stress along the surface, tension positive"},
    {"fatigue", "residual_y", STRESS(NULL, -10, 10), "0", AT(stress.residual_y),
     true, "residual stress across"},

    {"body", "material", CHOICE(materials), NULL,
     offsetof(ovr_body_form, material), true,
     "gives modulus and Poisson's ratio; those that are given count"},
    {"body", "modulus", WITH_UNIT(OVR_PRESSURE, 1e3, 1e13), NULL,
     offsetof(ovr_body_form, modulus), true,
     "Young's modulus E; both bodies' give the reduced one"},
    {"body", "poisson", PLAIN(0, 0.5), "0.3", offsetof(ovr_body_form, poisson),
     true, "Poisson's ratio; 0.3 where no material says otherwise"},
    {"body", "conductivity", WITH_UNIT(OVR_CONDUCTIVITY, 1e-3, 1e4), NULL,
     offsetof(ovr_body_form, thermal.conductivity), true,
     "with heat; of its material, else of steel"},
    {"body", "heat_capacity", WITH_UNIT(OVR_HEAT_CAPACITY, 1, 1e30), NULL,
     offsetof(ovr_body_form, thermal.heat_capacity), true,
     "with heat; of its material, else of steel"},
    {"body", "density", WITH_UNIT(OVR_MASS_DENSITY, 100, 1e5), NULL,
     offsetof(ovr_body_form, thermal.density), true,
     "with heat; of its material, else of steel"},
    {"body", "radius", OVR_NUMBER, OVR_LENGTH, OVR_NOT_HERTZIAN, -1e4, 1e4,
     false, flat, NULL, offsetof(ovr_body_form, radius), true,
     "radius at the contact, negative where it is concave, or flat; both "
     "bodies' give the reduced one"},
};
enum { ROWS = sizeof table / sizeof table[0] };

/* --------------------------------------------------------------- sections */

static const ovr_section sections[] = {
    {"contact", false,
     "the operating conditions: M and L; or lambda and alphabar; or load (or "
     "hertz_pressure), radius, modulus, viscosity, alpha and speeds"},
    {"lubricant", false,
     "how viscosity and density depend on pressure; what the laws need"},
    {"heat", false, "temperatures of film and surfaces"},
    {"domain", false, "the part of the film that is computed, and its grid"},
    {"solver", false, "multigrid; the defaults do for nearly every case"},
    {"time", false, "the run in time, and the scheme (of steady cases too)"},
    {"load", false, "load against time, relative to that of [contact]"},
    {"speed", false, "mean speed against time, relative to that of [contact]"},
    {"sliding", false,
     "(u1 - u2)/um against time, over the nominal um, any sign; from and to "
     "are "
     "slide_to_roll unless given"},
    {"radius", false,
     "reduced radius against time, relative to that of [contact], which stays "
     "the scale"},
    {"radius_1", false,
     "radius of surface 1 against time, relative to the reduced one of "
     "[contact], negative: concave; the rest of the curvature is surface 2's; "
     "without it all of it moves at the mean speed"},
    {"cavitation", false, "what becomes of the film behind its rupture"},
    {"supply", false,
     "the oil that arrives; its history is relative to the thicknesses"},
    {"passes", false,
     "several passes: the layers that leave feed the next one where they lie"},
    {"feature", true,
     "[feature NAME], any number: what is on the smooth surfaces"},
    {"output", false, "what is stored, where and when"},
    {"paper", false,
     "the algorithm of Venner, ten Napel & Bosma (1990), for their tables; "
     "[solver] may hold these keys too, as it once did"},
    {"stress", false,
     "stresses below a surface; without this section there are none"},
    {"fatigue", false, "what they do to the material; needs [stress]"},
    {"body", true,
     "[body 1], [body 2]: the bodies, for what [contact] does not say"},
};
enum { SECTIONS = sizeof sections / sizeof sections[0] };

const ovr_parameter *ovr_parameter_row(size_t k)
{
    return k < ROWS ? &table[k] : NULL;
}

const ovr_section *ovr_section_row(size_t k)
{
    return k < SECTIONS ? &sections[k] : NULL;
}

const ovr_section *ovr_section_find(const char *name)
{
    for (size_t k = 0; k < SECTIONS; k++)
        if (!strcmp(sections[k].name, name))
            return &sections[k];
    return NULL;
}

size_t ovr_section_first(const ovr_section *section)
{
    size_t k = 0;
    while (k < ROWS && strcmp(table[k].section, section->name) != 0)
        k++;
    return k;
}

size_t ovr_section_size(const ovr_section *section)
{
    size_t n = 0;
    for (size_t k = 0; k < ROWS; k++)
        n += !strcmp(table[k].section, section->name);
    return n;
}

/* Sections, and where keys that they once had are now. */
static const struct {
    const char *before, *now;
} moved[] = {{"solver", "paper"}};

const ovr_section *ovr_section_now(const ovr_section *before, const char *key)
{
    for (size_t k = 0; k < sizeof moved / sizeof *moved; k++) {
        const ovr_section *now = ovr_section_find(moved[k].now);
        if (now && !strcmp(before->name, moved[k].before) &&
            !ovr_parameter_find(before, key) && ovr_parameter_find(now, key))
            return now;
    }
    return before;
}

const ovr_parameter *ovr_parameter_find(const ovr_section *section,
                                        const char *key)
{
    for (size_t k = 0; k < ROWS; k++)
        if (!strcmp(table[k].section, section->name) &&
            !strcmp(table[k].key, key))
            return &table[k];
    return NULL;
}

/* ------------------------------------------------------------- for people */

size_t ovr_parameter_count(void)
{
    return ROWS;
}

const char *ovr_section_name(size_t k)
{
    return k < SECTIONS ? sections[k].name : NULL;
}

bool ovr_section_named(size_t k)
{
    return k < SECTIONS && sections[k].named;
}

const char *ovr_section_help(size_t k)
{
    return k < SECTIONS ? sections[k].help : NULL;
}

static const char *type_name(ovr_kind kind)
{
    switch (kind) {
    case OVR_NUMBER: return "number";
    case OVR_INTEGER: return "whole number";
    case OVR_CHOICE: return "choice";
    case OVR_FLAG: return "yes or no";
    case OVR_TEXT: return "text";
    case OVR_PATH: return "path";
    case OVR_NUMBERS: return "numbers";
    case OVR_WORDS: return "words";
    }
    return "";
}

const char *ovr_hertzian_name(ovr_hertzian hertzian)
{
    switch (hertzian) {
    case OVR_NOT_HERTZIAN: break;
    case OVR_IN_B: return "b";
    case OVR_IN_HEIGHT: return "b^2/R";
    case OVR_IN_TIME: return "b/um";
    case OVR_IN_PRESSURE: return "ph";
    case OVR_IN_AREA: return "b^3/R";
    }
    return "";
}

void ovr_parameter_into(size_t k, ovr_parameter_info *to)
{
    const ovr_parameter *row = &table[k < ROWS ? k : 0];
    ovr_parameter_info info = {
        .section = row->section,
        .key = row->key,
        .type = type_name(row->kind),
        .units = ovr_units_allowed(row->dimension),
        .bare = ovr_hertzian_name(row->hertzian),
        .initial = row->initial,
        .least = row->least,
        .most = row->most,
        .above = row->above,
        .physics = row->physics,
        .help = row->help,
    };
    for (size_t i = 0; row->words && row->words[i].name && i < 23; i++)
        info.choices[i] = row->words[i].name;
    ovr_sized_give(to, &info, sizeof info);
}
