/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Draws what has yielded below a surface: its profile before and after, the
 * strain that has flowed and the stress that stays, place by depth. */
#include <math.h>
#include <stdio.h>

#include "pictures/material.h"
#include "pictures/picture.h"

typedef struct yielded {
    ovr_material_group in;
    double *before, *after, *flowed, *residual;
    double from, to; /* xi of what has yielded, and some more */
} yielded;

/* The range is where anything flowed, with as much again on both sides; else
 * all. */
static void find_range(yielded *y)
{
    double low = INFINITY, high = -INFINITY;
    for (size_t i = 0; i < y->in.points * y->in.depths; i++)
        if (y->flowed[i] > 0) {
            low = fmin(low, y->in.xi[i % y->in.points]);
            high = fmax(high, y->in.xi[i % y->in.points]);
        }
    double margin = fmax(high - low, 0.2);
    y->from = fmax(y->in.xi[0], low - margin);
    y->to = fmin(y->in.xi[y->in.points - 1], high + margin);
    if (!(high >= low)) {
        y->from = y->in.xi[0];
        y->to = y->in.xi[y->in.points - 1];
    }
}

static ovr_status read_group(yielded *y, int surface, ovr_error *err)
{
    ovr_material_group *in = &y->in;
    if (!ovr_material_find(in, "plastic", surface, "cumulative"))
        return ovr_fail(err, OVR_BAD_INPUT,
                        "the file contains no %s; run the case with a "
                        "section [plastic]",
                        in->group);
    if (ovr_material_axes(in, err) ||
        !(y->before = ovr_material_read(in, "profile_before", 1, in->points,
                                        err)) ||
        !(y->after = ovr_material_read(in, "profile_after", 1, in->points,
                                       err)) ||
        !(y->flowed = ovr_material_read(in, "cumulative", in->depths,
                                        in->points, err)) ||
        !(y->residual = ovr_material_read(in, "residual_x", in->depths,
                                          in->points, err)))
        return OVR_BAD_INPUT;
    find_range(y);
    return OVR_OK;
}

static void profile_panel(const yielded *y, ovr_panel *panel)
{
    *panel = ovr_panel_make(ovr_material_place,
                            "profile height ({/:Italic b}^2/{/:Italic R})");
    panel->x_from = y->from;
    panel->x_to = y->to;
    ovr_series s = {.label = "before",
                    .n = y->in.points,
                    .x = y->in.xi,
                    .y = y->before,
                    .mark = OVR_MARK_DASHED,
                    .colour = OVR_STEEL};
    ovr_panel_add(panel, y->in.arena, s);
    s.label = "after";
    s.y = y->after;
    s.mark = OVR_MARK_LINE;
    s.colour = OVR_RED;
    ovr_panel_add(panel, y->in.arena, s);
}

/* The value of the layer and point that a cell lies in, over the logarithm of
 * the depth. */
static double at_cell(const ovr_material_group *in, const double *v, double xi,
                      double z)
{
    double u = (xi - in->xi[0]) / (in->xi[1] - in->xi[0]) + 0.5;
    size_t k = u > 0 ? (size_t)u : 0, j = 0;
    if (k >= in->points)
        k = in->points - 1;
    while (j + 1 < in->depths && sqrt(in->z[j] * in->z[j + 1]) < z)
        j++;
    return v[j * in->points + k];
}

/* Colours from 0, or from the negative where the values have signs. */
static ovr_status map_panel(const yielded *y, const double *v, bool signs,
                            ovr_panel *panel, ovr_error *err)
{
    enum { CELLS_Z = 120 };
    ovr_image *image = &panel->image;
    double maximum = 0;
    panel->x_from = y->from;
    panel->x_to = y->to;
    panel->height = 1.3;
    image->ny = CELLS_Z;
    if (ovr_material_map(&y->in, v, at_cell, panel, err))
        return OVR_NO_MEMORY;
    for (size_t c = 0; c < image->nx * image->ny; c++)
        maximum = fmax(maximum, fabs(image->values[c]));
    image->to = maximum > 0 ? maximum : 1;
    image->from = signs ? -image->to : 0;
    return OVR_OK;
}

ovr_status ovr_draw_plastic(const ovr_drawing *drawing, ovr_chart *chart,
                            ovr_error *err)
{
    enum { PANELS = 3, NOTE = 200 };
    yielded y = {.in = {.run = drawing->runs, .arena = drawing->arena}};
    int surface = drawing->options->surface == 2 ? 2 : 1;
    ovr_panel *panel = ovr_arena_take(drawing->arena, PANELS, sizeof *panel,
                                      err);
    char *note = ovr_arena_take(drawing->arena, NOTE, 1, err);
    if (!panel || !note)
        return OVR_NO_MEMORY;
    panel[1].image.label = "plastic strain";
    panel[2].image.label = "residual stress, {/Symbol s}_x ({/:Italic p}_h)";
    if (read_group(&y, surface, err))
        return OVR_BAD_INPUT;
    profile_panel(&y, &panel[0]);
    if (map_panel(&y, y.flowed, false, &panel[1], err) ||
        map_panel(&y, y.residual, true, &panel[2], err))
        return OVR_BAD_INPUT;
    snprintf(note, NOTE, "plastic strain up to %.3g", panel[1].image.to);
    chart->subtitle = note;
    chart->rows = PANELS;
    chart->panel = panel;
    return OVR_OK;
}
