/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The figure of a study: a quantity of its cases against one key, with a line
 * for each value of a second key and a panel for each combination of the
 * others. Cases that differ only in seeds share a point: their mean, with a
 * band from minimum to maximum. Against a seed the figure is a histogram of the
 * quantity, with quantiles.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/given.h"
#include "base/text.h"
#include "overroll/text.h"
#include "pictures/picture.h"
#include "pictures/snapshot.h"
#include "run/comparison.h"
#include "run/study_table.h"

enum { LINES = 21, PANELS = 12, KEYS = 16, LABEL = 240, ENOUGH = 3000 };

typedef struct sample {
    size_t panel, line;
    double x, y;
} sample;

/* Keys whose values define groups of cases, and a row of each group. */
typedef struct groups {
    const ovr_table_column *key[KEYS];
    size_t keys, row[LINES], count;
} groups;

typedef struct axis {
    double factor;
    char label[LABEL], unit[40];
} axis;

typedef struct figure {
    const ovr_figure_options *o;
    const ovr_table *t;
    const ovr_table_column *x, *y;
    groups lines, panels;
    sample *sample;
    size_t samples;
    bool banded; /* some points represent several cases */
    axis x_axis, y_axis;
    double x_from, x_to, y_from, y_to; /* drawn range */
    bool log_x;
    ovr_arena *arena;
} figure;

/* --------------------------------------------------------------- columns */

/* Returns row k of those that are compared: all rows, or a pseudorandom subset
 * of many. */
static size_t some_row(const ovr_table *t, size_t k)
{
    size_t rows = ovr_table_rows(t);
    return rows > ENOUGH ? k * 2654435761u % rows : k;
}

/* True if rows with equal values of `a` (NULL: all rows) have equal values of
 * `b`, as for keys of a [zip]. */
static bool determines(const ovr_table *t, const ovr_table_column *a,
                       const ovr_table_column *b)
{
    for (size_t i = 1; i < ovr_table_rows(t) && i < ENOUGH; i++) {
        size_t row = some_row(t, i), first = 0;
        while (a && first < i && !ovr_table_same(a, some_row(t, first), row))
            first++;
        if (first < i && !ovr_table_same(b, some_row(t, first), row))
            return false;
    }
    return true;
}

static bool of_zip(const ovr_table_column *c, const char *name)
{
    return c->zip && strcmp(c->zip, name) == 0;
}

/* Returns the column with a name; for a [zip NAME] the first key that
 * identifies its values. */
static const ovr_table_column *named(const ovr_table *t, const char *name)
{
    const ovr_table_column *c, *other, *best = NULL;
    for (size_t k = 0; (c = ovr_table_at(t, k)) != NULL; k++)
        if (strcmp(c->name, name) == 0)
            return c;
    for (size_t k = 0; !best && (c = ovr_table_at(t, k)) != NULL; k++) {
        bool all = of_zip(c, name);
        for (size_t j = 0; all && (other = ovr_table_at(t, j)) != NULL; j++)
            all = !of_zip(other, name) || determines(t, c, other);
        best = all ? c : NULL;
    }
    for (size_t k = 0; !best && (c = ovr_table_at(t, k)) != NULL; k++)
        best = of_zip(c, name) ? c : NULL;
    return best;
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

static bool is_printed(const figure *f, const ovr_table_column *c)
{
    bool told = determines(f->t, NULL, c) ||
                (f->x && determines(f->t, f->x, c));
    for (size_t k = 0; !told && k < f->lines.keys; k++)
        told = determines(f->t, f->lines.key[k], c);
    for (size_t k = 0; !told && k < f->panels.keys; k++)
        told = determines(f->t, f->panels.key[k], c);
    return told;
}

/* Returns the first varying key that is not used yet; a seed only if `seed`. */
static const ovr_table_column *next_key(const figure *f, bool numeric,
                                        bool seed)
{
    const ovr_table_column *c;
    for (size_t k = 0; (c = ovr_table_at(f->t, k)) != NULL; k++)
        if (c->varied && is_seed(c) == seed && !is_printed(f, c) &&
            (!numeric || is_numeric(f->t, c)))
            return c;
    return NULL;
}

/* Lists for messages the names of columns, or of keys and zips. */
static const char *list(const ovr_table *t, bool varied, char *text,
                        size_t capacity)
{
    const ovr_table_column *c;
    const char *zip = NULL;
    size_t used = 0;
    *text = '\0';
    for (size_t k = 0; (c = ovr_table_at(t, k)) && used + 160 < capacity; k++) {
        if (c->varied != varied || strcmp(c->name, "task") == 0 ||
            strcmp(c->name, "name") == 0 || strcmp(c->name, "status") == 0)
            continue;
        used += (size_t)snprintf(text + used, capacity - used, "%s%.60s",
                                 used ? ", " : "", c->name);
        if (c->zip && *c->zip && (!zip || strcmp(c->zip, zip) != 0))
            used += (size_t)snprintf(text + used, capacity - used, ", %.60s",
                                     zip = c->zip);
    }
    return text;
}

/* Returns the most similar name, or NULL. */
static const char *nearest(const ovr_table *t, bool varied, const char *name)
{
    const char *names[256];
    const ovr_table_column *c;
    size_t n = 0;
    for (size_t k = 0; (c = ovr_table_at(t, k)) && n < 256; k++)
        if (c->varied == varied)
            names[n++] = c->name;
    return ovr_suggest(name, names, n);
}

static ovr_status no_column(const figure *f, const char *name, bool varied,
                            ovr_error *err)
{
    char there[700], hint[100] = "";
    const char *meant = nearest(f->t, varied, name);
    if (!varied && !*list(f->t, false, there, sizeof there))
        return ovr_table_fail_empty(f->t, err);
    if (meant)
        snprintf(hint, sizeof hint, " did you mean '%.60s'?", meant);
    return ovr_fail(err, OVR_BAD_INPUT, "no %s '%.60s';%s there are %s",
                    varied ? "key of the study" : "quantity", name, hint,
                    list(f->t, varied, there, sizeof there));
}

/* Returns the column of the minimum film thickness, over the run if the film is
 * transient and in metres if the contact has dimensions; NULL: none. */
static const ovr_table_column *usual_quantity(const figure *f)
{
    static const char *const names[] = {"H_min_overall_m",    "H_min_overall",
                                        "min_film_located_m", "H_min_located",
                                        "min_film_m",         "H_min"};
    const ovr_table_column *c = NULL;
    for (size_t k = 0; !c && k < sizeof names / sizeof *names; k++)
        c = named(f->t, names[k]);
    return c;
}

/* Chooses the requested key, none for "", or the next one that varies. */
static ovr_status choose_group(const figure *f, const char *asked, groups *to,
                               ovr_error *err)
{
    const ovr_table_column *c = asked && *asked ? named(f->t, asked)
                                : asked         ? NULL
                                                : next_key(f, false, false);
    if (asked && *asked && (!c || !c->varied))
        return no_column(f, asked, true, err);
    if (c)
        to->key[to->keys++] = c;
    return OVR_OK;
}

static ovr_status choose_x(figure *f, ovr_error *err)
{
    const char *x = f->o->x;
    f->x = x ? named(f->t, x) : next_key(f, true, false);
    if (!x && !f->x)
        f->x = next_key(f, true, true);
    if (x && (!f->x || !f->x->varied))
        return no_column(f, x, true, err);
    if (!f->x)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "the study varies no numeric key to draw against");
    if (!is_numeric(f->t, f->x))
        return ovr_fail(
            err, OVR_BAD_INPUT,
            "the values of '%.60s' are not numbers; use another key",
            f->x->name);
    return OVR_OK;
}

static ovr_status choose_columns(figure *f, ovr_error *err)
{
    const ovr_figure_options *o = f->o;
    f->y = o->y ? named(f->t, o->y) : usual_quantity(f);
    if (!f->y)
        return no_column(f, o->y ? o->y : "H_min", false, err);
    if (choose_x(f, err) || choose_group(f, o->by, &f->lines, err) ||
        choose_group(f, o->panels, &f->panels, err))
        return OVR_BAD_INPUT;
    while (!o->panels && f->panels.keys && f->panels.keys < KEYS) {
        const ovr_table_column *more = next_key(f, false, false);
        if (!more)
            break;
        f->panels.key[f->panels.keys++] = more;
    }
    return OVR_OK;
}

/* --------------------------------------------------------------- samples */

static ovr_status find_group(groups *g, size_t row, size_t maximum,
                             const char *what, size_t *which, ovr_error *err)
{
    for (*which = 0; *which < g->count; ++*which) {
        bool all = true;
        for (size_t k = 0; all && k < g->keys; k++)
            all = ovr_table_same(g->key[k], g->row[*which], row);
        if (all)
            return OVR_OK;
    }
    if (g->count == maximum)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "'%.60s' has more values than the maximum number of "
                        "%s, %zu; select keys by --against, --lines and "
                        "--panels",
                        g->key[g->keys - 1]->name, what, maximum);
    g->row[g->count++] = row;
    return OVR_OK;
}

static int in_order(const void *a, const void *b)
{
    const sample *p = a, *q = b;
    if (p->panel != q->panel)
        return p->panel > q->panel ? 1 : -1;
    if (p->line != q->line)
        return p->line > q->line ? 1 : -1;
    return (p->x > q->x) - (p->x < q->x);
}

static ovr_status collect_samples(figure *f, ovr_error *err)
{
    size_t rows = ovr_table_rows(f->t);
    f->sample = ovr_arena_take(f->arena, rows, sizeof *f->sample, err);
    if (!f->sample || !f->x || !f->y)
        return OVR_NO_MEMORY;
    for (size_t i = 0; i < rows; i++) {
        sample *s = &f->sample[f->samples];
        if (!isfinite(f->y->number[i]))
            continue;
        if (find_group(&f->lines, i, LINES, "lines", &s->line, err) ||
            find_group(&f->panels, i, PANELS, "panels", &s->panel, err))
            return OVR_BAD_INPUT;
        s->x = f->x->number[i];
        s->y = f->y->number[i];
        f->samples++;
    }
    if (!f->samples)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "no case has a value of '%.60s' yet; 'overroll "
                        "sweep' runs them",
                        f->y->name);
    qsort(f->sample, f->samples, sizeof *f->sample, in_order);
    for (size_t i = 1; i < f->samples; i++)
        f->banded = f->banded ||
                    in_order(&f->sample[i - 1], &f->sample[i]) == 0;
    return OVR_OK;
}

/* ------------------------------------------------------------------- axes */

/* Escapes a name for gnuplot's enhanced text. */
static void append_plain(char *to, size_t capacity, const char *name,
                         size_t size)
{
    size_t used = strlen(to);
    for (size_t i = 0; i < size && used + 5 < capacity; i++) {
        char c = name[i];
        if (c == '_')
            used += (size_t)snprintf(to + used, capacity - used, "\\_");
        else if ((c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') ||
                 (c >= 'A' && c <= 'Z') || strchr(" .-/%',", c) ||
                 (unsigned char)c >= 0x80)
            to[used++] = c, to[used] = '\0';
    }
}

/* Returns a unit with its printed symbols instead of ASCII. */
static const char *printed(const char *unit)
{
    return strcmp(unit, "um") == 0      ? "µm"
           : strcmp(unit, "us") == 0    ? "µs"
           : strcmp(unit, "degC") == 0  ? "°C"
           : strcmp(unit, "b^2/R") == 0 ? "b²/R"
                                        : unit;
}

/* Returns the unit in which all values of a key were written ("rpm"), and its
 * size in the table's unit; NULL if there are several or none. */
static const char *unit_written(const figure *f, const ovr_table_column *c,
                                double *size)
{
    const char *unit = NULL;
    for (size_t i = 0; c->text && i < ovr_table_rows(f->t); i++) {
        const char *at = c->text[i];
        double value;
        if (!ovr_read_number(&at, &value))
            return NULL;
        at += strspn(at, " ");
        if (!*at || (unit && strcmp(unit, at) != 0))
            return NULL;
        unit = at;
        if (value != 0)
            *size = c->number[i] / value;
    }
    return unit;
}

/* Makes an axis title, "minimum film thickness (um)", "reduced radius, R (mm)";
 * for a quantity without a name the first `size` characters of its key. */
static void title_axis(axis *a, const ovr_table_column *c, size_t size)
{
    const ovr_quantity_name name = c->varied ? ovr_key_named(c->name)
                                             : ovr_quantity_named(c->name);
    size_t length;
    const char *symbol = ovr_name_symbol(name.text, &length);
    if (!*a->unit)
        snprintf(a->unit, sizeof a->unit, "%s", printed(name.unit));
    if (!c->varied && !strcmp(name.text, c->name))
        append_plain(a->label, LABEL, c->name, size);
    else
        append_plain(a->label, LABEL, name.text, length);
    if (symbol)
        snprintf(a->label + strlen(a->label), LABEL - strlen(a->label), ", %s",
                 symbol);
    if (*a->unit) {
        snprintf(a->label + strlen(a->label), LABEL - strlen(a->label), " (");
        append_plain(a->label, LABEL, a->unit, strlen(a->unit));
        snprintf(a->label + strlen(a->label), LABEL - strlen(a->label), ")");
    }
}

/* Makes an axis. SI numbers have the unit in which they were written, otherwise
 * the largest one in which they exceed 0.1; "H_min_m" is in m. */
static axis axis_of(const figure *f, const ovr_table_column *c, double largest)
{
    static const struct {
        const char *si, *ending;
        struct {
            double size;
            const char *name;
        } unit[3];
    } kinds[] = {
        {"m", "_m", {{1e-3, "mm"}, {1e-6, "µm"}, {1e-9, "nm"}}},
        {"Pa", "_Pa", {{1e9, "GPa"}, {1e6, "MPa"}, {1e3, "kPa"}}},
        {"s", "_s", {{1, "s"}, {1e-3, "ms"}, {1e-6, "µs"}}},
        {"N/m", "_N_per_m", {{1e3, "kN/m"}, {1, "N/m"}, {1, "N/m"}}},
        {"rad/s",
         "_rad_per_s",
         {{0.10471975511965977, "rpm"}, {1, NULL}, {1, NULL}}},
        {"Pa.s", "_Pa_s", {{1, "Pa.s"}, {1e-3, "mPa.s"}, {1e-3, "mPa.s"}}},
        {"1/Pa", "_per_Pa", {{1e-9, "1/GPa"}, {1, NULL}, {1, NULL}}}};
    axis a = {.factor = 1};
    size_t size = strlen(c->name);
    double one = 1;
    const char *unit = unit_written(f, c, &one);
    for (size_t k = 0; !unit && k < sizeof kinds / sizeof kinds[0]; k++) {
        size_t ending = strlen(kinds[k].ending);
        bool ends = !c->varied && size > ending &&
                    !strcmp(c->name + size - ending, kinds[k].ending);
        int u = 0;
        if (!ends && strcmp(c->unit, kinds[k].si) != 0)
            continue;
        while (u < 2 && kinds[k].unit[u + 1].name &&
               !(largest >= 0.1 * kinds[k].unit[u].size))
            u++;
        one = kinds[k].unit[u].size;
        unit = kinds[k].unit[u].name;
        size -= ends ? ending : 0;
    }
    a.factor = 1 / one;
    snprintf(a.unit, sizeof a.unit, "%s", printed(unit ? unit : c->unit));
    title_axis(&a, c, size);
    return a;
}

static void make_axes(figure *f)
{
    double max_x = 0, max_y = 0;
    for (size_t i = 0; i < f->samples; i++) {
        max_x = fmax(max_x, fabs(f->sample[i].x));
        max_y = fmax(max_y, fabs(f->sample[i].y));
    }
    f->x_axis = axis_of(f, f->x, max_x);
    f->y_axis = axis_of(f, f->y, max_y);
}

/* Names a group by its values: "Rq = 0.05 µm, level = 8". */
static void name_group(const figure *f, const groups *g, size_t which,
                       char *text, size_t capacity)
{
    size_t used = 0, row = g->row[which];
    *text = '\0';
    for (size_t k = 0; k < g->keys && used + 140 < capacity; k++) {
        const ovr_table_column *c = g->key[k];
        axis a = axis_of(f, c, fabs(c->number[row]));
        const ovr_quantity_name name = ovr_key_named(c->name);
        size_t length;
        ovr_name_symbol(name.text, &length);
        used += (size_t)snprintf(text + used, capacity - used,
                                 "%s%.*s = ", used ? ", " : "",
                                 length < 60 ? (int)length : 60, name.text);
        if (isfinite(c->number[row]))
            used += (size_t)snprintf(text + used, capacity - used,
                                     "%.6g%s%.20s", c->number[row] * a.factor,
                                     *a.unit ? " " : "", a.unit);
        else
            used += (size_t)snprintf(text + used, capacity - used, "%.60s",
                                     c->text ? c->text[row] : "?");
    }
}

/* Returns the end of the samples of a panel and line, which begin at *first. */
static size_t end_of(const figure *f, size_t panel, size_t line, size_t *first)
{
    size_t end;
    while (*first < f->samples && (f->sample[*first].panel < panel ||
                                   (f->sample[*first].panel == panel &&
                                    f->sample[*first].line < line)))
        ++*first;
    for (end = *first; end < f->samples && f->sample[end].panel == panel &&
                       f->sample[end].line == line;)
        end++;
    return end;
}

/* ------------------------------------------------------------------ lines */

/* Makes points of mean, minimum and maximum from the samples first .. end-1: a
 * band, a line and points. */
static bool make_line(const figure *f, size_t first, size_t end,
                      ovr_curve_style as, ovr_series *series)
{
    size_t n = end - first, m = 0;
    double *block = ovr_arena_take(f->arena, n + 1, 4 * sizeof *block, NULL);
    double *x = block, *mean, *low, *high;
    if (!block)
        return false;
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
        series[k] = (ovr_series){.n = m,
                                 .x = x,
                                 .y = k ? mean : low,
                                 .to = k ? NULL : high,
                                 .x_factor = f->x_axis.factor,
                                 .factor = f->y_axis.factor,
                                 .colour = as.colour,
                                 .mark = k == 0   ? OVR_MARK_BAND
                                         : k == 1 ? as.mark
                                                  : OVR_MARK_POINTS,
                                 .width = k == 2 ? 2.4 : 0};
    return true;
}

/* Writes the names of the keys over which the band extends: those shown by
 * neither axis, line nor panel. */
static void name_band(const figure *f, char *text, size_t capacity)
{
    const ovr_table_column *c;
    size_t used = (size_t)snprintf(text, capacity,
                                   "band: minimum to maximum over");
    bool any = false;
    for (size_t k = 0; (c = ovr_table_at(f->t, k)) && used + 70 < capacity; k++)
        if (c->varied && !is_printed(f, c)) {
            used += (size_t)snprintf(text + used, capacity - used, "%s %.60s",
                                     any ? "," : "",
                                     ovr_key_named(c->name).text);
            any = true;
        }
}

/* Draws bands first, then lines and points. */
static void draw_lines(figure *f, size_t panel, ovr_panel *to)
{
    size_t lines = f->lines.count, first = 0;
    ovr_series(*three)[3] = ovr_arena_take(f->arena, lines, sizeof *three,
                                           NULL);
    char text[LABEL];
    for (size_t k = 0; three && k < lines; k++) {
        size_t end = end_of(f, panel, k, &first);
        if (!make_line(f, first, end, ovr_curve_style_of(k), three[k]))
            return;
        name_group(f, &f->lines, k, text, sizeof text);
        if (f->lines.keys && panel == 0)
            three[k][1].label = ovr_arena_text(f->arena, text, NULL);
    }
    if (three && f->banded && panel == 0) {
        name_band(f, text, sizeof text);
        three[0][0].label = ovr_arena_text(f->arena, text, NULL);
    }
    for (size_t j = 0; three && j < 3 * lines; j++)
        ovr_panel_add(to, f->arena, three[j % lines][j / lines]);
}

/* ------------------------------------------------------------- histograms */

static int by_value(const void *a, const void *b)
{
    double s = ((const sample *)a)->y, t = ((const sample *)b)->y;
    return (s > t) - (s < t);
}

/* Computes a quantile of sorted samples, linear between them (Hyndman and Fan's
 * type 7). */
static double quantile(const sample *s, size_t n, double part)
{
    double at = part * (double)(n - 1);
    size_t k = (size_t)at;
    return k + 1 < n ? s[k].y + (at - (double)k) * (s[k + 1].y - s[k].y)
                     : s[n - 1].y;
}

/* Adds a histogram in % of the cases and three vertical lines. */
static void add_bins(figure *f, const sample *s, size_t n, size_t bins,
                     ovr_curve_style as, const char *label, ovr_panel *to)
{
    double low = to->x_from, width = (to->x_to - low) / (double)bins;
    double *x = ovr_arena_take(f->arena, 4 * bins, sizeof *x, NULL);
    if (!x)
        return;
    double *y = x + 2 * bins, maximum = 0;
    for (size_t b = 0, i = 0; b < bins; b++) {
        double end = low + width * (double)(b + 1), count = 0;
        for (; i < n && (s[i].y * f->y_axis.factor < end || b + 1 == bins); i++)
            count++;
        x[2 * b] = end - width, x[2 * b + 1] = end;
        y[2 * b] = y[2 * b + 1] = 100 * count / (double)n;
        maximum = fmax(maximum, y[2 * b]);
    }
    f->y_to = fmax(f->y_to, 1.08 * maximum);
    ovr_panel_add(
        to, f->arena,
        (ovr_series){.label = label,
                     .n = 2 * bins,
                     .x = x,
                     .y = y,
                     .colour = as.colour,
                     .mark = f->lines.count > 1 ? as.mark : OVR_MARK_AREA});
}

static const double parts[] = {0.05, 0.5, 0.95};

static void add_quantiles(const figure *f, const double q[3],
                          ovr_curve_style as, ovr_panel *to)
{
    for (int k = 0; k < 3; k++)
        ovr_panel_line(
            to, f->arena, q[k], q[k], 0, 1e3, /* beyond the axis */
            (ovr_series){.colour = as.colour,
                         .mark = k == 1 ? OVR_MARK_DASHED : OVR_MARK_DOTTED,
                         .width = 1.6});
}

/* Returns a line's quantiles: in its label for the legend, which is in the
 * first panel, or with several panels in the note of each. */
static const char *label_of(const figure *f, size_t panel, size_t line,
                            const double q[3], ovr_panel *to)
{
    bool alone = f->panels.count == 1;
    char said[LABEL], name[LABEL], text[3 * LABEL];
    snprintf(said, sizeof said, "5, 50, 95 %%: %.4g, %.4g, %.4g%s%s", q[0],
             q[1], q[2], *f->y_axis.unit ? " " : "", f->y_axis.unit);
    name_group(f, &f->lines, line, name, sizeof name);
    if (!alone) {
        snprintf(text, sizeof text, "%.220s; %s", to->note, said);
        to->note = ovr_arena_text(f->arena, text, NULL);
    }
    snprintf(text, sizeof text, "%s%s%s", name, *name && alone ? ": " : "",
             alone ? said : "");
    return *text && f->sample[0].panel == panel
               ? ovr_arena_text(f->arena, text, NULL)
               : NULL;
}

/* Sets the panel's range and chooses the number of bins by Rice's rule for the
 * narrowest group. */
static size_t count_bins(const figure *f, size_t panel, ovr_panel *to)
{
    double low = INFINITY, high = -INFINITY, width = INFINITY;
    size_t first = 0;
    for (size_t k = 0; k < f->lines.count; k++) {
        size_t end = end_of(f, panel, k, &first), n = end - first;
        sample *s = f->sample + first;
        if (n == 0)
            continue;
        qsort(s, n, sizeof *s, by_value);
        low = fmin(low, s->y);
        high = fmax(high, s[n - 1].y);
        if (s[n - 1].y > s->y)
            width = fmin(width,
                         (s[n - 1].y - s->y) / ceil(2 * cbrt((double)n)));
    }
    double margin = high > low ? 0 : fmax(0.01 * fabs(low), 1e-12);
    to->x_from = (low - margin) * f->y_axis.factor;
    to->x_to = (high + margin) * f->y_axis.factor;
    return (size_t)fmax(1, fmin(ceil((high - low) / width - 1e-9), 200));
}

static void draw_bins(figure *f, size_t panel, ovr_panel *to)
{
    size_t first = 0, bins = count_bins(f, panel, to);
    for (size_t k = 0; k < f->lines.count; k++) {
        const ovr_curve_style as = ovr_curve_style_of(k);
        size_t end = end_of(f, panel, k, &first), n = end - first;
        const sample *s = f->sample + first;
        double q[3];
        if (n == 0)
            continue;
        for (int j = 0; j < 3; j++)
            q[j] = quantile(s, n, parts[j]) * f->y_axis.factor;
        add_bins(f, s, n, bins, as, label_of(f, panel, k, q, to), to);
        add_quantiles(f, q, as, to);
    }
}

/* ----------------------------------------------------------------- figure */

/* Chooses the range of an axis: minimum to maximum with a margin. */
static void axis_range(double low, double high, bool logarithmic, double *from,
                       double *to)
{
    double margin = 0.04 * (high - low);
    *from = *to = NAN;
    if (logarithmic && low > 0 && high > low) {
        margin = pow(high / low, 0.04);
        *from = low / margin;
        *to = high * margin;
    } else if (!logarithmic && high > low) {
        *from = low - margin;
        *to = high + margin;
    }
}

static int by_x(const void *a, const void *b)
{
    double p = ((const sample *)a)->x, q = ((const sample *)b)->x;
    return (p > q) - (p < q);
}

/* True if the values of x are positive, at least four, over a decade or more,
 * and each exceeds the preceding one by the same factor. */
static bool is_geometric(const figure *f)
{
    sample *sorted = ovr_arena_take(f->arena, f->samples, sizeof *sorted, NULL);
    double factor = 0;
    size_t values = 1;
    if (!sorted || f->samples < 4)
        return false;
    memcpy(sorted, f->sample, f->samples * sizeof *sorted);
    qsort(sorted, f->samples, sizeof *sorted, by_x);
    double low = sorted[0].x, high = sorted[f->samples - 1].x;
    if (!(low > 0 && high >= 10 * low * (1 - 1e-9)))
        return false;
    for (size_t i = 1; i < f->samples; i++) {
        double ratio = sorted[i].x / sorted[i - 1].x;
        if (ratio <= 1 + 1e-9)
            continue;
        values++;
        if (factor > 0 && fabs(log(ratio) / log(factor) - 1) > 1e-3)
            return false;
        factor = ratio;
    }
    return values >= 4;
}

static void set_ranges(figure *f)
{
    double x_low = INFINITY, x_high = -INFINITY;
    double y_low = INFINITY, y_high = -INFINITY;
    for (size_t i = 0; i < f->samples; i++) {
        x_low = fmin(x_low, f->sample[i].x * f->x_axis.factor);
        x_high = fmax(x_high, f->sample[i].x * f->x_axis.factor);
        y_low = fmin(y_low, f->sample[i].y * f->y_axis.factor);
        y_high = fmax(y_high, f->sample[i].y * f->y_axis.factor);
    }
    axis_range(x_low, x_high, f->log_x, &f->x_from, &f->x_to);
    axis_range(y_low, y_high, f->o->log_y, &f->y_from, &f->y_to);
}

static void draw_panels(figure *f, ovr_panel *panel)
{
    bool bins = is_seed(f->x);
    f->log_x = f->o->log_x || (!bins && !f->o->linear && is_geometric(f));
    if (!bins)
        set_ranges(f);
    for (size_t k = 0; k < f->panels.count; k++) {
        char note[LABEL];
        name_group(f, &f->panels, k, note, sizeof note);
        panel[k] = (ovr_panel){.x_label = bins ? f->y_axis.label
                                               : f->x_axis.label,
                               .y_label = bins ? "cases (%)" : f->y_axis.label,
                               .note = ovr_arena_text(f->arena, note, NULL),
                               .log_x = f->log_x && !bins,
                               .log_y = f->o->log_y && !bins};
        (bins ? draw_bins : draw_lines)(f, k, &panel[k]);
    }
    for (size_t k = 0; k < f->panels.count; k++) {
        panel[k].x_from = bins ? panel[k].x_from : f->x_from;
        panel[k].x_to = bins ? panel[k].x_to : f->x_to;
        panel[k].y_from = f->y_from;
        panel[k].y_to = f->y_to;
    }
}

static ovr_status draw(figure *f, ovr_error *err)
{
    size_t n = f->panels.count;
    size_t columns = n < 4 ? n : n == 4 ? 2 : n < 7 ? 3 : 4;
    size_t rows = (n + columns - 1) / columns;
    ovr_panel *panel = ovr_arena_take(f->arena, rows * columns, sizeof *panel,
                                      err);
    ovr_chart chart = {.kind = "study",
                       .width = n > 1 ? 1280 : 960,
                       .height = n > 1 ? 860 : 640,
                       .rows = rows,
                       .columns = columns,
                       .share_x = !is_seed(f->x),
                       .share_y = true,
                       .panel = panel};
    if (!panel)
        return OVR_NO_MEMORY;
    make_axes(f);
    draw_panels(f, panel);
    return ovr_figure_draw(&chart, f->o, f->arena, err);
}

static ovr_status draw_table(const void *table, const ovr_figure_options *o,
                             ovr_arena *arena, ovr_error *err)
{
    figure f = {.o = o, .t = table, .arena = arena};
    ovr_status status = choose_columns(&f, err);
    if (!status)
        status = collect_samples(&f, err);
    return status ? status : draw(&f, err);
}

ovr_status ovr_figure(const ovr_table *table, const ovr_figure_options *given,
                      const ovr_allocator *allocator, ovr_error *err)
{
    if (!table)
        return ovr_fail_null(err, __func__);
    return ovr_figure_of(table, given, allocator, draw_table, err);
}
