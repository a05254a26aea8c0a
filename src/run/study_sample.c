/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Computes the statistics of the samples of a study from its table, group by
 * group. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_sort.h>

#include "base/disk.h"
#include "base/given.h"
#include "base/text.h"
#include "mathematics/sample.h"
#include "overroll/questions.h"
#include "overroll/text.h"
#include "run/comparison.h"
#include "run/csv.h"
#include "run/internal.h"
#include "run/study_table.h"
#include "run/summary_lines.h"

enum { QUANTITIES = 32, NAME_CAPACITY = 400 };

struct ovr_sample {
    ovr_arena arena;
    ovr_sample_row *row;
    ovr_sample_input **input; /* values of an input for each row */
    size_t rows;
};

typedef struct sampling {
    ovr_sample *to;
    const ovr_study *s;
    const ovr_table *t;
    const ovr_table_column *quantity[QUANTITIES];
    size_t quantities;
    ovr_error *err;
} sampling;

bool ovr_study_random(const ovr_study *study)
{
    return study && study->random.how.draws > 0;
}

/* --------------------------------------------------------------- quantities */

static bool add_quantity(sampling *w, const char *name)
{
    const ovr_table_column *c = ovr_table_summary(w->t, name);
    for (size_t k = 0; k < w->quantities; k++)
        if (w->quantity[k] == c)
            return true;
    if (c && w->quantities < QUANTITIES)
        w->quantity[w->quantities++] = c;
    return c != NULL;
}

static ovr_status no_quantity(const sampling *w, const char *name)
{
    const char *names[OVR_TABLE_COLUMNS], *meant;
    size_t keys = w->t->keys, count = w->t->columns - keys;
    if (!count)
        return ovr_table_fail_empty(w->t, w->err);
    for (size_t k = 0; k < count; k++)
        names[k] = w->t->column[keys + k].name;
    meant = ovr_suggest(name, names, count);
    if (!meant)
        return ovr_fail(w->err, OVR_BAD_INPUT, "no quantity '%.60s'", name);
    ovr_fail(w->err, OVR_BAD_INPUT,
             "unknown quantity '%.60s'; did you mean '%s'?", name, meant);
    return OVR_BAD_INPUT;
}

static ovr_status add_requested(sampling *w, const char *names)
{
    while (*names) {
        char name[NAME_CAPACITY];
        size_t size = strcspn(names, ",");
        ovr_line one = {names, size, 0};
        one = ovr_trim(one);
        snprintf(name, sizeof name, "%.*s", (int)one.size, one.text);
        if (*name && !add_quantity(w, name))
            return no_quantity(w, name);
        names += size + (names[size] == ',');
    }
    return OVR_OK;
}

/* Selects the default quantities: those of [limits], the key of [find],
 * minimum film thickness and maximum pressure, in SI if available. */
static ovr_status add_usual(sampling *w)
{
    static const char *const films[] = {"H_min_overall_m",    "H_min_overall",
                                        "min_film_located_m", "H_min_located",
                                        "min_film_m",         "H_min"};
    static const char *const pressures[] = {"P_max_overall_Pa", "P_max_overall",
                                            "max_pressure_Pa", "P_max"};
    const ovr_study *s = w->s;
    for (size_t k = 0; k < s->limits; k++)
        if (!add_quantity(w, s->limit[k].quantity))
            return no_quantity(w, s->limit[k].quantity);
    if (s->find.how.key)
        add_quantity(w, s->find.how.key);
    for (size_t k = 0; k < 6 && !add_quantity(w, films[k]); k++)
        ;
    for (size_t k = 0; k < 4 && !add_quantity(w, pressures[k]); k++)
        ;
    return w->quantities ? OVR_OK : no_quantity(w, "H_min_located");
}

/* --------------------------------------------------------------------- rows */

static void find_range(const sampling *w, size_t from, const char *name,
                       int range[2])
{
    const ovr_table_column *c = ovr_table_summary(w->t, name);
    range[0] = range[1] = 0;
    for (size_t i = 0; c && i < w->s->random.how.draws; i++) {
        double v = c->number[from + i];
        if (isnan(v))
            continue;
        if (!range[1] || (int)v < range[0])
            range[0] = (int)v;
        if ((int)v > range[1])
            range[1] = (int)v;
    }
}

/* True if the value counts: it is finite, and a steady solution has converged.
 * Transient runs with flagged steps count and are marked. */
static bool is_number(const sampling *w, size_t task, double value)
{
    const ovr_table_column *converged = ovr_table_summary(w->t, "converged");
    const ovr_table_column *steps = ovr_table_summary(w->t, "steps");
    bool marched = steps && isfinite(steps->number[task]);
    return isfinite(value) &&
           (marched || !converged || !(converged->number[task] <= 0));
}

static void count_states(const sampling *w, size_t from, ovr_sample_row *r)
{
    const ovr_table_column *marked = ovr_table_summary(w->t, "steps_marked");
    for (size_t i = from; i < from + r->draws; i++) {
        r->finished += w->t->state[i] == OVR_SWEEP_FINISHED;
        r->failed += w->t->state[i] == OVR_SWEEP_FAILED;
        r->marked += marked && marked->number[i] > 0;
    }
    find_range(w, from, "order", r->order);
    find_range(w, from, "level", r->level);
}

/* Stores the standard error of the mean: for independent samples the usual one,
 * for shifted point sets that of the independent replicates' means. */
static void compute_error(const sampling *w, const double *value,
                          ovr_sample_row *r)
{
    const ovr_sampling *how = &w->s->random.how;
    double mean = 0, squares = 0, n = (double)how->shifts;
    r->error = r->factor = NAN;
    if (how->design == OVR_PLAIN) {
        r->error = r->sd / sqrt((double)r->known);
        r->factor = ovr_student(r->known);
    }
    if (how->design != OVR_SOBOL || how->shifts < 2)
        return;
    for (size_t k = 0; k < how->shifts; k++) {
        double sum = 0, count = 0;
        for (size_t i = k; i < how->draws; i += how->shifts)
            if (isfinite(value[i]))
                sum += value[i], count++;
        mean += sum / count / n;
        squares += pow(sum / count, 2) / n;
    }
    r->error = sqrt(fmax(0, squares - mean * mean) / (n - 1));
    r->factor = ovr_student(how->shifts);
}

/* Computes moments about the first value to reduce cancellation, because values
 * of a narrow sample are close to each other. */
static void compute_moments(const double *known, ovr_sample_row *r)
{
    double n = (double)r->known, sum = 0, squares = 0;
    for (size_t i = 0; i < r->known; i++)
        sum += known[i] - known[0];
    r->mean = known[0] + sum / n;
    for (size_t i = 0; i < r->known; i++)
        squares += pow(known[i] - r->mean, 2);
    r->sd = sqrt(squares / (n - 1));
}

static void compute_quantiles(const double *sorted, ovr_sample_row *r)
{
    static const double p[OVR_SAMPLE_QUANTILES] = {0.01, 0.05, 0.1, 0.5,
                                                   0.9,  0.95, 0.99};
    for (int k = 0; k < OVR_SAMPLE_QUANTILES; k++) {
        ovr_interval i = ovr_quantile_interval(sorted, r->known, p[k]);
        r->p[k] = p[k];
        r->quantile[k] = ovr_quantile(sorted, r->known, p[k]);
        r->low[k] = i.low;
        r->high[k] = i.high;
    }
}

static void compute_limits(const sampling *w, const double *known,
                           ovr_sample_row *r)
{
    size_t unknown = r->failed;
    for (size_t j = 0; j < w->s->limits; j++) {
        const ovr_comparison *c = &w->s->limit[j];
        size_t k = r->limits, held = 0, n = r->known + unknown;
        if (strcmp(c->quantity, r->quantity) != 0 || k == OVR_SAMPLE_LIMITS)
            continue;
        for (size_t i = 0; i < r->known; i++)
            held += c->sense > 0 ? known[i] >= c->target
                                 : known[i] <= c->target;
        r->sense[k] = c->sense;
        r->limit[k] = c->target;
        r->P[k] = (double)held / (double)r->known;
        r->P_low[k] = ovr_proportion(held, n).low;
        r->P_high[k] = ovr_proportion(held + unknown, n).high;
        r->limits++;
    }
}

/* True for keys that are seeds, which have no correlation with results. */
static bool is_seed(const char *where)
{
    size_t size = strlen(where);
    return size > 5 && !strcmp(where + size - 5, ".seed");
}

/* Computes the influence of inputs; omitted below 50 samples. */
static ovr_status compute_inputs(sampling *w, size_t from, const double *value,
                                 size_t row)
{
    enum { ENOUGH = 50 };
    const double all = 0.995; /* bins lose less than this fraction of a curve */
    ovr_sample_row *r = &w->to->row[row];
    ovr_arena arena = ovr_arena_make(&w->s->arena.allocator);
    double *x = ovr_arena_take(&arena, r->draws, sizeof *x, w->err);
    double *y = ovr_arena_take(&arena, r->draws, sizeof *y, w->err);
    ovr_sample_input *input = ovr_arena_take(&w->to->arena, w->t->keys,
                                             sizeof *input, w->err);
    w->to->input[row] = input;
    for (size_t k = 0; x && y && input && r->known >= ENOUGH && k < w->t->keys;
         k++) {
        const ovr_table_column *c = &w->t->column[k];
        const ovr_study_key *key = w->t->key[k];
        ovr_sample_input *in = &input[r->inputs];
        ovr_interval i = {NAN, NAN};
        size_t n = 0;
        if (!key->random || !ovr_table_numeric(c) || is_seed(key->where))
            continue;
        for (size_t d = 0; d < r->draws; d++)
            if (isfinite(value[d])) {
                x[n] = c->number[from + d];
                y[n++] = value[d];
            }
        *in = (ovr_sample_input){
            .key = ovr_arena_text(&w->to->arena, c->name, w->err),
            .related = key->related,
            .share = NAN};
        if (!in->related) {
            in->share = ovr_first_order(x, y, n, &arena);
            i = ovr_bootstrap(ovr_first_order, x, y, n, &arena.allocator);
        }
        in->share_low = i.low > 0 || isnan(i.low) ? i.low : 0;
        in->share_high = i.high < all || isnan(i.high) ? i.high : 1;
        in->rho = ovr_rank_correlation(x, y, n, &arena);
        i = ovr_bootstrap(ovr_rank_correlation, x, y, n, &arena.allocator);
        in->rho_low = i.low;
        in->rho_high = i.high;
        i = ovr_bin_ends(x, y, n, &arena);
        in->lowest = i.low;
        in->highest = i.high;
        r->inputs += in->key != NULL;
    }
    ovr_arena_release(&arena);
    return x && y && input ? OVR_OK : OVR_NO_MEMORY;
}

/* Returns the common beginning of the names of a group's tasks. */
static const char *group_name(sampling *w, size_t from)
{
    char text[OVR_STUDY_NAME];
    ovr_study_name(w->s, from, text, sizeof text);
    char *name = ovr_arena_text(&w->to->arena, text, w->err);
    char *draw = name ? strstr(name, "draw-") : NULL;
    if (draw)
        draw[draw > name ? -1 : 0] = '\0';
    return name;
}

/* Returns the values of the other keys, "mean_speed = 1 m/s, load = 20 kN/m".
 */
static const char *group_label(sampling *w, size_t from)
{
    ovr_words label = {""};
    for (size_t i = 0; i < w->s->keys; i++) {
        const ovr_study_key *key = &w->s->key[i];
        char value[OVR_STUDY_VALUE];
        if (!key->fixed && !key->random)
            ovr_words_add(&label, "%s%s = %s", *label.text ? ", " : "",
                          key->shown, ovr_study_value(w->s, key, from, value));
    }
    return ovr_arena_text(&w->to->arena, label.text, w->err);
}

static ovr_status compute_row(sampling *w, size_t row, size_t group,
                              const ovr_table_column *of)
{
    size_t draws = w->s->random.how.draws, from = group * draws;
    ovr_arena arena = ovr_arena_make(&w->s->arena.allocator);
    double *known = ovr_arena_take(&arena, draws, sizeof *known, w->err);
    double *value = ovr_arena_take(&arena, draws, sizeof *value, w->err);
    ovr_sample_row *r = &w->to->row[row];
    ovr_status status = known && value ? OVR_OK : OVR_NO_MEMORY;
    *r = (ovr_sample_row){.draws = draws};
    r->mean = r->sd = r->error = r->factor = NAN;
    r->group = group_name(w, from);
    r->label = group_label(w, from);
    r->quantity = ovr_arena_text(&w->to->arena, of->name, w->err);
    const ovr_quantity_name name = ovr_quantity_named(of->name);
    r->name = ovr_arena_text(&w->to->arena, name.text, w->err);
    r->unit = name.unit;
    if (!r->group || !r->label || !r->quantity || !r->name)
        status = OVR_NO_MEMORY;
    if (!status) {
        count_states(w, from, r);
        for (size_t i = 0; i < draws; i++) {
            double v = of->number[from + i];
            value[i] = is_number(w, from + i, v) ? v : NAN;
            if (isfinite(value[i]))
                known[r->known++] = value[i];
        }
        r->failed += r->finished - r->known;
        r->finished = r->known;
        if (r->known)
            compute_moments(known, r);
        compute_error(w, value, r);
        gsl_sort(known, 1, r->known);
        compute_quantiles(known, r);
        if (r->known)
            compute_limits(w, known, r);
        status = compute_inputs(w, from, value, row);
    }
    ovr_arena_release(&arena);
    return status;
}

static ovr_status compute_rows(sampling *w)
{
    ovr_sample *to = w->to;
    size_t groups = w->s->tasks / w->s->random.how.draws;
    ovr_status status = OVR_OK;
    to->rows = groups * w->quantities;
    to->row = ovr_arena_take(&to->arena, to->rows, sizeof *to->row, w->err);
    to->input = ovr_arena_take(&to->arena, to->rows, sizeof *to->input, w->err);
    if (ovr_arena_status(&to->arena))
        return OVR_NO_MEMORY;
    for (size_t k = 0; !status && k < to->rows; k++)
        status = compute_row(w, k, k / w->quantities,
                             w->quantity[k % w->quantities]);
    return status;
}

/* ----------------------------------------------------------------- creation */

ovr_sample *ovr_study_sample(const ovr_study *study, const char *quantities,
                             ovr_error *err)
{
    if (!study)
        return ovr_null(err, __func__);
    ovr_arena arena = ovr_arena_make(NULL);
    ovr_sample *to = ovr_arena_take(&arena, 1, sizeof *to, err);
    if (!to)
        return NULL;
    to->arena = arena;
    ovr_table *t = NULL;
    ovr_status status = OVR_OK;
    if (!ovr_study_random(study))
        status = ovr_fail(err, OVR_BAD_INPUT,
                          "%s: has no [random] section, which statistics need",
                          study->path);
    if (!status && !(t = ovr_study_table(study, err)))
        status = OVR_NO_MEMORY;
    sampling w = {.to = to, .s = study, .t = t, .err = err};
    if (!status)
        status = quantities ? add_requested(&w, quantities) : add_usual(&w);
    if (!status)
        status = compute_rows(&w);
    ovr_table_free(t);
    if (!status)
        return to;
    ovr_sample_free(to);
    return NULL;
}

void ovr_sample_free(ovr_sample *sample)
{
    if (sample) {
        ovr_arena arena = sample->arena;
        ovr_arena_release(&arena);
    }
}

const ovr_sample_row *ovr_sample_at(const ovr_sample *sample, size_t k)
{
    if (!sample || k >= sample->rows)
        return NULL;
    return &sample->row[k];
}

const ovr_sample_input *ovr_sample_input_at(const ovr_sample *sample,
                                            size_t row, size_t k)
{
    if (!sample || row >= sample->rows || k >= sample->row[row].inputs)
        return NULL;
    return &sample->input[row][k];
}

/* ------------------------------------------------------------------ writing */

static void write_number(FILE *to, double value)
{
    fputc(',', to);
    ovr_csv_number(to, isfinite(value) ? value : NAN, 17);
}

static void write_row(const ovr_sample *s, size_t k, FILE *to)
{
    const ovr_sample_row *r = &s->row[k];
    fprintf(to, "%s,%s,%zu,%zu,%zu,%zu", r->group, r->quantity, r->draws,
            r->finished, r->failed, r->marked);
    write_number(to, r->mean);
    write_number(to, r->error);
    write_number(to, r->sd);
    for (int i = 0; i < OVR_SAMPLE_QUANTILES; i++) {
        write_number(to, r->quantile[i]);
        write_number(to, r->low[i]);
        write_number(to, r->high[i]);
    }
    write_number(to, r->limits ? r->limit[0] : NAN);
    write_number(to, r->limits ? r->P[0] : NAN);
    write_number(to, r->limits ? r->P_low[0] : NAN);
    write_number(to, r->limits ? r->P_high[0] : NAN);
    for (size_t i = 0; i < r->inputs; i++) {
        write_number(to, s->input[k][i].share);
        write_number(to, s->input[k][i].rho);
    }
    fputc('\n', to);
}

ovr_status ovr_sample_write(const ovr_sample *sample, const char *path,
                            bool force, ovr_error *err)
{
    if (!sample || !path)
        return ovr_fail_null(err, __func__);
    if (!force && ovr_file_ours(path, "group,quantity,draws", err))
        return OVR_BAD_INPUT;
    FILE *to = fopen(path, "w");
    if (!to)
        return ovr_csv_end(to, path, err);
    fputs("group,quantity,draws,finished,failed,marked,mean,mean_error,sd", to);
    for (int i = 0; sample->rows && i < OVR_SAMPLE_QUANTILES; i++) {
        int percent = (int)lround(100 * sample->row[0].p[i]);
        fprintf(to, ",q%02d,q%02d_low,q%02d_high", percent, percent, percent);
    }
    fputs(",limit,P,P_low,P_high", to);
    for (size_t i = 0; sample->rows && i < sample->row[0].inputs; i++)
        fprintf(to, ",share_%s,rho_%s", sample->input[0][i].key,
                sample->input[0][i].key);
    fputc('\n', to);
    for (size_t k = 0; k < sample->rows; k++)
        write_row(sample, k, to);
    return ovr_csv_end(to, path, err);
}
