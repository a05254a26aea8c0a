/* SPDX-License-Identifier: GPL-3.0-or-later */
/* [contact] and [body]. */
#include "case/keys/keys.h"

#include <math.h>

#include "contact/contact.h"

static const ovr_word materials[] = {{"steel", OVR_STEEL},
                                     {"silicon-nitride", OVR_SILICON_NITRIDE},
                                     {"tungsten-carbide", OVR_TUNGSTEN_CARBIDE},
                                     {"bronze", OVR_BRONZE},
                                     {"glass", OVR_GLASS},
                                     {"sapphire", OVR_SAPPHIRE},
                                     {NULL, 0}};
static const ovr_word scales[] = {
    {"dry", OVR_SCALE_DRY}, {"substrate", OVR_SCALE_SUBSTRATE}, {NULL, 0}};
static const ovr_word no_yield[] = {{"none", 0}, {NULL, 0}};
static const ovr_word flat[] = {{"flat", INFINITY}, {NULL, 0}};

static const ovr_parameter contact_keys[] = {
    {"M", PLAIN(OVR_M_MIN, OVR_M_MAX), NULL, AT(contact.M), true, ALWAYS,
     "Moes' load number W/sqrt(2U)"},
    {"L", PLAIN(0, OVR_L_MAX), NULL, AT(contact.L), true, ALWAYS,
     "Moes' lubricant number G (2U)^(1/4); 0: isoviscous, incompressible"},
    {"lambda", PLAIN(1e-12, 1e7), NULL, AT(contact.lambda), true, ALWAYS,
     "dimensionless speed parameter 3 pi^2/(8 M^2), with alphabar instead of M "
     "and L; not the lambda ratio, see Rq_1"},
    {"alphabar", PLAIN(0, 1e5), NULL, AT(contact.alphabar), true, ALWAYS,
     "alpha times the Hertzian pressure, with lambda"},
    {"load", WITH_UNIT(OVR_LOAD, 1e-6, 1e10), NULL, AT(contact.load), true,
     ALWAYS, "load per unit width, w; with contact.width also as a force"},
    {"width", WITH_UNIT(OVR_LENGTH, 1e-7, 1e4), NULL, AT(contact.width), false,
     "modulus or G or load or [body]",
     "length of the contact along the rollers' axes: for a load in N, and for "
     "forces in N"},
    {"hertz_pressure", WITH_UNIT(OVR_PRESSURE, 1e2, 1e12), NULL,
     AT(contact.hertz_pressure), true, ALWAYS,
     "maximum Hertzian pressure p_h, instead of load (or of alpha)"},
    {"radius", WITH_UNIT(OVR_LENGTH, 1e-7, 1e4), NULL, AT(contact.radius), true,
     "modulus or G or load or [body]",
     "reduced radius R, 1/R = 1/R1 + 1/R2; or from [body 1] and [body 2]"},
    {"modulus", WITH_UNIT(OVR_PRESSURE, 1e3, 1e13), NULL, AT(contact.modulus),
     true, ALWAYS,
     "reduced modulus E', 2/E' = (1-nu1^2)/E1 + (1-nu2^2)/E2; or from [body "
     "1] and [body 2]"},
    {"viscosity", WITH_UNIT(OVR_DYNAMIC_VISCOSITY, 1e-7, 1e7), NULL,
     AT(oil.viscosity), true, ALWAYS, "the same as lubricant.viscosity"},
    {"alpha", WITH_UNIT(OVR_PER_PRESSURE, 0, 1e-5), NULL, AT(oil.alpha), true,
     ALWAYS, "the same as lubricant.alpha"},
    {"speed_1", WITH_UNIT(OVR_SURFACE_SPEED, -1e4, 1e4), NULL,
     AT(contact.speed_1), true, ALWAYS, "speed of surface 1 along +x, u1"},
    {"speed_2", WITH_UNIT(OVR_SURFACE_SPEED, -1e4, 1e4), NULL,
     AT(contact.speed_2), true, ALWAYS, "speed of surface 2 along +x, u2"},
    {"mean_speed", WITH_UNIT(OVR_SPEED, 1e-12, 1e4), NULL,
     AT(contact.mean_speed), true, ALWAYS,
     "um = (u1 + u2)/2, instead of the two speeds"},
    {"slide_to_roll", WITH_UNIT(OVR_SHARE, -1e3, 1e3), NULL,
     AT(contact.slide_to_roll), true, ALWAYS,
     "(u1 - u2)/um, may be in %; default: 0"},
    {"G", PLAIN(1, 1e7), NULL, AT(contact.G), true, ALWAYS,
     "alpha E' in addition to M and L, instead of modulus, for friction "
     "coefficients"},
    {"Rq_1", WITH_UNIT(OVR_LENGTH, 0, 1e-3), NULL, AT(Rq[0]), false,
     "modulus or G or load or [body]",
     "root mean square roughness of surface 1 that is not on the grid; gives "
     "the lambda ratio, without other effect"},
    {"Rq_2", WITH_UNIT(OVR_LENGTH, 0, 1e-3), NULL, AT(Rq[1]), false,
     "modulus or G or load or [body]",
     "root mean square roughness of "
     "surface 2 that is not on the grid"},
    {"bearable_pressure", WITH_UNIT(OVR_PRESSURE, 1, 1e13), "4 GPa",
     AT(bearable), false, ALWAYS,
     "a warning is printed above this pressure; hardened steel yields there"},
    {"scale", CHOICE(scales), "dry", AT(scale), true, "coating.thickness",
     "reference of b, p_h, M and L: the dry contact of the bodies with their "
     "layers, or of the substrates alone"},
};

const ovr_section ovr_contact_section = {
    "contact", false, NULL,
    "operating conditions: M and L, or lambda and alphabar, or load (or "
    "hertz_pressure), radius, modulus, viscosity, alpha and speeds",
    ROWS(contact_keys)};

static const ovr_parameter body_keys[] = {
    {"material", CHOICE(materials), NULL, offsetof(ovr_body_form, material),
     true, "no contact.modulus or [stress] or heat.model = lobatto",
     "material, which supplies the properties that are not set"},
    {"modulus", WITH_UNIT(OVR_PRESSURE, 1e3, 1e13), NULL,
     offsetof(ovr_body_form, modulus), true, ALWAYS,
     "Young's modulus E; both bodies determine the reduced modulus"},
    {"poisson", PLAIN(0, 0.5), NULL, offsetof(ovr_body_form, poisson), true,
     "no contact.modulus or [stress]; modulus or material or [stress]",
     "Poisson's ratio; default: that of the material, otherwise 0.3"},
    {"conductivity", WITH_UNIT(OVR_CONDUCTIVITY, 1e-3, 1e4), NULL,
     offsetof(ovr_body_form, thermal.conductivity), true,
     "heat.model = lobatto",
     "needed with heat; default: that of the "
     "material, otherwise of steel"},
    {"heat_capacity", WITH_UNIT(OVR_HEAT_CAPACITY, 1, 1e30), NULL,
     offsetof(ovr_body_form, thermal.heat_capacity), true,
     "heat.model = lobatto",
     "needed with heat; default: that of the "
     "material, otherwise of steel"},
    {"density", WITH_UNIT(OVR_MASS_DENSITY, 100, 1e5), NULL,
     offsetof(ovr_body_form, thermal.density), true, "heat.model = lobatto",
     "needed with heat; default: that of the material, otherwise of steel"},
    {"yield", STRESS(no_yield, 0, 1e4), NULL, offsetof(ovr_body_form, yield),
     false, "[stress]",
     "yield stress (von Mises), also a reference of stresses; default: that "
     "of the material, otherwise none"},
    {"radius", OVR_NUMBER, OVR_LENGTH, OVR_NOT_HERTZIAN, -1e4, 1e4, false,
     .words = flat, NULL, offsetof(ovr_body_form, radius), true, ALWAYS,
     "radius at the contact, negative: concave, or flat; both bodies "
     "determine the reduced radius"},
};

const ovr_section ovr_body_section = {
    "body", true, NULL,
    "[body 1], [body 2]: properties of the bodies that are not in [contact]",
    ROWS(body_keys)};
