/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "pictures/snapshot.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* ------------------------------------------------------------------- look */

static void make_hertz(ovr_snapshot_style *look)
{
    for (int k = 0; k < OVR_HERTZ_POINTS; k++) {
        double angle = acos(-1) * k / (OVR_HERTZ_POINTS - 1);
        look->hertz_x[k] = -cos(angle);
        look->hertz_P[k] = sin(angle);
    }
}

/* Writes the values that all runs have in common. */
void ovr_heading(const ovr_stored *runs, size_t count, char *heading,
                 size_t capacity)
{
    static const char *const formats[] = {"{/:Italic M} = %.4g",
                                          "{/:Italic L} = %.4g",
                                          "{/:Italic p}_h = %.3g GPa"};
    size_t used = 0, flagged = 0;
    *heading = 0;
    for (size_t k = 0; k < sizeof formats / sizeof *formats; k++) {
        double value = NAN;
        bool common = true;
        for (size_t j = 0; j < count; j++) {
            const ovr_result_info *i = runs[j].info;
            const double own[] = {i->M, i->L, i->ph * 1e-9};
            common &= isfinite(own[k]) && (j == 0 || own[k] == value);
            value = own[k];
        }
        if (common && used + 60 <= capacity) {
            used += (size_t)snprintf(heading + used, capacity - used, "%s",
                                     used ? ",  " : "");
            used += (size_t)snprintf(heading + used, capacity - used,
                                     formats[k], value);
        }
    }
    for (size_t j = 0; j < count; j++)
        if (runs[j].unresolved && used + 90 <= capacity) {
            used += (size_t)snprintf(heading + used, capacity - used,
                                     "%smaximum pressure not resolved (%s)",
                                     used ? ",  " : "", runs[j].unresolved);
            break;
        }
    for (size_t j = 0; j < count; j++)
        flagged += runs[j].flagged;
    if (flagged && used + 60 <= capacity)
        snprintf(heading + used, capacity - used,
                 "%s%zu flagged step%s (not converged)", used ? ",  " : "",
                 flagged, flagged > 1 ? "s" : "");
}

ovr_status ovr_snapshot_style_make(ovr_snapshot_style *look,
                                   const ovr_picture_options *o,
                                   const ovr_extent *e, const ovr_stored *run,
                                   size_t count, ovr_error *err)
{
    double reach = fmax(fabs(e->x_from), fabs(e->x_to));
    double T_end = run->times[run->info->snapshots - 1];
    ovr_status status;
    memset(look, 0, sizeof *look);
    look->options = o;
    look->extent = *e;
    look->title = ovr_stored_title(run, count, o->title);
    look->P_to = o->P_to > 0 ? o->P_to : 1.15 * fmax(e->P_high, 1);
    look->H_to = o->H_to > 0 ? o->H_to : 1.6 * e->H_high;
    if (!(look->H_to > 0))
        look->H_to = 1;
    make_hertz(look);
    ovr_heading(run, count, look->heading, sizeof look->heading);
    status = ovr_axis_make(OVR_KIND_LENGTH, run->result, o->units, reach,
                           &look->x, err);
    if (status == OVR_OK)
        status = ovr_axis_make(OVR_KIND_PRESSURE, run->result, o->units,
                               look->P_to, &look->P, err);
    if (status == OVR_OK)
        status = ovr_axis_make(OVR_KIND_HEIGHT, run->result, o->units,
                               look->H_to, &look->H, err);
    if (status == OVR_OK)
        status = ovr_axis_make(OVR_KIND_TIME, run->result, o->units, T_end,
                               &look->T, err);
    return status;
}

/* ----------------------------------------------------------------- curves */

ovr_curve_style ovr_curve_style_of(size_t k)
{
    static const int colour[] = {OVR_BLUE,  OVR_RED,   OVR_GREEN, OVR_VIOLET,
                                 OVR_AMBER, OVR_STEEL, OVR_GREY};
    static const ovr_mark mark[] = {OVR_MARK_LINE, OVR_MARK_DASHED,
                                    OVR_MARK_DOTTED};
    return (ovr_curve_style){colour[k % 7], mark[k / 7 % 3]};
}

/* Makes the curve of a field against x within the range of the picture. */
static ovr_series curve(const ovr_snapshot_style *look,
                        const ovr_snapshot *snapshot, const double *values,
                        double factor)
{
    ovr_series s = {.x_factor = look->x.factor, .factor = factor, .width = 2.2};
    size_t a, b;
    ovr_extent_nodes(&look->extent, snapshot->run, &a, &b);
    s.n = b - a;
    s.x = snapshot->run->x + a;
    s.y = values + a;
    return s;
}

static ovr_series hertz(const ovr_snapshot_style *look,
                        const ovr_snapshot *snapshot)
{
    const ovr_stored *run = snapshot->run;
    return (ovr_series){.n = OVR_HERTZ_POINTS,
                        .x = look->hertz_x,
                        .y = look->hertz_P,
                        .x_factor = look->x.factor * run->by.x *
                                    ovr_stored_hertz_width(run, snapshot->k),
                        .factor = look->P.factor * run->by.pressure *
                                  ovr_stored_hertz_pressure(run, snapshot->k),
                        .mark = OVR_MARK_DASHED,
                        .colour = OVR_STEEL,
                        .width = 1.4};
}

/* Returns the space between zero film thickness and the roughness, and below
 * it. */
static double gap(const ovr_snapshot_style *look)
{
    return 0.1 * look->H_to;
}

static double bottom(const ovr_snapshot_style *look)
{
    const ovr_extent *e = &look->extent;
    double span = fmin(e->S_high - e->S_low, 1.2 * look->H_to);
    if (look->options->no_roughness || e->S_high <= e->S_low)
        return 0;
    return -2.2 * gap(look) - span;
}

static ovr_series ground(const ovr_snapshot_style *look,
                         const ovr_snapshot *snapshot)
{
    ovr_series s = curve(look, snapshot, snapshot->S, look->H.factor);
    s.mark = OVR_MARK_AREA;
    s.shift = -(look->extent.S_high + gap(look)) * look->H.factor;
    s.base = bottom(look) * look->H.factor;
    s.width = 1.2;
    s.colour = OVR_STEEL;
    return s;
}

/* ----------------------------------------------------------------- panels */

static ovr_panel panel_of(const ovr_snapshot_style *look, ovr_series *series,
                          const ovr_axis *y, double from, double to)
{
    return (ovr_panel){.x_label = look->x.label,
                       .y_label = y->label,
                       .x_from = look->extent.x_from * look->x.factor,
                       .x_to = look->extent.x_to * look->x.factor,
                       .y_from = from * y->factor,
                       .y_to = to * y->factor,
                       .ground = true,
                       .series = series};
}

/* Label of a snapshot: within its panel, or in the legend of the pressure. */
typedef struct labelled {
    const char *label;
    ovr_curve_style as;
    bool alone; /* the only one: filled */
} labelled;

static void add_pressure(const ovr_snapshot_style *look,
                         const ovr_snapshot *snapshot, const labelled *as,
                         ovr_series *series, ovr_panel *panel)
{
    ovr_series s;
    if (!snapshot->P)
        return;
    s = curve(look, snapshot, snapshot->P, look->P.factor);
    s.label = as->label;
    s.colour = as->as.colour;
    s.mark = as->alone ? OVR_MARK_AREA : as->as.mark;
    series[panel->count++] = s;
}

/* Adds the lubricant layers on both walls in the partially filled gap. */
static void add_oil(const ovr_snapshot_style *look,
                    const ovr_snapshot *snapshot, ovr_series *series,
                    ovr_panel *panel)
{
    const double *const from[] = {snapshot->wall, snapshot->hung};
    const double *const to[] = {snapshot->oil, snapshot->H};
    for (int k = 0; k < 2; k++) {
        ovr_series s = curve(look, snapshot, from[k], look->H.factor);
        s.to = curve(look, snapshot, to[k], look->H.factor).y;
        s.colour = OVR_AMBER;
        s.mark = OVR_MARK_BAND;
        series[panel->count++] = s;
    }
}

static void add_film(const ovr_snapshot_style *look,
                     const ovr_snapshot *snapshot, const labelled *as,
                     ovr_series *series, ovr_panel *panel)
{
    ovr_series s;
    bool oil = as->alone && snapshot->oil;
    if (oil)
        add_oil(look, snapshot, series, panel);
    if (snapshot->H) {
        s = curve(look, snapshot, snapshot->H, look->H.factor);
        s.label = oil           ? "film thickness, lubricant shaded"
                  : as->alone   ? "film thickness"
                  : snapshot->P ? NULL
                                : as->label;
        s.colour = as->alone ? OVR_AMBER : as->as.colour;
        s.mark = oil ? OVR_MARK_LINE : as->alone ? OVR_MARK_AREA : as->as.mark;
        series[panel->count++] = s;
    }
    if (snapshot->S && bottom(look) < 0) {
        s = ground(look, snapshot);
        s.label = as->alone ? "surface height (undeformed)" : NULL;
        if (!as->alone) {
            s.mark = as->as.mark;
            s.colour = as->as.colour;
        }
        series[panel->count++] = s;
    }
}

/* Adds the Hertzian pressure of the first run, and of others with different
 * scales. */
static void add_hertz(const ovr_snapshot_style *look,
                      const ovr_snapshot *snapshot, size_t count,
                      ovr_series *series, ovr_panel *panel)
{
    for (size_t k = 0; k < count; k++) {
        ovr_series s = hertz(look, &snapshot[k]);
        bool seen = false;
        for (size_t j = 0; j < k; j++)
            seen |= snapshot[j].run == snapshot[k].run;
        if (seen || (k > 0 && !ovr_stored_differs(snapshot[k].run)))
            continue;
        s.label = k == 0 ? "Hertzian pressure" : NULL;
        if (ovr_stored_differs(snapshot[k].run))
            s.colour = ovr_curve_style_of(k).colour;
        series[panel->count++] = s;
    }
}

/* Adds temperatures of both surfaces and of the mid-film; with several
 * snapshots only the mid-film. */
static void add_temperatures(const ovr_snapshot_style *look,
                             const ovr_snapshot *snapshot, const labelled *as,
                             ovr_series *series, ovr_panel *panel)
{
    static const char *const names[3] = {"surface 1", "surface 2",
                                         "middle of the film"};
    static const int colours[3] = {OVR_BLUE, OVR_GREEN, OVR_RED};
    for (int k = as->alone ? 0 : 2; k < 3; k++) {
        if (!snapshot->hot[k])
            continue;
        ovr_series s = curve(look, snapshot, snapshot->hot[k], 1);
        s.label = as->alone ? names[k] : NULL;
        s.colour = as->alone ? colours[k] : as->as.colour;
        s.mark = as->alone ? OVR_MARK_LINE : as->as.mark;
        series[panel->count++] = s;
    }
}

/* Draws the row of temperatures if any snapshot of the column has them. */
static void draw_temperatures(ovr_snapshot_chart *to,
                              const ovr_snapshot_style *look,
                              const ovr_snapshot *snapshot, size_t count,
                              size_t column)
{
    static const ovr_axis degC = {1, "temperature, {/:Italic T} (°C)",
                                  "temperature in degC", "°C"};
    size_t columns = to->chart.columns;
    const ovr_extent *e = &look->extent;
    double margin = fmax(0.06 * (e->hot_high - e->hot_low), 0.1);
    ovr_series *series = to->series[2 * columns + column];
    ovr_panel *panel = &to->panel[to->chart.rows * columns + column];
    bool any = false;
    for (size_t k = 0; k < count; k++)
        any |= snapshot[k].hot[0] || snapshot[k].hot[1] || snapshot[k].hot[2];
    if (!any)
        return;
    *panel = panel_of(look, series, &degC, e->hot_low - margin,
                      e->hot_high + margin);
    panel->ground = false;
    panel->height = 0.8;
    for (size_t k = 0; k < count; k++) {
        labelled as = {NULL, ovr_curve_style_of(k), count == 1};
        add_temperatures(look, &snapshot[k], &as, series, panel);
    }
    to->chart.rows++;
}

/* Snapshots of a column; empty rows are omitted. */
static void draw_column(ovr_snapshot_chart *to, const ovr_snapshot_style *look,
                        const ovr_snapshot *snapshot, size_t count,
                        size_t column, const char *const *labels)
{
    size_t columns = to->chart.columns;
    bool above = false, below = false;
    ovr_series *pressures = to->series[column],
               *films = to->series[columns + column];
    ovr_panel unused = {0}, *P, *H;
    for (size_t k = 0; k < count; k++) {
        above |= snapshot[k].P != NULL;
        below |= snapshot[k].H != NULL || snapshot[k].S != NULL;
    }
    above |= !below;
    P = above ? &to->panel[column] : &unused;
    H = below ? &to->panel[(above ? columns : 0) + column] : &unused;
    to->chart.rows = (size_t)above + (size_t)below;
    *P = panel_of(look, pressures, &look->P, 0, look->P_to);
    P->height = 1;
    if (below) {
        *H = panel_of(look, films, &look->H, bottom(look), look->H_to);
        H->height = 1 - 0.5 * bottom(look) / look->H_to;
        H->bar_unit = look->H.unit;
    }
    for (size_t k = 0; k < count; k++) {
        labelled as = {count > 1 ? labels[k] : "pressure",
                       ovr_curve_style_of(k), count == 1};
        add_pressure(look, &snapshot[k], &as, pressures, P);
        if (below)
            add_film(look, &snapshot[k], &as, films, H);
    }
    if (!look->options->no_hertz && above)
        add_hertz(look, snapshot, count, pressures, P);
    draw_temperatures(to, look, snapshot, count, column);
}

static void write_time(char *note, size_t size, const ovr_snapshot_style *look,
                       double T, const char *about)
{
    if (look->T.unit[0])
        snprintf(note, size, "t = %.3f %s%s", T * look->T.factor, look->T.unit,
                 about);
    else
        snprintf(note, size, "T = %.3f%s", T, about);
}

/* Names a snapshot by its run, its time, or both. */
static const char *name_snapshot(ovr_snapshot_chart *to, size_t k,
                                 const ovr_snapshot *snapshot, size_t instants,
                                 size_t runs)
{
    const char *note = to->note[k / runs];
    if (instants == 1)
        return snapshot->run->name;
    if (runs == 1)
        return note;
    snprintf(to->name[k], sizeof to->name[k], "%.40s, %s", snapshot->run->name,
             note);
    return to->name[k];
}

void ovr_snapshot_draw(ovr_snapshot_chart *to, const ovr_snapshot_style *look,
                       const ovr_snapshot *snapshot, size_t instants,
                       size_t runs, const char *const *about)
{
    const ovr_picture_options *o = look->options;
    size_t columns = o->overlay ? 1 : instants;
    const char *label[OVR_SNAPSHOTS];
    bool steady = true;
    memset(to, 0, sizeof *to);
    to->chart = (ovr_chart){.title = look->title,
                            .subtitle = look->heading,
                            .width = o->width > 0 ? o->width : 1280,
                            .height = o->height > 0 ? o->height : 720,
                            .rows = 2,
                            .columns = columns,
                            .share_x = true,
                            .share_y = true,
                            .panel = to->panel};
    for (size_t k = 0; k < runs; k++)
        steady &= ovr_stored_is_steady(snapshot[k].run);
    for (size_t k = 0; k < instants; k++)
        write_time(to->note[k], sizeof to->note[k], look, snapshot[k * runs].T,
                   steady || !about ? "" : about[k]);
    if (steady && instants)
        snprintf(to->note[0], sizeof to->note[0], "steady");
    for (size_t k = 0; k < instants * runs; k++)
        label[k] = name_snapshot(to, k, &snapshot[k], o->overlay ? instants : 1,
                                 runs);
    if (o->overlay)
        draw_column(to, look, snapshot, instants * runs, 0, label);
    for (size_t k = 0; !o->overlay && k < instants; k++) {
        draw_column(to, look, snapshot + k * runs, runs, k, label + k * runs);
        to->panel[k].note = to->note[k];
    }
}
