/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reading a study: its keys name those of the case. */
#include "run/study.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/entries.h"
#include "base/error.h"
#include "base/given.h"
#include "base/text.h"
#include "case/parameters.h"
#include "overroll/text.h"

enum { LINE_MAX = 65534, STUDY_MAX = 1 << 22 };

enum section { NO_SECTION, STUDY, SET, PRODUCT, ZIP, FIND, RANDOM, LIMITS };

typedef struct reading {
    ovr_study *s;
    long line;
    enum section section;
    int zips;
    const char *zip_name;
    const char *table; /* of [random file TABLE]; or NULL */
    ovr_error *err;
} reading;

static ovr_status fail(reading *r, const char *what, const char *about)
{
    return ovr_fail_at(r->err, OVR_BAD_INPUT, r->s->path, r->line, what, about);
}

/* ------------------------------------------------------------------ lines */

static const char *path_of(reading *r, const char *value)
{
    return ovr_study_path(r->s, value, r->err);
}

/* [random], or [random file TABLE]. */
static ovr_status open_random(reading *r)
{
    const char *rest = r->zip_name;
    r->table = NULL;
    if (!*rest)
        return OVR_OK;
    if (strncmp(rest, "file ", 5) != 0)
        return fail(r, "[random %.60s]: must be [random] or [random file FILE]",
                    rest);
    rest += 5 + strspn(rest + 5, " \t");
    return (r->table = path_of(r, rest)) ? OVR_OK : OVR_NO_MEMORY;
}

static ovr_status open_section(reading *r, const char *header)
{
    static const char *const names[] = {"study", "set",    "product", "zip",
                                        "find",  "random", "limits"};
    enum { NAMES = sizeof names / sizeof *names };
    const ovr_study_words words = {"", names, NAMES, ""};
    char name[64];
    snprintf(name, sizeof name, "%.*s", (int)strcspn(header, " \t"), header);
    for (int i = 0; i < NAMES; i++)
        if (!strcmp(name, names[i])) {
            r->section = (enum section)(i + 1);
            r->zips += r->section == ZIP;
            header += strlen(name);
            r->zip_name = ovr_arena_text(
                &r->s->arena, header + strspn(header, " \t"), r->err);
            if (!r->zip_name)
                return OVR_NO_MEMORY;
            return r->section == RANDOM ? open_random(r) : OVR_OK;
        }
    if (ovr_section_find(name))
        return fail(r,
                    "[%s] belongs in a case: this is one, not a study; "
                    "'overroll run' runs it",
                    name);
    return ovr_study_unknown(r->s, &words, name, r->line, r->err);
}

static ovr_status take_setting(reading *r, const char *key, const char *value)
{
    static const char *const names[] = {"case", "output", "results"};
    const ovr_study_words words = {" in [study]", names, 3, ""};
    if (!strcmp(key, "case"))
        return (r->s->case_path = path_of(r, value)) ? OVR_OK : OVR_NO_MEMORY;
    if (!strcmp(key, "output"))
        return (r->s->output = path_of(r, value)) ? OVR_OK : OVR_NO_MEMORY;
    if (!strcmp(key, "results")) {
        r->s->results = !strcmp(value, "yes");
        return r->s->results || !strcmp(value, "no")
                   ? OVR_OK
                   : fail(r, "results: '%.40s' must be yes or no", value);
    }
    return ovr_study_unknown(r->s, &words, key, r->line, r->err);
}

static ovr_status take_values(reading *r, const char *key, const char *value)
{
    ovr_study *s = r->s;
    ovr_study_key *k = ovr_study_new_key(s, key, r->line, r->err);
    ovr_error why = {0};
    if (!k)
        return OVR_BAD_INPUT;
    k->fixed = r->section == SET;
    k->zip = r->section == ZIP ? r->zips : 0;
    k->zip_name = r->zip_name;
    if (k->fixed) { /* one value, commas and all */
        k->value = ovr_arena_take(&s->arena, 1, sizeof *k->value, r->err);
        if (!k->value)
            return OVR_NO_MEMORY;
        k->value[0] = ovr_arena_text(&s->arena, value, r->err);
        k->count = 1;
    } else if (ovr_study_values(value, &s->arena, &k->value, &k->count, &why)) {
        return ovr_fail_at(r->err, why.status, s->path, r->line, "%s: %.800s",
                           key, why.message);
    }
    return OVR_OK;
}

/* "A, B" */
static ovr_status take_ends(reading *r, const char *value)
{
    ovr_find_options *f = &r->s->find.how;
    char **ends;
    size_t count = 0;
    ovr_error why = {0};
    if (ovr_study_values(value, &r->s->arena, &ends, &count, &why) ||
        count != 2)
        return fail(r, "between: '%.60s' must be two numbers, A, B", value);
    f->low = ends[0];
    f->high = ends[1];
    return OVR_OK;
}

static ovr_status take_find(reading *r, const char *key, const char *value)
{
    static const char *const names[] = {"key", "between", "so_that", "which",
                                        "tolerance"};
    const ovr_study_words words = {" in [find]", names,
                                   sizeof names / sizeof *names, ""};
    ovr_find_options *f = &r->s->find.how;
    const char *at = value, **to = NULL;
    r->s->find.line = r->line;
    if (!strcmp(key, "between"))
        return take_ends(r, value);
    if (!strcmp(key, "tolerance"))
        return ovr_read_number(&at, &f->tolerance) && !*at
                   ? OVR_OK
                   : fail(r, "tolerance: '%.40s' must be a number", value);
    to = !strcmp(key, "key")       ? &f->key
         : !strcmp(key, "so_that") ? &f->condition
         : !strcmp(key, "which")   ? &f->which
                                   : NULL;
    if (to)
        return (*to = ovr_arena_text(&r->s->arena, value, r->err))
                   ? OVR_OK
                   : OVR_NO_MEMORY;
    return ovr_study_unknown(r->s, &words, key, r->line, r->err);
}

/* "min_film_m >= 0.2 um": the entry ends its key before the '='. */
static ovr_status take_limit(reading *r, const char *key, const char *value)
{
    char text[400];
    ovr_error why = {0};
    ovr_study *s = r->s;
    size_t size = strlen(key);
    bool sign = size && strchr("<>", key[size - 1]);
    snprintf(text, sizeof text, "%.180s%s %.180s", key, sign ? "=" : "", value);
    if (s->limits == OVR_STUDY_MAX_LIMITS)
        return fail(r, "'%.60s' is one limit too many: at most 16", key);
    if (!sign && strncmp(value, "at ", 3) != 0)
        return fail(
            r, "'%.100s' must be QUANTITY >= VALUE or QUANTITY <= VALUE", key);
    if (ovr_comparison_read(text, &s->limit[s->limits], &s->arena, &why))
        return fail(r, "%.300s", why.message);
    s->limits++;
    return OVR_OK;
}

static ovr_status take_entry(reading *r, const ovr_entry *entry)
{
    r->line = entry->line;
    if (entry->section)
        return open_section(r, entry->section);
    if (!*entry->value)
        return fail(r, "%.60s: the value is missing", entry->key);
    switch (r->section) {
    case STUDY: return take_setting(r, entry->key, entry->value);
    case FIND: return take_find(r, entry->key, entry->value);
    case RANDOM: return ovr_study_take_random(r->s, entry, r->table, r->err);
    case LIMITS: return take_limit(r, entry->key, entry->value);
    default: return take_values(r, entry->key, entry->value);
    }
}

static ovr_status read_lines(reading *r)
{
    ovr_study *s = r->s;
    ovr_entry entry;
    ovr_entries all = {
        .file = s->path,
        .at = ovr_text_file(s->path, "study", STUDY_MAX, &s->arena, r->err),
        .maximum = LINE_MAX};
    ovr_status status = all.at ? ovr_entries_open(&all, &s->arena, r->err)
                               : r->err->status;
    while (!status && !(status = ovr_entries_next(&all, &entry, r->err)) &&
           entry.line)
        status = take_entry(r, &entry);
    return status;
}

/* ----------------------------------------------------------- combinations */

/* Keys of one zip must have as many values. */
static ovr_status check_zips(ovr_study *s, ovr_error *err)
{
    for (size_t i = 1; i < s->keys; i++) {
        const ovr_study_key *a = &s->key[i - 1], *b = &s->key[i];
        if (b->zip && a->zip == b->zip && a->count != b->count)
            return ovr_fail_at(err, OVR_BAD_INPUT, s->path, b->line,
                               "%s has %zu value%s, %s before it %zu: those of "
                               "a [zip] go together",
                               b->where, b->count, b->count == 1 ? "" : "s",
                               a->where, a->count);
    }
    return OVR_OK;
}

static ovr_status set_strides(ovr_study *s, ovr_error *err)
{
    size_t tasks = 1;
    for (size_t i = s->keys; i-- > 0;) {
        ovr_study_key *k = &s->key[i];
        bool with_next = k->zip && i + 1 < s->keys && k[1].zip == k->zip;
        k->stride = with_next ? k[1].stride : tasks;
        if (with_next)
            continue;
        tasks *= k->count;
        if (tasks > OVR_STUDY_MAX_TASKS)
            return ovr_fail(
                err, OVR_BAD_INPUT,
                "%s: has more than a million cases: give fewer values",
                s->path);
    }
    s->tasks = tasks;
    return OVR_OK;
}

/* ------------------------------------------------------------------ study */

/* Folder of the study, and results in a folder of its name. */
static ovr_status set_places(ovr_study *s, ovr_error *err)
{
    char text[4096];
    const char *slash = strrchr(s->path, '/');
    size_t length = strlen(s->path);
    if (length > 4000)
        return ovr_fail(err, OVR_BAD_INPUT, "the path is too long");
    snprintf(text, sizeof text, "%.*s",
             slash ? (int)(slash - s->path) + (slash == s->path) : 1,
             slash ? s->path : ".");
    s->folder = ovr_arena_text(&s->arena, text, err);
    if (length > 4 && !strcmp(s->path + length - 4, ".ini"))
        snprintf(text, sizeof text, "%.*s", (int)length - 4, s->path);
    else
        snprintf(text, sizeof text, "%s.results", s->path);
    s->output = ovr_arena_text(&s->arena, text, err);
    return s->folder && s->output ? OVR_OK : OVR_NO_MEMORY;
}

/* All of [find] or none of it. */
static ovr_status check_find(const ovr_study *s, ovr_error *err)
{
    const ovr_find_options *f = &s->find.how;
    if (!s->find.line || (f->key && f->low && f->condition))
        return OVR_OK;
    return ovr_fail_at(err, OVR_BAD_INPUT, s->path, s->find.line,
                       "[find]: %s is missing",
                       !f->key   ? "key"
                       : !f->low ? "between"
                                 : "so_that");
}

static ovr_status read_study(ovr_study *s, const char *path, ovr_error *err)
{
    reading r = {.s = s, .err = err};
    s->results = true;
    s->path = ovr_arena_text(&s->arena, path, err);
    if (!s->path || set_places(s, err) || read_lines(&r) ||
        check_find(s, err) || ovr_study_draw_all(s, r.zips + 1, err) ||
        check_zips(s, err) || set_strides(s, err) ||
        ovr_study_name_tasks(s, err))
        return OVR_BAD_INPUT;
    return ovr_study_try_values(s, err) ? OVR_BAD_INPUT
                                        : ovr_study_try_find(s, err);
}

ovr_study *ovr_study_read(const char *path, const ovr_allocator *allocator,
                          ovr_error *err)
{
    if (!path)
        return ovr_null(err, __func__);
    ovr_arena arena = ovr_arena_make(allocator);
    ovr_study *s = ovr_arena_take(&arena, 1, sizeof *s, err);
    if (!s)
        return NULL;
    s->arena = arena;
    if (read_study(s, path, err)) {
        ovr_study_free(s);
        return NULL;
    }
    return s;
}

void ovr_study_free(ovr_study *s)
{
    if (s) {
        ovr_arena arena = s->arena;
        ovr_arena_release(&arena);
    }
}

size_t ovr_study_cases(const ovr_study *s)
{
    return s ? s->tasks : 0;
}

const char *ovr_study_name(const ovr_study *s, size_t k)
{
    if (!s)
        return NULL;
    return s->name[k];
}

const char *ovr_study_output(const ovr_study *s)
{
    return s ? s->output : NULL;
}

ovr_status ovr_study_output_set(ovr_study *s, const char *folder,
                                ovr_error *err)
{
    if (!s || !folder)
        return ovr_fail_null(err, __func__);
    const char *copy = ovr_arena_text(&s->arena, folder, err);
    s->output = copy ? copy : s->output;
    return copy ? OVR_OK : OVR_NO_MEMORY;
}

void ovr_study_file(const ovr_study *s, size_t task, const char *ending,
                    char *path, size_t capacity)
{
    snprintf(path, capacity, "%s/%s%s", s->output, s->name[task], ending);
}
