/* SPDX-License-Identifier: GPL-3.0-or-later */
/* [feature NAME]. */
#include "case/keys/keys.h"

#include <math.h>

static const ovr_word shapes[] = {{"dent", OVR_DENT},
                                  {"bump", OVR_BUMP},
                                  {"indent", OVR_INDENT},
                                  {"ridge", OVR_RIDGE},
                                  {"step", OVR_STEP},
                                  {"groove", OVR_GROOVE},
                                  {"wave", OVR_WAVE},
                                  {"chirp", OVR_CHIRP},
                                  {"texture", OVR_TEXTURE},
                                  {"profile", OVR_PROFILE},
                                  {"roughness", OVR_ROUGHNESS},
                                  {"areal", OVR_AREAL},
                                  {NULL, 0}};
static const ovr_word at_inlet[] = {{"inlet", -INFINITY}, {NULL, 0}};
static const ovr_word endless[] = {{"endless", 0}, {NULL, 0}};
static const ovr_word footprints[] = {
    {"round", 0}, {"endless", INFINITY}, {NULL, 0}};
static const ovr_word levellings[] = {{"none", OVR_LEVEL_NONE},
                                      {"mean", OVR_LEVEL_MEAN},
                                      {"line", OVR_LEVEL_LINE},
                                      {"plane", OVR_LEVEL_LINE},
                                      {"polynomial", OVR_LEVEL_POLYNOMIAL},
                                      {"ends", OVR_LEVEL_ENDS},
                                      {"circle", OVR_LEVEL_CIRCLE},
                                      {"auto", OVR_LEVEL_AUTO},
                                      {NULL, 0}};
static const ovr_word extensions[] = {{"none", OVR_EXTEND_NONE},
                                      {"periodic", OVR_EXTEND_PERIODIC},
                                      {"mirror", OVR_EXTEND_MIRROR},
                                      {NULL, 0}};
static const ovr_word spectra[] = {{"self-affine", OVR_SELF_AFFINE},
                                   {"exponential", OVR_EXPONENTIAL},
                                   {NULL, 0}};

/* A right angle, in radians. */
#define QUARTER 1.57079632679489661923

#define IN_FORM(field) offsetof(ovr_feature_settings, form.field)
#define IN_FEATURE(field) offsetof(ovr_feature_settings, field)

static const ovr_parameter feature_keys[] = {
    {"surface", WHOLE(1, 2), "1", IN_FORM(surface), true, ALWAYS,
     "surface of the feature: 1 moves at u1, 2 at u2"},
    {"shape", CHOICE(shapes), NULL, IN_FORM(shape), true, ALWAYS,
     "shape of the feature"},
    {"start", LENGTH_OR(at_inlet, -1e6, 1e6), NULL, IN_FORM(start), true,
     ALWAYS,
     "X of the centre at T = 0 (of a step its edge, of a profile or roughness "
     "its leading end); inlet (also the default): just upstream of the film, "
     "so that the feature enters at once"},
    {"centre", LENGTH(-1e6, 1e6), NULL, IN_FORM(centre), true, ALWAYS,
     "X of the centre at T = 0, also for profiles"},
    {"edge", LENGTH(-1e6, 1e6), NULL, IN_FORM(edge), true, ALWAYS,
     "X of the leading end at T = 0"},
    {"arrival", TIME(-1e6, 1e6), NULL, IN_FORM(arrival), true, ALWAYS,
     "T at which the centre is at X = 0"},
    {"origin", LENGTH(-1e6, 1e6), NULL, IN_FORM(origin), true,
     "shape = wave | texture or extend = periodic | mirror",
     "wave, texture: X of a crest (dimple) at T = 0"},
#define AS_HEIGHT(name, help)                                                  \
    {#name, HEIGHT, NULL, IN_FORM(name), true, OVR_BY_SHAPE, help},
#define AS_LENGTH(name, help)                                                  \
    {#name, SIZE, NULL, IN_FORM(name), true, OVR_BY_SHAPE, help},
    OVR_FEATURE_SIZES(AS_HEIGHT, AS_LENGTH){"across", LENGTH(-1e3, 1e3), "0",
                                            IN_FORM(across), true, "[strip]",
                                            "Y of the centre"},
    {"width_across", LENGTH_OR(footprints, 1e-6, 1e3), NULL,
     IN_FORM(width_across), true, "[strip]",
     "extent across rolling, measured like the width along x: a length, "
     "round, or endless (the same for all y)"},
    {"length_across", SIZE, NULL, IN_FORM(length_across), true, "[strip]",
     "length of a ridge, groove or step across rolling, tapered at both ends; "
     "default: endless"},
    {"angle", WITH_UNIT(OVR_ANGLE, -QUARTER, QUARTER), "0 deg", IN_FORM(angle),
     true, "[strip]",
     "angle of the length, of the crests of a wave or of the lay of "
     "roughness from the y axis towards +x; 90 deg: along rolling"},
    {"wavelength_across", SIZE, NULL, IN_FORM(wavelength_across), true,
     "[strip]",
     "length of a second wave that crosses the first; distance of dimples of "
     "a texture across rolling"},
    {"stagger", PLAIN(0, 1), "0", IN_FORM(stagger), true,
     "[strip]; shape = texture",
     "every second row of dimples is shifted by this share of "
     "wavelength_across"},
    {"grow", TIME(0, 1e6), NULL, IN_FORM(grow), true, ALWAYS,
     "time over which the feature grows in place (quintic smoothstep)"},
    {"grow_from", TIME(-1e6, 1e6), "0", IN_FORM(grow_from), true, "grow",
     "start of the growth"},
    {"repeat", SIZE, NULL, IN_FORM(repeat), true, ALWAYS,
     "distance of copies of the feature"},
    {"copies", WHOLE_OR(endless, 1, 1000000), "endless", IN_FORM(copies), true,
     "repeat", "number of copies with repeat"},
    {"file", PATH, NULL, IN_FEATURE(source.file), true,
     "shape = profile | areal", "file of heights"},
    {"unit_x", TEXT, NULL, IN_FEATURE(source.unit_x), true,
     "shape = profile | areal",
     "unit of the lengths if the file does not specify it"},
    {"unit_z", TEXT, NULL, IN_FEATURE(source.unit_z), true,
     "shape = profile | areal",
     "unit of the heights if the file does not specify it"},
    {"spacing", SIZE, NULL, IN_FEATURE(source.spacing), true,
     "shape = profile | areal", "spacing of the heights if the file has no x"},
    {"spacing_across", SIZE, NULL, IN_FEATURE(source.spacing_across), true,
     "shape = profile | areal; spacing",
     "distance of the rows of a map if it is not the spacing"},
    {"column_x", WHOLE(1, 1000), NULL, IN_FEATURE(source.column_x), true,
     "shape = profile", "column of the lengths"},
    {"column_z", WHOLE(1, 1000), NULL, IN_FEATURE(source.column_z), true,
     "shape = profile", "column of the heights"},
    {"row", WHOLE(1, 10000000), NULL, IN_FEATURE(source.row), true,
     "shape = profile",
     "row of an areal file, from 1; default: middle line across the lay"},
    {"column", WHOLE(1, 10000000), NULL, IN_FEATURE(source.column), true,
     "shape = profile", "column of an areal file, from 1"},
    {"y", LENGTH(0, 1e9), NULL, IN_FEATURE(source.y), true, "shape = profile",
     "row of an areal file nearest to this y"},
    {"direction", PLAIN(-180, 180), NULL, IN_FEATURE(source.direction), true,
     "shape = profile",
     "line through the centre of an areal file at this angle to its x axis, "
     "degrees"},
    {"band", SIZE, NULL, IN_FEATURE(source.band), true, "shape = profile",
     "width of the band of an areal file over which heights are averaged"},
    {"from", LENGTH(-1e6, 1e6), NULL, IN_FEATURE(conditioning.from), true,
     "shape = profile | areal", "start of the used range of x"},
    {"to", LENGTH(-1e6, 1e6), NULL, IN_FEATURE(conditioning.to), true,
     "shape = profile | areal", "end of the used range of x"},
    {"scale", PLAIN(0, 1e6), "1", IN_FEATURE(conditioning.scale), true,
     "shape = profile | areal", "factor of the heights"},
    {"invert", FLAG, "no", IN_FEATURE(conditioning.invert), true,
     "shape = profile | areal", "change the sign of the heights"},
    {"stretch", POSITIVE(1e6), "1", IN_FEATURE(conditioning.stretch), true,
     "shape = profile | areal", "lengths times this"},
    {"reverse", FLAG, "no", IN_FEATURE(conditioning.reverse), true,
     "shape = profile | areal", "reverse x"},
    {"max_gap", SIZE, NULL, IN_FEATURE(conditioning.max_gap), true,
     "shape = profile", "longest gap to fill; default: 5 % of the length"},
    {"max_missing", PLAIN(0, 0.95), "0.2", IN_FEATURE(conditioning.max_missing),
     true, "shape = profile | areal", "largest missing fraction"},
    {"outliers", PLAIN(1, 1e3), NULL, IN_FEATURE(conditioning.outliers), true,
     "shape = profile | areal",
     "replace points that deviate from their neighbours by more than this "
     "number of robust standard deviations"},
    {"level", CHOICE(levellings), "line", IN_FEATURE(conditioning.level), true,
     "shape = profile | areal",
     "form to be removed; ends: the line through the outer tenths of the "
     "profile"},
    {"degree", WHOLE(0, 12), "2", IN_FEATURE(conditioning.degree), true,
     "shape = profile | areal; level = polynomial", "degree of the polynomial"},
    {"lambda_c", SIZE, NULL, IN_FEATURE(conditioning.lambda_c), true,
     "shape = profile | areal",
     "Gaussian cut-off wavelength above which waves are removed"},
    {"lambda_s", SIZE, NULL, IN_FEATURE(conditioning.lambda_s), true,
     "shape = profile | areal",
     "Gaussian cut-off wavelength below which waves are removed"},
    {"offset", SHIFT, "0", IN_FEATURE(conditioning.offset), true,
     "shape = profile | areal", "offset added to the heights"},
    {"taper", LENGTH(0, 1e4), NULL, IN_FEATURE(conditioning.taper), true,
     "shape = profile | areal | roughness",
     "length over which the profile is tapered to zero; default: 5 % of its "
     "length"},
    {"extend", CHOICE(extensions), "none", IN_FEATURE(conditioning.extend),
     true, "shape = profile | areal | roughness",
     "continuation of the profile beyond its ends"},
    {"turn", FLAG, "no", IN_FEATURE(conditioning.turn), true, "shape = areal",
     "the map is turned: its y runs along rolling"},
    {"from_across", LENGTH(-1e6, 1e6), NULL,
     IN_FEATURE(conditioning.from_across), true, "shape = areal",
     "start of the used range across rolling, from the first row"},
    {"to_across", LENGTH(-1e6, 1e6), NULL, IN_FEATURE(conditioning.to_across),
     true, "shape = areal", "end of the used range of x across rolling"},
    {"taper_across", LENGTH(0, 1e4), NULL,
     IN_FEATURE(conditioning.taper_across), true, "shape = areal",
     "length across rolling over which the map is blended into its other "
     "side or the smooth surface; default: 5 % of its width"},
    {"extend_across", CHOICE(extensions), "periodic",
     IN_FEATURE(conditioning.extend_across), true, "shape = areal",
     "beyond its sides; none: the smooth surface up to the width of the strip"},
    {"peklenik", POSITIVE(1e3), "1", IN_FEATURE(roughness.peklenik), true,
     "[strip]; shape = roughness",
     "ratio of the correlation lengths along and across rolling, turned by "
     "angle: below 1 transverse, above 1 longitudinal"},
    {"Rq", HEIGHT, NULL, IN_FEATURE(roughness.Rq), true, "shape = roughness",
     "root mean square height"},
    {"spectrum", CHOICE(spectra), "self-affine", IN_FEATURE(roughness.spectrum),
     true, "shape = roughness", "spectrum of the heights"},
    {"hurst", PLAIN(0, 1), "0.8", IN_FEATURE(roughness.hurst), true,
     "shape = roughness; spectrum = self-affine", "Hurst exponent"},
    {"rolloff", SIZE, NULL, IN_FEATURE(roughness.rolloff), true,
     "shape = roughness; spectrum = self-affine",
     "wavelength above which the spectrum is flat"},
    {"shortest", SIZE, NULL, IN_FEATURE(roughness.shortest), true,
     "shape = roughness", "shortest wavelength"},
    {"correlation", SIZE, NULL, IN_FEATURE(roughness.correlation), true,
     "shape = roughness; spectrum = exponential", "correlation length"},
    {"skewness", PLAIN(-10, 10), NULL, IN_FEATURE(roughness.skewness), true,
     "shape = roughness", "skewness of the heights"},
    {"kurtosis", PLAIN(1, 100), NULL, IN_FEATURE(roughness.kurtosis), true,
     "shape = roughness", "kurtosis of the heights (3: Gaussian)"},
    {"seed", WHOLE(0, 2147483647), NULL, IN_FEATURE(roughness.seed), true,
     "shape = roughness",
     "seed of the random numbers; default: 1, 3, 5 ... for the roughness "
     "features of surface 1 in the order of the case, 2, 4, 6 ... of surface "
     "2"},
};

const ovr_section ovr_feature_section = {
    "feature", true, NULL,
    "[feature NAME], any number: surface features (dents, waves, profiles, "
    "roughness)",
    ROWS(feature_keys)};
