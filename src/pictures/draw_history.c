/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Pictures against time: the history, and the film thickness in the centre. */
#include <math.h>
#include <string.h>

#include "pictures/chart.h"
#include "pictures/picture.h"
#include "pictures/snapshot.h"

enum { RUNS = 4 };

/* A column of the history that is drawn. */
typedef struct column {
    const char *name, *label;
    int colour;
    bool heads; /* for several results: its curves are in the legend */
} column;

static ovr_status time_axis(const ovr_drawing *drawing, ovr_panel *panel,
                            ovr_axis *axis, ovr_error *err)
{
    const ovr_stored *run = drawing->runs;
    const ovr_picture_options *o = drawing->options;
    double begin = INFINITY, end = 0, from, to;
    ovr_status status;
    for (size_t k = 0; k < drawing->count; k++) {
        size_t steps = run[k].info->steps;
        double *T = ovr_stored_history(&run[k], "time", run[k].by.time,
                                       drawing->arena, err);
        if (!T)
            return err && err->status ? err->status : OVR_IO;
        if (steps == 0)
            return ovr_fail(err, OVR_BAD_INPUT,
                            "%s: contains no time step "
                            "yet",
                            run[k].name);
        begin = fmin(begin, T[0]);
        end = fmax(end, T[steps - 1]);
    }
    from = isnan(o->T_from) ? begin : o->T_from;
    to = isnan(o->T_to) ? end : o->T_to;
    status = ovr_axis_make(OVR_KIND_TIME, run->result, o->units, fmax(to, from),
                           axis, err);
    if (status != OVR_OK)
        return status;
    if (to <= from)
        to = from + 1;
    panel->x_label = axis->label;
    panel->x_from = from * axis->factor;
    panel->x_to = to * axis->factor;
    return OVR_OK;
}

/* Makes a curve of a column. For one run, columns differ in colour; for
 * several, runs differ in colour and dash, and the single column is named at
 * the axis. */
static ovr_series series_of(const ovr_drawing *drawing, const ovr_stored *run,
                            const column *c, double T_factor)
{
    size_t k = (size_t)(run - drawing->runs);
    ovr_series series = {.n = run->info->steps,
                         .x_factor = T_factor,
                         .colour = c->colour,
                         .label = c->label};
    if (drawing->count > 1) {
        series.colour = ovr_curve_style_of(k).colour;
        series.mark = ovr_curve_style_of(k).mark;
        series.label = c->heads ? run->name : NULL;
    }
    return series;
}

/* Adds columns of every run to a panel whose time axis is set. */
static ovr_status add_columns(const ovr_drawing *drawing, const column *columns,
                              size_t count, ovr_unit_kind kind, double T_factor,
                              ovr_panel *panel, ovr_error *err)
{
    double high = 0;
    ovr_axis y;
    panel->count = 0; /* a copy of another panel's */
    for (size_t k = 0; k < count * drawing->count; k++) {
        const ovr_stored *run = &drawing->runs[k % drawing->count];
        const column *c = &columns[k / drawing->count];
        double by = kind == OVR_KIND_PRESSURE ? run->by.pressure : run->by.film;
        ovr_series s = series_of(drawing, run, c, T_factor);
        s.x = ovr_stored_history(run, "time", run->by.time, drawing->arena,
                                 err);
        s.y = s.x ? ovr_stored_history(run, c->name, by, drawing->arena, err)
                  : NULL;
        if (!s.y)
            return err ? err->status : OVR_IO;
        high = fmax(high, ovr_axis_reach(s.y, run->info->steps));
        ovr_panel_add(panel, drawing->arena, s);
    }
    ovr_status status = ovr_axis_make(kind, drawing->runs->result,
                                      drawing->options->units, high, &y, err);
    for (size_t k = 0; k < panel->count; k++)
        panel->series[k].factor = y.factor;
    panel->y_label = y.label;
    panel->y_from = 0;
    panel->y_to = 1.08 * high * y.factor;
    panel->ground = true;
    panel->note = drawing->count > 1 && count == 1 ? columns->label : NULL;
    return status;
}

static void fill(const ovr_drawing *drawing, const ovr_panel *panels,
                 size_t rows, ovr_chart *chart, ovr_error *err)
{
    enum { CAPACITY = 240 };
    char *heading = ovr_arena_take(drawing->arena, CAPACITY, 1, err);
    if (heading)
        ovr_heading(drawing->runs, drawing->count, heading, CAPACITY);
    chart->subtitle = heading;
    chart->rows = rows;
    chart->panel = panels;
}

/* Draws the history. For one result both film thicknesses are in one panel; for
 * several, each has its own. */
ovr_status ovr_draw_history(const ovr_drawing *drawing, ovr_chart *chart,
                            ovr_error *err)
{
    static const column columns[] = {
        {"central_film_thickness", "central film thickness", OVR_AMBER, true},
        {"min_film_thickness", "minimum film thickness", OVR_RED, false},
        {"max_pressure", "maximum pressure", OVR_BLUE, false}};
    ovr_panel *panel = ovr_arena_take(drawing->arena, 3, sizeof *panel, err);
    size_t films = drawing->count > 1 ? 2 : 1, k;
    ovr_axis T = {0};
    ovr_status status = panel ? OVR_OK : OVR_NO_MEMORY;
    if (status == OVR_OK)
        status = time_axis(drawing, panel, &T, err);
    for (k = 0; status == OVR_OK && k < films; k++) {
        panel[k + 1] = panel[0];
        status = add_columns(drawing, columns + k, 3 - films, OVR_KIND_HEIGHT,
                             T.factor, &panel[k], err);
    }
    if (status == OVR_OK)
        status = add_columns(drawing, columns + 2, 1, OVR_KIND_PRESSURE,
                             T.factor, &panel[k], err);
    for (k = 0; status == OVR_OK && drawing->options->H_to > 0 && k < films;
         k++)
        panel[k].y_to = drawing->options->H_to * panel[k].series[0].factor;
    if (status == OVR_OK)
        fill(drawing, panel, films + 1, chart, err);
    return status;
}

/* ------------------------------------------------------------------ trace */

/* Interpolates linearly between the two nodes around X = 0. */
static double at_centre(const ovr_stored *run, const double *values)
{
    size_t i = 0, n = run->info->nodes;
    double part;
    while (i + 2 < n && run->x[i + 1] <= 0)
        i++;
    if (n < 2)
        return values[0];
    part = -run->x[i] / (run->x[i + 1] - run->x[i]);
    return values[i] + part * (values[i + 1] - values[i]);
}

static ovr_status roughness_there(const ovr_drawing *drawing, double *S,
                                  ovr_error *err)
{
    const ovr_stored *run = drawing->runs;
    ovr_snapshot snapshot;
    ovr_status status = ovr_snapshot_make(&snapshot, run, drawing->arena, err);
    /* Reads only the roughness. */
    snapshot = (ovr_snapshot){.run = run, .S = snapshot.S};
    for (size_t k = 0; status == OVR_OK && k < run->info->snapshots; k++) {
        status = ovr_snapshot_read(&snapshot, k, err);
        if (status == OVR_OK)
            S[k] = at_centre(run, snapshot.S);
    }
    return status;
}

/* Returns the name of the first of several results, which is the one shown. */
static const char *first_name(const ovr_drawing *drawing, ovr_error *err)
{
    ovr_text text = ovr_text_make(drawing->arena);
    ovr_text_put(&text, "surface height at x = 0 (undeformed)");
    if (drawing->count > 1) {
        ovr_text_put(&text, " of ");
        ovr_text_put(&text, drawing->runs->name);
    }
    ovr_text_add(&text, "", 1);
    return ovr_text_status(&text, err) == OVR_OK ? text.data : NULL;
}

static ovr_status add_roughness(const ovr_drawing *drawing,
                                const ovr_panel *film, ovr_panel *panel,
                                ovr_error *err)
{
    const ovr_stored *run = drawing->runs;
    double *S = ovr_arena_take(drawing->arena, run->info->snapshots, sizeof *S,
                               err);
    ovr_series *series = ovr_arena_take(drawing->arena, 1, sizeof *series, err);
    ovr_status status = S && series ? roughness_there(drawing, S, err)
                                    : OVR_NO_MEMORY;
    double factor = film->series->factor, low = 0, high = 0, margin;
    for (size_t k = 0; status == OVR_OK && k < run->info->snapshots; k++) {
        low = fmin(low, S[k]);
        high = fmax(high, S[k]);
    }
    if (status != OVR_OK)
        return status;
    margin = fmax(0.12 * (high - low), 1e-3 * film->y_to / factor);
    *series = (ovr_series){.label = first_name(drawing, err),
                           .n = run->info->snapshots,
                           .x = run->times,
                           .y = S,
                           .x_factor = film->series->x_factor,
                           .factor = factor,
                           .mark = OVR_MARK_AREA,
                           .colour = OVR_STEEL,
                           .base = (low - margin) * factor,
                           .width = 1.5};
    *panel = *film;
    panel->series = series;
    panel->count = 1;
    panel->note = NULL;
    panel->ground = false;
    panel->y_from = (low - margin) * factor;
    panel->y_to = (high + margin) * factor;
    panel->height = 0.6;
    return OVR_OK;
}

ovr_status ovr_draw_trace(const ovr_drawing *drawing, ovr_chart *chart,
                          ovr_error *err)
{
    static const column film[] = {
        {"central_film_thickness", "film thickness at x = 0", OVR_AMBER, true}};
    ovr_panel *panel = ovr_arena_take(drawing->arena, 2, sizeof *panel, err);
    bool rough = drawing->runs->roughness && !drawing->options->no_roughness;
    ovr_axis T = {0};
    ovr_status status = panel ? OVR_OK : OVR_NO_MEMORY;
    if (status == OVR_OK)
        status = time_axis(drawing, panel, &T, err);
    if (status == OVR_OK)
        status = add_columns(drawing, film, 1, OVR_KIND_HEIGHT, T.factor,
                             &panel[0], err);
    if (status == OVR_OK && rough)
        status = add_roughness(drawing, &panel[0], &panel[1], err);
    if (status == OVR_OK)
        fill(drawing, panel, rough ? 2 : 1, chart, err);
    return status;
}
