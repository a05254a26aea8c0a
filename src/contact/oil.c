/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Computes the laws of a contact from the known data of a lubricant. For laws
 * without a parameter alpha, alpha is the slope of ln eta at p = 0:
 *     Doolittle  alpha = B R0/((1 - R0)^2 K0)
 *     Yasutomi   alpha = ln 10 C1 C2/(C2 + u0)^2 (A1 A2 - b1 b2 u0),
 *                eta0 = eta_g 10^(-C1 u0/(C2 + u0)), u0 = T - Tg0
 */
#include "contact/oil.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/error.h"
#include "base/given.h"
#include "contact/contact.h"
#include "contact/laws/fluid.h"
#include "contact/laws/law_table.h"

static const double P0_PAPER = 1.98e8; /* Pa */
static const double Z_PAPER = 0.68;
static const double DENSITY_A = 5.9e8; /* Pa */
/* Density of mineral oils of VG 32 to 68 at 15 degC: the middle of the range in
 * the table of lubricants of ROSS (github.com/petrobras/ross), kg/m3. */
static const double DENSITY_MINERAL = 870;
/* Thermal expansion of mineral oils near 40 degC, 1/K; converts their density
 * from 15 degC to other temperatures. */
static const double EXPANSION = 6.5e-4;

ovr_oil ovr_oil_default(void)
{
    ovr_oil oil = {.viscosity_law = OVR_ROELANDS,
                   .density_law = OVR_DOWSON_HIGGINSON};
    double *const numbers[] = {&oil.temperature,
                               &oil.viscosity,
                               &oil.alpha,
                               &oil.p0,
                               &oil.z,
                               &oil.tait_K0,
                               &oil.tait_K0_slope,
                               &oil.doolittle_B,
                               &oil.doolittle_R0,
                               &oil.yasutomi.C1,
                               &oil.yasutomi.C2,
                               &oil.yasutomi.Tg0,
                               &oil.yasutomi.A1,
                               &oil.yasutomi.T,
                               &oil.yasutomi.A2,
                               &oil.yasutomi.b1,
                               &oil.yasutomi.b2,
                               &oil.glass_viscosity,
                               &oil.nu_40,
                               &oil.nu_100,
                               &oil.density_15,
                               &oil.viscosity_index,
                               &oil.S0,
                               &oil.beta};
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++)
        *numbers[i] = NAN;
    return oil;
}

/* ------------------------------------------------------------- given data */

typedef struct need {
    const char *name;
    double value;
} need;

static ovr_status all_given(const need *needs, size_t n, const char *law,
                            ovr_error *err)
{
    for (size_t i = 0; i < n; i++)
        if (isnan(needs[i].value))
            return ovr_fail_about(err, needs[i].name, "%s needs %s", law,
                                  needs[i].name);
    return OVR_OK;
}

static ovr_status check_tait(const ovr_oil *oil, ovr_error *err)
{
    const need needs[] = {{"tait_K0", oil->tait_K0},
                          {"tait_K0_slope", oil->tait_K0_slope}};
    if (oil->viscosity_law != OVR_DOOLITTLE && oil->density_law != OVR_TAIT)
        return OVR_OK;
    return all_given(needs, 2, "Tait's equation", err);
}

static ovr_status by_doolittle(ovr_oil *oil, ovr_error *err)
{
    double B = oil->doolittle_B, R0 = oil->doolittle_R0;
    const need needs[] = {{"doolittle_B", B}, {"doolittle_R0", R0}};
    if (all_given(needs, 2, "Doolittle's law", err))
        return OVR_BAD_INPUT;
    if (!(R0 < 1))
        return ovr_fail_about(err, "doolittle_R0",
                              "doolittle_R0 = %g: must be below 1", R0);
    oil->alpha = B * R0 / ((1 - R0) * (1 - R0) * oil->tait_K0);
    return OVR_OK;
}

static ovr_status by_yasutomi(ovr_oil *oil, ovr_error *err)
{
    ovr_yasutomi *y = &oil->yasutomi;
    const double ln10 = log(10);
    const need needs[] = {{"temperature", oil->temperature},
                          {"yasutomi_Tg0", y->Tg0},
                          {"yasutomi_A1", y->A1},
                          {"yasutomi_A2", y->A2},
                          {"yasutomi_b1", y->b1},
                          {"yasutomi_b2", y->b2},
                          {"yasutomi_C1", y->C1},
                          {"yasutomi_C2", y->C2}};
    double u, w;
    if (all_given(needs, sizeof needs / sizeof *needs, "Yasutomi's law", err))
        return OVR_BAD_INPUT;
    y->T = oil->temperature;
    u = y->T - y->Tg0;
    w = y->C2 + u;
    if (!(u > 0))
        return ovr_fail_about(err, "temperature",
                              "temperature = %g K: must be above that of the "
                              "glass transition, %g K",
                              y->T, y->Tg0);
    oil->alpha = ln10 * y->C1 * y->C2 / (w * w) *
                 (y->A1 * y->A2 - y->b1 * y->b2 * u);
    if (isnan(oil->viscosity) && !isnan(oil->glass_viscosity))
        oil->viscosity = oil->glass_viscosity * pow(10, -y->C1 * u / w);
    return OVR_OK;
}

static ovr_status by_table(ovr_oil *oil, ovr_error *err)
{
    const ovr_law_table *t = oil->viscosity_table;
    if (!t)
        return ovr_fail_about(err, "viscosity_law",
                              "viscosity_law = table needs viscosity_file");
    oil->alpha = t->slope[0] / t->mesh;
    if (isnan(oil->viscosity))
        oil->viscosity = t->ambient;
    return OVR_OK;
}

/* Uses the slope at p = 0 if the law has no parameter alpha. */
static ovr_status by_its_law(ovr_oil *oil, ovr_error *err)
{
    bool own = oil->viscosity_law == OVR_DOOLITTLE ||
               oil->viscosity_law == OVR_YASUTOMI ||
               oil->viscosity_law == OVR_VISCOSITY_TABLE;
    ovr_status status = OVR_OK;
    if (!own)
        return OVR_OK;
    if (!isnan(oil->alpha))
        return ovr_fail_about(
            err, "alpha",
            "alpha is already determined by viscosity_law; remove alpha");
    if (oil->viscosity_law == OVR_DOOLITTLE)
        status = by_doolittle(oil, err);
    else if (oil->viscosity_law == OVR_YASUTOMI)
        status = by_yasutomi(oil, err);
    else
        status = by_table(oil, err);
    if (!status && !(oil->alpha > 0 && isfinite(oil->alpha)))
        return ovr_fail_about(err, "viscosity_law",
                              "viscosity_law: the viscosity must rise from p = "
                              "0 on; its slope there gives alpha = %g 1/Pa",
                              oil->alpha);
    return status;
}

/* --------------------------------------------------- from the data sheet */

/* Lists in one message everything that a data sheet lacks. */
static ovr_status check_sheet_complete(const ovr_oil *oil, ovr_error *err)
{
    bool index = !isnan(oil->nu_100) || !isnan(oil->viscosity_index);
    bool slope = oil->viscosity_law == OVR_ROELANDS ||
                 oil->viscosity_law == OVR_BARUS;
    const struct {
        bool lacks;
        const char *key, *text;
    } needs[] = {
        {isnan(oil->temperature), "temperature", "temperature (e.g. 60 degC)"},
        {isnan(oil->nu_40), "viscosity_40", "viscosity_40 or iso_vg"},
        {!index, "viscosity_index",
         "viscosity_index (mineral oil: 95, PAO: 140) or viscosity_100"},
        {slope && isnan(oil->alpha) && !oil->mineral, "alpha",
         "alpha (mineral oil: 20 1/GPa, PAO: 15 1/GPa) or oil = mineral"}};
    const char *first = NULL;
    char list[320] = "";
    size_t used = 0;
    for (size_t k = 0; k < sizeof needs / sizeof *needs; k++)
        if (needs[k].lacks && used < sizeof list) {
            used += (size_t)snprintf(list + used, sizeof list - used, "%s%s",
                                     first ? "; " : "", needs[k].text);
            first = first ? first : needs[k].key;
        }
    if (!first || !strcmp(first, "alpha"))
        return OVR_OK;
    return ovr_fail_about(err, first,
                          "the viscosity from a data sheet needs %s", list);
}

static ovr_status check_sheet(const ovr_oil *oil, ovr_error *err)
{
    if (!isnan(oil->viscosity))
        return ovr_fail_about(err, "viscosity",
                              "viscosity is already determined by "
                              "viscosity_40 (or iso_vg) at the temperature; "
                              "remove viscosity or viscosity_40");
    if (check_sheet_complete(oil, err))
        return OVR_BAD_INPUT;
    if (!isnan(oil->nu_100) && !isnan(oil->viscosity_index))
        return ovr_fail_about(err, "viscosity_index",
                              "viscosity_100 and viscosity_index determine "
                              "each other; remove one of them");
    return OVR_OK;
}

static ovr_status by_data_sheet(ovr_oil *oil, ovr_error *err)
{
    double above = oil->temperature - 288.15;
    if (isnan(oil->nu_40) && isnan(oil->nu_100) && isnan(oil->viscosity_index))
        return OVR_OK;
    if (check_sheet(oil, err))
        return OVR_BAD_INPUT;
    if (isnan(oil->density_15))
        oil->density_15 = DENSITY_MINERAL;
    if (isnan(oil->nu_100))
        oil->nu_100 = ovr_viscosity_at_100(oil->nu_40, oil->viscosity_index);
    if (isnan(oil->nu_100))
        return ovr_fail_about(err, "viscosity_index",
                              "viscosity_index = %g: no viscosity of at "
                              "least 2 mm2/s at 100 degC has this index",
                              oil->viscosity_index);
    if (!(oil->nu_100 < oil->nu_40))
        return ovr_fail_about(err, "viscosity_100",
                              "viscosity_100 must be below viscosity_40");
    oil->viscosity = ovr_walther(oil->nu_40, oil->nu_100, oil->temperature) *
                     oil->density_15 * (1 - EXPANSION * above);
    return OVR_OK;
}

/* Estimated pressure-viscosity coefficient of a mineral oil, 1/Pa, from its
 * viscosity (Pa s): Roelands' relation
 *   alpha = z (ln eta0 + 9.67)/p0,  z = 0.68, p0 = 198 MPa
 * (Roelands, Vlugter & Waterman, J. Basic Eng. 85 (1963) 601; z of a paraffinic
 * oil as in Venner, ten Napel & Bosma 1990).  Measured values are 0.6 to 1
 * times this estimate, see overroll-case(5). */
static double estimated_alpha(double viscosity)
{
    return Z_PAPER * (log(viscosity) + 9.67) / P0_PAPER;
}

/* Estimates missing values of a mineral oil. */
static ovr_status estimate(ovr_oil *oil, ovr_error *err)
{
    bool slope = oil->viscosity_law == OVR_ROELANDS ||
                 oil->viscosity_law == OVR_BARUS;
    if (!oil->mineral || !isnan(oil->alpha) || !slope)
        return OVR_OK;
    if (isnan(oil->viscosity))
        return ovr_fail_about(err, "oil",
                              "oil = mineral needs iso_vg, viscosity_index and "
                              "temperature, or viscosity");
    oil->alpha = estimated_alpha(oil->viscosity);
    if (!(oil->alpha > 0))
        return ovr_fail_about(err, "oil",
                              "oil = mineral cannot estimate alpha for a "
                              "viscosity of %g mPa.s; set lubricant.alpha",
                              1e3 * oil->viscosity);
    return OVR_OK;
}

static ovr_status complete(ovr_oil *oil, ovr_error *err)
{
    if (check_tait(oil, err) || by_data_sheet(oil, err) || estimate(oil, err))
        return OVR_BAD_INPUT;
    if (oil->density_law == OVR_DENSITY_TABLE && !oil->density_table)
        return ovr_fail_about(err, "density_law",
                              "density_law = table needs density_file");
    return by_its_law(oil, err);
}

ovr_status ovr_oil_complete(ovr_oil *oil, ovr_error *err)
{
    ovr_oil whole;
    ovr_status status = OVR_TAKE(ovr_oil, &whole, oil, err);
    if (!status)
        status = complete(&whole, err);
    if (!status)
        *oil = whole;
    return status;
}

/* ------------------------------------------------------------- scaling */

static ovr_status index_z(const ovr_contact *contact, double p0, double given,
                          double *z, ovr_error *err)
{
    *z = given;
    if (!isnan(given)) {
        if (given > 0 && given <= 2)
            return OVR_OK;
        return ovr_fail_about(err, "z", "z = %g: must be above 0 and at most 2",
                              given);
    }
    *z = Z_PAPER;
    if (isnan(contact->viscosity) || isnan(contact->alpha))
        return OVR_OK;
    *z = contact->alpha * p0 / (log(contact->viscosity) + 9.67);
    if (*z > 0 && *z <= 2)
        return OVR_OK;
    return ovr_fail_about(
        err, "alpha",
        "z = %g by Roelands' relation from alpha and viscosity is outside "
        "the range of lubricants; check alpha and viscosity, or set z",
        *z);
}

static ovr_status check_known(const ovr_oil *oil, const ovr_contact *contact,
                              ovr_error *err)
{
    bool needs_ph = (oil->viscosity_law != OVR_BARUS &&
                     oil->viscosity_law != OVR_ISOVISCOUS) ||
                    oil->density_law != OVR_INCOMPRESSIBLE;
    bool plain_film = !(contact->L > 0);
    if (plain_film && oil->viscosity_law != OVR_ISOVISCOUS &&
        isnan(contact->alpha))
        return ovr_fail_about(err, "alpha",
                              "alpha is missing (pressure-viscosity "
                              "coefficient; not needed with viscosity_law = "
                              "isoviscous)");
    if (!plain_film && needs_ph && !(contact->ph > 0))
        return ovr_fail_about(err, "alpha",
                              "alpha is missing: the lubricant's laws need the "
                              "Hertzian pressure, alphabar/alpha");
    return OVR_OK;
}

static void scale_laws(const ovr_oil *oil, double ph, ovr_lubricant *made)
{
    made->A = oil->density_law == OVR_DOWSON_HIGGINSON ? DENSITY_A / ph : 1;
    made->tait_K = oil->tait_K0 / ph;
    made->tait_K_slope = oil->tait_K0_slope;
    made->doolittle_B = oil->doolittle_B;
    made->doolittle_R0 = oil->doolittle_R0;
    made->yasutomi = oil->yasutomi;
    made->yasutomi.A2 *= ph;
    made->yasutomi.b1 *= ph;
    if (oil->viscosity_law == OVR_VISCOSITY_TABLE)
        made->viscosity_table = oil->viscosity_table;
    if (oil->density_law == OVR_DENSITY_TABLE)
        made->density_table = oil->density_table;
    made->table_ph = ph;
}

static ovr_status scale(const ovr_oil *oil, const ovr_contact *contact,
                        ovr_lubricant *lubricant, ovr_error *err)
{
    double p0 = isnan(oil->p0) ? P0_PAPER : oil->p0;
    ovr_lubricant made = {.viscosity_law = OVR_ISOVISCOUS,
                          .density_law = OVR_INCOMPRESSIBLE,
                          .P0 = 1,
                          .z = 1,
                          .A = 1};
    if (!(p0 > 0 && isfinite(p0)))
        return ovr_fail_about(err, "p0",
                              "p0 = %g Pa: must be positive and finite", p0);
    if (check_known(oil, contact, err))
        return OVR_BAD_INPUT;
    if (contact->L > 0) {
        made.viscosity_law = oil->viscosity_law;
        made.density_law = oil->density_law;
        made.alphabar = contact->alphabar;
        scale_laws(oil, contact->ph, &made);
    }
    if (made.viscosity_law == OVR_ROELANDS) {
        if (index_z(contact, p0, oil->z, &made.z, err))
            return OVR_BAD_INPUT;
        made.P0 = p0 / contact->ph;
    }
    *lubricant = made;
    return OVR_OK;
}

ovr_status ovr_oil_scale(const ovr_oil *oil, const ovr_contact *contact,
                         ovr_lubricant *lubricant, ovr_error *err)
{
    ovr_oil whole;
    ovr_contact of;
    ovr_lubricant made;
    if (OVR_TAKE(ovr_oil, &whole, oil, err) ||
        OVR_TAKE(ovr_contact, &of, contact, err) ||
        ovr_check_output_argument(lubricant, "ovr_lubricant", err) ||
        scale(&whole, &of, &made, err))
        return OVR_BAD_INPUT;
    *lubricant = made;
    return OVR_OK;
}

/* Creates a lubricant from its laws and Roelands' constants only. */
ovr_status ovr_lubricant_make(const ovr_contact *contact,
                              ovr_viscosity_law viscosity_law,
                              ovr_density_law density_law, double p0, double z,
                              ovr_lubricant *lubricant, ovr_error *err)
{
    ovr_oil oil = ovr_oil_default();
    oil.viscosity_law = viscosity_law;
    oil.density_law = density_law;
    oil.p0 = p0;
    oil.z = z;
    return ovr_oil_scale(&oil, contact, lubricant, err);
}

/* Integrates by 5-point Gauss-Legendre panels, each 1.2 times as long as the
 * one before, until eta exceeds 1e18 or panels are negligible. */
double ovr_asymptotic_alphabar(const ovr_lubricant *lubricant)
{
    static const double x[] = {0, 0.5384693101056831, 0.9061798459386640};
    static const double w[] = {0.5688888888888889, 0.4786286704993665,
                               0.2369268850561891};
    double width, at = 0, sum = 0;
    if (!lubricant || !(lubricant->alphabar > 0))
        return NAN;
    width = 0.05 / lubricant->alphabar;
    for (int panel = 0; panel < 200; panel++) {
        double part = 0;
        for (int k = -2; k <= 2; k++) {
            int j = k < 0 ? -k : k;
            double P = at + width / 2 * (1 + (k < 0 ? -x[j] : x[j]));
            part += w[j] / ovr_viscosity(lubricant, P);
        }
        sum += part * width / 2;
        at += width;
        if (part * width < 1e-14 * sum)
            return 1 / sum;
        width *= 1.2;
    }
    return NAN;
}

/* ------------------------------------------------- the laws at one pressure */

/* The laws of a lubricant (contact/laws) at one pressure. */

double ovr_viscosity(const ovr_lubricant *lubricant, double P)
{
    const ovr_lubricant *oil = lubricant;
    fluid_laws c = {0};
    if (!oil)
        return NAN;
    ovr_viscosity_law law = oil->viscosity_law;
    fluid_laws_make(oil, &c);
    double divisor = viscosity_divisor(&c, law, P), slope;
    double power = viscosity_begin(&c, law, P, divisor, 1 / divisor, &slope);
    return exp2(-viscosity_finish(&c, law, power, &slope));
}

double ovr_density(const ovr_lubricant *lubricant, double P)
{
    const ovr_lubricant *oil = lubricant;
    fluid_laws c = {0};
    double slope;
    if (!oil)
        return NAN;
    fluid_laws_make(oil, &c);
    return density_at(&c, oil->density_law, P, &slope);
}
