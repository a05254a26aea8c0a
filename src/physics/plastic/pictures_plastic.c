/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Picture of plastic deformation below a surface: profile before and after,
 * plastic strain and residual stress over position and depth. */
#include <math.h>
#include <stdio.h>

#include "pictures/material.h"
#include "pictures/picture.h"
#include "pictures/view_data.h"
#include "surface/surfaces.h"

typedef struct yielded {
    ovr_material_group in;
    double *before, *after, *flowed, *residual;
    double from, to; /* range of xi with plastic deformation and a margin */
} yielded;

/* Finds the range with plastic deformation, extended by its length on both
 * sides; otherwise the whole window. */
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

/* Value of the layer and point that contain a cell; depths are logarithmic. */
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

/* Colour scale from 0, or from the negative maximum if values are signed. */
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
    if (ovr_arena_status(drawing->arena))
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

/* ----------------------------------------------------------------- page */

/*
 * Plastic strain and residual stress at the end of a run, for the web page:
 * values at positions in the material and at geometrically increasing depths
 * from the first layer, and the position of the material at each snapshot.
 */

enum { ROWS = 40, MATERIAL_COLUMNS = 400 };

typedef struct material {
    ovr_material_group in;
    int surface;
    size_t columns;
    double *cell, depth[ROWS];
} material;

static const struct {
    const char *array, *name;
    bool pure; /* a number without a unit */
} material_maps[] = {{"cumulative", "plastic strain", true},
                     {"residual_x", "residual stress along x", false},
                     {"residual_z", "residual stress along z", false},
                     {"residual_xz", "residual shear stress", false}};

static bool find_group(material *m)
{
    for (m->surface = 1; m->surface <= 2; m->surface++)
        if (ovr_material_find(&m->in, "plastic", m->surface, "cumulative") &&
            m->in.depths > 1)
            return true;
    return false;
}

/* X of the reference, the centre of the surface's first feature. */
static bool find_places(const material *m, size_t snapshots, size_t every,
                        double *at)
{
    ovr_case *c = NULL;
    ovr_setup *setup = ovr_stored_setup(m->in.run, &c, NULL);
    bool made = setup && !ovr_setup_prepare(setup, NULL, NULL);
    size_t n = made ? ovr_surfaces_count(setup->surfaces) : 0;
    size_t k = 0;
    while (k < n && ovr_surfaces_info(setup->surfaces, k).surface != m->surface)
        k++;
    for (size_t snapshot = 0; k < n && snapshot < snapshots; snapshot++)
        at[snapshot] = ovr_surfaces_centre(setup->surfaces, k,
                                           m->in.run->times[snapshot * every]);
    ovr_setup_free(setup);
    ovr_case_free(c);
    return k < n;
}

/* Writes the values of the layer and point that contain each cell. */
static ovr_status write_material_map(ovr_text *to, const material *m,
                                     size_t map, ovr_error *err)
{
    const ovr_material_group *in = &m->in;
    const double *v = ovr_material_read(in, material_maps[map].array,
                                        in->depths, in->points, err);
    double low = 0, high = 0;
    if (!v)
        return OVR_BAD_INPUT;
    for (size_t r = 0, j = 0; r < ROWS; r++) {
        while (j + 1 < in->depths &&
               sqrt(in->z[j] * in->z[j + 1]) < m->depth[r])
            j++;
        for (size_t c = 0; c < m->columns; c++) {
            size_t i = c * (in->points - 1) / (m->columns - 1);
            double value = v[j * in->points + i];
            m->cell[r * m->columns + c] = value;
            low = fmin(low, value);
            high = fmax(high, value);
        }
    }
    ovr_text_put(to, map ? ",{" : "{");
    ovr_text_doubles(to, "data", m->cell, ROWS * m->columns);
    ovr_text_print(to,
                   "\"name\":\"%s\",\"pure\":%d,\"low\":%.17g,\"high\":%.17g}",
                   material_maps[map].name, material_maps[map].pure, low,
                   high > low ? high : low + 1);
    return OVR_OK;
}

ovr_status ovr_view_material(const ovr_view_run *view, ovr_error *err)
{
    ovr_text *to = view->to;
    ovr_arena *arena = view->arena;
    const size_t snapshots = view->snapshots;
    material m = {.in = {.run = view->run, .arena = arena}};
    const ovr_material_group *in = &m.in;
    double *at = ovr_arena_take(arena, snapshots, sizeof *at, err);
    if (!at)
        return OVR_NO_MEMORY;
    if (!find_group(&m) || !find_places(&m, snapshots, view->every, at))
        return OVR_OK;
    m.columns = in->points > MATERIAL_COLUMNS ? MATERIAL_COLUMNS : in->points;
    m.cell = ovr_arena_take(arena, ROWS * m.columns, sizeof *m.cell, err);
    if (!m.cell || ovr_material_axes(&m.in, err))
        return OVR_BAD_INPUT;
    for (int r = 0; r < ROWS; r++)
        m.depth[r] = in->z[0] * pow(in->z[in->depths - 1] / in->z[0],
                                    (double)r / (ROWS - 1));
    ovr_text_print(to,
                   "\"material\":{\"columns\":%zu,\"rows\":%d,\"x0\":%.17g,"
                   "\"x1\":%.17g,",
                   m.columns, ROWS, in->xi[0], in->xi[in->points - 1]);
    ovr_text_doubles(to, "z", m.depth, ROWS);
    ovr_text_doubles(to, "place", at, snapshots);
    ovr_text_put(to, "\"fields\":[");
    ovr_status status = OVR_OK;
    for (size_t map = 0;
         !status && map < sizeof material_maps / sizeof *material_maps; map++)
        status = write_material_map(to, &m, map, err);
    ovr_text_put(to, "]},");
    return status;
}
