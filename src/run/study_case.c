/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Creates the cases of a study and their names. */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/error.h"
#include "base/given.h"
#include "overroll/questions.h"
#include "run/run.h"
#include "run/study.h"

enum { NAME_MAX = 120 };

static const char *value_at(const ovr_study *s, const ovr_study_key *key,
                            size_t v, char *text)
{
    if (key->value)
        return key->value[v];
    if (key->random)
        return ovr_study_draw_at(s, key, v, text);
    ovr_study_range_at(&key->range, v, text);
    return text;
}

static size_t value_number(const ovr_study_key *key, size_t task)
{
    return (task / key->stride) % key->count;
}

const char *ovr_study_value(const ovr_study *s, const ovr_study_key *key,
                            size_t task, char *text)
{
    return value_at(s, key, value_number(key, task), text);
}

/* Returns the sample number of a task, from 0. Cases with the same sample
 * differ in keys that are not random. */
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

/* Returns the shortest end of section.key that no other key has. */
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

/* Copies characters that are safe in a file name. Blanks are removed, others
 * become '~'. */
static size_t append_safe(char *to, size_t capacity, const char *text)
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

/* Appends the values of lists and ranges to the name. Returns its length before
 * truncation. */
static size_t append_values(const ovr_study *s, size_t task, char *name,
                            size_t capacity)
{
    size_t n = 0, whole;
    name[0] = '\0';
    for (size_t i = 0; i < s->keys && n < capacity - 300; i++) {
        char part[300], value[OVR_STUDY_VALUE];
        if (s->key[i].fixed || s->key[i].random)
            continue;
        snprintf(part, sizeof part, "%s%s=%s", n ? "_" : "", s->key[i].shown,
                 ovr_study_value(s, &s->key[i], task, value));
        n += append_safe(name + n, capacity - n, part);
    }
    whole = n;
    if (n > NAME_MAX)
        snprintf(name + NAME_MAX - 9, 10, "-%08x", hash(name));
    return whole;
}

void ovr_study_name(const ovr_study *s, size_t k, char *text, size_t capacity)
{
    char name[8192];
    size_t n;
    if (!s || !text || k >= s->tasks)
        return;
    n = append_values(s, k, name, sizeof name) ? strlen(name) : 0;
    if (s->random.how.draws)
        snprintf(name + n, sizeof name - n, "%sdraw-%04zu", n ? "_" : "",
                 draw_of(s, k) + 1);
    snprintf(text, capacity, "%s", *name ? name : "case");
}

/* --------------------------------------------------------- duplicate names */

static ovr_status fail_twice(const ovr_study *s, size_t task, ovr_error *err)
{
    char name[OVR_STUDY_NAME];
    ovr_study_name(s, task, name, sizeof name);
    return ovr_fail(err, OVR_BAD_INPUT, "%s: the case %.150s is given twice",
                    s->path, name);
}

typedef struct hashed {
    uint64_t hash;
    size_t task;
} hashed;

static int by_hash(const void *a, const void *b)
{
    const hashed *x = a, *y = b;
    return (x->hash > y->hash) - (x->hash < y->hash);
}

/* Checks that the names of `count` tasks, `stride` apart, differ. */
static ovr_status check_names(const ovr_study *s, size_t count, size_t stride,
                              ovr_error *err)
{
    ovr_arena arena = ovr_arena_make(&s->arena.allocator);
    hashed *all = ovr_arena_take(&arena, count, sizeof *all, err);
    ovr_status status = all ? OVR_OK : OVR_NO_MEMORY;
    for (size_t i = 0; all && i < count; i++) {
        char name[OVR_STUDY_NAME];
        ovr_study_name(s, i * stride, name, sizeof name);
        all[i] = (hashed){ovr_text_hash(name), i * stride};
    }
    if (all)
        qsort(all, count, sizeof *all, by_hash);
    for (size_t i = 1; !status && i < count; i++)
        if (all[i - 1].hash == all[i].hash)
            status = fail_twice(s, all[i].task, err);
    ovr_arena_release(&arena);
    return status;
}

/* True if names differ whenever the values of a key or zip differ: no name is
 * truncated, and no value looks like a key. */
static bool is_plain(const ovr_study *s)
{
    size_t longest = 0;
    for (size_t i = 0; i < s->keys; i++) {
        const ovr_study_key *k = &s->key[i];
        size_t most = k->value ? 0 : 2 * sizeof k->range.unit;
        if (k->fixed || k->random)
            continue;
        for (size_t v = 0; k->value && v < k->count; v++) {
            if (strchr(k->value[v], '='))
                return false;
            if (strlen(k->value[v]) > most)
                most = strlen(k->value[v]);
        }
        longest += strlen(k->shown) + 2 + most;
    }
    return longest <= NAME_MAX;
}

/* True if the values of a range differ in their first ten digits. */
static bool has_distinct_texts(const ovr_study_range *r)
{
    double largest = fmax(fabs(r->from), fabs(r->to));
    double step = r->log ? fabs(log(r->to / r->from))
                         : fabs(r->to - r->from) / largest;
    return step / (double)(r->count - 1) > 1e-8;
}

/* Checks the names of all tasks. Keys of a zip have the same stride and number
 * of values. */
static ovr_status check_all_names(const ovr_study *s, ovr_error *err)
{
    const size_t draws = s->random.how.draws ? s->random.how.draws : 1;
    ovr_status status = OVR_OK;
    if (!is_plain(s))
        return check_names(s, s->tasks / draws, draws, err);
    for (size_t i = 0; !status && i < s->keys; i++) {
        const ovr_study_key *k = &s->key[i];
        bool again = i && k->zip && k[-1].zip == k->zip;
        if (k->fixed || k->random || again)
            continue;
        if (k->value || !has_distinct_texts(&k->range))
            status = check_names(s, k->count, k->stride, err);
    }
    return status;
}

ovr_status ovr_study_name_keys(ovr_study *s, ovr_error *err)
{
    for (size_t i = 0; i < s->keys; i++)
        s->key[i].shown = short_name(s, s->key[i].where);
    return check_all_names(s, err);
}

/* ------------------------------------------------------------------ cases */

static ovr_case *base_case(const ovr_study *s, ovr_error *err)
{
    if (s->case_path)
        return ovr_case_read(s->case_path, NULL, err);
    return ovr_case_read_text("", s->path, s->folder, NULL, err);
}

static ovr_status set_key(const ovr_study *s, const ovr_study_key *k,
                          const char *value, ovr_case *c, ovr_error *err)
{
    char origin[300];
    snprintf(origin, sizeof origin, "%.280s:%ld", s->path, k->line);
    return ovr_case_set(c, k->where, value, origin, err);
}

/* Fails with a message about a draw that the case rejects, and the remedy. */
static ovr_status bad_draw(const ovr_study *s, const ovr_study_key *k, size_t v,
                           const ovr_error *why, ovr_error *err)
{
    const char *what = why->message + why->file;
    char text[OVR_STUDY_VALUE];
    what += strspn(what, ":0123456789 ");
    return ovr_fail_at(err, OVR_BAD_INPUT, s->path, k->line,
                       "sample %zu of %s is %.60s: %.500s; use lognormal or "
                       "within",
                       v + 1, k->where, value_at(s, k, v, text), what);
}

static ovr_status set_value(const ovr_study *s, const ovr_study_key *k,
                            size_t v, ovr_case *c, ovr_error *err)
{
    char text[OVR_STUDY_VALUE];
    ovr_error why = {0};
    ovr_status status = set_key(s, k, value_at(s, k, v, text), c,
                                k->random ? &why : err);
    return status && k->random ? bad_draw(s, k, v, &why, err) : status;
}

ovr_status ovr_study_put(const ovr_study *s, const ovr_study_key *key,
                         size_t task, ovr_case *c, ovr_error *err)
{
    return set_value(s, key, value_number(key, task), c, err);
}

ovr_case *ovr_study_case(const ovr_study *s, size_t task, ovr_error *err)
{
    if (!s)
        return ovr_null(err, __func__);
    ovr_case *c = base_case(s, err);
    ovr_status status = OVR_OK;
    for (size_t i = 0; c && !status && i < s->keys; i++)
        status = ovr_study_put(s, &s->key[i], task, c, err);
    if (status) {
        ovr_case_free(c);
        return NULL;
    }
    if (c)
        ovr_case_unset(c, "output.file"); /* set by the study */
    return c;
}

/* Checks every value of a list. A range is checked at its first thousand values
 * and at its last value: an invalid step (of integers) appears among the
 * first. */
ovr_status ovr_study_try_values(const ovr_study *s, ovr_error *err)
{
    enum { FIRST = 1000 };
    ovr_case *c = base_case(s, err);
    ovr_status status = c ? OVR_OK : OVR_BAD_INPUT;
    for (size_t i = 0; !status && i < s->keys; i++) {
        const ovr_study_key *k = &s->key[i];
        size_t first = k->random ? 1 : k->value ? k->count : FIRST;
        for (size_t v = 0; !status && v < k->count && v < first; v++)
            status = set_value(s, k, v, c, err);
        if (!status && !k->random)
            status = set_value(s, k, k->count - 1, c, err);
    }
    ovr_case_free(c);
    return status;
}

/* Checks the draws from..from+count-1. Allowed values are intervals, so the
 * smallest and the largest draw of a distribution suffice. All draws are
 * checked if one of these two is rejected, or if they are cells of a file. */
static ovr_status try_key(const ovr_study *s, const ovr_study_key *k,
                          size_t from, size_t count, ovr_case *c,
                          ovr_error *err)
{
    size_t least = from, most = from;
    double low = INFINITY, high = -INFINITY;
    ovr_error why = {0};
    ovr_status status = OVR_OK;
    for (size_t v = from; k->draw.law == OVR_DRAW_NUMBER && v < from + count;
         v++) {
        double u = ovr_draw_at(&s->random.how, k->draw.dimension, v);
        if (u < low)
            low = u, least = v;
        if (u > high)
            high = u, most = v;
    }
    if (k->draw.law != OVR_DRAW_CELL && !set_value(s, k, least, c, &why) &&
        !set_value(s, k, most, c, &why))
        return OVR_OK;
    for (size_t v = from; !status && v < from + count; v++)
        status = set_value(s, k, v, c, err);
    return status;
}

ovr_status ovr_study_try_draws(const ovr_study *s, size_t first, size_t last,
                               ovr_error *err)
{
    const size_t draws = s->random.how.draws;
    size_t from = draws ? first % draws : 0, count = last - first + 1;
    ovr_case *c = draws ? base_case(s, err) : NULL;
    ovr_status status = c || !draws ? OVR_OK : OVR_BAD_INPUT;
    if (from + count > draws) {
        from = 0;
        count = draws;
    }
    for (size_t i = 0; !status && i < s->keys; i++)
        if (s->key[i].random)
            status = try_key(s, &s->key[i], from, count, c, err);
    ovr_case_free(c);
    return status;
}

/* Checks [find] with the first case. */
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

/* ------------------------------------------------------------------ hashes */

static uint64_t joined(uint64_t hash, const char *text)
{
    return (hash ^ ovr_text_hash(text)) * 1099511628211u;
}

/* Hashes the base case, including [set] and without varied keys. */
ovr_status ovr_study_hash(ovr_study *s, ovr_error *err)
{
    ovr_case *c = base_case(s, err);
    ovr_arena arena = ovr_arena_make(&s->arena.allocator);
    ovr_status status = c ? OVR_OK : OVR_BAD_INPUT;
    for (size_t i = 0; !status && i < s->keys; i++) {
        const ovr_study_key *k = &s->key[i];
        if (k->fixed)
            status = set_value(s, k, 0, c, err);
        else
            ovr_case_unset(c, k->where);
        for (size_t n = 0; n < k->draw.cells; n++)
            s->signature = joined(s->signature, k->draw.cell[n]);
    }
    if (!status)
        ovr_case_unset(c, "output.file");
    const char *text = status ? NULL : ovr_study_text(s, c, &arena, err);
    if (text) {
        s->base = ovr_text_hash(text);
        s->signature = joined(s->signature, text);
    }
    ovr_arena_release(&arena);
    ovr_case_free(c);
    return text ? OVR_OK : OVR_NO_MEMORY;
}

uint64_t ovr_study_identity(const ovr_study *s, size_t task)
{
    uint64_t hash = s->base;
    for (size_t i = 0; i < s->keys; i++) {
        char text[OVR_STUDY_VALUE];
        if (s->key[i].fixed)
            continue;
        hash = joined(hash, s->key[i].where);
        hash = joined(hash, ovr_study_value(s, &s->key[i], task, text));
    }
    return hash;
}
