/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Usual symbols and names of quantities, and the case parameters that hold
 * them.  Used in messages about unknown keys and sections, and by help.
 */
#include <string.h>
#include <strings.h>

#include "case/parameters.h"
#include "overroll/case.h"

#define SYMBOL(symbol, section, key, name)                                     \
    {                                                                          \
        symbol,                                                                \
        {                                                                      \
            section, key, name, section "." key                                \
        }                                                                      \
    }

/* Symbols are case-sensitive ("E", "e"); names of three or more letters are
 * not. */
static const struct {
    const char *symbol;
    ovr_symbol meaning;
} symbols[] = {
    SYMBOL("E", "body", "modulus", "Young's modulus"),
    SYMBOL("E1", "body", "modulus", "Young's modulus of [body 1]"),
    SYMBOL("E2", "body", "modulus", "Young's modulus of [body 2]"),
    SYMBOL("E_1", "body", "modulus", "Young's modulus of [body 1]"),
    SYMBOL("E_2", "body", "modulus", "Young's modulus of [body 2]"),
    SYMBOL("youngs_modulus", "body", "modulus", "Young's modulus"),
    SYMBOL("elastic_modulus", "body", "modulus", "Young's modulus"),
    SYMBOL("E'", "contact", "modulus", "reduced modulus E'"),
    SYMBOL("E_prime", "contact", "modulus", "reduced modulus E'"),
    SYMBOL("Er", "contact", "modulus", "reduced modulus E'"),
    SYMBOL("Eeq", "contact", "modulus", "reduced modulus E'"),
    SYMBOL("reduced_modulus", "contact", "modulus", "reduced modulus E'"),
    SYMBOL("nu", "body", "poisson", "Poisson's ratio"),
    SYMBOL("nu1", "body", "poisson", "Poisson's ratio of [body 1]"),
    SYMBOL("nu2", "body", "poisson", "Poisson's ratio of [body 2]"),
    SYMBOL("poissons_ratio", "body", "poisson", "Poisson's ratio"),
    SYMBOL("R", "contact", "radius", "reduced radius R"),
    SYMBOL("Rx", "contact", "radius", "reduced radius R"),
    SYMBOL("R1", "body", "radius", "radius of [body 1]"),
    SYMBOL("R2", "body", "radius", "radius of [body 2]"),
    SYMBOL("radius_1", "body", "radius", "radius of [body 1]"),
    SYMBOL("radius_2", "body", "radius", "radius of [body 2]"),
    SYMBOL("reduced_radius", "contact", "radius", "reduced radius R"),
    SYMBOL("w", "contact", "load", "load per unit width"),
    SYMBOL("W", "contact", "load", "load per unit width"),
    SYMBOL("F", "contact", "load", "load per unit width"),
    SYMBOL("F_N", "contact", "load", "load per unit width"),
    SYMBOL("force", "contact", "load", "load per unit width"),
    SYMBOL("normal_load", "contact", "load", "load per unit width"),
    SYMBOL("line_load", "contact", "load", "load per unit width"),
    SYMBOL("ph", "contact", "hertz_pressure", "maximum Hertzian pressure"),
    SYMBOL("p_h", "contact", "hertz_pressure", "maximum Hertzian pressure"),
    SYMBOL("p0_hertz", "contact", "hertz_pressure",
           "maximum Hertzian pressure"),
    SYMBOL("pmax", "contact", "hertz_pressure", "maximum Hertzian pressure"),
    SYMBOL("p_max", "contact", "hertz_pressure", "maximum Hertzian pressure"),
    SYMBOL("u1", "contact", "speed_1", "speed of surface 1"),
    SYMBOL("u2", "contact", "speed_2", "speed of surface 2"),
    SYMBOL("u_1", "contact", "speed_1", "speed of surface 1"),
    SYMBOL("u_2", "contact", "speed_2", "speed of surface 2"),
    SYMBOL("um", "contact", "mean_speed", "entrainment speed"),
    SYMBOL("u_m", "contact", "mean_speed", "entrainment speed"),
    SYMBOL("ue", "contact", "mean_speed", "entrainment speed"),
    SYMBOL("u_e", "contact", "mean_speed", "entrainment speed"),
    SYMBOL("entrainment_speed", "contact", "mean_speed", "entrainment speed"),
    SYMBOL("rolling_speed", "contact", "mean_speed", "entrainment speed"),
    SYMBOL("SRR", "contact", "slide_to_roll",
           "slide-to-roll ratio (u1 - u2)/u_m"),
    SYMBOL("slide_roll_ratio", "contact", "slide_to_roll",
           "slide-to-roll ratio (u1 - u2)/u_m"),
    SYMBOL("slip", "contact", "slide_to_roll",
           "slide-to-roll ratio (u1 - u2)/u_m"),
    SYMBOL("Rq1", "contact", "Rq_1", "roughness of surface 1"),
    SYMBOL("Rq2", "contact", "Rq_2", "roughness of surface 2"),
    SYMBOL("sigma_1", "contact", "Rq_1", "roughness of surface 1"),
    SYMBOL("sigma_2", "contact", "Rq_2", "roughness of surface 2"),
    SYMBOL("eta", "lubricant", "viscosity",
           "dynamic viscosity at ambient pressure"),
    SYMBOL("eta0", "lubricant", "viscosity",
           "dynamic viscosity at ambient pressure"),
    SYMBOL("eta_0", "lubricant", "viscosity",
           "dynamic viscosity at ambient pressure"),
    SYMBOL("mu0", "lubricant", "viscosity",
           "dynamic viscosity at ambient pressure"),
    SYMBOL("dynamic_viscosity", "lubricant", "viscosity",
           "dynamic viscosity at ambient pressure"),
    SYMBOL("nu40", "lubricant", "viscosity_40",
           "kinematic viscosity at 40 degC"),
    SYMBOL("nu100", "lubricant", "viscosity_100",
           "kinematic viscosity at 100 degC"),
    SYMBOL("VG", "lubricant", "iso_vg", "ISO viscosity grade"),
    SYMBOL("ISO_VG", "lubricant", "iso_vg", "ISO viscosity grade"),
    SYMBOL("VI", "lubricant", "viscosity_index", "viscosity index"),
    SYMBOL("alpha0", "lubricant", "alpha", "pressure-viscosity coefficient"),
    SYMBOL("alpha_p", "lubricant", "alpha", "pressure-viscosity coefficient"),
    SYMBOL("pressure_viscosity_coefficient", "lubricant", "alpha",
           "pressure-viscosity coefficient"),
    SYMBOL("rho", "lubricant", "density_15", "density at 15 degC"),
    SYMBOL("rho0", "lubricant", "density_15", "density at 15 degC"),
    SYMBOL("T0", "lubricant", "temperature", "temperature of the lubricant"),
    SYMBOL("tau0", "lubricant", "eyring_stress", "Eyring stress"),
    SYMBOL("tau_0", "lubricant", "eyring_stress", "Eyring stress"),
    SYMBOL("tau_E", "lubricant", "eyring_stress", "Eyring stress"),
    SYMBOL("tau_L", "lubricant", "limiting_shear",
           "limiting shear stress coefficient tau_L/p"),
    SYMBOL("tau_lim", "lubricant", "limiting_shear",
           "limiting shear stress coefficient tau_L/p"),
    SYMBOL("mu_b", "boundary", "friction", "boundary friction coefficient"),
    SYMBOL("dt", "time", "step", "time step"),
    SYMBOL("t_end", "time", "end", "end of the run"),
    SYMBOL("nx", "domain", "level", "grid level"),
    SYMBOL("sigma", "boundary", "Rq", "composite roughness"),
};
#undef SYMBOL

const ovr_symbol *ovr_symbol_find(const char *symbol)
{
    bool word = strlen(symbol) > 2;
    for (size_t k = 0; k < sizeof symbols / sizeof *symbols; k++)
        if (!strcmp(symbols[k].symbol, symbol) ||
            (word && !strcasecmp(symbols[k].symbol, symbol)))
            return &symbols[k].meaning;
    return NULL;
}

const char *ovr_parameter_by_symbol(const char *symbol)
{
    const ovr_symbol *found = symbol ? ovr_symbol_find(symbol) : NULL;
    return found ? found->path : NULL;
}

/* Synonyms of section names. */
static const char *const sections[][2] = {
    {"oil", "lubricant"},       {"fluid", "lubricant"},
    {"body1", "body 1"},        {"body2", "body 2"},
    {"body_1", "body 1"},       {"body_2", "body 2"},
    {"surface1", "body 1"},     {"surface2", "body 2"},
    {"material", "body 1"},     {"solid", "body 1"},
    {"geometry", "contact"},    {"operating", "contact"},
    {"conditions", "contact"},  {"bearing", "roller_bearing"},
    {"mesh", "domain"},         {"grid", "domain"},
    {"thermal", "heat"},        {"temperature", "heat"},
    {"roughness", "boundary"},  {"mixed", "boundary"},
    {"wear", "boundary"},       {"asperity", "boundary"},
    {"starvation", "supply"},   {"dlc", "coating dlc"},
    {"layer", "coating layer"}, {"life", "fatigue"},
    {"results", "output"},      {"numerics", "solver"}};

const char *ovr_section_by_synonym(const char *word)
{
    for (size_t k = 0; k < sizeof sections / sizeof *sections; k++)
        if (!strcasecmp(sections[k][0], word))
            return sections[k][1];
    return NULL;
}
