/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The contact of a case and its lubricant: [contact], [body 1], [body 2] and
 * [lubricant]. They are evaluated first, because they scale all other numbers:
 *
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
 * Yield strength.  Steel: hardened 100Cr6 (AISI 52100) by Swift's law 945 MPa
 * (20 + 10^6 eps)^0.121, as used for dented raceways (Nelias and others); 2.37
 * GPa at 0.2 % strain.  Bronze: sand cast, at 0.5 % extension, the source
 * above. Brittle materials have none.
 */
#include "case/resolve.h"

#include <math.h>
#include <string.h>

#include "base/entries.h"
#include "base/error.h"
#include "base/text.h"
#include "contact/contact.h"
#include "contact/oil.h"
#include "elements/case_element.h"

static const double ALPHA_PAPER = 1.7e-8; /* 1/Pa */

/* ----------------------------------------------------------------- bodies */

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

static bool has_key(const ovr_block *block, const char *key)
{
    return block && ovr_block_get(block, key)->given;
}

static ovr_status check_names(const ovr_resolved *r, ovr_error *err)
{
    for (const ovr_block *b = r->c->blocks; b; b = b->next)
        if (!strcmp(b->section->name, "body") && b->name &&
            strcmp(b->name, "1") != 0 && strcmp(b->name, "2") != 0)
            return ovr_fail_at(err, OVR_BAD_INPUT, r->c->name, b->line,
                               "[body %s]: must be [body 1] or [body 2]",
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
    if (body->material && !has_key(block, "modulus"))
        body->modulus = materials[body->material].modulus;
    if (body->material && !has_key(block, "poisson"))
        body->poisson = materials[body->material].poisson;
    if (body->radius == 0)
        return ovr_fail_slot(err, ovr_block_get(block, "radius"),
                             "must not be 0; use flat for a plane surface");
    return OVR_OK;
}

/* Checks that both bodies or neither give `what`, and that [contact] does not
 * give it as well. */
static ovr_status check_both(const ovr_resolved *r, const char *what,
                             const double value[2], double given,
                             ovr_error *err)
{
    const ovr_block *contact = ovr_block_of(r, "contact");
    if (isnan(value[0]) && isnan(value[1]))
        return OVR_OK;
    if (isnan(value[0]) || isnan(value[1])) {
        int k = isnan(value[0]);
        return ovr_fail_at(
            err, OVR_BAD_INPUT, r->c->name, block_of_body(r, k)->line,
            "[body %d] has a %s; set it in [body %d] too", k + 1, what, 2 - k);
    }
    if (!isnan(given))
        return ovr_fail_slot(err, ovr_block_get(contact, what),
                             "is already determined by [body 1] and [body 2]; "
                             "remove this key or those of the bodies");
    return OVR_OK;
}

static ovr_status reduce_modulus(ovr_resolved *r, ovr_error *err)
{
    const ovr_body_form *b = r->body;
    double *reduced = &r->values.contact.modulus;
    const double E[2] = {b[0].modulus, b[1].modulus};
    /* a body without its own modulus is allowed if only [stress] uses the body
     */
    bool needed = isnan(*reduced) || has_key(block_of_body(r, 0), "modulus") ||
                  has_key(block_of_body(r, 1), "modulus");
    if (!needed)
        return OVR_OK;
    if (check_both(r, "modulus", E, *reduced, err))
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
    if (check_both(r, "radius", R, *reduced, err))
        return OVR_BAD_INPUT;
    if (isnan(R[0]))
        return OVR_OK;
    curvature = 1 / R[0] + 1 / R[1];
    if (!(curvature > 0))
        return ovr_fail_slot(err, ovr_block_get(block_of_body(r, 1), "radius"),
                             "1/R1 + 1/R2 = %g 1/m: must be positive; "
                             "otherwise the bodies do not touch in a line",
                             curvature);
    *reduced = 1 / curvature;
    return OVR_OK;
}

/* Converts a rotational speed to m/s. */
static ovr_status convert_rotation(ovr_resolved *r, int k, double *speed,
                                   ovr_error *err)
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
                             "%s needs contact.width; set it, or give the "
                             "load per unit width, in N/m or N/mm",
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
        bool given = has_key(block, "yield");
        if (given && ovr_block_fill(r, block, &again, err))
            return OVR_BAD_INPUT;
        body->yield = given          ? again.yield
                      : isfinite(ph) ? materials[body->material].yield / ph
                                     : 0;
    }
    return OVR_OK;
}

static ovr_status resolve_bodies(ovr_resolved *r, ovr_error *err)
{
    ovr_conditions *given = &r->values.contact;
    if (check_names(r, err) || fill_body(r, 0, err) || fill_body(r, 1, err) ||
        reduce_modulus(r, err) || reduce_radius(r, err) ||
        convert_rotation(r, 0, &given->speed_1, err) ||
        convert_rotation(r, 1, &given->speed_2, err))
        return OVR_BAD_INPUT;
    return spread_load(r, err);
}

/* -------------------------------------------------------------- lubricant */

/* Reads a file of values measured against pressure, named by a key. */
static ovr_status read_table(ovr_resolved *r, const char *key, const char *file,
                             ovr_table_of what, ovr_error *err)
{
    bool density = what == OVR_TABLE_OF_DENSITY;
    ovr_two_columns c = {
        .name = {"pressure", density ? "density" : "viscosity"},
        .header = {OVR_PRESSURE,
                   density ? OVR_MASS_DENSITY : OVR_DYNAMIC_VISCOSITY},
        .example = density ? "pressure [MPa], density [kg/m3]"
                           : "pressure [MPa], viscosity [mPa.s]"};
    ovr_error why = {0};
    ovr_status status;
    if (!file)
        return OVR_OK;
    status = ovr_slot_columns(ovr_slot_of(r, "lubricant", key), file, &c,
                              &r->arena, err);
    if (status)
        return status;
    const ovr_law_points points = {what, c.count, c.x, c.y};
    r->tables[what] = ovr_law_table_create(&points, &r->arena.allocator, &why);
    return r->tables[what] ? OVR_OK : ovr_fail_from(err, &why, file, 0);
}

/* -------------------------------------------------------------- lubricant */

static ovr_status grade(ovr_resolved *r, ovr_error *err)
{
    ovr_oil *oil = &r->values.oil;
    const ovr_slot *slot = ovr_block_get(ovr_block_of(r, "lubricant"),
                                         "iso_vg");
    if (isnan(r->values.iso_vg))
        return OVR_OK;
    if (!isnan(oil->nu_40))
        return ovr_fail_slot(err, slot,
                             "viscosity_40 is also set; remove one of the two");
    oil->nu_40 = r->values.iso_vg * 1e-6;
    return OVR_OK;
}

static ovr_status resolve_oil(ovr_resolved *r, ovr_error *err)
{
    ovr_settings *v = &r->values;
    ovr_oil *oil = &v->oil;
    ovr_error why = {0};
    ovr_status status = grade(r, err);
    const ovr_slot *supplied = ovr_slot_of(r, "heat", "temperature");
    if (supplied->given && !isnan(oil->temperature))
        return ovr_fail_slot(
            err, supplied, "is also set in [lubricant]; remove one of the two");
    if (supplied->given)
        oil->temperature = supplied->number;
    if (!status && oil->viscosity_law == OVR_VISCOSITY_TABLE)
        status = read_table(r, "viscosity_file", v->viscosity_file,
                            OVR_TABLE_OF_VISCOSITY, err);
    if (!status && oil->density_law == OVR_DENSITY_TABLE)
        status = read_table(r, "density_file", v->density_file,
                            OVR_TABLE_OF_DENSITY, err);
    if (status)
        return status;
    oil->viscosity_table = r->tables[OVR_TABLE_OF_VISCOSITY];
    oil->density_table = r->tables[OVR_TABLE_OF_DENSITY];
    bool given = !isnan(oil->alpha);
    if (ovr_oil_complete(oil, &why))
        return ovr_fail_in(err, r->c, ovr_block_of(r, "lubricant"),
                           ovr_block_of(r, "contact"), &why);
    r->alpha_estimated = oil->mineral && !given;
    return OVR_OK;
}

/* ------------------------------------------------------ rheological model */

/* Returns the shear stress that scales the table: that at which the viscosity
 * has fallen to 0.7 of its initial value, or the last one. The table is fine
 * near this stress. */
static double scaling_stress(const ovr_two_columns *p)
{
    const double *rate = p->x, *shear = p->y;
    size_t k = 0;
    while (k + 1 < p->count && shear[k] / rate[k] > 0.7 * shear[0] / rate[0])
        k++;
    return p->count ? shear[k] : 1;
}

static ovr_status read_flow_table(ovr_resolved *r, ovr_error *err)
{
    ovr_flow_form *form = &r->values.flow;
    const ovr_block *block = ovr_block_of(r, "lubricant");
    const char *file = r->values.rheology_file;
    ovr_two_columns p = {.name = {"rate", "stress"},
                         .header = {OVR_SHEAR_RATE, OVR_PRESSURE},
                         .example = "rate [1/s], stress [MPa]"};
    if (!file)
        return ovr_fail_slot(err, ovr_block_get(block, "rheology"),
                             "table needs 'rheology_file' in [lubricant]");
    if (ovr_slot_columns(ovr_block_get(block, "rheology_file"), file, &p,
                         &r->arena, err))
        return OVR_BAD_INPUT;
    form->points = p.count;
    form->shear = p.y;
    form->rate = p.x;
    form->stress = scaling_stress(&p);
    return OVR_OK;
}

ovr_status ovr_resolve_flow(ovr_resolved *r, ovr_error *err)
{
    ovr_flow_form *form = &r->values.flow;
    const ovr_block *block = ovr_block_of(r, "lubricant");
    ovr_error why = {0};
    if (form->rheology == OVR_CARREAU)
        form->rheology = (ovr_rheology)r->values.carreau_form;
    if (form->rheology == OVR_FLOW_TABLE && read_flow_table(r, err))
        return err ? err->status : OVR_BAD_INPUT;
    if (form->rheology > OVR_EYRING) {
        form->law = r->flow_law = ovr_flow_law_create(form, &r->arena.allocator,
                                                      &why);
        if (!form->law)
            return ovr_fail_in(err, r->c, block, NULL, &why);
    }
    if (ovr_lubricant_flow(&r->contact, form, &r->lubricant, &why))
        return ovr_fail_in(err, r->c, block, NULL, &why);
    return OVR_OK;
}

/* ------------------------------------------------------------------ Contact */

/* Rejects viscosity or alpha given in both [contact] and [lubricant]. */
static ovr_status check_twice(const ovr_resolved *r, const char *key,
                              ovr_error *err)
{
    const ovr_slot *one = ovr_slot_of(r, "contact", key);
    const ovr_slot *other = ovr_slot_of(r, "lubricant", key);
    if (!one->given || !other->given)
        return OVR_OK;
    return ovr_fail_slot(err, other,
                         "is also set in [contact]; remove one of the two");
}

/* Returns the composite roughness; a surface without a value counts as
 * smooth. */
static double composite(const double Rq[2])
{
    if (isnan(Rq[0]) && isnan(Rq[1]))
        return NAN;
    return hypot(isnan(Rq[0]) ? 0 : Rq[0], isnan(Rq[1]) ? 0 : Rq[1]);
}

ovr_status ovr_resolve_contact(ovr_resolved *r, ovr_error *err)
{
    ovr_conditions *given = &r->values.contact;
    const ovr_block *contact = ovr_block_of(r, "contact");
    const ovr_block *lubricant = ovr_block_of(r, "lubricant");
    ovr_error why = {0};
    bool numbers;
    *given = ovr_conditions_default();
    r->values.flow = ovr_flow_form_default();
    if (check_twice(r, "viscosity", err) || check_twice(r, "alpha", err))
        return OVR_BAD_INPUT;
    r->values.oil = ovr_oil_default();
    r->values.iso_vg = NAN;
    r->values.Rq[0] = r->values.Rq[1] = NAN;
    if (ovr_section_fill(r, "contact", err) ||
        ovr_section_fill(r, "lubricant", err))
        return OVR_BAD_INPUT;
    r->setup.bearable = r->values.bearable;
    if (ovr_resolve_element_keys(r, err) || resolve_bodies(r, err) ||
        ovr_resolve_element(r, err) || resolve_oil(r, err))
        return err ? err->status : OVR_BAD_INPUT;
    given->viscosity = r->values.oil.viscosity;
    given->alpha = r->values.oil.alpha;
    numbers = !isnan(given->M) || !isnan(given->L) || !isnan(given->lambda) ||
              !isnan(given->alphabar);
    if (numbers && isnan(given->alpha) && isnan(given->hertz_pressure))
        given->alpha = ALPHA_PAPER;
    if (ovr_contact_resolve(given, &r->contact, &why))
        return ovr_fail_in(err, r->c, contact, lubricant, &why);
    r->setup.Rq = composite(r->values.Rq) / r->contact.height;
    if (ovr_resolve_stiffness(r, err))
        return err ? err->status : OVR_BAD_INPUT;
    if (ovr_oil_scale(&r->values.oil, &r->contact, &r->lubricant, &why))
        return ovr_fail_in(err, r->c, contact, lubricant, &why);
    return OVR_OK;
}
