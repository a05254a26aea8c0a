/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "run/comparison.h"

#include <stdio.h>
#include <string.h>

#include "base/error.h"
#include "base/quantity.h"
#include "overroll/simulation.h"
#include "physics/stress/stress.h"
#include "run/summary_lines.h"

/* Reads a relation ("at most", "<=" ...) at *text and moves *text past it. */
static bool read_relation(const char **text, int *sense)
{
    static const struct {
        const char *words;
        int sense;
    } forms[] = {
        {"is at least ", 1}, {"is at most ", -1}, {"is ", 0}, {"== ", 0},
        {"= ", 0},           {"at least ", 1},    {">= ", 1}, {"at most ", -1},
        {"<= ", -1},         {"==", 0},           {"=", 0},   {">=", 1},
        {"<=", -1}};
    *text += strspn(*text, " \t");
    for (size_t k = 0; k < sizeof forms / sizeof *forms; k++)
        if (!strncmp(*text, forms[k].words, strlen(forms[k].words))) {
            *text += strlen(forms[k].words);
            *sense = forms[k].sense;
            return true;
        }
    return false;
}

/* Writes to `buffer` the key of the number in SI that corresponds to a quantity
 * in Hertzian units. Returns false if there is none. */
static bool twin_of(const char *quantity, char buffer[OVR_QUANTITY_CAPACITY])
{
    const ovr_observable *o;
    ovr_extreme e;
    *buffer = '\0';
    for (size_t k = 0; (o = ovr_observable_at(k)); k++)
        if (o->key && o->key_si && !strcmp(o->key, quantity))
            snprintf(buffer, OVR_QUANTITY_CAPACITY, "%s", o->key_si);
    for (size_t k = 0; !*buffer && ovr_extreme_at(k, &e); k++)
        if (!strcmp(e.key, quantity))
            snprintf(buffer, OVR_QUANTITY_CAPACITY, "%s", e.key_si);
    return *buffer;
}

const char *ovr_quantity_bare(const char *quantity,
                              char buffer[OVR_QUANTITY_CAPACITY])
{
    const ovr_observable *o;
    ovr_extreme e;
    snprintf(buffer, OVR_QUANTITY_CAPACITY, "%.*s", OVR_QUANTITY_CAPACITY - 1,
             quantity);
    for (size_t k = 0; (o = ovr_observable_at(k)); k++)
        if (o->key && o->key_si && !strcmp(o->key_si, quantity))
            return snprintf(buffer, OVR_QUANTITY_CAPACITY, "%s", o->key),
                   buffer;
    for (size_t k = 0; ovr_extreme_at(k, &e); k++)
        if (*e.key_si && !strcmp(e.key_si, quantity))
            return snprintf(buffer, OVR_QUANTITY_CAPACITY, "%s", e.key), buffer;
    return buffer;
}

static bool is_key(const char *key, const char *bare, const char *si)
{
    return (bare && !strcmp(key, bare)) || (si && *si && !strcmp(key, si));
}

/* Returns the name of a summary's number that is neither a quantity of a state
 * nor an extreme. */
static const char *other_name(const char *key)
{
    static const char *const names[][2] = {
        {"H_cen_moes", "central film thickness, Moes"},
        {"H_cen_fit", "central film thickness, overroll fit"},
        {"H_min_fit", "minimum film thickness, overroll fit"},
        {"film_Rq_predicted", "predicted film thickness roughness Rq"},
        {"film_Rq_predicted_m", "predicted film thickness roughness Rq"},
        {"H_min_predicted", "predicted minimum film thickness"},
        {"H_min_predicted_m", "predicted minimum film thickness"},
        {"lambda_ratio", "lambda ratio"},
        {"lambda_ratio_predicted", "predicted lambda ratio"},
        {"expected_error", "expected discretization error"},
        {"power_loss_W", "friction power loss"},
        {"efficiency", "efficiency"},
        {"life_ratio", "life ratio"},
        {"utilisation", "utilization of the fatigue limit"},
        {"equivalent_length", "equivalent raceway length"},
        {"equivalent_length_m", "equivalent raceway length"},
        {"R_max", "shear path radius R"},
        {"R_max_Pa", "shear path radius R"}};
    for (size_t k = 0; k < sizeof names / sizeof *names; k++)
        if (!strcmp(key, names[k][0]))
            return names[k][1];
    return NULL;
}

/* Returns "maximum shear stress" for "tau_max" and "tau_max_Pa". */
static const char *stress_name(const char *key)
{
    const ovr_stress_figure *f;
    for (size_t k = 0; (f = ovr_stress_figure_at(k)); k++) {
        size_t size = strlen(f->key);
        if (f->label && !strncmp(key, f->key, size) &&
            (!key[size] || !strcmp(key + size, "_Pa")))
            return f->label;
    }
    return NULL;
}

/* Returns the SI unit that the end of a key specifies, or "". */
static const char *si_unit(const char *key)
{
    static const char *const units[][2] = {
        {"_N_per_m", "N/m"}, {"_W_per_m", "W/m"},
        {"_m_per_s", "m/s"}, {"_rad_per_s", "rad/s"},
        {"_per_Pa", "1/Pa"}, {"_Pa_s", "Pa.s"},
        {"_N_m", "N.m"},     {"_Pa", "Pa"},
        {"_rpm", "rpm"},     {"_deg", "deg"},
        {"_m", "m"},         {"_s", "s"},
        {"_N", "N"},         {"_W", "W"},
        {"_K", "K"}};
    size_t size = strlen(key);
    for (size_t k = 0; k < sizeof units / sizeof *units; k++) {
        size_t ending = strlen(units[k][0]);
        if (size > ending && !strcmp(key + size - ending, units[k][0]))
            return units[k][1];
    }
    return "";
}

/* Returns the Hertzian unit of a dimensionless number of this kind. */
static const char *bare_unit(ovr_unit_kind kind)
{
    switch (kind) {
    case OVR_KIND_LENGTH: return "b";
    case OVR_KIND_HEIGHT: return "b^2/R";
    case OVR_KIND_PRESSURE: return "p_h";
    case OVR_KIND_TIME: return "b/u_m";
    case OVR_KIND_TEMPERATURE: return "K";
    default: return "";
    }
}

ovr_quantity_name ovr_quantity_named(const char *key)
{
    ovr_quantity_name name = {.unit = si_unit(key)};
    const char *other;
    const ovr_observable *o;
    ovr_extreme e;
    for (size_t k = 0; (o = ovr_observable_at(k)); k++)
        if (is_key(key, o->key, o->key_si)) {
            snprintf(name.text, sizeof name.text, "%s", o->long_name);
            if (o->key && !strcmp(key, o->key))
                name.unit = bare_unit(o->kind);
            return name;
        }
    for (size_t k = 0; ovr_extreme_at(k, &e); k++)
        if (is_key(key, e.key, e.key_si)) {
            snprintf(name.text, sizeof name.text, "%s", e.long_name);
            if (!strcmp(key, e.key))
                name.unit = bare_unit(e.kind);
            return name;
        }
    other = other_name(key);
    if (!other)
        other = ovr_contact_label(key);
    if (!other)
        other = stress_name(key);
    snprintf(name.text, sizeof name.text, "%.199s", other ? other : key);
    return name;
}

ovr_quantity_name ovr_key_named(const char *key)
{
    static const char *const names[][2] = {
        {"M", "Moes' load number M"},
        {"L", "Moes' lubricant number L"},
        {"lambda", "dimensionless speed parameter"},
        {"alphabar", "alpha p_h"},
        {"hertz_pressure", "maximum Hertzian pressure p_h"},
        {"radius", "reduced radius R"},
        {"modulus", "reduced modulus E'"},
        {"viscosity", "viscosity eta0"},
        {"alpha", "pressure-viscosity coefficient alpha"},
        {"mean_speed", "entrainment speed u_m"},
        {"speed_1", "speed of surface 1"},
        {"speed_2", "speed of surface 2"},
        {"slide_to_roll", "slide-to-roll ratio"},
        {"Rq", "root mean square roughness Rq"},
        {"limiting_shear", "limiting shear stress coefficient"},
        {"iso_vg", "ISO viscosity grade"},
        {"level", "grid level"}};
    ovr_quantity_name name = {.unit = ""};
    snprintf(name.text, sizeof name.text, "%.199s", key);
    for (size_t k = 0; k < sizeof names / sizeof *names; k++)
        if (!strcmp(key, names[k][0])) {
            snprintf(name.text, sizeof name.text, "%s", names[k][1]);
            return name;
        }
    for (char *c = name.text; *c; c++)
        if (*c == '_' || *c == '.')
            *c = ' ';
    return name;
}

const char *ovr_name_symbol(const char *name, size_t *length)
{
    static const char *const symbols[][2] = {
        {" p_h", "{/:Italic p}_h"}, {" u_m", "{/:Italic u}_m"},
        {" eta0", "{/Symbol h}_0"}, {" alpha", "{/Symbol a}"},
        {" E'", "{/:Italic E}'"},   {" M", "{/:Italic M}"},
        {" L", "{/:Italic L}"},     {" R", "{/:Italic R}"},
        {" b", "{/:Italic b}"},     {" Rq", "{/:Italic Rq}"}};
    size_t size = strlen(name);
    for (size_t k = 0; k < sizeof symbols / sizeof *symbols; k++) {
        *length = size - strlen(symbols[k][0]);
        if (size > strlen(symbols[k][0]) &&
            !strcmp(name + *length, symbols[k][0]))
            return symbols[k][1];
    }
    *length = size;
    return NULL;
}

/* True if the key ends in the SI unit `si`: "_N_per_m" for "N/m", "_per_Pa" for
 * "1/Pa". */
static bool ends_in(const char *key, const char *si)
{
    char ending[40] = "_";
    size_t used = 1, size = strlen(key);
    for (si += !strncmp(si, "1/", 2); *si && used + 6 < sizeof ending; si++)
        if (*si == '/')
            used += (size_t)snprintf(ending + used, sizeof ending - used, "%s",
                                     used > 1 ? "_per_" : "per_");
        else
            ending[used++] = *si == '.' ? '_' : *si, ending[used] = '\0';
    return size > used && !strcmp(key + size - used, ending);
}

const char *ovr_amount_read(const char *text, double *number)
{
    text += strspn(text, " \t");
    return ovr_read_number(&text, number) ? text + strspn(text, " \t") : NULL;
}

/* Reads the target. If it has a unit, converts it to SI and compares it with
 * the quantity in SI. */
static ovr_status read_target(ovr_comparison *c, const char *text,
                              ovr_arena *arena, ovr_error *err)
{
    const char *at = ovr_amount_read(text, &c->target), *si;
    char twin[OVR_QUANTITY_CAPACITY];
    ovr_quantity q;
    ovr_dimension dimension;
    if (!at)
        return ovr_fail_about(err, "condition", "%s: '%.60s' must be a number",
                              c->quantity, text);
    if (!*at)
        return OVR_OK;
    dimension = ovr_unit_dimension(at);
    if (dimension == OVR_PURE ||
        ovr_quantity_read(text, dimension, false, &q, NULL))
        return ovr_fail_about(err, "condition", "%s: unknown unit '%.40s'",
                              c->quantity, at);
    si = ovr_unit_si(dimension);
    if (twin_of(c->quantity, twin) && ends_in(twin, si))
        c->quantity = ovr_arena_text(arena, twin, err);
    else if (!ends_in(c->quantity, si) && strcmp(si, "K") != 0)
        return ovr_fail_about(err, "condition",
                              "%s cannot be measured in "
                              "%.40s",
                              c->quantity, at);
    c->target = q.value;
    return c->quantity ? OVR_OK : OVR_NO_MEMORY;
}

static ovr_status fail_form(const char *text, ovr_error *err)
{
    return ovr_fail_about(err, "condition",
                          "'%.80s' must be QUANTITY is VALUE, at most VALUE or "
                          "at least VALUE",
                          text);
}

/* Returns the first word of a condition and its length. */
static const char *first_word(const char *text, size_t *size)
{
    const char *at = text + strspn(text, " \t");
    *size = strcspn(at, " \t<=>");
    return at;
}

const char *ovr_comparison_quantity(const char *text, ovr_arena *arena,
                                    ovr_error *err)
{
    size_t size;
    const char *at = first_word(text, &size);
    char *quantity = ovr_arena_take(arena, size + 1, 1, err);
    if (!quantity)
        return NULL;
    memcpy(quantity, at, size);
    if (size)
        return quantity;
    fail_form(text, err);
    return NULL;
}

ovr_status ovr_comparison_read(const char *text, ovr_comparison *c,
                               ovr_arena *arena, ovr_error *err)
{
    size_t size;
    const char *at = first_word(text, &size) + size;
    c->quantity = ovr_comparison_quantity(text, arena, err);
    if (!c->quantity)
        return OVR_BAD_INPUT;
    if (!read_relation(&at, &c->sense))
        return fail_form(text, err);
    return read_target(c, at + strspn(at, " \t"), arena, err);
}
