/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The figure of a study: a quantity of its cases against one key, a line for
 * each value of a second one.  Cases that differ in other keys alone (seeds)
 * share a point: their mean, in a band from the smallest to the largest.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/plain.h"
#include "base/sized.h"
#include "pictures/picture.h"
#include "pictures/snapshot.h"

enum { LINES = 21, LABEL = 200 };

void ovr_figure_options_fill(ovr_figure_options *options)
{
    const ovr_figure_options defaults = {.force = false};
    ovr_sized_fill(options, &defaults, sizeof defaults);
}

typedef struct sample {
    size_t line;
    double x, y;
} sample;

typedef struct figure {
    const ovr_figure_options *o;
    const ovr_table *t;
    const ovr_table_column *x, *y, *by; /* by may be NULL */
    size_t lines, value[LINES];         /* a row that has the line's value */
    sample *sample;
    size_t samples;
    ovr_arena *arena;
} figure;

/* --------------------------------------------------------------- columns */

static const ovr_table_column *named(const ovr_table *t, const char *name)
{
    const ovr_table_column *c;
    for (size_t k = 0; (c = ovr_table_at(t, k)); k++)
        if (strcmp(c->name, name) == 0)
            break;
    return c;
}

static bool same(const ovr_table_column *c, size_t i, size_t j)
{
    return c->text ? strcmp(c->text[i], c->text[j]) == 0
                   : c->number[i] == c->number[j];
}

static bool varies(const ovr_table *t, const ovr_table_column *c)
{
    for (size_t i = 1; i < ovr_table_rows(t); i++)
        if (!same(c, 0, i))
            return true;
    return false;
}

/* Two keys that change together (zip) are one. */
static bool together(const ovr_table *t, const ovr_table_column *a,
                     const ovr_table_column *b)
{
    for (size_t i = 1; i < ovr_table_rows(t); i++)
        if (same(a, 0, i) != same(b, 0, i) ||
            same(a, i - 1, i) != same(b, i - 1, i))
            return false;
    return true;
}

static bool is_seed(const ovr_table_column *c)
{
    size_t size = strlen(c->name);
    return size >= 4 && strcmp(c->name + size - 4, "seed") == 0;
}

static bool is_numeric(const ovr_table *t, const ovr_table_column *c)
{
    for (size_t i = 0; i < ovr_table_rows(t); i++)
        if (!isfinite(c->number[i]))
            return false;
    return true;
}

/* The first key that varies and is neither a seed nor `x` again. */
static const ovr_table_column *next_key(const ovr_table *t,
                                        const ovr_table_column *x, bool numeric)
{
    const ovr_table_column *c;
    for (size_t k = 0; (c = ovr_table_at(t, k)) != NULL; k++) {
        bool other = !x || (c != x && !together(t, x, c));
        if (c->varied && other && !is_seed(c) && varies(t, c) &&
            (!numeric || is_numeric(t, c)))
            return c;
    }
    return NULL;
}

/* What there is, for messages. */
static const char *list(const ovr_table *t, bool varied, char *text,
                        size_t room)
{
    const ovr_table_column *c;
    size_t used = 0;
    *text = '\0';
    for (size_t k = 0; (c = ovr_table_at(t, k)) && used + 80 < room; k++)
        if (c->varied == varied && strcmp(c->name, "task") != 0 &&
            strcmp(c->name, "name") != 0 && strcmp(c->name, "status") != 0)
            used += (size_t)snprintf(text + used, room - used, "%s%.60s",
                                     used ? ", " : "", c->name);
    return text;
}

static ovr_status no_column(const figure *f, const char *name, bool varied,
                            ovr_error *err)
{
    char there[700];
    if (!varied && !*list(f->t, false, there, sizeof there))
        return ovr_fail(err, OVR_BAD_INPUT,
                        "no case has finished yet: 'overroll sweep' runs them");
    return ovr_fail(err, OVR_BAD_INPUT, "no %s '%.60s'; there are %s",
                    varied ? "key of the study" : "quantity", name,
                    list(f->t, varied, there, sizeof there));
}

static ovr_status choose_columns(figure *f, ovr_error *err)
{
    const ovr_figure_options *o = f->o;
    const char *y = o->y ? o->y : "H_min_overall";
    f->y = named(f->t, y);
    if (!f->y && !o->y)
        f->y = named(f->t, y = "H_min");
    if (!f->y)
        return no_column(f, y, false, err);
    f->x = o->x ? named(f->t, o->x) : next_key(f->t, NULL, true);
    if (!f->x)
        return o->x ? no_column(f, o->x, true, err)
                    : ovr_fail(err, OVR_BAD_INPUT,
                               "the study varies no key with numbers");
    if (!is_numeric(f->t, f->x))
        return ovr_fail(err, OVR_BAD_INPUT, "'%.60s' is not a key of numbers",
                        f->x->name);
    f->by = !o->by   ? next_key(f->t, f->x, false)
            : *o->by ? named(f->t, o->by)
                     : NULL;
    if (o->by && *o->by && !f->by)
        return no_column(f, o->by, true, err);
    return OVR_OK;
}

/* --------------------------------------------------------------- samples */

static ovr_status find_line(figure *f, size_t row, size_t *line, ovr_error *err)
{
    for (*line = 0; *line < f->lines; ++*line)
        if (!f->by || same(f->by, f->value[*line], row))
            return OVR_OK;
    if (f->lines == LINES)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "'%.60s' has more than %d values: too many lines",
                        f->by->name, LINES);
    f->value[f->lines++] = row;
    return OVR_OK;
}

static int in_order(const void *a, const void *b)
{
    const sample *p = a, *q = b;
    if (p->line != q->line)
        return p->line > q->line ? 1 : -1;
    return (p->x > q->x) - (p->x < q->x);
}

static ovr_status take_samples(figure *f, ovr_error *err)
{
    size_t rows = ovr_table_rows(f->t);
    f->sample = ovr_arena_take(f->arena, rows, sizeof *f->sample, err);
    if (!f->sample || !f->x || !f->y)
        return OVR_NO_MEMORY;
    for (size_t i = 0; i < rows; i++) {
        sample *s = &f->sample[f->samples];
        if (!isfinite(f->y->number[i]))
            continue;
        if (find_line(f, i, &s->line, err))
            return OVR_BAD_INPUT;
        s->x = f->x->number[i];
        s->y = f->y->number[i];
        f->samples++;
    }
    if (!f->samples)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "no case has a value of '%.60s' yet: 'overroll sweep' "
                        "runs them",
                        f->y->name);
    qsort(f->sample, f->samples, sizeof *f->sample, in_order);
    return OVR_OK;
}

/* ------------------------------------------------------------------- axes */

typedef struct axis {
    double factor;
    char label[LABEL];
} axis;

/* A name for gnuplot's enhanced text: nothing in it means anything. */
static void put_plain(char *to, size_t room, const char *name, size_t size)
{
    size_t used = strlen(to);
    for (size_t i = 0; i < size && used + 5 < room; i++) {
        char c = name[i];
        if (c == '_')
            used += (size_t)snprintf(to + used, room - used, "\\_");
        else if ((c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') ||
                 (c >= 'A' && c <= 'Z') || strchr(" .-/", c))
            to[used++] = c, to[used] = '\0';
    }
}

/* SI numbers in the largest unit that leaves a tenth; "H_min_m" is in m. */
static axis axis_of(const ovr_table_column *c, double largest)
{
    static const struct {
        const char *si, *ending;
        struct {
            double size;
            const char *name;
        } unit[3];
    } kinds[] = {{"m", "_m", {{1e-3, "mm"}, {1e-6, "µm"}, {1e-9, "nm"}}},
                 {"Pa", "_Pa", {{1e9, "GPa"}, {1e6, "MPa"}, {1e3, "kPa"}}},
                 {"s", "_s", {{1, "s"}, {1e-3, "ms"}, {1e-6, "µs"}}},
                 {"N/m", "_N_per_m", {{1e3, "kN/m"}, {1, "N/m"}, {1, "N/m"}}}};
    axis a = {1, ""};
    size_t size = strlen(c->name);
    for (size_t k = 0; k < sizeof kinds / sizeof kinds[0]; k++) {
        size_t ending = strlen(kinds[k].ending);
        bool ends = !*c->unit && !c->varied && size > ending &&
                    !strcmp(c->name + size - ending, kinds[k].ending);
        int u = 0;
        if (!ends && strcmp(c->unit, kinds[k].si) != 0)
            continue;
        while (u < 2 && !(largest >= 0.1 * kinds[k].unit[u].size))
            u++;
        a.factor = 1 / kinds[k].unit[u].size;
        put_plain(a.label, LABEL, c->name, ends ? size - ending : size);
        snprintf(a.label + strlen(a.label), LABEL - strlen(a.label), "  [%s]",
                 kinds[k].unit[u].name);
        return a;
    }
    put_plain(a.label, LABEL, c->name, size);
    if (*c->unit) {
        char unit[40] = "";
        put_plain(unit, sizeof unit, c->unit, strlen(c->unit));
        snprintf(a.label + strlen(a.label), LABEL - strlen(a.label), "  [%s]",
                 unit);
    }
    return a;
}

/* ------------------------------------------------------------------ lines */

/* The samples first .. end-1 of a line as points of mean, least, most. */
static ovr_status add_line(const figure *f, size_t first, size_t end,
                           ovr_series *series, ovr_error *err)
{
    size_t n = end - first, m = 0;
    double *block = ovr_arena_take(f->arena, n, 4 * sizeof *block, err);
    double *x = block, *mean, *low, *high;
    ovr_curve_style as = ovr_curve_style_of(f->sample[first].line);
    if (!block)
        return OVR_NO_MEMORY;
    mean = block + n, low = mean + n, high = low + n;
    for (size_t i = first, j; i < end; i = j, m++) {
        x[m] = f->sample[i].x;
        mean[m] = 0;
        low[m] = INFINITY, high[m] = -INFINITY;
        for (j = i; j < end && f->sample[j].x == x[m]; j++) {
            mean[m] += f->sample[j].y;
            low[m] = fmin(low[m], f->sample[j].y);
            high[m] = fmax(high[m], f->sample[j].y);
        }
        mean[m] /= (double)(j - i);
    }
    for (int k = 0; k < 3; k++)
        series[k] = (ovr_series){
            .n = m, .x = x, .y = mean, .colour = as.colour};
    series[0].y = low;
    series[0].to = high;
    series[0].mark = OVR_MARK_BAND;
    series[1].mark = as.mark;
    series[2].mark = OVR_MARK_POINTS;
    series[2].width = 2.4;
    return OVR_OK;
}

static const char *line_label(const figure *f, size_t line, ovr_error *err)
{
    char text[LABEL];
    size_t row = f->value[line];
    if (!f->by)
        return NULL;
    if (f->by->text)
        snprintf(text, sizeof text, "%.60s = %.60s", f->by->name,
                 f->by->text[row]);
    else
        snprintf(text, sizeof text, "%.60s = %g%s%.20s", f->by->name,
                 f->by->number[row], *f->by->unit ? " " : "", f->by->unit);
    return ovr_arena_text(f->arena, text, err);
}

/* Bands below, lines and points above. */
static ovr_status add_lines(const figure *f, ovr_series *series, axis *x,
                            axis *y, ovr_error *err)
{
    size_t lines = f->lines, first = 0;
    double most_x = 0, most_y = 0;
    for (size_t i = 0; i < f->samples; i++) {
        most_x = fmax(most_x, fabs(f->sample[i].x));
        most_y = fmax(most_y, fabs(f->sample[i].y));
    }
    *x = axis_of(f->x, most_x);
    *y = axis_of(f->y, most_y);
    for (size_t k = 0; k < lines; k++) {
        ovr_series three[3];
        size_t end = first;
        while (end < f->samples && f->sample[end].line == k)
            end++;
        if (add_line(f, first, end, three, err))
            return OVR_NO_MEMORY;
        three[1].label = line_label(f, k, err);
        for (size_t j = 0; j < 3; j++) {
            three[j].x_factor = x->factor;
            three[j].factor = y->factor;
            series[j * lines + k] = three[j];
        }
        first = end;
    }
    return OVR_OK;
}

/* A little room beside the outer points. */
static void set_range(const figure *f, const axis *x, ovr_panel *panel)
{
    double low = INFINITY, high = -INFINITY, room;
    for (size_t i = 0; i < f->samples; i++) {
        low = fmin(low, f->sample[i].x * x->factor);
        high = fmax(high, f->sample[i].x * x->factor);
    }
    if (f->o->log_x && low > 0) {
        room = pow(high / low, 0.04);
        panel->x_from = low / room;
        panel->x_to = high * room;
    } else if (!f->o->log_x && high > low) {
        room = 0.04 * (high - low);
        panel->x_from = low - room;
        panel->x_to = high + room;
    }
}

static ovr_status draw(figure *f, ovr_error *err)
{
    const ovr_figure_options *o = f->o;
    ovr_series *series = ovr_arena_take(f->arena, 3 * f->lines, sizeof *series,
                                        err);
    axis x, y;
    ovr_panel panel = {.x_from = NAN, .x_to = NAN, .y_from = NAN, .y_to = NAN};
    ovr_chart chart = {.title = o->title,
                       .width = o->width > 0 ? o->width : 960,
                       .height = o->height > 0 ? o->height : 640,
                       .rows = 1,
                       .columns = 1,
                       .panel = &panel};
    if (!series || add_lines(f, series, &x, &y, err))
        return OVR_NO_MEMORY;
    set_range(f, &x, &panel);
    panel.x_label = x.label;
    panel.y_label = y.label;
    panel.log_x = o->log_x;
    panel.log_y = o->log_y;
    panel.count = 3 * f->lines;
    panel.series = series;
    return ovr_chart_draw(&chart, o->template_path, o->path, o->script,
                          f->arena, err);
}

ovr_status ovr_figure(const ovr_table *table, const ovr_figure_options *given,
                      const ovr_allocator *allocator, ovr_error *err)
{
    ovr_figure_options own, *options = &own;
    if (OVR_SIZED_TAKE(ovr_figure_options, options, given, err))
        return OVR_BAD_INPUT;
    locale_t before = ovr_plain_begin();
    ovr_arena arena = ovr_arena_make(allocator);
    figure f = {.o = options, .t = table, .arena = &arena};
    ovr_form form;
    ovr_status status = ovr_may_create(options->path, options->force, err);
    if (!status)
        status = ovr_form_of(options->path, &form, err);
    if (!status)
        status = choose_columns(&f, err);
    if (!status)
        status = take_samples(&f, err);
    if (!status)
        status = draw(&f, err);
    ovr_arena_release(&arena);
    ovr_plain_end(before);
    return status;
}
