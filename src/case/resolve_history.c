/* SPDX-License-Identifier: GPL-3.0-or-later */
/* [load] and [speed] become histories; tables are read from their files. */
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "case/resolve.h"

enum { TABLE_MOST = 1000000 }; /* points */

static ovr_status missing(ovr_resolved *r, const ovr_block *block,
                          const char *key, ovr_error *err)
{
    const ovr_slot *history = ovr_block_get(block, "history");
    (void)r;
    return ovr_fail_slot(err, history, "%s needs '%s' in [%s]", history->text,
                         key, block->section->name);
}

/* ----------------------------------------------------------------- tables */

typedef struct points {
    double *T, *value;
    size_t count, room;
    double least, most; /* of its values */
} points;

static ovr_status grow(points *p, ovr_arena *arena, ovr_error *err)
{
    size_t room = p->room ? 2 * p->room : 256;
    double *T = ovr_arena_take(arena, room, sizeof *T, err);
    double *value = ovr_arena_take(arena, room, sizeof *value, err);
    if (!T || !value)
        return OVR_NO_MEMORY;
    if (p->count) {
        memcpy(T, p->T, p->count * sizeof *T);
        memcpy(value, p->value, p->count * sizeof *value);
    }
    p->T = T;
    p->value = value;
    p->room = room;
    return OVR_OK;
}

static const char *skip_separators(const char *s)
{
    return s + strspn(s, " \t,;");
}

/* Two numbers, or nothing (a comment or an empty line), or an error. */
static ovr_status read_line(const char *file, long line, char *text, points *p,
                            double unit, ovr_arena *arena, ovr_error *err)
{
    const char *s = skip_separators(text);
    double T, value;
    text[strcspn(text, "#\r\n")] = '\0';
    if (!*s)
        return OVR_OK;
    if (!ovr_read_number(&s, &T) || s == skip_separators(s) ||
        (s = skip_separators(s), !ovr_read_number(&s, &value)) ||
        *skip_separators(s))
        return ovr_fail_at(err, OVR_BAD_INPUT, file, line,
                           "must be two numbers, time and value");
    if (value < p->least || value > p->most)
        return ovr_fail_at(err, OVR_BAD_INPUT, file, line,
                           "value %g must be %g to %g (of the nominal one)",
                           value, p->least, p->most);
    if (p->count == TABLE_MOST)
        return ovr_fail_at(err, OVR_BAD_INPUT, file, line,
                           "more than %d points", TABLE_MOST);
    if (p->count == p->room && grow(p, arena, err))
        return OVR_NO_MEMORY;
    p->T[p->count] = T * unit;
    p->value[p->count++] = value;
    return OVR_OK;
}

static ovr_status read_table(const char *file, const ovr_slot *slot, points *p,
                             double unit, ovr_arena *arena, ovr_error *err)
{
    FILE *in = fopen(file, "r");
    ovr_status status = OVR_OK;
    char text[256];
    if (!in)
        return ovr_fail_slot(err, slot, "cannot read '%s': %s", file,
                             strerror(errno));
    for (long line = 1; !status && fgets(text, sizeof text, in); line++) {
        if (strlen(text) == sizeof text - 1)
            status = ovr_fail_at(err, OVR_BAD_INPUT, file, line,
                                 "the line is too long");
        else
            status = read_line(file, line, text, p, unit, arena, err);
    }
    if (!status && ferror(in))
        status = ovr_fail_slot(err, slot, "cannot read '%s'", file);
    fclose(in);
    return status;
}

/* b/um for one unit of the table's times. */
static ovr_status time_unit(const ovr_resolved *r, const ovr_block *block,
                            int unit, double *value, ovr_error *err)
{
    static const double seconds[] = {1, 1, 1e-3, 1e-6};
    *value = unit ? seconds[unit] / r->contact.time : 1;
    if (!isnan(*value))
        return OVR_OK;
    return ovr_fail_slot(err, ovr_block_get(block, "time_unit"),
                         "needs a physical contact: add radius, "
                         "modulus and viscosity (or speeds)");
}

static ovr_status load_table(ovr_resolved *r, const ovr_block *block,
                             const ovr_change *change, ovr_history_form *form,
                             ovr_error *err)
{
    const ovr_parameter *to = ovr_parameter_find(block->section, "to");
    points p = {.least = to->least, .most = to->most};
    double unit;
    ovr_status status;
    if (!change->file)
        return missing(r, block, "file", err);
    if (time_unit(r, block, change->time_unit, &unit, err))
        return OVR_BAD_INPUT;
    status = read_table(change->file, ovr_block_get(block, "file"), &p, unit,
                        &r->arena, err);
    form->points = p.count;
    form->T = p.T;
    form->value = p.value;
    return status;
}

/* -------------------------------------------------------------------- all */

/* It begins, swings about and ends at the slide_to_roll of the contact. */
static void of_sliding(const ovr_resolved *r, ovr_history_form *form)
{
    form->mean = r->contact.u1_ratio - r->contact.u2_ratio;
    if (isnan(form->from))
        form->from = form->mean;
    if (isnan(form->to))
        form->to = form->mean;
}

ovr_status ovr_resolve_history(ovr_resolved *r, const char *section,
                               const ovr_change *change,
                               const ovr_allocator *allocator,
                               ovr_history **history, ovr_error *err)
{
    const ovr_block *block = ovr_case_find_block(r->c, section, NULL);
    ovr_history_form form = ovr_history_form_default();
    ovr_error why = {0};
    form.kind = (ovr_history_kind)change->history;
    form.from = change->from;
    form.to = change->to;
    form.start = change->start;
    form.duration = change->duration;
    form.amplitude = change->amplitude;
    form.period = change->period;
    if (strcmp(section, "sliding") == 0)
        of_sliding(r, &form);
    if (strcmp(section, "speed") == 0)
        form.mean = change->mean;
    if (form.kind == OVR_HISTORY_CONSTANT)
        return OVR_OK;
    if (form.kind == OVR_HISTORY_SINE && !ovr_block_get(block, "period")->given)
        return missing(r, block, "period", err);
    if (form.kind == OVR_HISTORY_TABLE) {
        ovr_status status = load_table(r, block, change, &form, err);
        if (status)
            return status;
    }
    *history = ovr_history_create(&form, allocator, &why);
    return *history ? OVR_OK : ovr_fail_in(err, r->c, block, NULL, &why);
}
