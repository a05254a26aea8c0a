/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * [body 1] and [body 2], and what follows from them:
 *     2/E' = (1 - nu1^2)/E1 + (1 - nu2^2)/E2
 *     1/R = 1/R1 + 1/R2,  R_k negative where body k is concave
 *     u_k = omega_k |R_k|,  w = F/width
 *
 * Materials, at room temperature.  Steel: ISO 6336-2.  Silicon nitride, hot
 * pressed: Lily Bearing, Ceramic Materials and Their Properties.  Tungsten
 * carbide, cemented: MakeItFrom.com, Tungsten Carbide (WC).  Bronze, cast tin
 * bronze: Copper Development Association, C93200.  Glass: SCHOTT, N-BK7.
 * Sapphire: Voigt's mean of the crystal's constants C11 = 496, C33 = 498, C44
 * = 148, C12 = 164, C13 = 115 GPa (Uni Optics).  Heat: the same sources;
 * silicon nitride's capacity MakeItFrom.com (IEC 60672 C-935), sapphire
 * Aggarwal & Ramdas, Physical Properties of Diamond and Sapphire, 2019; steel
 * as in bearing practice.
 *
 * Yield, where plastic strain begins.  Steel: hardened 100Cr6 (AISI 52100) by
 * Swift's law 945 MPa (20 + 10^6 eps)^0.121, as papers on dented raceways take
 * it (Nelias and others); at 0.2 % it bears 2.37 GPa.  Bronze: sand cast, at
 * 0.5 % extension, the source above.  What breaks before it yields has none.
 */
#include <math.h>
#include <string.h>

#include "base/error.h"
#include "case/resolve.h"

static const struct {
    double modulus, poisson, yield;
    ovr_thermal thermal;
} materials[] = {
    [OVR_STEEL] = {206e9, 0.30, 1.36e9, {46, 460, 7850}},
    [OVR_SILICON_NITRIDE] = {310e9, 0.27, 0, {30, 800, 3290}},
    [OVR_TUNGSTEN_CARBIDE] = {630e9, 0.24, 0, {85, 280, 15000}},
    [OVR_BRONZE] = {100e9, 0.34, 0.125e9, {59, 377, 8930}},
    [OVR_GLASS] = {82e9, 0.206, 0, {1.114, 858, 2510}},
    [OVR_SAPPHIRE] = {408e9, 0.23, 0, {35, 785, 3980}},
};

static const ovr_block *block_of_body(const ovr_resolved *r, int k)
{
    return ovr_case_find_block(r->c, "body", k ? "2" : "1");
}

static bool says(const ovr_block *block, const char *key)
{
    return block && ovr_block_get(block, key)->given;
}

static ovr_status check_names(const ovr_resolved *r, ovr_error *err)
{
    for (const ovr_block *b = r->c->blocks; b; b = b->next)
        if (!strcmp(b->section->name, "body") && b->name &&
            strcmp(b->name, "1") != 0 && strcmp(b->name, "2") != 0)
            return ovr_fail_at(err, OVR_BAD_INPUT, r->c->name, b->line,
                               "[body %s]: there are [body 1] and [body 2]",
                               b->name);
    return OVR_OK;
}

static void fill_thermal(ovr_body_form *body)
{
    int material = body->material ? body->material : OVR_STEEL;
    const ovr_thermal *from = &materials[material].thermal;
    ovr_thermal *to = &body->thermal;
    if (isnan(to->conductivity))
        to->conductivity = from->conductivity;
    if (isnan(to->heat_capacity))
        to->heat_capacity = from->heat_capacity;
    if (isnan(to->density))
        to->density = from->density;
}

static ovr_status fill_body(ovr_resolved *r, int k, ovr_error *err)
{
    ovr_body_form *body = &r->body[k];
    const ovr_block *block = block_of_body(r, k);
    *body = (ovr_body_form){0, NAN, 0.3, NAN, 0, {NAN, NAN, NAN}};
    if (block && ovr_block_fill(r, block, body, err))
        return OVR_BAD_INPUT;
    fill_thermal(body);
    if (!block)
        return OVR_OK;
    if (body->material && !says(block, "modulus"))
        body->modulus = materials[body->material].modulus;
    if (body->material && !says(block, "poisson"))
        body->poisson = materials[body->material].poisson;
    if (body->radius == 0)
        return ovr_fail_slot(err, ovr_block_get(block, "radius"),
                             "must not be 0; flat is a word");
    return OVR_OK;
}

/* Both bodies give `what`, or neither; [contact] gives it or they do. */
static ovr_status both(const ovr_resolved *r, const char *what,
                       const double value[2], double given, ovr_error *err)
{
    const ovr_block *contact = ovr_block_of(r, "contact");
    if (isnan(value[0]) && isnan(value[1]))
        return OVR_OK;
    if (isnan(value[0]) || isnan(value[1])) {
        int k = isnan(value[0]);
        return ovr_fail_at(
            err, OVR_BAD_INPUT, r->c->name, block_of_body(r, k)->line,
            "[body %d] has a %s; [body %d] needs one too", k + 1, what, 2 - k);
    }
    if (!isnan(given))
        return ovr_fail_slot(err, ovr_block_get(contact, what),
                             "follows from [body 1] and [body 2]: leave it "
                             "out here or there");
    return OVR_OK;
}

static ovr_status reduce_modulus(ovr_resolved *r, ovr_error *err)
{
    const ovr_body_form *b = r->body;
    double *reduced = &r->values.contact.modulus;
    const double E[2] = {b[0].modulus, b[1].modulus};
    /* of a body without one the stresses alone may speak */
    bool needed = isnan(*reduced) || says(block_of_body(r, 0), "modulus") ||
                  says(block_of_body(r, 1), "modulus");
    if (!needed)
        return OVR_OK;
    if (both(r, "modulus", E, *reduced, err))
        return OVR_BAD_INPUT;
    if (!isnan(E[0]))
        *reduced = 2 / ((1 - b[0].poisson * b[0].poisson) / E[0] +
                        (1 - b[1].poisson * b[1].poisson) / E[1]);
    return OVR_OK;
}

static ovr_status reduce_radius(ovr_resolved *r, ovr_error *err)
{
    const double R[2] = {r->body[0].radius, r->body[1].radius};
    double *reduced = &r->values.contact.radius, curvature;
    if (both(r, "radius", R, *reduced, err))
        return OVR_BAD_INPUT;
    if (isnan(R[0]))
        return OVR_OK;
    curvature = 1 / R[0] + 1 / R[1];
    if (!(curvature > 0))
        return ovr_fail_slot(err, ovr_block_get(block_of_body(r, 1), "radius"),
                             "1/R1 + 1/R2 = %g 1/m: must be positive, the "
                             "bodies would not touch in a line",
                             curvature);
    *reduced = 1 / curvature;
    return OVR_OK;
}

/* rad/s to m/s */
static ovr_status turn(ovr_resolved *r, int k, double *speed, ovr_error *err)
{
    const ovr_slot *slot = ovr_block_get(ovr_block_of(r, "contact"),
                                         k ? "speed_2" : "speed_1");
    if (!slot->unit || ovr_unit_dimension(slot->unit) != OVR_ROTATION)
        return OVR_OK;
    if (!isfinite(r->body[k].radius))
        return ovr_fail_slot(err, slot, "%s needs a radius in [body %d]",
                             slot->text, k + 1);
    *speed *= fabs(r->body[k].radius);
    return OVR_OK;
}

static ovr_status spread_load(ovr_resolved *r, ovr_error *err)
{
    ovr_conditions *given = &r->values.contact;
    const ovr_slot *slot = ovr_block_get(ovr_block_of(r, "contact"), "load");
    if (!slot->unit || ovr_unit_dimension(slot->unit) != OVR_FORCE)
        return OVR_OK;
    if (isnan(given->width))
        return ovr_fail_slot(err, slot,
                             "%s needs the width of the contact in [contact]; "
                             "or give it per length, in N/m or N/mm",
                             slot->text);
    given->load /= given->width;
    return OVR_OK;
}

ovr_status ovr_resolve_yield(ovr_resolved *r, ovr_error *err)
{
    double ph = r->contact.ph;
    for (int k = 0; k < 2; k++) {
        ovr_body_form *body = &r->body[k], again = *body;
        const ovr_block *block = block_of_body(r, k);
        bool given = says(block, "yield");
        if (given && ovr_block_fill(r, block, &again, err))
            return OVR_BAD_INPUT;
        body->yield = given          ? again.yield
                      : isfinite(ph) ? materials[body->material].yield / ph
                                     : 0;
    }
    return OVR_OK;
}

ovr_status ovr_resolve_bodies(ovr_resolved *r, ovr_error *err)
{
    ovr_conditions *given = &r->values.contact;
    if (check_names(r, err) || fill_body(r, 0, err) || fill_body(r, 1, err) ||
        reduce_modulus(r, err) || reduce_radius(r, err) ||
        turn(r, 0, &given->speed_1, err) || turn(r, 1, &given->speed_2, err))
        return OVR_BAD_INPUT;
    return spread_load(r, err);
}
