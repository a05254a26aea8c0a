/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "run/comparison.h"

#include <stdio.h>
#include <string.h>

#include "base/error.h"
#include "base/quantity.h"
#include "overroll/simulation.h"

/* "at most", "<=" and so on at *text, which moves behind it. */
static bool read_relation(const char **text, int *sense)
{
    static const struct {
        const char *words;
        int sense;
    } forms[] = {{"is ", 0}, {"== ", 0},       {"= ", 0},   {"at least ", 1},
                 {">= ", 1}, {"at most ", -1}, {"<= ", -1}, {"==", 0},
                 {"=", 0},   {">=", 1},        {"<=", -1}};
    *text += strspn(*text, " \t");
    for (size_t k = 0; k < sizeof forms / sizeof *forms; k++)
        if (!strncmp(*text, forms[k].words, strlen(forms[k].words))) {
            *text += strlen(forms[k].words);
            *sense = forms[k].sense;
            return true;
        }
    return false;
}

/* The number of runs in SI that a quantity in Hertzian units has beside it,
 * into `buffer`; false: none. */
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

/* "minimum film thickness over the run" */
static void name_extreme(const ovr_extreme *e, char *text, size_t size)
{
    const ovr_observable *row = e->of;
    const char *label = row->extreme_label, *before = "", *after = "";
    if (e->part == OVR_KEPT_MEAN) {
        label = row->mean_label;
        before = label ? "" : "mean ";
    } else if (!label) {
        before = row->extreme == OVR_SMALLEST ? "smallest " : "largest ";
    }
    if (e->part == OVR_KEPT_PLACE)
        after = ": position";
    else if (e->part == OVR_KEPT_TIME)
        after = ": time";
    snprintf(text, size, "%s%s over the run%s", before,
             label ? label : row->long_name, after);
}

/* Unit of a dimensionless number of this kind. */
static const char *bare_unit(ovr_unit_kind kind)
{
    switch (kind) {
    case OVR_KIND_LENGTH: return "b";
    case OVR_KIND_HEIGHT: return "b^2/R";
    case OVR_KIND_PRESSURE: return "p_h";
    case OVR_KIND_TIME: return "b/u_m";
    default: return "";
    }
}

ovr_quantity_name ovr_quantity_named(const char *key)
{
    ovr_quantity_name name = {.unit = ""};
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
            name_extreme(&e, name.text, sizeof name.text);
            if (!strcmp(key, e.key))
                name.unit = bare_unit(e.kind);
            return name;
        }
    snprintf(name.text, sizeof name.text, "%.199s", key);
    return name;
}

/* "N/m" stands as "_N_per_m" at the end of a key, "1/Pa" as "_per_Pa". */
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

/* A unit makes the target SI, and picks the quantity that is in it. */
static ovr_status take_target(ovr_comparison *c, const char *text,
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

ovr_status ovr_comparison_read(const char *text, ovr_comparison *c,
                               ovr_arena *arena, ovr_error *err)
{
    const char *at = text + strspn(text, " \t");
    size_t size = strcspn(at, " \t<=>");
    char *quantity = ovr_arena_take(arena, size + 1, 1, err);
    if (!quantity)
        return OVR_NO_MEMORY;
    memcpy(quantity, at, size);
    c->quantity = quantity;
    at += size;
    if (!size || !read_relation(&at, &c->sense))
        return ovr_fail_about(
            err, "condition",
            "'%.80s' must be QUANTITY is VALUE, at most VALUE "
            "or at least VALUE",
            text);
    return take_target(c, at + strspn(at, " \t"), arena, err);
}
