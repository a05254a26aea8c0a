/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Settings of a case and access to its entries. Storage is in blocks.c, reading
 * of files in case_file.c, evaluation in resolve.c. */
#include "case/case.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/error.h"
#include "base/given.h"
#include "base/text.h"
#include "case/inputs.h"
#include "case/resolve.h"

/* --------------------------------------------------------------- settings */

/* "section.key" split at its last point. */
typedef struct place {
    ovr_slot *slot; /* NULL: no such key */
    const ovr_parameter *row;
} place;

static place find_place(ovr_case *c, const char *where, ovr_error *err)
{
    const char *point = strrchr(where, '.'), *name;
    const ovr_section *section;
    ovr_block *block;
    place at = {0};
    char header[OVR_NAME_MAX + 2];
    if (!point || point == where || !point[1]) {
        ovr_fail(err, OVR_BAD_INPUT,
                 "'%.60s' must be section.key, such as contact.M", where);
        return at;
    }
    snprintf(header, sizeof header, "%.*s", (int)(point - where), where);
    section = ovr_section_parse(header, &name, err);
    if (!section)
        return at;
    if (!ovr_parameter_find(section, point + 1)) {
        ovr_no_key(section, point + 1, err);
        return at;
    }
    block = ovr_case_block(c, section, name, err);
    if (block)
        at.slot = ovr_block_slot(block, point + 1, &at.row, err);
    return at;
}

/* True if a text, written into a case, is read again unchanged. */
static bool is_readable(const char *text)
{
    for (const char *p = text; *p; p++) {
        bool first = p == text || p[-1] == ' ' || p[-1] == '\t';
        if (*p == '#' || (*p == ';' && first) ||
            ((unsigned char)*p < ' ' && *p != '\t'))
            return false;
    }
    return true;
}

static const char *trimmed(const char *value, ovr_arena *arena, ovr_error *err)
{
    ovr_line line = ovr_trim((ovr_line){value, strlen(value), 0});
    char *copy = ovr_arena_take(arena, line.size + 1, 1, err);
    if (copy)
        memcpy(copy, line.text, line.size);
    return copy;
}

/* Clears the other key of the same quantity: viscosity and alpha are keys of
 * [contact] and of [lubricant], and the later setting is used. */
static void unset_other_name(ovr_case *c, const ovr_parameter *row)
{
    static const char *const sections[] = {"contact", "lubricant"};
    const ovr_parameter *same[2];
    char where[128];
    for (int k = 0; k < 2; k++)
        same[k] = ovr_parameter_find(ovr_section_find(sections[k]), row->key);
    for (int k = 0; k < 2 && same[0] && same[1]; k++)
        if (same[k] == row && same[0]->place == same[1]->place) {
            snprintf(where, sizeof where, "%s.%s", sections[1 - k], row->key);
            ovr_case_unset(c, where);
        }
}

ovr_status ovr_case_set(ovr_case *c, const char *where, const char *value,
                        const char *origin, ovr_error *err)
{
    if (!where)
        return ovr_fail_null(err, __func__);
    ovr_error why = {0};
    place at = find_place(c, where, &why);
    const ovr_parameter *row = at.row;
    ovr_slot fresh;
    if (!at.slot)
        return ovr_fail_from(err, &why, origin, 0);
    if (strlen(value) > OVR_LINE_MAX - OVR_NAME_MAX)
        return ovr_fail_about(err, row->key, "%s: %s: the value is too long",
                              origin, row->key);
    if (!is_readable(value))
        return ovr_fail_about(
            err, row->key,
            "%s: %s: the value must not contain #, a ; after a blank (these "
            "begin comments) or control characters",
            origin, row->key);
    value = trimmed(value, &c->arena, err);
    if (!value)
        return OVR_NO_MEMORY;
    if (ovr_slot_read(row, value, &c->arena, &fresh, &why))
        return ovr_fail_from(err, &why, origin, 0);
    fresh.given = true;
    fresh.line = 0;
    fresh.file = ovr_arena_text(&c->arena, origin, err);
    if (!fresh.file)
        return OVR_NO_MEMORY;
    fresh.replaces = at.slot->replaces ? at.slot->replaces : at.slot->line;
    *at.slot = fresh;
    unset_other_name(c, row);
    return OVR_OK;
}

ovr_status ovr_case_assign(ovr_case *c, const char *assignment,
                           const char *origin, ovr_error *err)
{
    if (!assignment)
        return ovr_fail_null(err, __func__);
    const char *equals = strchr(assignment, '=');
    char where[2 * OVR_NAME_MAX + 2], value[OVR_LINE_MAX + 1];
    ovr_line left, right;
    if (!equals)
        equals = assignment;
    left = ovr_trim((ovr_line){assignment, (size_t)(equals - assignment), 0});
    right = (ovr_line){equals + 1, *equals ? strlen(equals + 1) : 0, 0};
    right = ovr_trim(right);
    if (!left.size || left.size >= sizeof where || right.size >= sizeof value)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "%s: '%.60s' must be section.key=value", origin,
                        assignment);
    snprintf(where, sizeof where, "%.*s", (int)left.size, left.text);
    snprintf(value, sizeof value, "%.*s", (int)right.size, right.text);
    return ovr_case_set(c, where, value, origin, err);
}

void ovr_case_unset(ovr_case *c, const char *where)
{
    if (!where)
        return;
    place at = find_place(c, where, NULL);
    ovr_slot fresh;
    if (!at.slot)
        return;
    fresh = (ovr_slot){.key = at.row->key, .number = NAN};
    if (at.row->initial &&
        ovr_slot_read(at.row, at.row->initial, &c->arena, &fresh, NULL))
        return;
    fresh.replaces = at.slot->replaces ? at.slot->replaces : at.slot->line;
    *at.slot = fresh;
}

/* ----------------------------------------------------------------- access */

const char *ovr_case_name(const ovr_case *c)
{
    if (!c)
        return NULL;
    return c->name;
}

const char *ovr_case_directory(const ovr_case *c)
{
    if (!c)
        return NULL;
    return c->directory;
}

size_t ovr_case_entries(const ovr_case *c)
{
    if (!c)
        return 0;
    size_t n = 0;
    for (const ovr_block *b = c->blocks; b; b = b->next)
        n += b->count;
    return n;
}

ovr_case_entry ovr_case_entry_at(const ovr_case *c, size_t k)
{
    ovr_case_entry entry = {0};
    const ovr_block *b = c ? c->blocks : NULL;
    while (b && k >= b->count) {
        k -= b->count;
        b = b->next;
    }
    if (b) {
        const ovr_slot *slot = &b->slots[k];
        const ovr_parameter *row = &b->section->rows[k];
        entry.section = b->section->name;
        entry.name = b->name;
        entry.key = row->key;
        entry.text = slot->text;
        entry.given = slot->given;
        entry.file = slot->file;
        entry.line = slot->line;
        entry.number = slot->number;
        if (slot->unit)
            entry.unit = ovr_unit_si(ovr_unit_dimension(slot->unit));
        entry.parameter = b->first + k;
        entry.applies = ovr_key_applies(c, b, row);
    }
    return entry;
}

/* Compares names; points and blanks are equal. */
static bool is_same(const char *name, const char *where, size_t length)
{
    if (strlen(name) != length)
        return false;
    for (size_t k = 0; k < length; k++)
        if (name[k] != (where[k] == ' ' ? '.' : where[k]))
            return false;
    return true;
}

bool ovr_entry_is(const ovr_case_entry *entry, const char *where, size_t length)
{
    char name[300];
    snprintf(name, sizeof name, "%s%s%s.%s", entry->section,
             entry->name ? "." : "", entry->name ? entry->name : "",
             entry->key);
    return is_same(name, where, length);
}

/* ------------------------------------------------------------------ filling */

/* Stores the values of a block in the struct that its rows refer to, in the
 * units of the contact. Adds the place of a key to errors. */

/* ------------------------------------------------------- places of errors */

static const ovr_slot *given_slot(const ovr_block *block, const char *key)
{
    for (size_t k = 0; block && key && k < block->count; k++)
        if (block->slots[k].given && !strcmp(block->slots[k].key, key))
            return &block->slots[k];
    return NULL;
}

ovr_status ovr_fail_in(ovr_error *err, const ovr_case *c,
                       const ovr_block *block, const ovr_block *other,
                       const ovr_error *why)
{
    const ovr_slot *slot = given_slot(block, why->about);
    if (!slot)
        slot = given_slot(other, why->about);
    return slot ? ovr_fail_from(err, why, slot->file, slot->line)
                : ovr_fail_from(err, why, c->name, block->line);
}

/* --------------------------------------------------------------- scaling */

static double scale_of(const ovr_contact *contact, ovr_hertzian hertzian)
{
    switch (hertzian) {
    case OVR_NOT_HERTZIAN: break;
    case OVR_IN_B: return contact->b;
    case OVR_IN_HEIGHT: return contact->height;
    case OVR_IN_TIME: return contact->time;
    case OVR_IN_PRESSURE: return contact->ph;
    case OVR_IN_AREA: return contact->b * contact->height;
    }
    return 1;
}

static ovr_status no_scale(const ovr_parameter *row, const ovr_slot *slot,
                           ovr_error *err)
{
    const char *add = row->hertzian == OVR_IN_TIME
                          ? "radius, modulus and viscosity (or speeds)"
                          : "radius and modulus";
    return ovr_fail_slot(err, slot,
                         "%s needs a contact with dimensions; set %s (and "
                         "alpha), or write the number in %s without a unit",
                         slot->text, add, ovr_hertzian_name(row->hertzian));
}

/* Converts the number of a slot to Hertzian units and checks its range. */
static ovr_status scale(const ovr_resolved *r, const ovr_parameter *row,
                        const ovr_slot *slot, double *number, ovr_error *err)
{
    double unit = scale_of(&r->contact, row->hertzian);
    ovr_error why = {0};
    if (!slot->unit || !row->hertzian)
        return OVR_OK;
    if (unit == 0) /* defines the contact, so the unit is not known yet */
        return OVR_OK;
    if (isnan(unit))
        return no_scale(row, slot, err);
    *number /= unit;
    if (ovr_range_check(row, *number, slot->text, &why))
        return ovr_fail_slot(err, slot, "%.400s; it is %g %s", why.message,
                             *number, ovr_hertzian_name(row->hertzian));
    return OVR_OK;
}

static ovr_status fill_list(ovr_resolved *r, const ovr_parameter *row,
                            const ovr_slot *slot, ovr_list *list,
                            ovr_error *err)
{
    size_t n = slot->list.count;
    double *values = ovr_arena_take(&r->arena, n, sizeof *values, err);
    if (!values)
        return OVR_NO_MEMORY;
    for (size_t i = 0; i < n; i++) {
        values[i] = slot->list.values[i];
        if (scale(r, row, slot, &values[i], err))
            return OVR_BAD_INPUT;
    }
    *list = (ovr_list){n, values};
    return OVR_OK;
}

/* ---------------------------------------------------------------- filling */

static ovr_status fill(ovr_resolved *r, const ovr_parameter *row,
                       const ovr_slot *slot, void *to, ovr_error *err)
{
    double number = slot->number;
    switch (row->kind) {
    case OVR_NUMBER:
        if (!slot->word && scale(r, row, slot, &number, err))
            return OVR_BAD_INPUT;
        *(double *)to = number;
        break;
    case OVR_INTEGER:
    case OVR_CHOICE: *(int *)to = (int)number; break;
    case OVR_FLAG: *(bool *)to = number != 0; break;
    case OVR_TEXT:
        *(const char **)to = ovr_arena_text(&r->arena, slot->text, err);
        return *(const char **)to ? OVR_OK : OVR_NO_MEMORY;
    case OVR_PATH:
        *(const char **)to = ovr_slot_path(r->c, slot, &r->arena, err);
        return *(const char **)to ? OVR_OK : OVR_NO_MEMORY;
    case OVR_NUMBERS: return fill_list(r, row, slot, to, err);
    case OVR_WORDS: *(unsigned *)to = slot->bits; break;
    }
    return OVR_OK;
}

ovr_status ovr_block_fill(ovr_resolved *r, const ovr_block *block, void *into,
                          ovr_error *err)
{
    for (size_t k = 0; k < block->count; k++) {
        const ovr_parameter *row = &block->section->rows[k];
        const ovr_slot *slot = &block->slots[k];
        ovr_status status;
        if (!slot->text)
            continue;
        status = fill(r, row, slot, (char *)into + row->place, err);
        if (status)
            return status;
    }
    return OVR_OK;
}

const ovr_block *ovr_block_of(const ovr_resolved *r, const char *section)
{
    return ovr_case_find_block(r->c, section, NULL);
}

const ovr_slot *ovr_slot_of(const ovr_resolved *r, const char *section,
                            const char *key)
{
    return ovr_block_get(ovr_block_of(r, section), key);
}

ovr_status ovr_section_fill(ovr_resolved *r, const char *section,
                            ovr_error *err)
{
    return ovr_block_fill(r, ovr_block_of(r, section), &r->values, err);
}
