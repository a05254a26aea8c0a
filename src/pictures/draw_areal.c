/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Maps of a strip: fields at one time as colours in the plane of the contact.
 *
 * Fields are interpolated bilinearly to a uniform grid with about one cell per
 * two pixels; they are periodic across the rolling direction. The range of film
 * thickness extends to the maximum in |X| < 0.9 only, because film thicknesses
 * far from the contact would use most colours. Colours of pressure begin at
 * zero.
 */
#include "pictures/areal.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "pictures/snapshot.h"

enum { CELLS_X = 420, CELLS_Y = 260 };

/* Cells of the maps end before the next interval. */
static const double INSIDE = 0.9;

/* ------------------------------------------------------------------ ranges */

static ovr_status read_fields(ovr_areal_view *v, size_t k, ovr_error *err)
{
    ovr_status status = OVR_OK;
    for (int f = 0; !status && f < OVR_AREAL_FIELDS; f++)
        status = ovr_result_areal(v->run->result, v->field[f].name, k,
                                  OVR_HERTZIAN, v->field[f].values, err);
    return status;
}

static void include(const ovr_areal_view *v, ovr_areal_field *field)
{
    size_t n = v->run->info->nodes, lines = v->run->info->lines;
    bool film = field->kind == OVR_KIND_HEIGHT;
    for (size_t i = 0; field->values && i < n; i++) {
        double x = v->run->x[i];
        bool far = film && fabs(x) > INSIDE && v->x_from < INSIDE &&
                   v->x_to > -INSIDE;
        for (size_t j = 0; x >= v->x_from && x <= v->x_to && j < lines; j++) {
            field->low = fmin(field->low, field->values[j * n + i]);
            if (!far)
                field->high = fmax(field->high, field->values[j * n + i]);
        }
    }
}

ovr_status ovr_areal_view_include(ovr_areal_view *v, size_t k, ovr_error *err)
{
    ovr_status status = read_fields(v, k, err);
    for (int f = 0; !status && f < OVR_AREAL_FIELDS; f++)
        include(v, &v->field[f]);
    return status;
}

/* ------------------------------------------------------------------- make */

static ovr_status prepare_field(const ovr_areal_view *v, ovr_areal_field *field,
                                ovr_arena *arena, ovr_error *err)
{
    const ovr_result_info *info = v->run->info;
    const ovr_variable *variable = ovr_result_find(v->run->result, field->name);
    if (!variable)
        return ovr_fail(
            err, OVR_BAD_INPUT, "%s: has no '%s', which maps of a strip show",
            v->run->name ? v->run->name : "the result", field->name);
    field->kind = variable->kind;
    field->low = INFINITY;
    field->high = -INFINITY;
    field->values = ovr_arena_take(arena, info->nodes * info->lines,
                                   sizeof(double), err);
    field->image = ovr_arena_take(arena, (size_t)CELLS_X * CELLS_Y,
                                  sizeof(double), err);
    field->across = ovr_arena_take(arena, info->lines + 1, sizeof(double), err);
    return ovr_arena_status(arena);
}

ovr_status ovr_areal_view_make(ovr_areal_view *v, const ovr_stored *run,
                               const ovr_picture_options *options,
                               ovr_arena *arena, ovr_error *err)
{
    const ovr_result_info *info = run->info;
    ovr_extent extent = ovr_extent_make(options->x_from, options->x_to, run, 1);
    *v = (ovr_areal_view){
        .run = run,
        .options = options,
        .x_from = fmax(extent.x_from, run->x[0]),
        .x_to = fmin(extent.x_to, run->x[info->nodes - 1]),
        .along = isnan(options->along) ? 0 : options->along,
        .line = NAN,
        .field = {{.name = "pressure"}, {.name = "film_thickness"}}};
    if (info->lines < 2)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "maps across rolling need the result of a strip");
    if (!(v->along >= v->x_from && v->along <= v->x_to))
        return ovr_fail(err, OVR_BAD_INPUT,
                        "--along %g: must be a position from %g to %g b",
                        v->along, v->x_from, v->x_to);
    v->y = ovr_arena_take(arena, info->lines + 1, sizeof *v->y, err);
    if (!v->y)
        return OVR_NO_MEMORY;
    ovr_status status = ovr_result_y(run->result, OVR_HERTZIAN, v->y, err);
    if (!status)
        status = ovr_result_across(run->result, &v->line, err);
    for (size_t j = 0; j < info->lines; j++)
        if (v->y[j] == v->line)
            v->shown = j;
    v->y[info->lines] = v->y[0] + info->width;
    for (int f = 0; !status && f < OVR_AREAL_FIELDS; f++)
        status = prepare_field(v, &v->field[f], arena, err);
    ovr_heading(run, 1, v->heading, sizeof v->heading);
    return status;
}

/* ------------------------------------------------------------------- draw */

/* Returns the interval of x that contains a position, and the weight of its
 * upper end. */
static size_t interval(const double *x, size_t n, double at, double *share)
{
    size_t low = 0, high = n - 1;
    while (high - low > 1) {
        size_t middle = (low + high) / 2;
        if (x[middle] <= at)
            low = middle;
        else
            high = middle;
    }
    *share = fmin(fmax((at - x[low]) / (x[high] - x[low]), 0), 1);
    return low;
}

/* Interpolates the field at node interval i, weight u, between the lines j and
 * j + 1, weight t. */
static double between(const ovr_areal_view *v, const double *values, size_t i,
                      double u, size_t j, double t)
{
    size_t n = v->run->info->nodes, lines = v->run->info->lines;
    const double *a = values + j % lines * n + i;
    const double *b = values + (j + 1) % lines * n + i;
    return (1 - t) * ((1 - u) * a[0] + u * a[1]) +
           t * ((1 - u) * b[0] + u * b[1]);
}

static void fill_image(const ovr_areal_view *v, ovr_areal_field *field,
                       double factor)
{
    const ovr_result_info *info = v->run->info;
    for (size_t c = 0; c < CELLS_X; c++) {
        double u, t,
            x = v->x_from + (v->x_to - v->x_from) * ((double)c + 0.5) / CELLS_X;
        size_t i = interval(v->run->x, info->nodes, x, &u);
        for (size_t r = 0; r < CELLS_Y; r++) {
            double y = v->y[0] + info->width * ((double)r + 0.5) / CELLS_Y;
            size_t j = interval(v->y, info->lines + 1, y, &t);
            double value = between(v, field->values, i, u, j, t);
            field->image[r * CELLS_X + c] = factor * value;
            field->above |= value > field->high * (1 + 1e-9);
        }
    }
}

/* Derives the label of y from the label of x: "{/:Italic y} ...". */
static void label_across(const char *x, char *label, size_t size)
{
    const char *symbol = strstr(x, "Italic x");
    int before = symbol ? (int)(symbol - x) + 7 : 0;
    snprintf(label, size, "%.*sy%s", before, x, symbol ? symbol + 8 : "");
}

static void draw_map(ovr_areal_view *v, int f, const ovr_axis *x,
                     const ovr_axis *value)
{
    ovr_areal_field *field = &v->field[f];
    ovr_series *cut = v->series[f][0];
    cut[0] = (ovr_series){.n = 2,
                          .x = v->x_ends,
                          .y = v->line_ends,
                          .x_factor = x->factor,
                          .factor = x->factor,
                          .mark = OVR_MARK_DASHED,
                          .colour = OVR_WHITE,
                          .width = 1};
    cut[1] = cut[0];
    cut[1].x = v->along_ends;
    cut[1].y = v->y_ends;
    fill_image(v, field, value->factor);
    v->panel[f] = (ovr_panel){.note = v->note[f],
                              .x_label = x->label,
                              .y_label = v->label,
                              .x_from = v->x_from * x->factor,
                              .x_to = v->x_to * x->factor,
                              .y_from = v->y_ends[0] * x->factor,
                              .y_to = v->y_ends[1] * x->factor,
                              .height = 1.5,
                              .count = 2,
                              .series = cut,
                              .image = {.nx = CELLS_X,
                                        .ny = CELLS_Y,
                                        .values = field->image,
                                        .from = field->low * value->factor,
                                        .to = field->high * value->factor,
                                        .above = field->above,
                                        .label = value->label}};
}

static void draw_cuts(ovr_areal_view *v, int f, const ovr_axis *x,
                      const ovr_axis *value)
{
    ovr_areal_field *field = &v->field[f];
    size_t n = v->run->info->nodes, lines = v->run->info->lines;
    double u, high = field->high + 0.04 * (field->high - field->low);
    size_t i = interval(v->run->x, n, v->along, &u);
    ovr_series *along = v->series[f][1], *across = v->series[f][2];
    for (size_t j = 0; j <= lines; j++)
        field->across[j] = between(v, field->values, i, u, j, 0);
    *along = (ovr_series){.n = n,
                          .x = v->run->x,
                          .y = field->values + v->shown * n,
                          .x_factor = x->factor,
                          .factor = value->factor,
                          .colour = f ? OVR_STEEL : OVR_AMBER};
    *across = *along;
    across->n = lines + 1;
    across->x = v->y;
    across->y = field->across;
    ovr_panel panel = {.note = v->note[2],
                       .x_label = x->label,
                       .y_label = value->label,
                       .x_from = v->x_from * x->factor,
                       .x_to = v->x_to * x->factor,
                       .y_to = high * value->factor,
                       .count = 1,
                       .series = along};
    v->panel[f + OVR_AREAL_FIELDS] = panel;
    panel.note = v->note[3];
    panel.x_label = v->label;
    panel.x_from = v->y_ends[0] * x->factor;
    panel.x_to = v->y_ends[1] * x->factor;
    panel.series = across;
    v->panel[f + 2 * OVR_AREAL_FIELDS] = panel;
}

/* Sets requested ranges, and widens colour ranges with a single value. */
static void set_range(const ovr_areal_view *v, ovr_areal_field *field)
{
    bool film = field->kind == OVR_KIND_HEIGHT;
    double asked = film ? v->options->H_to : v->options->P_to;
    if (!film)
        field->low = 0;
    if (asked > 0)
        field->high = asked;
    if (!(field->high > field->low))
        field->high = field->low + 1e-6;
    field->above = false; /* set by fill_image */
}

static void note(ovr_areal_view *v, size_t k, const ovr_axis *T,
                 const ovr_axis *x)
{
    double t = v->run->times[k] * T->factor, along = v->along * x->factor;
    const char *space = *T->unit ? " " : "";
    snprintf(v->note[0], sizeof v->note[0], "pressure, %s = %.4g%s%s",
             *T->unit ? "t" : "t u_m/b", t, space, T->unit);
    snprintf(v->note[1], sizeof v->note[1], "film thickness");
    snprintf(v->note[2], sizeof v->note[2], "cut at %s = %.3g%s%s",
             *x->unit ? "y" : "y/b", v->line * x->factor, *x->unit ? " " : "",
             x->unit);
    snprintf(v->note[3], sizeof v->note[3], "cut at %s = %.3g%s%s",
             *x->unit ? "x" : "x/b", along, *x->unit ? " " : "", x->unit);
}

ovr_status ovr_areal_view_draw(ovr_areal_view *v, size_t k, ovr_chart *chart,
                               ovr_error *err)
{
    ovr_result *result = v->run->result;
    ovr_units units = v->options->units;
    ovr_axis x = {0}, T = {0}, value = {0};
    const size_t lines = v->run->info->lines;
    double reach = fmax(fabs(v->x_from), fabs(v->x_to));
    ovr_status status = read_fields(v, k, err);
    if (!status)
        status = ovr_axis_make(OVR_KIND_LENGTH, result, units, reach, &x, err);
    if (!status)
        status = ovr_axis_make(OVR_KIND_TIME, result, units,
                               v->run->times[v->run->info->snapshots - 1], &T,
                               err);
    if (status)
        return status;
    label_across(x.label, v->label, sizeof v->label);
    note(v, k, &T, &x);
    v->x_ends[0] = v->x_from, v->x_ends[1] = v->x_to;
    v->y_ends[0] = v->y[0], v->y_ends[1] = v->y[lines];
    v->along_ends[0] = v->along_ends[1] = v->along;
    v->line_ends[0] = v->line_ends[1] = v->line;
    for (int f = 0; f < OVR_AREAL_FIELDS; f++) {
        set_range(v, &v->field[f]);
        status = ovr_axis_make(v->field[f].kind, result, units,
                               v->field[f].high, &value, err);
        if (status)
            return status;
        draw_map(v, f, &x, &value);
        draw_cuts(v, f, &x, &value);
    }
    chart->rows = OVR_AREAL_ROWS;
    chart->columns = OVR_AREAL_FIELDS;
    chart->share_x = chart->share_y = false;
    chart->panel = v->panel;
    chart->subtitle = v->heading;
    return OVR_OK;
}

/* Returns the snapshot whose central film thickness varies most across the
 * strip. */
static size_t most_varied(const ovr_stored *run, ovr_arena *arena)
{
    double *deviation = ovr_stored_history(
        run, "central_film_thickness_deviation", 1, arena, NULL);
    double *T = ovr_stored_history(run, "time", 1, arena, NULL);
    size_t most = 0;
    for (size_t k = 1; deviation && T && k < run->info->steps; k++)
        if (deviation[k] > deviation[most])
            most = k;
    return deviation && T ? ovr_stored_nearest(run, T[most])
                          : run->info->snapshots - 1;
}

ovr_status ovr_draw_areal(const ovr_drawing *drawing, ovr_chart *chart,
                          ovr_error *err)
{
    const ovr_picture_options *o = drawing->options;
    ovr_areal_view *v = ovr_arena_take(drawing->arena, 1, sizeof *v, err);
    if (!v)
        return OVR_NO_MEMORY;
    if (o->time_count > 1)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "a map across rolling shows one instant: give --at "
                        "once");
    size_t k = o->time_count ? ovr_stored_nearest(drawing->runs, o->times[0])
                             : most_varied(drawing->runs, drawing->arena);
    ovr_status status = ovr_areal_view_make(v, drawing->runs, o, drawing->arena,
                                            err);
    if (!status)
        status = ovr_areal_view_include(v, k, err);
    return status ? status : ovr_areal_view_draw(v, k, chart, err);
}
