/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Dimensionless numbers of heat (equations in heat_numbers.h). */
#include "contact/heat_numbers.h"

#include <math.h>

#include "base/error.h"
#include "base/given.h"

static const double PI = 3.14159265358979323846;

static ovr_status missing(const char *name, ovr_error *err)
{
    return ovr_fail_about(err, name, "heat needs %s", name);
}

static ovr_status check_contact(const ovr_contact *c, const ovr_lubricant *oil,
                                ovr_error *err)
{
    if (isnan(c->b) || isnan(c->height))
        return missing("radius and modulus", err);
    if (!(c->um > 0))
        return missing("viscosity and speeds", err);
    if (!(c->L > 0) && oil->viscosity_law != OVR_ISOVISCOUS)
        return missing("alpha", err);
    return OVR_OK;
}

/* Sets S0 or beta, and computes the other one at ambient pressure. */
static ovr_status viscosity(const ovr_heat_form *form, const ovr_lubricant *oil,
                            ovr_heat *heat, ovr_error *err)
{
    double above = form->temperature - OVR_ROELANDS_T;
    bool roelands = oil->viscosity_law == OVR_ROELANDS;
    double C = roelands ? oil->alphabar * oil->P0 / oil->z : 0;
    if (!(above > 0))
        return ovr_fail_about(err, "temperature",
                              "temperature = %g K: must be above 138 K",
                              form->temperature);
    if (isnan(form->S0) && isnan(form->beta))
        return ovr_fail_about(err, "beta",
                              roelands
                                  ? "heat needs S0 or beta: set one of them"
                                  : "heat needs beta with this viscosity "
                                    "law; set beta = -d ln eta/dT (mineral "
                                    "oils: 0.03 1/K)");
    if (!isnan(form->S0) && !isnan(form->beta))
        return ovr_fail_about(
            err, "beta",
            "S0 and beta determine each other; remove one of them");
    if (!roelands && isnan(form->beta))
        return ovr_fail_about(err, "S0",
                              "S0 is a parameter of Roelands' law; set beta "
                              "= -d ln eta/dT instead");
    heat->C = C;
    heat->S0 = isnan(form->S0) ? form->beta * above / C : form->S0;
    heat->beta = isnan(form->beta) ? form->S0 * C / above : form->beta;
    return OVR_OK;
}

static void make_numbers(const ovr_heat_form *form, const ovr_contact *c,
                         bool compressible, ovr_heat *heat)
{
    const ovr_thermal *oil = &form->oil;
    double capacity = oil->density * oil->heat_capacity;
    double u[2] = {c->u1_ratio * c->um, c->u2_ratio * c->um};
    heat->points = form->points;
    heat->T0 = form->temperature;
    heat->theta = c->ph / capacity;
    heat->conduction = oil->conductivity * c->radius * c->radius /
                       (capacity * c->um * c->b * c->b * c->b);
    heat->expansion = compressible ? form->expansion : 0;
    heat->A = 5.9e8 / c->ph;
    heat->density_expands = compressible && form->density_expands;
    heat->min_peclet = 0.1;
    for (int k = 0; k < 2; k++) {
        const ovr_thermal *body = &form->body[k];
        double stored = body->density * body->heat_capacity;
        double bulk = form->bulk[k];
        heat->bulk[k] = isnan(bulk) ? 0 : bulk - form->temperature;
        heat->solid[k] = oil->conductivity * c->radius * pow(c->b, -1.5) /
                         sqrt(PI * body->conductivity * stored * c->um);
        heat->peclet[k] = fabs(u[k]) * c->b * stored / body->conductivity;
        heat->diffusion[k] = body->conductivity / (stored * c->um * c->b);
        heat->slowest[k] = fabs(u[k]) / c->um;
    }
}

ovr_status ovr_heat_make(const ovr_heat_form *form, const ovr_contact *contact,
                         const ovr_lubricant *lubricant, ovr_heat *heat,
                         ovr_error *err)
{
    ovr_heat_form whole;
    ovr_contact of;
    ovr_lubricant oil;
    ovr_heat made = {0};
    if (OVR_TAKE(ovr_heat_form, &whole, form, err) ||
        OVR_TAKE(ovr_contact, &of, contact, err) ||
        OVR_TAKE(ovr_lubricant, &oil, lubricant, err) ||
        ovr_check_output_argument(heat, "ovr_heat", err))
        return OVR_BAD_INPUT;
    if (isnan(whole.temperature))
        return missing("temperature", err);
    if (check_contact(&of, &oil, err) || viscosity(&whole, &oil, &made, err))
        return OVR_BAD_INPUT;
    make_numbers(&whole, &of, oil.density_law != OVR_INCOMPRESSIBLE, &made);
    *heat = made;
    return OVR_OK;
}

/* x of heat_numbers.h, with a lower bound far below real temperatures. */
static double warmth(const ovr_heat *heat, double T)
{
    return fmax(1 + T / (heat->T0 - OVR_ROELANDS_T), 1e-3);
}

double ovr_heat_log_viscosity(const ovr_heat *given, double log_eta, double T)
{
    const ovr_heat *heat = given;
    if (!heat)
        return NAN;
    if (heat->C == 0)
        return log_eta - heat->beta * T;
    return (log_eta + heat->C) * pow(warmth(heat, T), -heat->S0) - heat->C;
}

double ovr_heat_viscosity_fall(const ovr_heat *given, double log_eta, double T)
{
    const ovr_heat *heat = given;
    double x;
    if (!heat)
        return NAN;
    if (heat->C == 0)
        return heat->beta;
    x = warmth(heat, T);
    return heat->S0 * (log_eta + heat->C) * pow(x, -heat->S0) /
           (x * (heat->T0 - OVR_ROELANDS_T));
}
