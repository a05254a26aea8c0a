/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The values of a block into the struct that its rows point into, in the units
 * of the contact; and where errors about them belong. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/error.h"
#include "case/inputs.h"
#include "case/resolve.h"

/* ----------------------------------------------------- where errors belong */

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

/* Hertzian value of a number of the slot, checked against the range. */
static ovr_status scale(const ovr_resolved *r, const ovr_parameter *row,
                        const ovr_slot *slot, double *number, ovr_error *err)
{
    double unit = scale_of(&r->contact, row->hertzian);
    ovr_error why = {0};
    if (!slot->unit || !row->hertzian)
        return OVR_OK;
    if (unit == 0) /* of what makes the contact: it is not known yet */
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
                       const ovr_slot *slot, void *place, ovr_error *err)
{
    double number = slot->number;
    switch (row->kind) {
    case OVR_NUMBER:
        if (!slot->word && scale(r, row, slot, &number, err))
            return OVR_BAD_INPUT;
        *(double *)place = number;
        break;
    case OVR_INTEGER:
    case OVR_CHOICE: *(int *)place = (int)number; break;
    case OVR_FLAG: *(bool *)place = number != 0; break;
    case OVR_TEXT:
        *(const char **)place = ovr_arena_text(&r->arena, slot->text, err);
        return *(const char **)place ? OVR_OK : OVR_NO_MEMORY;
    case OVR_PATH:
        *(const char **)place = ovr_slot_path(r->c, slot, &r->arena, err);
        return *(const char **)place ? OVR_OK : OVR_NO_MEMORY;
    case OVR_NUMBERS: return fill_list(r, row, slot, place, err);
    case OVR_WORDS: *(unsigned *)place = slot->bits; break;
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
