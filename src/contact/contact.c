/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Operating conditions and their scaling. The following relations are
 * consequences of the definitions in overroll/contact.h:
 *     ph^2 = w E'/(2 pi R)        b = 4 R ph/E'       w = pi b ph/2
 *     W = w/(E' R) = pi b^2/(8 R^2)
 *     2U = (W/M)^2                us = 2U E' R/eta0
 *     M^2 = 3 pi^2/(8 lambda)     L = alphabar sqrt(2 pi/M)
 * Every error message names a field, if possible one that is given.
 */
#include "contact/contact.h"

#include <math.h>
#include <string.h>

#include "base/error.h"
#include "base/given.h"
#include "overroll/contact.h"

static const double PI = 3.14159265358979323846;

/* Redundant values may differ only by rounding. */
static const double AGREE = 1e-6;

ovr_conditions ovr_conditions_default(void)
{
    const ovr_conditions defaults = {.M = NAN,
                                     .L = NAN,
                                     .lambda = NAN,
                                     .alphabar = NAN,
                                     .load = NAN,
                                     .hertz_pressure = NAN,
                                     .radius = NAN,
                                     .modulus = NAN,
                                     .viscosity = NAN,
                                     .alpha = NAN,
                                     .speed_1 = NAN,
                                     .speed_2 = NAN,
                                     .mean_speed = NAN,
                                     .slide_to_roll = NAN,
                                     .G = NAN,
                                     .width = NAN};
    return defaults;
}

static bool known(double value)
{
    return !isnan(value);
}

static ovr_status refuse(ovr_error *err, const char *name, const char *why)
{
    return ovr_fail_about(err, name, "%s %s", name, why);
}

static ovr_status check_sign(const char *name, double value, bool zero_too,
                             ovr_error *err)
{
    if (!known(value) || (isfinite(value) && value > 0))
        return OVR_OK;
    if (zero_too && value == 0)
        return OVR_OK;
    return ovr_fail_about(err, name, "%s = %g: must be %s and finite", name,
                          value, zero_too ? "zero or positive" : "positive");
}

static ovr_status check_values(const ovr_conditions *c, ovr_error *err)
{
    const struct {
        const char *name;
        double value;
        bool zero_too;
    } all[] = {
        {"M", c->M, false},
        {"L", c->L, true},
        {"lambda", c->lambda, false},
        {"alphabar", c->alphabar, true},
        {"load", c->load, false},
        {"hertz_pressure", c->hertz_pressure, false},
        {"radius", c->radius, false},
        {"modulus", c->modulus, false},
        {"viscosity", c->viscosity, false},
        {"alpha", c->alpha, true},
        {"mean_speed", c->mean_speed, false},
        {"G", c->G, false},
        {"width", c->width, false},
    };
    for (size_t i = 0; i < sizeof all / sizeof all[0]; i++)
        if (check_sign(all[i].name, all[i].value, all[i].zero_too, err))
            return OVR_BAD_INPUT;
    if (isinf(c->speed_1) || isinf(c->speed_2) || isinf(c->slide_to_roll))
        return refuse(err,
                      isinf(c->slide_to_roll) ? "slide_to_roll"
                      : isinf(c->speed_1)     ? "speed_1"
                                              : "speed_2",
                      "must be finite");
    return OVR_OK;
}

double ovr_slip_ratio(double u1, double u2, double um)
{
    const double rounding = 1e-12;
    double slip = (u1 - u2) / um;
    return fabs(slip) <= rounding ? 0 : slip;
}

/* Computes um and the ratios u1/um, u2/um = 1 +- SRR/2. */
static ovr_status resolve_speeds(const ovr_conditions *c, ovr_contact *to,
                                 ovr_error *err)
{
    double half = known(c->slide_to_roll) ? c->slide_to_roll / 2 : 0;
    to->um = c->mean_speed;
    to->u1_ratio = 1 + half;
    to->u2_ratio = 1 - half;
    if (!known(c->speed_1) && !known(c->speed_2))
        return OVR_OK;
    if (!known(c->speed_1))
        return ovr_fail_about(err, "speed_2",
                              "speed_1 is missing (speed_2 is given)");
    if (!known(c->speed_2))
        return ovr_fail_about(err, "speed_1",
                              "speed_2 is missing (speed_1 is given)");
    if (known(c->mean_speed))
        return refuse(err, "mean_speed",
                      "is already determined by speed_1 and speed_2; remove "
                      "this key or the two speeds");
    if (known(c->slide_to_roll))
        return refuse(err, "slide_to_roll",
                      "is already determined by speed_1 and speed_2; remove "
                      "this key or the two speeds");
    to->um = (c->speed_1 + c->speed_2) / 2;
    if (!(to->um > 0))
        return refuse(err, "speed_1",
                      "plus speed_2 must be positive: the fluid is carried "
                      "along +x; for squeeze or a start from rest give the "
                      "reference speeds here and their history in [speed]");
    to->u1_ratio = to->u2_ratio = 1;
    if (ovr_slip_ratio(c->speed_1, c->speed_2, to->um) != 0) {
        to->u1_ratio = c->speed_1 / to->um;
        to->u2_ratio = c->speed_2 / to->um;
    }
    return OVR_OK;
}

/* Checks that two values of the same number agree. */
static ovr_status agree(const char *name, double given, double follows,
                        const char *from, ovr_error *err)
{
    if (!known(given) || !known(follows) ||
        fabs(given - follows) <= AGREE * fabs(follows))
        return OVR_OK;
    return ovr_fail_about(
        err, name,
        "%s = %g (SI) contradicts %s, which give %g; remove one "
        "of them",
        name, given, from, follows);
}

/* Sets M, L, lambda and alphabar of *to from Moes' or Hertzian numbers. */
static ovr_status resolve_numbers(const ovr_conditions *c, ovr_contact *to,
                                  ovr_error *err)
{
    bool moes = known(c->M) || known(c->L);
    if (moes && (known(c->lambda) || known(c->alphabar)))
        return refuse(err, known(c->lambda) ? "lambda" : "alphabar",
                      "cannot be combined with M or L; set M and L, or lambda "
                      "and alphabar");
    if (known(c->load))
        return refuse(err, "load",
                      "is already determined by M and L (or lambda and "
                      "alphabar); remove one of them");
    if (moes && !known(c->M))
        return ovr_fail_about(err, "L", "M is missing (L is given)");
    if (moes && !known(c->L))
        return ovr_fail_about(err, "M",
                              "L is missing (M is given; L = 0: isoviscous)");
    if (!moes && !known(c->lambda))
        return ovr_fail_about(err, "alphabar",
                              "lambda is missing (alphabar is given)");
    if (!moes && !known(c->alphabar))
        return ovr_fail_about(err, "lambda",
                              "alphabar is missing (lambda is given)");
    to->M = moes ? c->M : sqrt(3 / (8 * c->lambda)) * PI;
    to->lambda = moes ? 3 * PI * PI / (8 * c->M * c->M) : c->lambda;
    to->L = moes ? c->L : c->alphabar * sqrt(2 * PI / to->M);
    to->alphabar = moes ? c->L * sqrt(c->M / (2 * PI)) : c->alphabar;
    return OVR_OK;
}

/* Computes E' from G = alpha E'. */
static ovr_status modulus_from_G(const ovr_conditions *c, ovr_contact *to,
                                 ovr_error *err)
{
    if (!known(c->G))
        return OVR_OK;
    if (known(c->modulus))
        return refuse(err, "G",
                      "is already determined by alpha and modulus; remove "
                      "one of them");
    if (!(to->L > 0))
        return refuse(err, "G",
                      "= alpha E' is zero in an isoviscous contact, L = 0; "
                      "set modulus");
    to->modulus = c->G / to->alpha;
    return OVR_OK;
}

/* Computes scales from the dimensionless numbers and the known dimensional
 * values. */
static ovr_status scales_from_numbers(const ovr_conditions *c, ovr_contact *to,
                                      ovr_error *err)
{
    double W, us, um;
    to->radius = c->radius;
    to->modulus = c->modulus;
    to->viscosity = c->viscosity;
    to->alpha = to->L > 0 ? c->alpha : 0;
    to->ph = c->hertz_pressure;
    if (to->L > 0 && known(c->alpha)) {
        if (c->alpha == 0)
            return refuse(err, "alpha", "= 0 contradicts L > 0");
        to->ph = to->alphabar / c->alpha;
        if (agree("hertz_pressure", c->hertz_pressure, to->ph,
                  "alpha and the numbers M, L", err))
            return OVR_BAD_INPUT;
    } else if (to->L > 0) {
        to->alpha = to->alphabar / to->ph;
    }
    if (modulus_from_G(c, to, err))
        return OVR_BAD_INPUT;
    to->b = 4 * c->radius * to->ph / to->modulus;
    to->load = PI * to->b * to->ph / 2;
    W = to->load / (to->modulus * c->radius);
    us = (W / to->M) * (W / to->M) * to->modulus * c->radius;
    if (!known(c->viscosity)) {
        to->viscosity = us / (2 * to->um);
        return OVR_OK;
    }
    um = us / (2 * c->viscosity);
    if (agree(known(c->mean_speed) ? "mean_speed" : "speed_1", to->um, um,
              "M, L and the viscosity (as mean speed)", err))
        return OVR_BAD_INPUT;
    if (known(um))
        to->um = um;
    return OVR_OK;
}

static ovr_status missing_physical(const ovr_conditions *c,
                                   const ovr_contact *to, ovr_error *err)
{
    if (known(c->load) && known(c->hertz_pressure))
        return refuse(err, "load",
                      "and hertz_pressure determine each other; remove one "
                      "of the two");
    if (!known(c->load) && !known(c->hertz_pressure))
        return refuse(err, "load",
                      "is missing; set M and L, or load (or hertz_pressure), "
                      "radius, modulus, viscosity, alpha and speeds");
    if (!known(c->radius))
        return refuse(err, "radius", "is missing (reduced radius R)");
    if (!known(c->modulus))
        return refuse(err, "modulus", "is missing (reduced modulus E')");
    if (!known(c->viscosity))
        return refuse(err, "viscosity", "is missing (at ambient pressure)");
    if (!known(to->um))
        return refuse(err, "mean_speed",
                      "is missing; set it, or speed_1 and speed_2");
    return OVR_OK;
}

static ovr_status resolve_physical(const ovr_conditions *c, ovr_contact *to,
                                   ovr_error *err)
{
    double R = c->radius, E = c->modulus, W, U2;
    if (missing_physical(c, to, err))
        return OVR_BAD_INPUT;
    if (known(c->G))
        return refuse(err, "G",
                      "is already determined by alpha and modulus; "
                      "remove this key");
    to->ph = known(c->load) ? sqrt(c->load / R * E / (2 * PI))
                            : c->hertz_pressure;
    to->b = 4 * R * to->ph / E;
    to->load = known(c->load) ? c->load : PI * to->b * to->ph / 2;
    W = to->load / (E * R);
    U2 = 2 * c->viscosity * to->um / (E * R);
    to->M = W / sqrt(U2);
    to->L = known(c->alpha) ? c->alpha * E * sqrt(sqrt(U2)) : 0;
    to->lambda = 3 * PI * PI / (8 * to->M * to->M);
    to->alphabar = known(c->alpha) ? c->alpha * to->ph : 0;
    to->radius = R;
    to->modulus = E;
    to->viscosity = c->viscosity;
    to->alpha = c->alpha;
    return OVR_OK;
}

static ovr_status check_range(const ovr_contact *to, bool physical,
                              ovr_error *err)
{
    const char *from = physical ? " (from the physical conditions)" : "";
    if (!(to->M >= OVR_M_MIN && to->M <= OVR_M_MAX))
        return ovr_fail_about(err, "M", "M = %g%s: must be %g to %g", to->M,
                              from, OVR_M_MIN, OVR_M_MAX);
    if (!(to->L >= 0 && to->L <= OVR_L_MAX))
        return ovr_fail_about(err, "L", "L = %g%s: must be 0 to %g", to->L,
                              from, OVR_L_MAX);
    if (isinf(to->b) || isinf(to->ph) || isinf(to->um) || isinf(to->load) ||
        to->b <= 0 || to->ph <= 0 || to->um <= 0 || to->load <= 0)
        return refuse(err, "radius",
                      "and the other physical conditions give scales beyond "
                      "the range of numbers");
    return OVR_OK;
}

static ovr_status resolve(const ovr_conditions *given, ovr_contact *contact,
                          ovr_error *err)
{
    ovr_contact to = {0};
    bool numbers = known(given->M) || known(given->L) || known(given->lambda) ||
                   known(given->alphabar);
    ovr_status status = check_values(given, err);
    if (!status)
        status = resolve_speeds(given, &to, err);
    if (!status && numbers)
        status = resolve_numbers(given, &to, err);
    if (!status && numbers)
        status = scales_from_numbers(given, &to, err);
    if (!status && !numbers)
        status = resolve_physical(given, &to, err);
    if (!status)
        status = check_range(&to, !numbers, err);
    if (status)
        return status;
    to.kappa = known(given->G) ? 4 * to.alphabar / given->G
                               : 4 * to.ph / to.modulus;
    to.height = to.b * to.b / to.radius;
    to.time = to.b / to.um;
    to.width = given->width;
    *contact = to;
    return OVR_OK;
}

ovr_status ovr_contact_resolve(const ovr_conditions *given,
                               ovr_contact *contact, ovr_error *err)
{
    ovr_conditions own;
    ovr_contact made;
    if (OVR_TAKE(ovr_conditions, &own, given, err) ||
        ovr_check_output_argument(contact, "ovr_contact", err) ||
        resolve(&own, &made, err))
        return OVR_BAD_INPUT;
    *contact = made;
    return OVR_OK;
}

/* ------------------------------------------------------ kinds of quantities */

/* Kinds of quantities: names, units, scales. */

#define ROW(name, si, hertzian, suffix)                                        \
    {                                                                          \
        name, si, hertzian, suffix                                             \
    }
static const ovr_kind_info kinds[OVR_KINDS + 1] = {
    [OVR_KIND_NUMBER] = ROW("number", "1", "1", ""),
    [OVR_KIND_COUNT] = ROW("count", "1", "1", ""),
    [OVR_KIND_FLAG] = ROW("flag", "1", "1", ""),
    [OVR_KIND_LENGTH] = ROW("length", "m", "b", "_m"),
    [OVR_KIND_HEIGHT] = ROW("height", "m", "b^2/R", "_m"),
    [OVR_KIND_PRESSURE] = ROW("pressure", "Pa", "ph", "_Pa"),
    [OVR_KIND_TIME] = ROW("time", "s", "b/um", "_s"),
    [OVR_KIND_VISCOSITY] = ROW("viscosity", "Pa s", "eta0", "_Pa_s"),
    [OVR_KIND_FLOW] = ROW("flow", "m2 s-1", "um b^2/R", "_m2_per_s"),
    [OVR_KIND_SHEAR] = ROW("shear stress", "Pa", "ph b/R", "_Pa"),
    [OVR_KIND_FORCE] = ROW("friction force", "N m-1", "ph b^2/R", "_N_per_m"),
    [OVR_KIND_POWER] = ROW("friction power", "W m-1", "um ph b^2/R",
                           "_W_per_m"),
    [OVR_KIND_TEMPERATURE] = ROW("temperature", "K", "K", ""),
    [OVR_KIND_HEAT] = ROW("heat flux", "W m-2", "um ph b/R", "_W_per_m2"),
    [OVR_KIND_AREA] = ROW("area", "m2", "b^3/R", "_m2"),
    [OVR_KINDS] = ROW("", "1", "1", "")};

const ovr_kind_info *ovr_kind_about(ovr_unit_kind kind)
{
    return &kinds[kind];
}

ovr_unit_kind ovr_kind_named(const char *name)
{
    if (!name)
        return OVR_KINDS;
    ovr_unit_kind kind = OVR_KIND_NUMBER;
    while (kind < OVR_KINDS && strcmp(kinds[kind].name, name) != 0)
        kind++;
    return kind;
}

double ovr_kind_scale(ovr_unit_kind kind, const ovr_contact *contact)
{
    const ovr_contact *c = contact;
    if (!c)
        return NAN;
    switch (kind) {
    case OVR_KIND_LENGTH: return c->b;
    case OVR_KIND_HEIGHT: return c->height;
    case OVR_KIND_PRESSURE: return c->ph;
    case OVR_KIND_TIME: return c->time;
    case OVR_KIND_VISCOSITY: return c->viscosity;
    case OVR_KIND_FLOW: return c->um * c->height;
    case OVR_KIND_SHEAR: return c->ph * c->kappa;
    case OVR_KIND_FORCE: return c->ph * c->kappa * c->b;
    case OVR_KIND_POWER: return c->ph * c->kappa * c->b * c->um;
    case OVR_KIND_HEAT: return c->ph * c->kappa * c->um;
    case OVR_KIND_AREA: return c->b * c->height;
    default: return 1;
    }
}
