/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Map of a field as colour against position and time. Moving features appear as
 * inclined lines whose slope is their speed. The field is interpolated
 * linearly, in x and time, to a uniform grid of about one cell per pixel. The
 * inlet meniscus of a starved film is drawn as a line.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "overroll/text.h"
#include "pictures/chart.h"
#include "pictures/picture.h"
#include "simulation/simulation.h"

enum { CELLS_X = 700, CELLS_T = 450 };

typedef struct map {
    const ovr_stored *run;
    const char *field;
    double x_from, x_to, T_from, T_to;
    double *values; /* CELLS_T rows of CELLS_X */
    double *row[2]; /* snapshots around a time, on the uniform grid */
    size_t held[2]; /* numbers of these snapshots */
    double *nodes;
} map;

static const size_t none = (size_t)-1;

static void onto_cells(const map *m, double *row)
{
    const double *x = m->run->x;
    size_t n = m->run->info->nodes, i = 0;
    for (size_t c = 0; c < CELLS_X; c++) {
        double at = m->x_from +
                    (m->x_to - m->x_from) * ((double)c + 0.5) / CELLS_X;
        while (i + 2 < n && x[i + 1] <= at)
            i++;
        row[c] = at < x[0] || at > x[n - 1]
                     ? NAN
                     : m->nodes[i] + (m->nodes[i + 1] - m->nodes[i]) *
                                         (at - x[i]) / (x[i + 1] - x[i]);
    }
}

/* Interpolates snapshot k to the uniform grid, in one of the two rows. */
static ovr_status hold(map *m, size_t k, const double **row, ovr_error *err)
{
    size_t slot = k % 2;
    *row = m->row[slot];
    if (m->held[slot] == k)
        return OVR_OK;
    if (ovr_result_snapshot(m->run->result, m->field, k, OVR_HERTZIAN, m->nodes,
                            err) != OVR_OK)
        return err ? err->status : OVR_IO;
    onto_cells(m, m->row[slot]);
    m->held[slot] = k;
    return OVR_OK;
}

static ovr_status fill_row(map *m, size_t c, size_t *k, ovr_error *err)
{
    const double *t = m->run->times, *low, *high;
    size_t last = m->run->info->snapshots - 1;
    double T = m->T_from + (m->T_to - m->T_from) * ((double)c + 0.5) / CELLS_T;
    double part;
    ovr_status status;
    while (*k + 2 <= last && t[*k + 1] <= T)
        ++*k;
    part = fmin(fmax((T - t[*k]) / (t[*k + 1] - t[*k]), 0), 1);
    status = hold(m, *k, &low, err);
    if (status == OVR_OK)
        status = hold(m, *k + 1, &high, err);
    for (size_t i = 0; status == OVR_OK && i < CELLS_X; i++)
        m->values[c * CELLS_X + i] = low[i] + part * (high[i] - low[i]);
    return status;
}

static ovr_status fill(map *m, ovr_arena *arena, ovr_error *err)
{
    size_t k = 0;
    ovr_status status = OVR_OK;
    m->values = ovr_arena_take(arena, (size_t)CELLS_T * CELLS_X, 8, err);
    m->row[0] = ovr_arena_take(arena, CELLS_X, sizeof(double), err);
    m->row[1] = ovr_arena_take(arena, CELLS_X, sizeof(double), err);
    m->nodes = ovr_arena_take(arena, m->run->info->nodes, 8, err);
    m->held[0] = m->held[1] = none;
    if (ovr_arena_status(arena))
        return OVR_NO_MEMORY;
    for (size_t c = 0; status == OVR_OK && c < CELLS_T; c++)
        status = fill_row(m, c, &k, err);
    return status;
}

/* Chooses the colour range from |X| < 0.9, because the film far from the
 * contact would use most colours; from all if that part is not shown. */
static void find_range(const map *m, double *low, double *high)
{
    bool film = strcmp(m->field, "film_thickness") == 0;
    *low = INFINITY, *high = -INFINITY;
    for (size_t c = 0; c < (size_t)CELLS_T * CELLS_X; c++) {
        double at = m->x_from + (m->x_to - m->x_from) *
                                    ((double)(c % CELLS_X) + 0.5) / CELLS_X;
        if (film && fabs(at) > 0.9 && m->x_from < 0.9 && m->x_to > -0.9)
            continue;
        *low = fmin(*low, m->values[c]);
        *high = fmax(*high, m->values[c]);
    }
    if (!(*high > *low))
        *high = *low + 1;
}

static double largest(const map *m)
{
    double maximum = -INFINITY;
    for (size_t c = 0; c < (size_t)CELLS_T * CELLS_X; c++)
        maximum = fmax(maximum, m->values[c]);
    return maximum;
}

/* Returns the upper end of the colours: the 99.8 % quantile, so that a spike of
 * one cell does not dominate. */
static double common_high(const map *m, double low, double high)
{
    enum { BINS = 500 };
    size_t count[BINS] = {0}, left = (size_t)CELLS_T * CELLS_X / 500, bin;
    for (size_t c = 0; c < (size_t)CELLS_T * CELLS_X; c++)
        if (m->values[c] >= low) {
            bin = (size_t)((m->values[c] - low) / (high - low) * (BINS - 1));
            count[bin < BINS ? bin : BINS - 1]++;
        }
    for (bin = BINS - 1; bin > 0 && count[bin] <= left; bin--)
        left -= count[bin];
    return low + (high - low) * (double)(bin + 1) / BINS;
}

/* Makes the label of a field whose kind has no symbol, with a power of ten for
 * short numbers. */
static ovr_status words(const ovr_drawing *drawing, const ovr_variable *v,
                        double largest, ovr_axis *axis, ovr_error *err)
{
    const ovr_observable *row = ovr_observable_field(v->name);
    const ovr_kind_info *kind = ovr_kind_about(v->kind);
    bool si = drawing->options->units == OVR_SI ||
              (drawing->options->units == OVR_AS_STORED &&
               strcmp(v->unit, "1") != 0);
    double scale = si ? v->scale : 1, power = floor(log10(largest * scale));
    char *label = ovr_arena_take(drawing->arena, 160, 1, err), ten[24] = "";
    if (!label)
        return OVR_NO_MEMORY;
    if (isnan(scale))
        return ovr_fail(err, OVR_BAD_INPUT,
                        "SI units need the scale of '%s', which is unknown",
                        v->name);
    if (!(fabs(power) > 2 && isfinite(power)))
        power = 0;
    else
        snprintf(ten, sizeof ten, "10^{%.0f} ", power);
    snprintf(label, 160, "%s (%s%s)", row ? row->long_name : kind->name, ten,
             si ? kind->si : kind->hertzian);
    *axis = (ovr_axis){scale / pow(10, power), label, label, ""};
    return OVR_OK;
}

static ovr_status degrees(const ovr_drawing *drawing, const map *m,
                          ovr_axis *axis, ovr_error *err)
{
    const ovr_observable *row = ovr_observable_field(m->field);
    char *label = ovr_arena_take(drawing->arena, 160, 1, err);
    if (!label)
        return OVR_NO_MEMORY;
    snprintf(label, 160, "%s (°C)", row ? row->long_name : m->field);
    *axis = (ovr_axis){1, label, label, "°C"};
    return OVR_OK;
}

/* Makes the axis of the colours. */
static ovr_status colour_axis(const ovr_drawing *drawing, const map *m,
                              double largest, ovr_axis *axis, ovr_error *err)
{
    const ovr_variable *v = ovr_result_find(m->run->result, m->field);
    if (v->kind == OVR_KIND_TEMPERATURE)
        return degrees(drawing, m, axis, err);
    return ovr_axis_has(v->kind)
               ? ovr_axis_make(v->kind, m->run->result, drawing->options->units,
                               largest, axis, err)
               : words(drawing, v, largest, axis, err);
}

/* Returns "cut at y/b = 0.5" for a strip; NULL for a line contact. */
static const char *note_cut(const ovr_drawing *drawing, const map *m,
                            const ovr_axis *x, ovr_error *err)
{
    enum { SIZE = 80 };
    double Y = NAN;
    if (m->run->info->lines < 2 || ovr_result_across(m->run->result, &Y, err))
        return NULL;
    char *note = ovr_arena_take(drawing->arena, SIZE, 1, err);
    if (note)
        snprintf(note, SIZE, "cut at %s = %.3g%s%s", *x->unit ? "y" : "y/b",
                 Y * x->factor, *x->unit ? " " : "", x->unit);
    return note;
}

static ovr_status make_panel(const ovr_drawing *drawing, map *m,
                             ovr_panel *panel, ovr_error *err)
{
    const ovr_picture_options *o = drawing->options;
    ovr_unit_kind kind = ovr_result_find(m->run->result, m->field)->kind;
    double low, high, highest, reach = fmax(fabs(m->x_from), fabs(m->x_to));
    ovr_axis x = {0}, T = {0}, v = {0};
    ovr_status status;
    if (kind == OVR_KIND_TEMPERATURE) /* degC in all pictures */
        for (size_t c = 0; c < (size_t)CELLS_T * CELLS_X; c++)
            m->values[c] -= 273.15;
    find_range(m, &low, &high);
    highest = largest(m);
    if (kind == OVR_KIND_PRESSURE)
        high = o->P_to > 0 ? o->P_to : common_high(m, low, high);
    if (kind == OVR_KIND_HEIGHT && o->H_to > 0)
        high = o->H_to;
    status = ovr_axis_make(OVR_KIND_LENGTH, m->run->result, o->units, reach, &x,
                           err);
    if (status == OVR_OK)
        status = ovr_axis_make(OVR_KIND_TIME, m->run->result, o->units, m->T_to,
                               &T, err);
    if (status == OVR_OK)
        status = colour_axis(drawing, m, fmax(fabs(low), fabs(high)), &v, err);
    if (status != OVR_OK)
        return status;
    for (size_t c = 0; c < (size_t)CELLS_T * CELLS_X; c++)
        m->values[c] *= v.factor;
    *panel = (ovr_panel){.note = note_cut(drawing, m, &x, err),
                         .x_label = x.label,
                         .y_label = T.label,
                         .x_from = m->x_from * x.factor,
                         .x_to = m->x_to * x.factor,
                         .y_from = m->T_from * T.factor,
                         .y_to = m->T_to * T.factor,
                         .image = {.nx = CELLS_X,
                                   .ny = CELLS_T,
                                   .values = m->values,
                                   .from = low * v.factor,
                                   .to = high * v.factor,
                                   .above = highest > high * (1 + 1e-9),
                                   .label = v.label}};
    return OVR_OK;
}

/* Adds the position of the meniscus at each step, if it is in the history. */
static ovr_status add_meniscus(const ovr_drawing *s, const map *m,
                               ovr_panel *panel, ovr_error *err)
{
    const ovr_stored *run = m->run;
    double x = m->x_to != 0 ? panel->x_to / m->x_to : panel->x_from / m->x_from;
    double T = panel->y_to / m->T_to;
    ovr_series *line;
    if (!ovr_result_find(run->result, "history/meniscus"))
        return OVR_OK;
    line = ovr_arena_take(s->arena, 1, sizeof *line, err);
    if (!line)
        return OVR_NO_MEMORY;
    *line = (ovr_series){.label = "inlet meniscus position",
                         .n = run->info->steps,
                         .x_factor = x,
                         .factor = T,
                         .colour = OVR_RED,
                         .width = 1.6};
    line->x = ovr_stored_history(run, "meniscus", run->by.x, s->arena, err);
    line->y = line->x
                  ? ovr_stored_history(run, "time", run->by.time, s->arena, err)
                  : NULL;
    panel->series = line;
    panel->count = 1;
    return line->y ? OVR_OK : OVR_IO;
}

static ovr_status check_field(const ovr_stored *run, const char *name,
                              ovr_error *err)
{
    const char *names[64], *meant;
    char hint[100] = "";
    size_t n = 0;
    for (; n < 64 && n < ovr_result_fields(run->result); n++) {
        names[n] = ovr_result_field(run->result, n)->name;
        if (strcmp(names[n], name) == 0)
            return OVR_OK;
    }
    meant = ovr_suggest(name, names, n);
    if (meant)
        snprintf(hint, sizeof hint, "; did you mean '%.60s'?", meant);
    return ovr_fail(err, OVR_BAD_INPUT,
                    "no map of '%s': the file contains no such field%s", name,
                    hint);
}

ovr_status ovr_draw_map(const ovr_drawing *drawing, ovr_chart *chart,
                        ovr_error *err)
{
    const ovr_picture_options *o = drawing->options;
    const ovr_stored *run = drawing->runs;
    ovr_extent e = ovr_extent_make(o->x_from, o->x_to, run, 1);
    map m = {.run = run, .field = o->field ? o->field : "film_thickness"};
    ovr_panel *panel = ovr_arena_take(drawing->arena, 1, sizeof *panel, err);
    ovr_status status = panel ? OVR_OK : OVR_NO_MEMORY;
    if (status == OVR_OK && run->info->snapshots < 2)
        status = ovr_fail(err, OVR_BAD_INPUT,
                          "a map needs at least two snapshots");
    if (status == OVR_OK)
        status = check_field(run, m.field, err);
    m.x_from = e.x_from;
    m.x_to = e.x_to;
    m.T_from = isnan(o->T_from) ? run->times[0] : o->T_from;
    m.T_to = isnan(o->T_to) ? run->times[run->info->snapshots - 1] : o->T_to;
    if (status == OVR_OK)
        status = fill(&m, drawing->arena, err);
    if (status == OVR_OK)
        status = make_panel(drawing, &m, panel, err);
    if (status == OVR_OK)
        status = add_meniscus(drawing, &m, panel, err);
    chart->rows = 1;
    chart->share_x = false;
    chart->panel = panel;
    return status;
}
