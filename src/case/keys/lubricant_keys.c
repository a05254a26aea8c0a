/* SPDX-License-Identifier: GPL-3.0-or-later */
/* [lubricant]. */
#include "case/keys/keys.h"

#include <math.h>

#include "contact/contact.h"

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
static const ovr_word rheologies[] = {{"newtonian", OVR_NEWTONIAN},
                                      {"eyring", OVR_EYRING},
                                      {"carreau", OVR_CARREAU},
                                      {"table", OVR_FLOW_TABLE},
                                      {NULL, 0}};
static const ovr_word carreau_forms[] = {
    {"rate", OVR_CARREAU}, {"stress", OVR_CARREAU_STRESS}, {NULL, 0}};
static const ovr_word oils[] = {{"given", 0}, {"mineral", 1}, {NULL, 0}};
static const ovr_word auto_nan[] = {{"auto", NAN}, {NULL, 0}};

static const ovr_parameter lubricant_keys[] = {
    {"viscosity_law", CHOICE(viscosity_laws), "roelands", AT(oil.viscosity_law),
     true, ALWAYS, "viscosity against pressure"},
    {"density_law", CHOICE(density_laws), "dowson-higginson",
     AT(oil.density_law), true, ALWAYS, "density against pressure"},
    {"oil", CHOICE(oils), "given", AT(oil.mineral), true,
     "no alpha or iso_vg or viscosity_40; "
     "no contact.alpha or iso_vg or viscosity_40",
     "mineral: where alpha is not given, an estimate from the viscosity"},
    {"viscosity", WITH_UNIT(OVR_DYNAMIC_VISCOSITY, 1e-7, 1e7), NULL,
     AT(oil.viscosity), true, ALWAYS,
     "dynamic viscosity eta0 at ambient pressure"},
    {"alpha", WITH_UNIT(OVR_PER_PRESSURE, 0, 1e-5), NULL, AT(oil.alpha), true,
     ALWAYS, "pressure-viscosity coefficient; default with M and L: 17 1/GPa"},
    {"p0", WITH_UNIT(OVR_PRESSURE, 1e5, 1e11), "198 MPa", AT(oil.p0), true,
     "viscosity_law = roelands", "Roelands' p0"},
    {"z", PLAIN_OR(auto_nan, 1e-3, 2), "auto", AT(oil.z), true,
     "viscosity_law = roelands",
     "Roelands' index; auto: alpha p0/(ln eta0 + 9.67) where alpha and "
     "viscosity are known, else 0.68"},
    {"rheology", CHOICE(rheologies), "newtonian", AT(flow.rheology), true,
     ALWAYS, "shear stress against shear rate"},
    {"eyring_stress", WITH_UNIT(OVR_PRESSURE, 1, 1e12), NULL, AT(flow.stress),
     true, "rheology = eyring",
     "Eyring stress tau0, above which the "
     "lubricant is shear-thinning"},
    {"eyring_number", POSITIVE(1e12), NULL, AT(flow.number), true,
     "rheology = eyring", "tau0 divided by p_h b/R, instead of eyring_stress"},
    {"carreau_stress", WITH_UNIT(OVR_PRESSURE, 1, 1e12), NULL, AT(flow.stress),
     true, "rheology = carreau",
     "stress tau0 (G), above which the lubricant is shear-thinning"},
    {"carreau_number", POSITIVE(1e12), NULL, AT(flow.number), true,
     "rheology = carreau",
     "tau0 divided by p_h b/R, instead of "
     "carreau_stress"},
    {"carreau_n", PLAIN(OVR_CARREAU_N_MIN, 1), "0.5", AT(flow.n), true,
     "rheology = carreau", "exponent of the shear stress at high shear rates"},
    {"carreau_a", PLAIN(OVR_CARREAU_A_MIN, OVR_CARREAU_A_MAX), "2", AT(flow.a),
     true, "rheology = carreau", "Yasuda's exponent of the transition"},
    {"carreau_form", CHOICE(carreau_forms), "rate", AT(carreau_form), true,
     "rheology = carreau",
     "argument of the Carreau function: shear rate, as in textbooks, or "
     "shear stress"},
    {"rheology_file", PATH, NULL, AT(rheology_file), true, "rheology = table",
     "file of shear stress against shear rate at ambient pressure"},
    {"limiting_shear", PLAIN(0, 1), "0", AT(flow.limiting_shear), true, ALWAYS,
     "limiting shear stress coefficient, an upper limit of mean shear stress "
     "divided by pressure in friction and heat; 0: no limit"},
    {"temperature", WITH_UNIT(OVR_TEMPERATURE, 150, 800), NULL,
     AT(oil.temperature), true,
     "viscosity_40 or iso_vg or viscosity_law = yasutomi or heat.model = "
     "lobatto",
     "temperature of lubricant and bodies at which the lubricant properties "
     "apply; for data-sheet viscosities and Yasutomi's law"},
    {"viscosity_40", WITH_UNIT(OVR_KINEMATIC_VISCOSITY, 1e-7, 1), NULL,
     AT(oil.nu_40), true, ALWAYS,
     "kinematic viscosity at 40 degC, from a data sheet"},
    {"viscosity_100", WITH_UNIT(OVR_KINEMATIC_VISCOSITY, 1e-7, 1), NULL,
     AT(oil.nu_100), true, ALWAYS, "kinematic viscosity at 100 degC"},
    {"iso_vg", PLAIN(2, 5000), NULL, AT(iso_vg), true, ALWAYS,
     "ISO VG grade: viscosity_40 in mm2/s, the middle of the grade"},
    {"viscosity_index", PLAIN(-200, 500), NULL, AT(oil.viscosity_index), true,
     ALWAYS, "viscosity index, instead of viscosity_100"},
    {"density_15", WITH_UNIT(OVR_MASS_DENSITY, 400, 3000), "870 kg/m3",
     AT(oil.density_15), true, "viscosity_40 or iso_vg",
     "density at 15 degC, with viscosity_40 or iso_vg; default: a mineral oil"},
    {"viscosity_file", PATH, NULL, AT(viscosity_file), true,
     "viscosity_law = table", "file of viscosity against pressure"},
    {"density_file", PATH, NULL, AT(density_file), true, "density_law = table",
     "file of density against pressure"},
    {"tait_K0", WITH_UNIT(OVR_PRESSURE, 1e6, 1e12), NULL, AT(oil.tait_K0), true,
     "density_law = tait or viscosity_law = doolittle",
     "bulk modulus at p = 0 and the temperature"},
    {"tait_K0_slope", PLAIN(0.1, 100), NULL, AT(oil.tait_K0_slope), true,
     "density_law = tait or viscosity_law = doolittle",
     "derivative K0' of the bulk modulus at p = 0, near 11"},
    {"doolittle_B", POSITIVE(1e3), NULL, AT(oil.doolittle_B), true,
     "viscosity_law = doolittle", "Doolittle's B"},
    {"doolittle_R0", POSITIVE(1), NULL, AT(oil.doolittle_R0), true,
     "viscosity_law = doolittle", "occupied volume fraction at p = 0"},
    {"yasutomi_Tg0", WITH_UNIT(OVR_TEMPERATURE, 50, 800), NULL,
     AT(oil.yasutomi.Tg0), true, "viscosity_law = yasutomi",
     "glass transition temperature at p = 0"},
    {"yasutomi_A1", WITH_UNIT(OVR_KELVINS, 1e-3, 1e4), NULL,
     AT(oil.yasutomi.A1), true, "viscosity_law = yasutomi",
     "A1 of the glass transition"},
    {"yasutomi_A2", WITH_UNIT(OVR_PER_PRESSURE, 1e-13, 1e-5), NULL,
     AT(oil.yasutomi.A2), true, "viscosity_law = yasutomi",
     "A2 of the glass transition"},
    {"yasutomi_b1", WITH_UNIT(OVR_PER_PRESSURE, 0, 1e-5), NULL,
     AT(oil.yasutomi.b1), true, "viscosity_law = yasutomi",
     "b1 of the factor F"},
    {"yasutomi_b2", PLAIN(-10, 0), NULL, AT(oil.yasutomi.b2), true,
     "viscosity_law = yasutomi", "b2 of the factor F"},
    {"yasutomi_C1", POSITIVE(100), NULL, AT(oil.yasutomi.C1), true,
     "viscosity_law = yasutomi",
     "C1, 16.04 where the glass viscosity is 1e12 Pa s"},
    {"yasutomi_C2", WITH_UNIT(OVR_KELVINS, 1e-3, 1e4), NULL,
     AT(oil.yasutomi.C2), true, "viscosity_law = yasutomi", "C2"},
    {"glass_viscosity", WITH_UNIT(OVR_DYNAMIC_VISCOSITY, 1, 1e15), NULL,
     AT(oil.glass_viscosity), true, "viscosity_law = yasutomi",
     "viscosity at the glass transition, where viscosity is not "
     "given"},
    {"S0", PLAIN(0, 10), NULL, AT(oil.S0), true,
     "heat.model = lobatto; viscosity_law = roelands",
     "Roelands' viscosity-temperature index, used by [heat]; default: from the "
     "two viscosities of the data sheet, otherwise 1.1"},
    {"beta", WITH_UNIT(OVR_PER_KELVIN, 0, 1), NULL, AT(oil.beta), true,
     "heat.model = lobatto",
     "temperature-viscosity coefficient -d ln eta/dT at p = 0, instead of S0 "
     "and for other laws; default: from the two viscosities of the data sheet"},
};

const ovr_section ovr_lubricant_section = {
    "lubricant", false, NULL,
    "viscosity-pressure and density-pressure relations, rheological model, and "
    "their constants",
    ROWS(lubricant_keys)};
