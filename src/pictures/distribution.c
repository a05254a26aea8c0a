/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Draws the statistics of a study's samples in four panels: histogram with
 * quantiles and limits, empirical distribution; and for each input the change
 * of the quantity from the input's lowest to its highest values, and its share
 * of the variance.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_sort.h>

#include "base/given.h"
#include "overroll/questions.h"
#include "pictures/picture.h"
#include "run/comparison.h"

enum { GROUPS = 6, INPUTS = 12, BINS = 60, LABEL = 200 };

typedef struct drawing {
    const ovr_figure_options *o;
    const ovr_sample *sample;
    const ovr_table_column *values; /* values of all tasks */
    const ovr_sample_row *row[GROUPS];
    size_t of[GROUPS]; /* rows of the statistics */
    size_t rows;
    double factor, low, high; /* in drawn units */
    char label[LABEL];
    ovr_arena *arena;
    ovr_error *err;
} drawing;

/* ----------------------------------------------------------------- choosing */

/* Makes the axis title of full name, symbol and unit.  Lengths are drawn in um
 * and pressures in GPa.  Commands of gnuplot, '_' and '^', are escaped. */
static void choose_axis(drawing *d)
{
    const char *key = d->row[0]->quantity, *at;
    const ovr_quantity_name name = ovr_quantity_named(key);
    const char *unit = name.unit;
    bool named = strcmp(name.text, key) != 0;
    size_t size = strlen(key), used = 0, text = strlen(name.text);
    size_t ending = 0, length;
    const char *symbol;
    char title[sizeof name.text + 40];
    d->factor = 1;
    if (size > 2 && !strcmp(key + size - 2, "_m")) {
        d->factor = 1e6;
        unit = "µm";
        ending = 2;
    } else if (size > 3 && !strcmp(key + size - 3, "_Pa")) {
        d->factor = 1e-9;
        unit = "GPa";
        ending = 3;
    }
    symbol = ovr_name_symbol(name.text, &length);
    snprintf(title, sizeof title, "%.*s", (int)(named ? length : text - ending),
             name.text);
    for (at = title; *at && used + 2 < LABEL; at++) {
        if (*at == '_' || *at == '^')
            d->label[used++] = '\\';
        d->label[used++] = *at;
    }
    snprintf(d->label + used, LABEL - used, "%s%s%s%s%s", symbol ? ", " : "",
             symbol ? symbol : "", *unit ? " (" : "", unit, *unit ? ")" : "");
}

/* Finds the rows of the quantity, one per group. */
static ovr_status choose_rows(drawing *d, const ovr_table *table)
{
    const ovr_sample_row *first = ovr_sample_at(d->sample, 0), *r;
    for (size_t k = 0; (r = ovr_sample_at(d->sample, k)); k++)
        if (!strcmp(r->quantity, first->quantity) && r->known > 1 &&
            d->rows < GROUPS) {
            d->of[d->rows] = k;
            d->row[d->rows++] = r;
        }
    const ovr_table_column *c;
    for (size_t k = 0; first && (c = ovr_table_at(table, k)); k++)
        if (!strcmp(c->name, first->quantity))
            d->values = c;
    if (!d->rows || !d->values)
        return ovr_fail(d->err, OVR_BAD_INPUT,
                        "no sample has finished yet; 'overroll sweep' runs "
                        "them");
    return OVR_OK;
}

/* Returns the values of a group, sorted, in drawn units. */
static double *sorted_values(const drawing *d, size_t group, size_t *count)
{
    const ovr_sample_row *r = d->row[group];
    size_t groups = 0, first = 0;
    const ovr_sample_row *other;
    double *v = ovr_arena_take(d->arena, r->draws, sizeof *v, d->err);
    for (size_t k = 0; (other = ovr_sample_at(d->sample, k)); k++)
        if (!strcmp(other->quantity, r->quantity)) {
            if (other == r)
                first = groups * r->draws;
            groups++;
        }
    *count = 0;
    for (size_t i = 0; v && i < r->draws; i++)
        if (isfinite(d->values->number[first + i]))
            v[(*count)++] = d->values->number[first + i] * d->factor;
    if (v)
        gsl_sort(v, 1, *count);
    return v;
}

/* ------------------------------------------------------------------- panels */

static const int colours[] = {OVR_BLUE,  OVR_AMBER,  OVR_GREEN, OVR_RED,
                              OVR_STEEL, OVR_VIOLET, OVR_GREY};
static int colour(size_t k)
{
    return colours[k % (sizeof colours / sizeof *colours)];
}

/* Adds a histogram in % of the samples, and the empirical distribution. */
static void add_group(drawing *d, size_t group, ovr_panel panel[2],
                      double *maximum)
{
    size_t n, bins, i = 0;
    double *v = sorted_values(d, group, &n);
    if (!v)
        return;
    bins = (size_t)ceil(2 * cbrt((double)n)); /* Rice's rule */
    bins = bins > BINS ? BINS : bins;
    double *x = ovr_arena_take(d->arena, 4 * bins + 4 * n, sizeof *x, NULL);
    double width = (v[n - 1] - v[0]) / (double)bins;
    if (!x)
        return;
    double *y = x + 2 * bins, *at = y + 2 * bins, *part = at + 2 * n;
    for (size_t b = 0; b < bins; b++) {
        double end = v[0] + width * (double)(b + 1), count = 0;
        for (; i < n && (v[i] < end || b + 1 == bins); i++)
            count++;
        x[2 * b] = end - width, x[2 * b + 1] = end;
        y[2 * b] = y[2 * b + 1] = 100 * count / (double)n;
        *maximum = fmax(*maximum, y[2 * b]);
    }
    for (size_t k = 0; k < n; k++) {
        at[2 * k] = at[2 * k + 1] = v[k];
        part[2 * k] = 100 * (double)k / (double)n;
        part[2 * k + 1] = 100 * (double)(k + 1) / (double)n;
    }
    ovr_panel_add(
        &panel[0], d->arena,
        (ovr_series){.label = d->rows > 1 ? d->row[group]->label : NULL,
                     .n = 2 * bins,
                     .x = x,
                     .y = y,
                     .colour = colour(group),
                     .mark = d->rows > 1 ? OVR_MARK_LINE : OVR_MARK_AREA});
    ovr_panel_add(
        &panel[1], d->arena,
        (ovr_series){.n = 2 * n, .x = at, .y = part, .colour = colour(group)});
    d->low = fmin(d->low, v[0]);
    d->high = fmax(d->high, v[n - 1]);
}

static void add_upright(drawing *d, ovr_panel *to, double at, ovr_series look)
{
    ovr_panel_line(to, d->arena, at, at, 0, 1e3, look);
}

/* Adds vertical lines: quantiles of a group (dotted), its median (dashed), and
 * limits. */
static void add_uprights(drawing *d, size_t group, ovr_panel *to)
{
    static const int shown[] = {1, 3, 5}; /* 5, 50, 95 % */
    const ovr_sample_row *r = d->row[group];
    for (int k = 0; k < 3; k++)
        add_upright(
            d, to, r->quantile[shown[k]] * d->factor,
            (ovr_series){.colour = colour(group),
                         .mark = k == 1 ? OVR_MARK_DASHED : OVR_MARK_DOTTED,
                         .width = 1.6});
    for (size_t k = 0; group == 0 && k < r->limits; k++) {
        double limit = r->limit[k] * d->factor;
        add_upright(d, to, limit,
                    (ovr_series){.colour = OVR_RED, .label = "limit"});
        d->low = fmin(d->low, limit);
        d->high = fmax(d->high, limit);
    }
}

/* Lists the inputs of the first group in the order of their influence. */
static size_t list_inputs(const drawing *d, const ovr_sample_input **to)
{
    const ovr_sample_input *in;
    size_t n = 0;
    for (size_t k = 0;
         n < INPUTS && (in = ovr_sample_input_at(d->sample, d->of[0], k));
         k++) {
        size_t j = n++;
        for (; j > 0 && fabs(to[j - 1]->highest - to[j - 1]->lowest) <
                            fabs(in->highest - in->lowest);
             j--)
            to[j] = to[j - 1];
        to[j] = in;
    }
    return n;
}

static void add_inputs(drawing *d, ovr_panel *tornado, ovr_panel *shares)
{
    const ovr_sample_input *in[INPUTS];
    size_t n = list_inputs(d, in);
    for (size_t k = 0; k < n; k++) {
        double y = (double)(n - k);
        char label[LABEL];
        snprintf(label, LABEL, "%.120s, rho %+.2f",
                 ovr_key_named(in[k]->key).text, in[k]->rho);
        ovr_panel_line(
            tornado, d->arena, in[k]->lowest * d->factor,
            in[k]->highest * d->factor, y, y,
            (ovr_series){.label = ovr_arena_text(d->arena, label, NULL),
                         .width = 8,
                         .colour = colour(k)});
        ovr_panel_line(shares, d->arena, in[k]->share_low, in[k]->share_high, y,
                       y, (ovr_series){.colour = colour(k)});
        ovr_panel_line(shares, d->arena, in[k]->share, in[k]->share, y, y,
                       (ovr_series){.colour = colour(k),
                                    .mark = OVR_MARK_POINTS,
                                    .width = 4});
    }
    tornado->y_from = shares->y_from = 0.4;
    tornado->y_to = shares->y_to = (double)n + 0.6;
    tornado->y_label = shares->y_label = "number of the input";
}

static ovr_status draw(drawing *d)
{
    ovr_panel panel[4] = {{0}};
    double maximum = 0;
    choose_axis(d);
    d->low = INFINITY;
    d->high = -INFINITY;
    for (size_t k = 0; k < d->rows; k++)
        add_group(d, k, panel, &maximum);
    for (size_t k = 0; k < d->rows; k++)
        add_uprights(d, k, &panel[0]);
    double margin = 0.03 * (d->high - d->low);
    for (int k = 0; k < 4; k++) {
        panel[k].x_label = d->label;
        panel[k].y_label = k == 1 ? "cumulative distribution (%)"
                                  : "share of the samples (%)";
        panel[k].x_from = d->low - margin;
        panel[k].x_to = d->high + margin;
        panel[k].y_to = k ? 100 : 1.08 * maximum;
    }
    panel[2].note = "mean at the lowest and highest values of the input";
    panel[3].note = "share of the variance with 95 % confidence interval";
    panel[3].x_label = "share of the variance";
    panel[3].x_from = 0;
    panel[3].x_to = 1;
    add_inputs(d, &panel[2], &panel[3]);
    ovr_chart chart = {.kind = "distribution",
                       .width = 1280,
                       .height = 800,
                       .rows = panel[2].count ? 2 : 1,
                       .columns = 2,
                       .panel = panel};
    return ovr_figure_draw(&chart, d->o, d->arena, d->err);
}

static ovr_status draw_study(const void *study, const ovr_figure_options *o,
                             ovr_arena *arena, ovr_error *err)
{
    ovr_table *table = NULL;
    ovr_sample *sample = ovr_study_sample(study, o->y, err);
    drawing d = {.o = o, .sample = sample, .arena = arena, .err = err};
    ovr_status status = OVR_OK;
    if (!sample || !(table = ovr_study_table(study, err)))
        status = OVR_BAD_INPUT;
    if (!status)
        status = choose_rows(&d, table);
    if (!status)
        status = draw(&d);
    ovr_sample_free(sample);
    ovr_table_free(table);
    return status;
}

ovr_status ovr_figure_distribution(const ovr_study *study,
                                   const ovr_figure_options *given,
                                   const ovr_allocator *allocator,
                                   ovr_error *err)
{
    if (!study)
        return ovr_fail_null(err, __func__);
    return ovr_figure_of(study, given, allocator, draw_study, err);
}
