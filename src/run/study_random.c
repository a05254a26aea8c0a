/* SPDX-License-Identifier: GPL-3.0-or-later */
/* [random] in a study: keys with distributions, whose samples change together
 * like the values of a [zip]. Sample i of a key is computed when needed. */
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/entries.h"
#include "base/error.h"
#include "base/quantity.h"
#include "base/text.h"
#include "overroll/text.h"
#include "run/csv.h"
#include "run/study.h"

enum { SHIFTS = 8, CELL = 200, LINES_MAX = 1 << 24 };

/* ---------------------------------------------------------------- settings */

static ovr_status fail(const ovr_study *s, long line, const char *what,
                       const char *about, ovr_error *err)
{
    return ovr_fail_at(err, OVR_BAD_INPUT, s->path, line, what, about);
}

static bool read_count(const char *text, double maximum, double *count)
{
    const char *at = text;
    return ovr_read_number(&at, count) && !*at && *count == floor(*count) &&
           *count >= 0 && *count <= maximum;
}

static ovr_status read_setting(ovr_study *s, const ovr_entry *entry,
                               ovr_error *err)
{
    static const char *const names[] = {"draws", "seed", "design", "shifts"};
    static const char *const designs[] = {"plain", "lhs", "sobol"};
    const ovr_study_words words = {" in [random]", names, 4,
                                   ", and keys of the case"};
    const char *key = entry->key, *value = entry->value;
    const long line = entry->line;
    ovr_sampling *how = &s->random.how;
    double count;
    if (!strcmp(key, "draws")) {
        s->random.line = line;
        if (!read_count(value, OVR_STUDY_MAX_TASKS, &count) || count < 8)
            return fail(s, line,
                        "draws: '%.40s' must be a whole number from 8 "
                        "to 1000000",
                        value, err);
        how->draws = (size_t)count;
        return OVR_OK;
    }
    if (!strcmp(key, "seed")) {
        if (!read_count(value, 9e15, &count))
            return fail(s, line, "seed: '%.40s' must be a whole number", value,
                        err);
        how->seed = (uint64_t)count;
        return OVR_OK;
    }
    if (!strcmp(key, "shifts")) {
        if (!read_count(value, 1000, &count) || count < 1)
            return fail(s, line,
                        "shifts: '%.40s' must be a whole number from "
                        "1 to 1000",
                        value, err);
        how->shifts = (size_t)count;
        s->random.shifts_given = true;
        return OVR_OK;
    }
    for (int k = 0; !strcmp(key, "design") && k < 3; k++)
        if (!strcmp(value, designs[k])) {
            how->design = (ovr_design)k;
            return OVR_OK;
        }
    if (!strcmp(key, "design"))
        return fail(s, line, "design: '%.40s' must be plain, lhs or sobol",
                    value, err);
    return ovr_study_unknown(s, &words, key, line, err);
}

ovr_status ovr_study_take_random(ovr_study *s, const ovr_entry *entry,
                                 const char *file, ovr_error *err)
{
    ovr_study_chances *r = &s->random;
    if (!r->line) {
        r->line = entry->line;
        r->how.design = OVR_SOBOL;
        r->how.seed = 1;
        r->how.shifts = SHIFTS;
    }
    if (!strchr(entry->key, '.') && !file)
        return read_setting(s, entry, err);
    if (r->keys == OVR_STUDY_MAX_KEYS)
        return fail(s, entry->line,
                    "'%.60s': a study has at most 64 random "
                    "keys",
                    entry->key, err);
    ovr_study_chance *c = &r->key[r->keys++];
    *c = (ovr_study_chance){ovr_arena_text(&s->arena, entry->key, err),
                            ovr_arena_text(&s->arena, entry->value, err), file,
                            entry->line};
    return c->where && c->text ? OVR_OK : OVR_NO_MEMORY;
}

/* ----------------------------------------------------------- distributions */

/* A number with its unit, read from the text before `end`. */
typedef struct amount {
    double value;
    char unit[40];
} amount;

static bool read_amount(const char *from, const char *end, amount *a)
{
    char text[120];
    ovr_line line = ovr_trim((ovr_line){from, (size_t)(end - from), 0});
    if (end - from >= (ptrdiff_t)sizeof text)
        return false;
    snprintf(text, sizeof text, "%.*s", (int)line.size, line.text);
    const char *unit = ovr_amount_read(text, &a->value);
    if (unit)
        snprintf(a->unit, sizeof a->unit, "%s", unit);
    return unit != NULL;
}

/* Converts to another unit; false if its dimension differs. */
static bool convert(amount *a, const char *unit)
{
    ovr_dimension d = ovr_unit_dimension(unit);
    if (!strcmp(a->unit, unit) || !*a->unit)
        return true;
    if (d == OVR_PURE || ovr_unit_dimension(a->unit) != d)
        return false;
    a->value *= ovr_unit_value(a->unit, d) / ovr_unit_value(unit, d);
    return isfinite(a->value);
}

/* Reads "300 kN/m sd 10 %". */
static bool read_moments(const char *from, const char *end, ovr_distribution *d,
                         char *unit)
{
    const char *sd = strstr(from, " sd ");
    amount mean, deviation;
    if (!sd || sd >= end || !read_amount(from, sd, &mean) ||
        !read_amount(sd + 4, end, &deviation))
        return false;
    if (!strcmp(deviation.unit, "%"))
        deviation = (amount){fabs(mean.value) * deviation.value / 100, ""};
    strcpy(unit, mean.unit);
    d->a = mean.value;
    d->b = deviation.value;
    if (!convert(&deviation, mean.unit))
        return false;
    d->b = deviation.value;
    return true;
}

/* Reads "7.9 mm to 8.1 mm", or three numbers with commas. Numbers without unit
 * have that of the last one. */
static bool read_several(const char *from, const char *end, const char *mark,
                         double *to, char *unit)
{
    const int count = *mark == ',' ? 3 : 2;
    amount a[3] = {{0}};
    for (int k = 0; k < count; k++) {
        const char *next = k + 1 < count ? strstr(from, mark) : end;
        if (!next || next > end || !read_amount(from, next, &a[k]))
            return false;
        from = next + strlen(mark);
    }
    strcpy(unit, a[count - 1].unit);
    for (int k = 0; k < count; k++) {
        if (!convert(&a[k], unit))
            return false;
        to[k] = a[k].value;
    }
    return true;
}

/* True for "300 kN/m sd 10": the deviation may be meant in percent. */
static bool lacks_unit(const char *text, const char *unit)
{
    const char *sd = strstr(text, " sd "), *within = strstr(text, " within ");
    amount deviation;
    return *unit && sd &&
           read_amount(sd + 4, within ? within : text + strlen(text),
                       &deviation) &&
           !*deviation.unit;
}

static bool read_distribution(const char *text, ovr_distribution *d, char *unit)
{
    static const struct {
        const char *word;
        ovr_law_of_chance law;
    } laws[] = {{"normal ", OVR_NORMAL},
                {"lognormal ", OVR_LOGNORMAL},
                {"uniform ", OVR_UNIFORM},
                {"triangular ", OVR_TRIANGULAR}};
    const char *within = strstr(text, " within ");
    const char *end = within ? within : text + strlen(text), *at = NULL;
    double ends[3] = {0};
    char other[40];
    *d = (ovr_distribution){.low = -INFINITY, .high = INFINITY};
    for (int k = 0; !at && k < 4; k++)
        if (!strncmp(text, laws[k].word, strlen(laws[k].word))) {
            d->law = laws[k].law;
            at = text + strlen(laws[k].word);
        }
    if (!at)
        return false;
    if (d->law == OVR_NORMAL || d->law == OVR_LOGNORMAL) {
        if (!read_moments(at, end, d, unit))
            return false;
    } else {
        bool three = d->law == OVR_TRIANGULAR;
        if (!read_several(at, end, three ? "," : " to ", ends, unit))
            return false;
        d->a = ends[0];
        d->b = ends[1];
        d->c = ends[2];
    }
    if (!within)
        return true;
    within += 8;
    if (!read_several(within, within + strlen(within), " to ", ends, other))
        return false;
    for (int k = 0; k < 2; k++) {
        amount a = {ends[k], ""};
        strcpy(a.unit, other);
        if (!convert(&a, unit))
            return false;
        *(k ? &d->high : &d->low) = a.value;
    }
    return true;
}

/* Reads "1..1000000000". */
static bool read_range(const char *text, double *from, double *count)
{
    char *end;
    long long a = strtoll(text, &end, 10), b;
    const char *second = end + 2;
    if (end == text || strncmp(end, "..", 2) != 0)
        return false;
    b = strtoll(second, &end, 10);
    *from = (double)a;
    *count = (double)(b - a) + 1;
    return end != second && !*end && b > a && *count < 9e15;
}

/* ------------------------------------------------------------------- files */

/* A column of a CSV table, or all lines of a list (name NULL). */
typedef struct rows {
    const char *path, *name;
    char **cell;
    size_t count;
} rows;

/* Returns the next line of a list without its comment. Commas have no
 * meaning. */
static char *next_line(char **at)
{
    char *line = *at + strspn(*at, " \t"), *end = line + strcspn(line, "\n");
    *at = end + (*end == '\n');
    *end = '\0';
    end = line + strcspn(line, "#\r");
    while (end > line && strchr(" \t", end[-1]))
        end--;
    *end = '\0';
    return line;
}

/* Returns the column with this name in the header, and its unit; -1 if there is
 * none. */
static int column_named(char **at, const char *name, const char **unit)
{
    bool last = false;
    int found = -1;
    for (int k = 0; !last; k++) {
        char *head = ovr_csv_cell(at, &last);
        const char *its = ovr_csv_unit(head);
        if (found < 0 && !strcmp(head, name))
            found = k, *unit = its;
    }
    return found;
}

/* Returns the cell in a column and skips the rest of the line; NULL if the line
 * is too short. */
static char *cell_of(char **at, int column)
{
    bool last = false;
    char *cell = NULL;
    for (int k = 0; !last; k++) {
        char *here = ovr_csv_cell(at, &last);
        cell = k == column ? here : cell;
    }
    return cell;
}

static ovr_status read_rows(ovr_study *s, const ovr_study_chance *c, rows *to,
                            ovr_error *err)
{
    const char *path = to->path, *name = to->name, *unit = "";
    const char *text = ovr_text_file(path, name ? "table" : "list", LINES_MAX,
                                     &s->arena, err);
    char *at = text ? ovr_arena_text(&s->arena, text, err) : NULL;
    char whole[CELL + 48];
    size_t lines = 1;
    if (!at)
        return err->status;
    for (const char *p = text; *p; p++)
        lines += *p == '\n';
    to->cell = ovr_arena_take(&s->arena, lines, sizeof *to->cell, err);
    if (!to->cell)
        return OVR_NO_MEMORY;
    const int column = name ? column_named(&at, name, &unit) : 0;
    if (column < 0)
        return ovr_fail_at(err, OVR_BAD_INPUT, s->path, c->line,
                           "%.200s has no column '%.60s'", path, name);
    while (*at) {
        const char *cell = name ? cell_of(&at, column) : next_line(&at);
        if (!cell || strlen(cell) >= CELL)
            return ovr_fail_at(err, OVR_BAD_INPUT, s->path, c->line,
                               "%.200s: a row is too short", path);
        if (!*cell)
            continue;
        snprintf(whole, sizeof whole, "%s%s%s", cell, *unit ? " " : "", unit);
        to->cell[to->count] = ovr_arena_text(&s->arena, whole, err);
        if (!to->cell[to->count++])
            return OVR_NO_MEMORY;
    }
    return to->count ? OVR_OK
                     : ovr_fail_at(err, OVR_BAD_INPUT, s->path, c->line,
                                   "%.200s is empty: it needs a line of names "
                                   "and rows of numbers",
                                   path);
}

/* ------------------------------------------------------------------ drawing */

/* Returns the name of the dimension from which a key is sampled. Keys from one
 * table share a dimension. Ranges of integers have none (NULL) and are sampled
 * independently. */
static const char *dimension_of(const ovr_study_chance *c)
{
    double from, count;
    if (read_range(c->text, &from, &count))
        return NULL;
    return c->file ? c->file : c->where;
}

static size_t find_dimension(const ovr_study_chances *r, const char *name)
{
    size_t k = 0;
    while (k < r->how.keys && strcmp(r->dimension[k], name) != 0)
        k++;
    return k;
}

static ovr_status add_dimensions(ovr_study *s, ovr_error *err)
{
    ovr_study_chances *r = &s->random;
    ovr_error why = {0};
    for (size_t k = 0; k < r->keys; k++) {
        const char *name = dimension_of(&r->key[k]);
        if (name && find_dimension(r, name) == r->how.keys)
            r->dimension[r->how.keys++] = name;
    }
    r->how.key = r->dimension;
    if (ovr_sampling_check(&r->how, &why))
        return ovr_fail_at(err, why.status, s->path, r->line, "%s",
                           why.message);
    return OVR_OK;
}

static ovr_status read_cells(ovr_study *s, const ovr_study_chance *c,
                             ovr_study_key *k, ovr_error *err)
{
    rows r = {c->file, NULL, NULL, 0};
    if (c->file) {
        if (strncmp(c->text, "column ", 7) != 0)
            return fail(s, c->line,
                        "'%.60s' must be column NAME, because keys of "
                        "[random file FILE] name its columns",
                        c->text, err);
        r.name = c->text + 7 + strspn(c->text + 7, " ");
    } else {
        r.path = ovr_study_path(s, c->text + 5 + strspn(c->text + 5, " "), err);
    }
    if (!r.path || read_rows(s, c, &r, err))
        return OVR_BAD_INPUT;
    k->draw.law = OVR_DRAW_CELL;
    k->draw.cell = r.cell;
    k->draw.cells = r.count;
    k->related = c->file != NULL;
    return OVR_OK;
}

static ovr_status read_law(ovr_study *s, const ovr_study_chance *c,
                           ovr_study_key *k, ovr_error *err)
{
    ovr_study_draw *draw = &k->draw;
    const char *name = dimension_of(c), *wrong;
    char unit[40] = "";
    if (!name) {
        draw->law = OVR_DRAW_WHOLE;
        read_range(c->text, &draw->from, &draw->whole);
        return OVR_OK;
    }
    draw->dimension = find_dimension(&s->random, name);
    if (c->file || !strncmp(c->text, "file ", 5))
        return read_cells(s, c, k, err);
    if (!read_distribution(c->text, &draw->distribution, unit))
        return fail(s, c->line,
                    "'%.80s' must be normal A sd B, lognormal A sd B, "
                    "uniform A to B, triangular A, B, C, each optionally "
                    "followed by 'within A to B', or whole numbers A..B, or "
                    "file NAME",
                    c->text, err);
    if (lacks_unit(c->text, unit))
        return ovr_fail_at(err, OVR_BAD_INPUT, s->path, c->line,
                           "'%.80s': sd needs a unit, such as %s, or %%",
                           c->text, unit);
    wrong = ovr_distribution_wrong(&draw->distribution);
    if (wrong)
        return ovr_fail_at(err, OVR_BAD_INPUT, s->path, c->line, "'%.80s': %s",
                           c->text, wrong);
    snprintf(draw->unit, sizeof draw->unit, "%s%s", *unit ? " " : "", unit);
    return OVR_OK;
}

const char *ovr_study_draw_at(const ovr_study *s, const ovr_study_key *k,
                              size_t i, char *text)
{
    const ovr_sampling *how = &s->random.how;
    const ovr_study_draw *draw = &k->draw;
    double u = draw->law == OVR_DRAW_WHOLE
                   ? ovr_uniform_at(how->seed, ovr_text_hash(k->where), i)
                   : ovr_draw_at(how, draw->dimension, i);
    if (draw->law == OVR_DRAW_CELL)
        return draw->cell[(size_t)(u * (double)draw->cells)];
    if (draw->law == OVR_DRAW_WHOLE)
        snprintf(text, OVR_STUDY_VALUE, "%.0f",
                 draw->from + floor(u * draw->whole));
    else
        snprintf(text, OVR_STUDY_VALUE, "%.17g%s",
                 ovr_distribution_inverse(&draw->distribution, u), draw->unit);
    return text;
}

/* Chooses the number of replicates: 8 by default, otherwise the largest divisor
 * of the number of draws from 7 to 4 or the smallest from 9 to 16. */
static void choose_shifts(ovr_study_chances *r)
{
    const size_t draws = r->how.draws;
    if (r->shifts_given || draws % SHIFTS == 0)
        return;
    for (size_t k = SHIFTS - 1; k >= SHIFTS / 2; k--)
        if (draws % k == 0) {
            r->how.shifts = k;
            return;
        }
    for (size_t k = SHIFTS + 1; k <= 2 * SHIFTS; k++)
        if (draws % k == 0) {
            r->how.shifts = k;
            return;
        }
}

static ovr_status fail_shifts(const ovr_study *s, ovr_error *err)
{
    const ovr_sampling *how = &s->random.how;
    const size_t below = how->draws - how->draws % how->shifts;
    return ovr_fail_at(err, OVR_BAD_INPUT, s->path, s->random.line,
                       "draws = %zu must be a multiple of shifts = %zu: use "
                       "%zu or %zu",
                       how->draws, how->shifts, below ? below : how->shifts,
                       below + (below ? 1 : 2) * how->shifts);
}

static ovr_status check_settings(const ovr_study *s, ovr_error *err)
{
    const ovr_study_chances *r = &s->random;
    if (!r->how.draws)
        return ovr_fail_at(err, OVR_BAD_INPUT, s->path, r->line,
                           "[random]: draws is missing");
    if (!r->keys)
        return ovr_fail_at(err, OVR_BAD_INPUT, s->path, r->line,
                           "[random]: no key of the case is random");
    if (r->how.design == OVR_SOBOL && r->how.draws % r->how.shifts)
        return fail_shifts(s, err);
    return OVR_OK;
}

ovr_status ovr_study_add_random(ovr_study *s, int zip, ovr_error *err)
{
    const ovr_study_chances *r = &s->random;
    ovr_status status = OVR_OK;
    if (!r->line)
        return OVR_OK;
    choose_shifts(&s->random);
    if (check_settings(s, err))
        return OVR_BAD_INPUT;
    status = add_dimensions(s, err);
    for (size_t n = 0; !status && n < r->keys; n++) {
        const ovr_study_chance *c = &r->key[n];
        ovr_study_key *k = ovr_study_new_key(s, c->where, c->line, err);
        if (!k)
            return OVR_BAD_INPUT;
        k->zip = zip;
        k->zip_name = "random";
        k->random = true;
        k->count = r->how.draws;
        status = read_law(s, c, k, err);
    }
    return status;
}
