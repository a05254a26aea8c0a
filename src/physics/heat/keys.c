/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The section [heat] and its keys. */
#include "physics/heat/heat.h"

#include <math.h>

#include "base/rows.h"
#include "case/setup.h"
#include "contact/contact.h"
#include "contact/oil.h"

static const double S0_USUAL = 1.1; /* usual value of mineral oils */

#define AT(field) offsetof(ovr_heat_case, field)

static const ovr_word heats[] = {{"none", 0}, {"lobatto", 1}, {NULL, 0}};
static const ovr_word heat_points[] = {
    {"auto", 0}, {"5", 5}, {"7", 7}, {NULL, 0}};

static const ovr_parameter keys[] = {
    {"model", CHOICE(heats), "none", AT(model), true, ALWAYS,
     "lobatto: temperatures by collocation across the film"},
    {"points", CHOICE(heat_points), "auto", AT(given.points), true,
     "model = lobatto",
     "number of points across the film; auto: 5, or 7 if the steady start "
     "needs them"},
    {"temperature", WITH_UNIT(OVR_TEMPERATURE, 150, 800), NULL,
     AT(given.temperature), true,
     "model = lobatto or lubricant.viscosity_40 or lubricant.iso_vg or "
     "lubricant.viscosity_law = yasutomi",
     "temperature of the supplied lubricant, for which viscosity and alpha are "
     "given, and of the bodies; or temperature in [lubricant]"},
    {"temperature_1", WITH_UNIT(OVR_TEMPERATURE, 150, 800), NULL,
     AT(given.bulk[0]), true, "model = lobatto",
     "temperature of body 1 far from the contact"},
    {"temperature_2", WITH_UNIT(OVR_TEMPERATURE, 150, 800), NULL,
     AT(given.bulk[1]), true, "model = lobatto",
     "temperature of body 2 far from the contact"},
    {"conductivity", WITH_UNIT(OVR_CONDUCTIVITY, 1e-3, 1e3), "0.14 W/m.K",
     AT(given.oil.conductivity), true, "model = lobatto",
     "thermal conductivity of the lubricant"},
    {"heat_capacity", WITH_UNIT(OVR_HEAT_CAPACITY, 1, 1e30), "2000 J/kg.K",
     AT(given.oil.heat_capacity), true, "model = lobatto",
     "specific heat capacity of the lubricant"},
    {"density", WITH_UNIT(OVR_MASS_DENSITY, 100, 1e5), "870 kg/m3",
     AT(given.oil.density), true, "model = lobatto",
     "density of the lubricant at p = 0"},
    {"expansion", WITH_UNIT(OVR_PER_KELVIN, 0, 0.1), "6.5e-4 1/K",
     AT(given.expansion), true, "model = lobatto",
     "thermal expansion coefficient of the lubricant at p = 0, decreasing with "
     "pressure (compressive heating); none for an incompressible lubricant"},
    {"density_expansion", FLAG, "yes", AT(given.density_expands), true,
     "model = lobatto",
     "no: the density is constant in temperature, as at the supply "
     "temperature"},
};

const ovr_section ovr_heat_section = {
    "heat", false, "model", "temperatures of film and surfaces", ROWS(keys)};

/* -d ln eta/dT at the lubricant temperature, if the data sheet has two
 * viscosities: from the kinematic viscosity and the density. */
static double fall_of_viscosity(const ovr_oil *oil, double expansion)
{
    const double step = 0.5; /* K */
    double T = oil->temperature;
    return log(ovr_walther(oil->nu_40, oil->nu_100, T - step) /
               ovr_walther(oil->nu_40, oil->nu_100, T + step)) /
               (2 * step) +
           expansion;
}

/* Sets missing values from the data sheet; S0 defaults to that of mineral oils.
 */
static void complete(const ovr_physics_case *of, ovr_heat_form *form)
{
    const ovr_oil *oil = of->oil;
    bool sheet = oil->nu_40 > 0 && oil->nu_100 > 0;
    form->S0 = oil->S0;
    form->beta = oil->beta;
    if (!isnan(form->S0) || !isnan(form->beta))
        return;
    if (sheet)
        form->beta = fall_of_viscosity(oil, form->expansion);
    else if (of->lubricant->viscosity_law == OVR_ROELANDS)
        form->S0 = S0_USUAL;
}

/* Finds the minimum speeds of the surfaces during a run with variable speed. */
static void find_slowest(const ovr_physics_case *of, ovr_heat *heat)
{
    const int times = 500;
    for (int k = 0; (of->speed || of->sliding) && k < 2; k++) {
        double before = 0;
        for (int i = 0; i <= (of->end > 0 ? times : 0); i++) {
            double u = ovr_speed_at(of->contact, of->speed, of->sliding, k,
                                    of->end * i / times);
            bool turns = u * before < 0;
            heat->slowest[k] = turns ? 0 : fmin(heat->slowest[k], fabs(u));
            before = u;
        }
    }
}

ovr_status ovr_heat_resolve(const ovr_physics_case *of, void *form, bool *on,
                            ovr_error *err)
{
    ovr_heat_case *h = form;
    *on = h->model != 0;
    if (!*on)
        return OVR_OK;
    h->given.temperature = of->oil->temperature;
    complete(of, &h->given);
    for (int k = 0; k < 2; k++) {
        h->given.body[k] = of->body[k].thermal;
        if (h->given.bulk[k] == 0)
            h->given.bulk[k] = NAN;
    }
    ovr_status status = ovr_heat_make(&h->given, of->contact, of->lubricant,
                                      &h->heat, err);
    if (!status)
        find_slowest(of, &h->heat);
    return status;
}

ovr_heat *ovr_setup_heat(const ovr_setup *setup)
{
    ovr_heat_case *form = ovr_setup_form(setup, "heat");
    return form && form->model ? &form->heat : NULL;
}
