/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Reading a study: its sections, the keys of the case that they vary, and the
 * lists and ranges of their values.
 */
#include "run/study.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/entries.h"
#include "base/error.h"
#include "base/given.h"
#include "base/text.h"
#include "case/parameters.h"
#include "overroll/text.h"

/* ----------------------------------------------------------- Keys and words */

const char *ovr_study_path(ovr_study *s, const char *path, ovr_error *err)
{
    char whole[4096];
    if (path[0] == '/' || !strcmp(s->folder, "."))
        return ovr_arena_text(&s->arena, path, err);
    snprintf(whole, sizeof whole, "%s/%s", s->folder, path);
    return ovr_arena_text(&s->arena, whole, err);
}

ovr_status ovr_study_unknown(const ovr_study *s, const ovr_study_words *words,
                             const char *given, long line, ovr_error *err)
{
    const char *what = *words->in ? "key" : "section";
    const char *meant = ovr_suggest(given, words->word, words->count);
    char there[200] = "";
    size_t used = 0;
    for (size_t k = 0; k < words->count && used < sizeof there; k++)
        used += (size_t)snprintf(there + used, sizeof there - used, "%s%s",
                                 k ? ", " : "", words->word[k]);
    ovr_fail_at(err, OVR_BAD_INPUT, s->path, line,
                meant ? "unknown %s '%.60s'%s; did you mean '%s'?"
                      : "unknown %s '%.60s'%s; must be one of %s%s",
                what, given, words->in, meant ? meant : there, words->more);
    return meant ? ovr_fail_meant(err, OVR_BAD_INPUT, meant) : OVR_BAD_INPUT;
}

/* Returns the row of a key "contact.KEY" or "lubricant.KEY" if both sections
 * have it and it sets the same number, otherwise NULL. */
static const ovr_parameter *row_with_two_names(const char *where)
{
    const char *key = strchr(where, '.');
    const ovr_parameter *a, *b;
    if (!key || (strncmp(where, "contact.", 8) != 0 &&
                 strncmp(where, "lubricant.", 10) != 0))
        return NULL;
    a = ovr_parameter_find(ovr_section_find("contact"), key + 1);
    b = ovr_parameter_find(ovr_section_find("lubricant"), key + 1);
    return a && b && a->place == b->place ? a : NULL;
}

static bool is_same_quantity(const char *a, const char *b)
{
    const ovr_parameter *row = row_with_two_names(a);
    return !strcmp(a, b) || (row && row == row_with_two_names(b));
}

ovr_study_key *ovr_study_new_key(ovr_study *s, const char *where, long line,
                                 ovr_error *err)
{
    ovr_study_key *k = &s->key[s->keys];
    const char *wrong = s->keys == OVR_STUDY_MAX_KEYS
                            ? "'%.60s': a study has at most 64 keys"
                            : NULL;
    for (size_t i = 0; !wrong && i < s->keys; i++)
        if (is_same_quantity(s->key[i].where, where))
            wrong = strcmp(s->key[i].where, where)
                        ? "'%.60s' is given twice, in [contact] and in "
                          "[lubricant]"
                        : "'%.60s' is given twice";
    if (wrong) {
        ovr_fail_at(err, OVR_BAD_INPUT, s->path, line, wrong, where);
        return NULL;
    }
    *k = (ovr_study_key){.where = ovr_arena_text(&s->arena, where, err),
                         .line = line};
    s->keys += k->where != NULL;
    return k->where ? k : NULL;
}

/* ------------------------------------------------------------------- Values */

enum { VALUE_CAPACITY = 200 };

/* Copies from..end without leading and trailing blanks. */
static char *trimmed(const char *from, const char *end, ovr_arena *arena,
                     ovr_error *err)
{
    char text[VALUE_CAPACITY];
    ovr_line line = ovr_trim((ovr_line){from, (size_t)(end - from), 0});
    if (!line.size || line.size >= VALUE_CAPACITY) {
        ovr_fail(err, OVR_BAD_INPUT,
                 line.size ? "a value is too long"
                           : "a value of the list is missing");
        return NULL;
    }
    snprintf(text, sizeof text, "%.*s", (int)line.size, line.text);
    return ovr_arena_text(arena, text, err);
}

/* ------------------------------------------------------------------- List */

static ovr_status read_list(const char *text, ovr_arena *arena, char ***values,
                            size_t *count, ovr_error *err)
{
    char stop = strchr(text, '|') ? '|' : ',';
    size_t n = 1;
    for (const char *c = text; *c; c++)
        n += *c == stop;
    *values = ovr_arena_take(arena, n, sizeof **values, err);
    *count = n;
    if (!*values)
        return OVR_NO_MEMORY;
    for (size_t i = 0; i < n; i++) {
        const char *end = strchr(text, stop);
        if (!end)
            end = text + strlen(text);
        (*values)[i] = trimmed(text, end, arena, err);
        if (!(*values)[i])
            return OVR_BAD_INPUT;
        text = end + 1;
    }
    return OVR_OK;
}

/* ------------------------------------------------------------------ Range */

/* Reads a number and the unit after it, separated by a blank; the unit may be
 * "". */
static bool read_end(const char *text, double *number, char *unit,
                     size_t capacity)
{
    const char *behind = ovr_amount_read(text, number);
    return behind && snprintf(unit, capacity, "%s%s", *behind ? " " : "",
                              behind) < (int)capacity;
}

static void copy_trimmed(char *to, const char *from, const char *end)
{
    ovr_line line = ovr_trim((ovr_line){from, (size_t)(end - from), 0});
    memcpy(to, line.text, line.size);
    to[line.size] = '\0';
}

/* Splits "A to B in N". */
static bool split_range(const char *text, char *from, char *to, size_t capacity,
                        size_t *count)
{
    const char *middle = strstr(text, " to ");
    const char *last = middle ? strstr(middle + 4, " in ") : NULL;
    char *end;
    unsigned long n;
    if (!last || (size_t)(middle - text) >= capacity ||
        (size_t)(last - middle - 4) >= capacity)
        return false;
    copy_trimmed(from, text, middle);
    copy_trimmed(to, middle + 4, last);
    last += 4 + strspn(last + 4, " ");
    n = strtoul(last, &end, 10);
    *count = n;
    return *last >= '0' && *last <= '9' && !*end && n > 1 &&
           n <= OVR_STUDY_MAX_TASKS;
}

static ovr_status parse_range(const char *text, ovr_study_range *r,
                              ovr_error *err)
{
    char from[80], to[80], unit[24];
    const char *after = strchr(text, ' ');
    r->log = text[1] == 'o';
    if (!after || !split_range(after + 1, from, to, sizeof from, &r->count))
        return ovr_fail(err, OVR_BAD_INPUT,
                        "'%.80s' must be '%s A to B in N' with N at least 2",
                        text, r->log ? "log" : "linear");
    if (!read_end(from, &r->from, unit, sizeof unit) ||
        !read_end(to, &r->to, r->unit, sizeof r->unit))
        return ovr_fail(err, OVR_BAD_INPUT, "'%.80s': A and B must be numbers",
                        text);
    if (unit[0] && strcmp(unit, r->unit) != 0)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "'%.80s': A and B must have the same unit", text);
    if (r->log && !(r->from > 0 && r->to > 0))
        return ovr_fail(err, OVR_BAD_INPUT, "'%.80s': A and B must be above 0",
                        text);
    return OVR_OK;
}

static double range_at(const ovr_study_range *r, size_t i)
{
    double s = (double)i / (double)(r->count - 1);
    if (i == 0 || i + 1 == r->count) /* the ends exactly as given */
        return i ? r->to : r->from;
    return r->log ? r->from * pow(r->to / r->from, s)
                  : r->from + s * (r->to - r->from);
}

/* Writes ten digits. The printed value is the one used in the case. */
void ovr_study_range_at(const ovr_study_range *r, size_t i, char *text)
{
    snprintf(text, OVR_STUDY_VALUE, "%.10g%s", range_at(r, i), r->unit);
}

/* Reads a range of whole numbers, "1..8". */
static bool is_count(const char *text, ovr_study_range *r)
{
    char *end;
    long from = strtol(text, &end, 10), to;
    const char *second = end + 2;
    if (end == text || strncmp(end, "..", 2) != 0)
        return false;
    to = strtol(second, &end, 10);
    if (end == second || *end || to <= from || to - from >= OVR_STUDY_MAX_TASKS)
        return false;
    *r = (ovr_study_range){(double)from, (double)to, "",
                           (size_t)(to - from) + 1, false};
    return true;
}

/* Reads a range; r->count is 0 if the text is a list. */
static ovr_status read_range(const char *text, ovr_study_range *r,
                             ovr_error *err)
{
    char from[80], to[80];
    size_t n;
    r->count = 0;
    if (is_count(text, r))
        return OVR_OK;
    if (!strncmp(text, "linear ", 7) || !strncmp(text, "log ", 4))
        return parse_range(text, r, err);
    if (!split_range(text, from, to, sizeof from, &n))
        return OVR_OK;
    return ovr_fail(err, OVR_BAD_INPUT,
                    "'%.80s' is a range: it must begin with linear or log; "
                    "did you mean 'linear %.80s'?",
                    text, text);
}

/* -------------------------------------------------------------------- Study */

enum { LINE_MAX = 65534, STUDY_MAX = 1 << 22 };

enum section { NO_SECTION, STUDY, SET, PRODUCT, ZIP, FIND, RANDOM, LIMITS };

typedef struct reading {
    ovr_study *s;
    long line;
    enum section section;
    int zips;
    const char *zip_name;
    const char *table; /* table of [random file TABLE]; or NULL */
    ovr_error *err;
} reading;

static ovr_status fail(reading *r, const char *what, const char *about)
{
    return ovr_fail_at(r->err, OVR_BAD_INPUT, r->s->path, r->line, what, about);
}

/* ------------------------------------------------------------------ Lines */

static const char *path_of(reading *r, const char *value)
{
    return ovr_study_path(r->s, value, r->err);
}

/* Begins a section [random] or [random file TABLE]. */
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
                    "[%s] is a section of a case: this file is a case, not a "
                    "study; 'overroll run' runs it",
                    name);
    return ovr_study_unknown(r->s, &words, name, r->line, r->err);
}

static ovr_status read_setting(reading *r, const char *key, const char *value)
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

static ovr_status read_values(reading *r, const char *key, const char *value)
{
    ovr_study *s = r->s;
    ovr_study_key *k = ovr_study_new_key(s, key, r->line, r->err);
    ovr_error why = {0};
    if (!k)
        return OVR_BAD_INPUT;
    k->fixed = r->section == SET;
    k->zip = r->section == ZIP ? r->zips : 0;
    k->zip_name = r->zip_name;
    if (k->fixed) { /* a single value, even if it contains commas */
        k->value = ovr_arena_take(&s->arena, 1, sizeof *k->value, r->err);
        if (!k->value)
            return OVR_NO_MEMORY;
        k->value[0] = ovr_arena_text(&s->arena, value, r->err);
        k->count = 1;
        return OVR_OK;
    }
    if (read_range(value, &k->range, &why) ||
        (!k->range.count &&
         read_list(value, &s->arena, &k->value, &k->count, &why)))
        return ovr_fail_at(r->err, why.status, s->path, r->line, "%s: %.800s",
                           key, why.message);
    if (k->range.count)
        k->count = k->range.count;
    return OVR_OK;
}

/* Reads "A, B". */
static ovr_status read_ends(reading *r, const char *value)
{
    ovr_find_options *f = &r->s->find.how;
    char **ends;
    size_t count = 0;
    ovr_error why = {0};
    if (read_list(value, &r->s->arena, &ends, &count, &why) || count != 2)
        return fail(r, "between: '%.60s' must be two numbers, A, B", value);
    f->low = ends[0];
    f->high = ends[1];
    return OVR_OK;
}

static ovr_status read_find(reading *r, const char *key, const char *value)
{
    static const char *const names[] = {"key", "between", "so_that", "which",
                                        "tolerance"};
    const ovr_study_words words = {" in [find]", names,
                                   sizeof names / sizeof *names, ""};
    ovr_find_options *f = &r->s->find.how;
    const char *at = value, **to = NULL;
    r->s->find.line = r->line;
    if (!strcmp(key, "between"))
        return read_ends(r, value);
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

/* Reads a limit, "min_film_m >= 0.2 um". The parser ends its key before the
 * '='. */
static ovr_status read_limit(reading *r, const char *key, const char *value)
{
    char text[400];
    ovr_error why = {0};
    ovr_study *s = r->s;
    size_t size = strlen(key);
    bool sign = size && strchr("<>", key[size - 1]);
    snprintf(text, sizeof text, "%.180s%s %.180s", key, sign ? "=" : "", value);
    if (s->limits == OVR_STUDY_MAX_LIMITS)
        return fail(r, "'%.60s': a study has at most 16 limits", key);
    if (!sign && strncmp(value, "at ", 3) != 0)
        return fail(
            r, "'%.100s' must be QUANTITY >= VALUE or QUANTITY <= VALUE", key);
    if (ovr_comparison_read(text, &s->limit[s->limits], &s->arena, &why))
        return fail(r, "%.300s", why.message);
    s->limits++;
    return OVR_OK;
}

static ovr_status read_entry(reading *r, const ovr_entry *entry)
{
    r->line = entry->line;
    if (entry->section)
        return open_section(r, entry->section);
    if (!*entry->value)
        return fail(r, "%.60s: the value is missing", entry->key);
    switch (r->section) {
    case STUDY: return read_setting(r, entry->key, entry->value);
    case FIND: return read_find(r, entry->key, entry->value);
    case RANDOM: return ovr_study_take_random(r->s, entry, r->table, r->err);
    case LIMITS: return read_limit(r, entry->key, entry->value);
    default: return read_values(r, entry->key, entry->value);
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
    s->signature = all.at ? ovr_text_hash(all.at) : 0;
    while (!status && !(status = ovr_entries_next(&all, &entry, r->err)) &&
           entry.line)
        status = read_entry(r, &entry);
    return status;
}

/* ----------------------------------------------------------- Combinations */

/* Checks that all keys of a zip have the same number of values. */
static ovr_status check_zips(ovr_study *s, ovr_error *err)
{
    for (size_t i = 1; i < s->keys; i++) {
        const ovr_study_key *a = &s->key[i - 1], *b = &s->key[i];
        if (b->zip && a->zip == b->zip && a->count != b->count)
            return ovr_fail_at(err, OVR_BAD_INPUT, s->path, b->line,
                               "%s has %zu value%s, but %s has %zu; keys of "
                               "a [zip] must have equally many values",
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
                "%s: has more than a million cases; use fewer values", s->path);
    }
    s->tasks = tasks;
    return OVR_OK;
}

/* ------------------------------------------------------------------ Study */

/* Sets the folder of the study and that of its results, which has the study's
 * name. */
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
    return ovr_arena_status(&s->arena);
}

/* Checks that [find] is complete or absent. */
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
        check_find(s, err) || ovr_study_add_random(s, r.zips + 1, err) ||
        check_zips(s, err) || set_strides(s, err) ||
        ovr_study_name_keys(s, err))
        return OVR_BAD_INPUT;
    if (ovr_study_try_values(s, err) || ovr_study_try_find(s, err))
        return OVR_BAD_INPUT;
    return ovr_study_hash(s, err);
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

bool ovr_study_in_rows(const ovr_study *s)
{
    return !s->results || s->find.how.key;
}

void ovr_study_file(const ovr_study *s, size_t task, const char *ending,
                    char *path, size_t capacity)
{
    char name[OVR_STUDY_NAME];
    ovr_study_name(s, task, name, sizeof name);
    snprintf(path, capacity, "%s/%s%s", s->output, name, ending);
}
