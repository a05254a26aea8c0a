/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The cases of a study: what they are called, and the case of each. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/error.h"
#include "base/given.h"
#include "overroll/questions.h"
#include "run/run.h"
#include "run/study.h"

enum { NAME_MAX = 120 };

const char *ovr_study_value(const ovr_study *s, const ovr_study_key *key,
                            size_t task)
{
    (void)s;
    return key->value[(task / key->stride) % key->count];
}

/* The draw of a task, from 0; the cases of one draw differ in keys that are not
 * random. */
static size_t draw_of(const ovr_study *s, size_t task)
{
    return s->random.how.draws ? task % s->random.how.draws : 0;
}

/* ------------------------------------------------------------------ names */

static bool same_end(const char *where, const char *end)
{
    size_t n = strlen(where), m = strlen(end);
    return n > m && !strcmp(where + n - m, end) && where[n - m - 1] == '.';
}

/* The last parts of section.key that no other key ends with. */
static const char *short_name(const ovr_study *s, const char *where)
{
    const char *end = where + strlen(where);
    while (end > where) {
        int others = 0;
        while (end > where && *--end != '.')
            ;
        end += *end == '.';
        for (size_t i = 0; i < s->keys; i++)
            others += same_end(s->key[i].where, end);
        if (others < 2)
            return end;
        end--;
    }
    return where;
}

/* Keeps what is safe in a file name; blanks go, the rest becomes '~'. */
static size_t put_safe(char *to, size_t capacity, const char *text)
{
    size_t n = 0;
    for (; *text && n + 1 < capacity; text++) {
        bool plain = strchr("+-.=_", *text) || (*text >= '0' && *text <= '9') ||
                     (*text >= 'A' && *text <= 'Z') ||
                     (*text >= 'a' && *text <= 'z');
        if (*text != ' ' && *text != '\t')
            to[n++] = plain ? *text : '~';
    }
    to[n] = '\0';
    return n;
}

/* FNV-1a, 32 bits (Fowler, Noll & Vo). */
static unsigned hash(const char *text)
{
    unsigned h = 2166136261u;
    for (; *text; text++)
        h = (h ^ (unsigned char)*text) * 16777619u;
    return h;
}

static char *task_name(ovr_study *s, size_t task, ovr_error *err)
{
    char name[8192];
    size_t n = 0;
    name[0] = '\0';
    for (size_t i = 0; i < s->keys && n < sizeof name - 300; i++) {
        char part[300];
        if (s->key[i].fixed || s->key[i].random)
            continue;
        snprintf(part, sizeof part, "%s%s=%s", n ? "_" : "", s->key[i].shown,
                 ovr_study_value(s, &s->key[i], task));
        n += put_safe(name + n, sizeof name - n, part);
    }
    if (n > NAME_MAX) {
        snprintf(name + NAME_MAX - 9, 10, "-%08x", hash(name));
        n = NAME_MAX;
    }
    if (s->random.how.draws)
        snprintf(name + n, sizeof name - n, "%sdraw-%04zu", n ? "_" : "",
                 draw_of(s, task) + 1);
    return ovr_arena_text(&s->arena, *name ? name : "case", err);
}

static int by_name(const void *a, const void *b)
{
    return strcmp(*(char *const *)a, *(char *const *)b);
}

static ovr_status check_names(ovr_study *s, ovr_error *err)
{
    char **sorted = ovr_arena_take(&s->arena, s->tasks, sizeof *sorted, err);
    ovr_status status = OVR_OK;
    if (!sorted)
        return OVR_NO_MEMORY;
    memcpy(sorted, s->name, s->tasks * sizeof *sorted);
    qsort(sorted, s->tasks, sizeof *sorted, by_name);
    for (size_t i = 1; !status && i < s->tasks; i++)
        if (!strcmp(sorted[i - 1], sorted[i]))
            status = ovr_fail(err, OVR_BAD_INPUT,
                              "%s: the case %.200s is there twice", s->path,
                              sorted[i]);
    return status;
}

ovr_status ovr_study_name_tasks(ovr_study *s, ovr_error *err)
{
    for (size_t i = 0; i < s->keys; i++)
        s->key[i].shown = short_name(s, s->key[i].where);
    s->name = ovr_arena_take(&s->arena, s->tasks, sizeof *s->name, err);
    if (!s->name)
        return OVR_NO_MEMORY;
    for (size_t i = 0; i < s->tasks; i++) {
        s->name[i] = task_name(s, i, err);
        if (!s->name[i])
            return OVR_NO_MEMORY;
    }
    return check_names(s, err);
}

/* ------------------------------------------------------------------ cases */

static ovr_case *base_case(const ovr_study *s, ovr_error *err)
{
    if (s->case_path)
        return ovr_case_read(s->case_path, NULL, err);
    return ovr_case_read_text("", s->path, s->folder, NULL, err);
}

static ovr_status put(const ovr_study *s, const ovr_study_key *k,
                      const char *value, ovr_case *c, ovr_error *err)
{
    char origin[300];
    snprintf(origin, sizeof origin, "%.280s:%ld", s->path, k->line);
    return ovr_case_set(c, k->where, value, origin, err);
}

ovr_case *ovr_study_case(const ovr_study *s, size_t task, ovr_error *err)
{
    if (!s)
        return ovr_null(err, __func__);
    ovr_case *c = base_case(s, err);
    ovr_status status = OVR_OK;
    for (size_t i = 0; c && !status && i < s->keys; i++)
        status = put(s, &s->key[i], ovr_study_value(s, &s->key[i], task), c,
                     err);
    if (status) {
        ovr_case_free(c);
        return NULL;
    }
    if (c)
        ovr_case_unset(c, "output.file"); /* its place is the study's */
    return c;
}

/* A draw that the case does not take: which, and what may be done. */
static ovr_status bad_draw(const ovr_study *s, const ovr_study_key *k, size_t v,
                           const ovr_error *why, ovr_error *err)
{
    const char *what = why->message + why->file;
    what += strspn(what, ":0123456789 ");
    return ovr_fail_at(err, OVR_BAD_INPUT, s->path, k->line,
                       "draw %zu of %s is %.60s: %.500s; use lognormal or "
                       "within",
                       v + 1, k->where, k->value[v], what);
}

/* Every value once, so that what is wrong is known before anything runs. */
ovr_status ovr_study_try_values(const ovr_study *s, ovr_error *err)
{
    ovr_case *c = base_case(s, err);
    ovr_status status = c ? OVR_OK : OVR_BAD_INPUT;
    for (size_t i = 0; !status && i < s->keys; i++)
        for (size_t v = 0; !status && v < s->key[i].count; v++) {
            ovr_error why = {0};
            status = put(s, &s->key[i], s->key[i].value[v], c,
                         s->key[i].random ? &why : err);
            if (status && s->key[i].random)
                bad_draw(s, &s->key[i], v, &why, err);
        }
    ovr_case_free(c);
    return status;
}

/* Tries what [find] asks, of the first case. */
ovr_status ovr_study_try_find(const ovr_study *s, ovr_error *err)
{
    const ovr_find_options *how = &s->find.how;
    ovr_error why = {0};
    ovr_case *c = how->key ? ovr_study_case(s, 0, err) : NULL;
    ovr_find *find;
    if (!c)
        return how->key ? OVR_BAD_INPUT : OVR_OK;
    find = ovr_find_create(c, how, &why);
    ovr_find_free(find);
    ovr_case_free(c);
    return find ? OVR_OK
                : ovr_fail_at(err, why.status, s->path, s->find.line, "%.900s",
                              why.message);
}

char *ovr_study_text(const ovr_study *s, ovr_case *c, ovr_arena *arena,
                     ovr_error *err)
{
    const ovr_find_options *f = &s->find.how;
    const char *text = ovr_case_text(c, err);
    size_t capacity = (text ? strlen(text) : 0) + 2000;
    char *all = text ? ovr_arena_take(arena, capacity, 1, err) : NULL;
    if (all && f->key)
        snprintf(all, capacity,
                 "%s# find %.200s %.300s between %.100s and %.100s so that "
                 "%.400s, to %g\n",
                 text, f->which ? f->which : "", f->key, f->low, f->high,
                 f->condition, f->tolerance);
    else if (all)
        strcpy(all, text);
    return all;
}
