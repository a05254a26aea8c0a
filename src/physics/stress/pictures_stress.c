/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Picture of the stresses at an instant: pressure, film thickness and stress
 * field. */
#include <math.h>
#include <stdio.h>

#include "physics/stress/pictures_depth.h"
#include "physics/stress/stress.h"
#include "pictures/chart.h"
#include "pictures/picture.h"
#include "pictures/snapshot.h"
#include "pictures/view_data.h"
#include "stress/layered.h"

/* Finds the snapshot with the largest stress, used by default. */
static ovr_status find_worst(ovr_depth_field *f, size_t *worst, ovr_error *err)
{
    double maximum = -1;
    for (size_t k = 0; k < f->run->info->snapshots; k++) {
        if (ovr_depth_field_solve(f, k, err))
            return OVR_BAD_INPUT;
        double v = fabs(f->worst.value);
        if (v > maximum)
            maximum = v, *worst = k;
    }
    return OVR_OK;
}

ovr_status ovr_stress_panel_add(ovr_depth_field *f,
                                const ovr_snapshot *snapshot,
                                const ovr_snapshot_style *look,
                                ovr_snapshot_chart *to, ovr_arena *arena,
                                ovr_error *err)
{
    enum { NOTE = 400 };
    char *note = ovr_arena_take(arena, NOTE, 1, err);
    ovr_panel *panel = &to->panel[to->chart.rows];
    ovr_axis x;
    const char *unit;
    if (!note)
        return OVR_NO_MEMORY;
    if (ovr_axis_make(OVR_KIND_LENGTH, f->run->result, look->options->units,
                      f->x_to, &x, err) ||
        ovr_depth_field_solve(f, snapshot->k, err) ||
        ovr_depth_field_panel(f, look->options->units, panel, arena, err))
        return OVR_BAD_INPUT;
    to->chart.rows++;
    unit = *x.unit ? x.unit : "b";
    bool unresolved = ovr_stored_unresolved(f->run, (ptrdiff_t)snapshot->k,
                                            f->worst.Z);
    snprintf(note, NOTE,
             "maximum %.3g p_h at x = %.3g %s, z = %.3g %s%s; smooth contact "
             "%.3g p_h%s",
             f->worst.value, f->worst.X * x.factor, unit, f->worst.Z * x.factor,
             unit, unresolved ? ", not resolved" : "", f->smooth,
             f->traction == 0 ? "" : "; with traction");
    panel->note = note;
    return OVR_OK;
}

static ovr_status draw(const ovr_drawing *drawing, ovr_depth_field *f,
                       ovr_chart *chart, ovr_error *err)
{
    const ovr_picture_options *o = drawing->options;
    ovr_snapshot_style *look = ovr_arena_take(drawing->arena, 1, sizeof *look,
                                              err);
    ovr_snapshot_chart *to = ovr_arena_take(drawing->arena, 1, sizeof *to, err);
    ovr_snapshot *snapshot = ovr_arena_take(drawing->arena, 1, sizeof *snapshot,
                                            err);
    ovr_extent extent = ovr_extent_make(f->x_from, f->x_to, drawing->runs, 1);
    size_t k = 0;
    if (!look || !to || !snapshot ||
        ovr_snapshot_make(snapshot, drawing->runs, drawing->arena, err))
        return OVR_NO_MEMORY;
    if (o->time_count)
        k = ovr_stored_nearest(drawing->runs, o->times[0]);
    else if (find_worst(f, &k, err))
        return OVR_BAD_INPUT;
    for (size_t j = 0; j < drawing->runs->info->snapshots; j += 8) {
        if (ovr_snapshot_read(snapshot, j, err))
            return OVR_BAD_INPUT;
        ovr_extent_add(&extent, snapshot);
    }
    if (ovr_snapshot_read(snapshot, k, err))
        return OVR_BAD_INPUT;
    ovr_extent_add(&extent, snapshot);
    if (ovr_snapshot_style_make(look, o, &extent, drawing->runs, 1, err))
        return OVR_BAD_INPUT;
    ovr_snapshot_draw(to, look, snapshot, 1, 1, NULL);
    if (ovr_stress_panel_add(f, snapshot, look, to, drawing->arena, err))
        return OVR_BAD_INPUT;
    to->chart.height = chart->height;
    *chart = to->chart;
    return OVR_OK;
}

ovr_status ovr_draw_stress(const ovr_drawing *drawing, ovr_chart *chart,
                           ovr_error *err)
{
    const ovr_picture_options *o = drawing->options;
    ovr_depth_field f;
    ovr_status status;
    if (drawing->runs->info->snapshots < 1)
        return ovr_fail(err, OVR_BAD_INPUT, "%s: contains no snapshot",
                        drawing->runs->name);
    const ovr_depth_look look = {o->field, o->log_depth, o->surface, o->x_from,
                                 o->x_to};
    status = ovr_depth_field_make(&f, drawing->runs, &look, drawing->arena,
                                  err);
    if (!status)
        status = draw(drawing, &f, chart, err);
    ovr_depth_field_free(&f);
    return status;
}

/* ----------------------------------------------------------------- page */

/*
 * Stresses below each snapshot, for the web page: values at columns along x and
 * at geometrically increasing depths from D, with the scale of the whole run,
 * the maximum of a smooth contact, and the position of the maximum of each
 * snapshot.
 */

enum { ROWS = 40, MAX_COLUMNS = 180, MIN_COLUMNS = 60 };
enum { MAX_VALUES = 2000000, STEPS = 1000 };

static const double DEEPEST = 2.5;

typedef struct sheet {
    ovr_depth_field field;
    size_t columns, snapshots, every;
    double *worst, z[ROWS];
    uint16_t *level;
    ovr_levels levels;
} sheet;

static ovr_status prepare(sheet *s, ovr_arena *arena, ovr_error *err)
{
    size_t maximum = MAX_VALUES / ROWS / s->snapshots;
    s->columns = maximum > MAX_COLUMNS   ? MAX_COLUMNS
                 : maximum < MIN_COLUMNS ? MIN_COLUMNS
                                         : maximum;
    for (int r = 0; r < ROWS; r++)
        s->z[r] = s->field.mesh *
                  pow(DEEPEST / s->field.mesh, (double)r / (ROWS - 1));
    /* Fine steps compared with the colours, over a much larger range */
    s->levels = ovr_levels_even(0, 1);
    s->levels.step = s->field.high / STEPS;
    s->levels.from = -s->levels.step * OVR_PACKED_LEVELS / 2;
    s->worst = ovr_arena_take(arena, 3 * s->snapshots, sizeof *s->worst, err);
    s->level = ovr_arena_take(arena, ROWS * s->columns * s->snapshots,
                              sizeof *s->level, err);
    return s->worst && s->level ? OVR_OK : OVR_NO_MEMORY;
}

static ovr_status fill(sheet *s, size_t snapshot, ovr_error *err)
{
    ovr_depth_field *f = &s->field;
    uint16_t *level = s->level + snapshot * ROWS * s->columns;
    double *worst = s->worst + 3 * snapshot;
    if (ovr_depth_field_solve(f, snapshot * s->every, err))
        return OVR_BAD_INPUT;
    worst[0] = f->worst.X, worst[1] = f->worst.Z, worst[2] = f->worst.value;
    for (size_t r = 0; r < ROWS; r++)
        for (size_t c = 0; c < s->columns; c++) {
            double part = (double)c / (double)(s->columns - 1);
            double X = f->x_from + part * (f->x_to - f->x_from);
            double v = ovr_depth_field_at(f, X, s->z[r]);
            level[r * s->columns + c] = ovr_level_of(&s->levels, v);
        }
    return OVR_OK;
}

/* Writes advice for each snapshot whose maximum stress the mesh does not
 * resolve, or "". */
static void write_unresolved(ovr_text *to, const sheet *s)
{
    const ovr_stored *run = s->field.run;
    if (!run->unresolved)
        return;
    ovr_text_put(to, "\"unresolved\":[");
    for (size_t k = 0; k < s->snapshots; k++) {
        const char *remedy = ovr_stored_unresolved(
            run, (ptrdiff_t)(k * s->every), s->worst[3 * k + 1]);
        ovr_text_print(to, "%s\"%s\"", k ? "," : "", remedy ? remedy : "");
    }
    ovr_text_put(to, "],");
}

/* Writes the depths of the interfaces, if the body has layers. */
static void write_layers(ovr_text *to, const ovr_layered *body)
{
    double bottom[OVR_LAYERS_MAX];
    for (int j = 0; j < body->layers; j++)
        bottom[j] = ovr_layered_bottom(body, j);
    if (body->layers)
        ovr_text_doubles(to, "layers", bottom, (size_t)body->layers);
}

static ovr_status write_stress(ovr_text *to, const sheet *s, ovr_arena *arena,
                               ovr_error *err)
{
    const ovr_depth_field *f = &s->field;
    bool both = f->which == OVR_STRESS_TAU_XZ;
    bool pressed = ovr_depth_field_is_pressed(f);
    ovr_status status;
    ovr_text_print(to,
                   "\"stress\":{\"name\":\"%s\",\"columns\":%zu,\"rows\":%d,"
                   "\"x0\":%.17g,\"x1\":%.17g,\"low\":%.17g,\"high\":%.17g,"
                   "\"smooth\":%.17g,\"least\":%.17g,",
                   f->name, s->columns, ROWS, f->x_from, f->x_to,
                   both || pressed ? -f->high : 0, pressed ? 0 : f->high,
                   f->smooth, f->minimum);
    ovr_text_doubles(to, "z", s->z, ROWS);
    ovr_text_doubles(to, "worst", s->worst, 3 * s->snapshots);
    write_layers(to, &f->coated.body);
    write_unresolved(to, s);
    ovr_text_print(to,
                   "\"levels\":%d,\"from\":%.17g,\"step\":%.17g,\"bend\":0,"
                   "\"data\":\"",
                   OVR_PACKED_LEVELS, s->levels.from, s->levels.step);
    status = ovr_pack_levels(to, s->level, ROWS * s->columns, s->snapshots,
                             arena, err);
    ovr_text_put(to, "\"},");
    return status;
}

/* True if the case has stresses. */
static bool is_asked(const ovr_stored *run)
{
    ovr_case *c;
    ovr_setup *setup = ovr_stored_setup(run, &c, NULL);
    bool asked = setup && ovr_setup_stress(setup)->surfaces && run->pressure;
    ovr_setup_free(setup);
    ovr_case_free(c);
    return asked;
}

ovr_status ovr_view_stress(const ovr_view_run *view, ovr_error *err)
{
    if (!view->stress && !is_asked(view->run))
        return OVR_OK;
    sheet s = {.snapshots = view->snapshots, .every = view->every};
    const ovr_depth_look look = {view->stress, false, 1, -1.8, 1.5};
    ovr_status status = ovr_depth_field_make(&s.field, view->run, &look,
                                             view->arena, err);
    if (!status)
        status = prepare(&s, view->arena, err);
    for (size_t k = 0; !status && k < s.snapshots; k++)
        status = fill(&s, k, err);
    if (!status)
        status = write_stress(view->to, &s, view->arena, err);
    ovr_depth_field_free(&s.field);
    return status;
}
