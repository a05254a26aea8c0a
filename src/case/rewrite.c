/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A case of an earlier version in today's words: every line stays, but for keys
 * that have moved to another section or have another name, and keys that are
 * refused today because they have no effect.  Defaults that have changed are
 * added as comments with the value that they had, so that who wants the numbers
 * of then has to take away a sign only.
 */
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "base/given.h"
#include "case/case.h"
#include "contact/reversal.h"

/* A default that is another one today. */
typedef struct changed_default {
    const char *since, *section, *key;
    const char *then;    /* its value before */
    const char *when;    /* it mattered (base/parameter.h); NULL: always */
    const char *changes; /* what that changes */
} changed_default;

static const changed_default changed_defaults[] = {
    {"0.3.0", "domain", "outlet", "1.5", NULL,
     "it follows the load: pressures of contacts above 2.25 times their "
     "nominal "
     "load were up to 1.6 times too large"},
    {"0.3.0", "domain", "level", "8", "time.end",
     "the first on which both films and the friction are expected to be right "
     "to 1e-3, mostly 6 or 7: a third to a tenth of the time"},
    {"0.3.0", "domain", "faces", "arithmetic", NULL,
     "central film at level 8: off by 2.5e-4 before, 5e-5 today (M = 20, "
     "L = 10)"},
    {"0.3.0", "domain", "order", "2", "heat.model = lobatto",
     "fourth order with heat too: an Eyring film of 1.16 GPa off by 1.7e-4 "
     "before, 1e-5 today (level 7)"},
    {"0.3.0", "heat", "points", "5", "model = lobatto",
     "7 where they are needed: 1.5 % of the film, .8 % of friction at 1.2 GPa"},
    {"0.3.0", "time", "step", "grid", "end",
     "steps of two meshes where they cost no accuracy: .6 of the time"},
    {"0.3.0", "time", "scheme", "upstream2",
     "load.history = ramp | step | sine | table or speed.history = ramp | step "
     "| sine | table or radius.history = ramp | step | sine | table or "
     "cavitation.model = conserving or heat.model = lobatto",
     "the characteristic scheme under histories and with mass-conserving "
     "cavitation too: "
     "film under a ramp of load off by 1.3e-3 before, 7e-6 today, starved in "
     "a dent 6e-3 and 3e-4 (level 7)"},
};

/* The lines go here. */
typedef struct lines {
    ovr_case_line *put;
    void *data;
} lines;

static void write_line(const lines *to, const char *format, ...)
    OVR_PRINTF(2, 3);
static void write_line(const lines *to, const char *format, ...)
{
    char text[2 * OVR_LINE_MAX + 600];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    to->put(to->data, text);
}

/* The given key whose line of the file this is. */
static const ovr_slot *slot_of_line(const ovr_case *c, long line,
                                    const ovr_block **block)
{
    for (*block = c->blocks; *block; *block = (*block)->next)
        for (size_t k = 0; k < (*block)->count; k++)
            if ((*block)->slots[k].given && (*block)->slots[k].line == line)
                return &(*block)->slots[k];
    return NULL;
}

static void put_header(const lines *to, const ovr_block *b)
{
    write_line(to, "[%s%s%s]", b->section->name, b->name ? " " : "",
               b->name ? b->name : "");
}

/* Keys that other sections held. */
static size_t put_moved(const lines *to, const ovr_block *b, bool count_only)
{
    size_t moved = 0;
    for (size_t k = 0; k < b->count; k++)
        if (b->slots[k].given && b->slots[k].before) {
            moved++;
            if (!count_only)
                write_line(to, "%s = %s    # stood in [%s]", b->slots[k].key,
                           b->slots[k].text, b->slots[k].before);
        }
    return moved;
}

/* Where speed reverses the domain has always ended as far away as it begins.
 * Of a case that is refused today nothing is known. */
static bool reverses(const ovr_case *c)
{
    ovr_error err = {0};
    ovr_setup *setup = ovr_case_resolve(c, NULL, &err);
    bool is_so = setup && ovr_history_reverses(setup->speed);
    ovr_setup_free(setup);
    return is_so;
}

static bool is_changed(const ovr_case *c, const ovr_block *b,
                       const changed_default *d)
{
    return !strcmp(d->section, b->section->name) &&
           !ovr_block_get(b, d->key)->given &&
           (!d->when || ovr_conditions_hold(c, b, d->when)) &&
           (strcmp(d->key, "outlet") != 0 || !reverses(c));
}

/* Defaults of the section that have changed. */
static size_t put_changed(const lines *to, const ovr_case *c,
                          const ovr_block *b, bool count_only)
{
    size_t count = sizeof changed_defaults / sizeof *changed_defaults;
    size_t changed = 0;
    for (size_t k = 0; k < count; k++) {
        const changed_default *d = &changed_defaults[k];
        if (!is_changed(c, b, d))
            continue;
        changed++;
        if (!count_only)
            write_line(to,
                       "# %s = %s    # was the default before %s; now %s: %s",
                       d->key, d->then, d->since,
                       ovr_block_get(b, d->key)->text, d->changes);
    }
    return changed;
}

/* The key is the first word of its line; what follows stays as it is. */
static void put_renamed(const lines *to, const ovr_slot *slot, const char *text,
                        int length)
{
    int blanks = (int)strspn(text, " \t");
    int after = blanks + (int)strlen(slot->once);
    write_line(to, "%.*s%s%.*s    # was called %s", blanks, text, slot->key,
               length - after, text + after, slot->once);
}

/* A line of the file as it would be written today. */
static void put_line(const lines *to, const ovr_case *c, long number,
                     const char *text, int length)
{
    const ovr_block *b;
    const ovr_slot *slot = slot_of_line(c, number, &b);
    ovr_idle idle;
    if (slot && slot->before)
        write_line(to, "# %.*s    # stands in [%s] now", length, text,
                   b->section->name);
    else if (slot && slot->once)
        put_renamed(to, slot, text, length);
    else if (slot && ovr_key_idle(c, b, slot, &idle) && !idle.said)
        write_line(to, "# %.*s    # %s", length, text, idle.text);
    else
        write_line(to, "%.*s", length, text);
}

static void put_source(const lines *to, const ovr_case *c)
{
    const char *at = c->source;
    for (long number = 1; *at; number++) {
        size_t length = strcspn(at, "\r\n");
        put_line(to, c, number, at, (int)length);
        for (const ovr_block *b = c->blocks; b; b = b->next)
            if (b->line == number) {
                put_moved(to, b, false);
                put_changed(to, c, b, false);
            }
        at += length;
        at += *at == '\r';
        at += *at == '\n';
    }
}

/* Puts what belongs to sections of which the file has none. */
static void put_missing(const lines *to, const ovr_case *c)
{
    for (const ovr_block *b = c->blocks; b; b = b->next)
        if (!b->line &&
            put_moved(to, b, true) + put_changed(to, c, b, true) > 0) {
            write_line(to, "%s", "");
            put_header(to, b);
            put_moved(to, b, false);
            put_changed(to, c, b, false);
        }
}

ovr_status ovr_case_rewrite(const ovr_case *c, ovr_case_line *put, void *data,
                            ovr_error *err)
{
    if (!c || !put)
        return ovr_fail_null(err, __func__);
    const lines to = {put, data};
    if (c->source)
        put_source(&to, c);
    put_missing(&to, c);
    return OVR_OK;
}
