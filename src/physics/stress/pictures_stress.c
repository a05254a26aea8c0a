/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The stresses at an instant: pressure, film, and the field below. */
#include <math.h>
#include <stdio.h>

#include "physics/stress/pictures_depth.h"
#include "pictures/axis.h"
#include "pictures/picture.h"
#include "pictures/snapshot.h"

/* The snapshot whose field has the largest value, where none is asked for. */
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

ovr_status ovr_stress_panel_add(ovr_depth_field *f, const ovr_shot *shot,
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
        ovr_depth_field_solve(f, shot->k, err) ||
        ovr_depth_field_panel(f, look->options->units, panel, arena, err))
        return OVR_BAD_INPUT;
    to->chart.rows++;
    unit = *x.unit ? x.unit : "b";
    bool unresolved = ovr_stored_unresolved(f->run, (ptrdiff_t)shot->k,
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
    ovr_shot *shot = ovr_arena_take(drawing->arena, 1, sizeof *shot, err);
    ovr_extent extent = ovr_extent_make(f->x_from, f->x_to, drawing->runs, 1);
    size_t k = 0;
    if (!look || !to || !shot ||
        ovr_shot_make(shot, drawing->runs, drawing->arena, err))
        return OVR_NO_MEMORY;
    if (o->time_count)
        k = ovr_stored_nearest(drawing->runs, o->times[0]);
    else if (find_worst(f, &k, err))
        return OVR_BAD_INPUT;
    for (size_t j = 0; j < drawing->runs->info->snapshots; j += 8) {
        if (ovr_shot_read(shot, j, err))
            return OVR_BAD_INPUT;
        ovr_extent_add(&extent, shot);
    }
    if (ovr_shot_read(shot, k, err))
        return OVR_BAD_INPUT;
    ovr_extent_add(&extent, shot);
    if (ovr_snapshot_style_make(look, o, &extent, drawing->runs, 1, err))
        return OVR_BAD_INPUT;
    ovr_snapshot_draw(to, look, shot, 1, 1, NULL);
    if (ovr_stress_panel_add(f, shot, look, to, drawing->arena, err))
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
