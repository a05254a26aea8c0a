/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Picture of the stress history of a surface: radius of the circumscribed
 * circle over position and depth, with the features above and the risk below;
 * and over depth only.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "case/case.h"
#include "overroll/case.h"
#include "physics/stress/stress.h"
#include "pictures/material.h"
#include "pictures/picture.h"
#include "stress/stress.h"
#include "surface/surfaces.h"

typedef struct history {
    ovr_material_group in;
    int surface;
    double *R, *smooth, *risk, *length, *S;
    bool life;
    double risk_smooth; /* NAN: unknown */
    double minimum, worst, worst_xi, worst_z;
} history;

/* Reads the heights of the surface at T = 0 and the smooth risk from the case.
 */
static void read_case(history *h, const double *A)
{
    ovr_case *c;
    ovr_setup *setup = ovr_stored_setup(h->in.run, &c, NULL);

    h->minimum = 8 * (h->in.run->x[1] - h->in.run->x[0]);
    if (setup && !ovr_setup_prepare(setup, NULL, NULL)) {
        const ovr_stress_setup *stress = ovr_setup_stress(setup);
        ovr_life_options life = stress->life;
        double z;
        h->minimum = fmax(8 * setup->mesh, life.least_depth);
        life.limit = stress->limit_pressure *
                     ovr_hertz_criterion(stress->criterion, stress->alpha,
                                         stress->poisson[h->surface - 1], &z);
        double *i = A ? ovr_arena_take(h->in.arena, h->in.depths, sizeof *i,
                                       NULL)
                      : NULL;
        size_t from = 0;
        while (from + 1 < h->in.depths &&
               h->in.z[from] < h->minimum * (1 - 1e-9))
            from++;
        if (i) {
            ovr_risk(&life, h->in.depths, h->in.z, A, i);
            h->risk_smooth = i[from];
        }
        double centre = 0;
        size_t n = setup->surfaces ? ovr_surfaces_count(setup->surfaces) : 0;
        for (size_t k = n; k-- > 0;)
            if (ovr_surfaces_info(setup->surfaces, k).surface == h->surface)
                centre = ovr_surfaces_centre(setup->surfaces, k, 0);
        double *X = ovr_arena_take(h->in.arena, h->in.points, sizeof *X, NULL);
        h->S = n ? ovr_arena_take(h->in.arena, h->in.points, sizeof *X, NULL)
                 : NULL;
        for (size_t k = 0; X && k < h->in.points; k++)
            X[k] = centre + h->in.xi[k];
        if (X && h->S)
            ovr_surfaces_heights(setup->surfaces, 0, h->in.points, X, h->S);
    }
    ovr_setup_free(setup);
    ovr_case_free(c);
}

static void find_worst(history *h)
{
    for (size_t j = 0; j < h->in.depths; j++)
        for (size_t k = 0; k < h->in.points; k++)
            if (h->in.z[j] >= h->minimum * (1 - 1e-9) &&
                h->R[j * h->in.points + k] > h->worst) {
                h->worst = h->R[j * h->in.points + k];
                h->worst_xi = h->in.xi[k];
                h->worst_z = h->in.z[j];
            }
}

static ovr_status read_history(history *h, ovr_error *err)
{
    ovr_material_group *in = &h->in;
    double *A = NULL;
    char path[64];
    if (!ovr_material_find(in, "fatigue", h->surface, "circle_radius"))
        return ovr_fail(err, OVR_BAD_INPUT,
                        "the file contains no %s; run the case with a "
                        "section [stress] (and [fatigue])",
                        in->group);
    snprintf(path, sizeof path, "%s/risk", in->group);
    h->life = ovr_result_find(in->run->result, path) != NULL;
    h->risk_smooth = NAN;
    if (ovr_material_axes(in, err) ||
        !(h->R = ovr_material_read(in, "circle_radius", in->depths, in->points,
                                   err)) ||
        !(h->smooth = ovr_material_read(in, "circle_radius_smooth", 1,
                                        in->depths, err)))
        return OVR_BAD_INPUT;
    if (h->life &&
        (!(h->risk = ovr_material_read(in, "risk", 1, in->points, err)) ||
         !(h->length = ovr_material_read(in, "equivalent_length", 1, in->depths,
                                         err)) ||
         !(A = ovr_material_read(in, "amplitude_smooth", 1, in->depths, err))))
        return OVR_BAD_INPUT;
    read_case(h, A);
    find_worst(h);
    return OVR_OK;
}

/* --------------------------------------------------------------------- map */

static double at_cell(const ovr_material_group *in, const double *R, double xi,
                      double z)
{
    double u = (xi - in->xi[0]) / (in->xi[1] - in->xi[0]);
    size_t k = u > 0 ? (size_t)u : 0, j = 0;
    if (k + 2 > in->points)
        k = in->points - 2;
    while (j + 2 < in->depths && in->z[j + 1] <= z)
        j++;
    double a = u - (double)k;
    double b = log(z / in->z[j]) / log(in->z[j + 1] / in->z[j]);
    const double *low = R + j * in->points + k, *high = low + in->points;
    return (1 - b) * ((1 - a) * low[0] + a * low[1]) +
           b * ((1 - a) * high[0] + a * high[1]);
}

static double largest_smooth(const history *h)
{
    double maximum = 0;
    for (size_t j = 0; j < h->in.depths; j++)
        maximum = fmax(
            maximum, h->in.z[j] >= h->minimum * (1 - 1e-9) ? h->smooth[j] : 0);
    return maximum;
}

/* Contours every 0.1, the maximum of the smooth contact, and a cross at the
 * worst point. */
static ovr_status map_panel(const history *h, ovr_panel *panel, ovr_error *err)
{
    enum { CELLS_Z = 160, CAPACITY = 120 };
    char *thin = ovr_arena_take(h->in.arena, 2 * CAPACITY, 1, err);
    size_t used = 0;
    *panel = (ovr_panel){
        .x_from = h->in.xi[0],
        .x_to = h->in.xi[h->in.points - 1],
        .height = 2,
        .image = {.ny = CELLS_Z,
                  .to = ceil(20 * fmax(h->worst, 0.25)) / 20,
                  .label = "shear path radius, {/:Italic R} ({/:Italic p}_h)"}};
    if (!thin || ovr_material_map(&h->in, h->R, at_cell, panel, err))
        return OVR_NO_MEMORY;
    for (int k = 1; k <= 10 && k <= 10 * panel->image.to; k++)
        used += (size_t)snprintf(thin + used, CAPACITY - used, "%s%g",
                                 used ? " " : "", 0.1 * k);
    snprintf(thin + CAPACITY, CAPACITY, "%.9g", largest_smooth(h));
    panel->image.contours = thin;
    panel->image.bold_contours = thin + CAPACITY;
    double x = h->worst_xi, z = log10(h->worst_z);
    ovr_panel_line(
        panel, h->in.arena, x, x, z, z,
        (ovr_series){
            .n = 1, .mark = OVR_MARK_CROSS, .colour = OVR_RED, .width = 3});
    return OVR_OK;
}

static void line_panel(const history *h, const char *label, const double *y,
                       ovr_mark mark, ovr_panel *panel)
{
    double low = INFINITY, high = -INFINITY;
    for (size_t k = 0; k < h->in.points; k++)
        low = fmin(low, y[k]), high = fmax(high, y[k]);
    double margin = 0.1 * fmax(high - low, 1e-12);
    *panel = (ovr_panel){.x_label = ovr_material_place,
                         .y_label = label,
                         .x_from = h->in.xi[0],
                         .x_to = h->in.xi[h->in.points - 1],
                         .y_from = low - margin,
                         .y_to = high + margin,
                         .height = 0.7};
    ovr_panel_add(panel, h->in.arena,
                  (ovr_series){.n = h->in.points,
                               .x = h->in.xi,
                               .y = y,
                               .mark = mark,
                               .colour = OVR_STEEL,
                               .base = low - margin});
}

/* i / i_0 on a logarithmic axis; omitted if i_0 is unknown. */
static ovr_status risk_panel(const history *h, ovr_panel *panel, ovr_error *err)
{
    double *v = ovr_arena_take(h->in.arena, h->in.points, sizeof *v, err);
    double low = INFINITY, high = 0;
    if (!v)
        return OVR_NO_MEMORY;
    for (size_t k = 0; k < h->in.points; k++) {
        v[k] = fmax(h->risk[k] / h->risk_smooth, 1e-3);
        low = fmin(low, v[k]), high = fmax(high, v[k]);
    }
    line_panel(h, "relative risk", v, OVR_MARK_LINE, panel);
    panel->log_y = true;
    panel->y_from = pow(10, floor(log10(low)));
    panel->y_to = pow(10, ceil(log10(fmax(high, 2))));
    return OVR_OK;
}

/* Describes the largest circle and, below a pressure spike that the mesh does
 * not resolve, the depth from which circles are resolved. */
static void describe_worst(const history *h, char *note, size_t capacity)
{
    const ovr_stored *run = h->in.run;
    bool shallow = ovr_stored_unresolved(run, -1, h->worst_z) != NULL;
    size_t used = (size_t)snprintf(note, capacity,
                                   "maximum R = %.3g p_h at xi = %.3g b, z = "
                                   "%.3g b%s; smooth contact %.3g p_h; from "
                                   "%.3g b down",
                                   h->worst, h->worst_xi, h->worst_z,
                                   shallow ? ", not resolved" : "",
                                   largest_smooth(h), h->minimum);
    if (ovr_stored_unresolved(run, -1, h->minimum))
        snprintf(note + used, capacity - used, ", resolved from %.3g b (%s)",
                 ovr_unresolved_depth(run->x[1] - run->x[0]), run->unresolved);
}

ovr_status ovr_draw_risk(const ovr_drawing *drawing, ovr_chart *chart,
                         ovr_error *err)
{
    enum { NOTE = 240 };
    history h = {
        .in = {.run = drawing->runs, .arena = drawing->arena},
        .surface = drawing->options->surface ? drawing->options->surface : 1};
    ovr_panel *panel = ovr_arena_take(drawing->arena, 3, sizeof *panel, err);
    char *note = ovr_arena_take(drawing->arena, NOTE, 1, err);
    size_t rows = 0;
    if (ovr_arena_status(drawing->arena))
        return OVR_NO_MEMORY;
    if (read_history(&h, err))
        return OVR_BAD_INPUT;
    if (h.S)
        line_panel(&h, "surface height ({/:Italic b}^2/{/:Italic R})", h.S,
                   OVR_MARK_AREA, &panel[rows++]);
    if (map_panel(&h, &panel[rows++], err))
        return OVR_NO_MEMORY;
    if (h.life && h.risk_smooth > 0 && risk_panel(&h, &panel[rows++], err))
        return OVR_NO_MEMORY;
    describe_worst(&h, note, NOTE);
    panel[h.S ? 1 : 0].note = note;
    chart->rows = rows;
    chart->panel = panel;
    return OVR_OK;
}

/* ------------------------------------------------------------------- depth */

static void add_over_depth(const history *h, ovr_panel *panel, const double *y,
                           const char *label, int colour, ovr_mark mark)
{
    ovr_panel_add(panel, h->in.arena,
                  (ovr_series){.label = label,
                               .n = h->in.depths,
                               .x = h->in.z,
                               .y = y,
                               .colour = colour,
                               .mark = mark});
}

static ovr_panel depth_panel(const history *h, const char *label, double from)
{
    ovr_panel panel = ovr_panel_make("depth, {/:Italic z} ({/:Italic b})",
                                     label);
    panel.x_from = h->in.z[0];
    panel.x_to = h->in.z[h->in.depths - 1];
    panel.y_from = from;
    panel.log_x = true;
    return panel;
}

/* Largest circle at each depth; NULL if there is no memory. */
static double *worst_at_depths(const history *h, ovr_error *err)
{
    double *worst = ovr_arena_take(h->in.arena, h->in.depths, sizeof *worst,
                                   err);
    for (size_t j = 0; worst && j < h->in.depths; j++)
        for (size_t k = 0; k < h->in.points; k++)
            worst[j] = fmax(worst[j], h->R[j * h->in.points + k]);
    return worst;
}

/* Panels of circles and, below, of equivalent lengths if there are any; returns
 * the number of panels. */
static size_t depth_panels(const history *h, const double *worst,
                           ovr_panel *panel)
{
    panel[0] = depth_panel(
        h, "shear path radius, {/:Italic R} ({/:Italic p}_h)", 0);
    add_over_depth(h, &panel[0], worst, "maximum over all material points",
                   OVR_RED, OVR_MARK_LINE);
    add_over_depth(h, &panel[0], h->smooth, "smooth reference", OVR_STEEL,
                   OVR_MARK_DASHED);
    if (!h->length || !isfinite(h->length[0]))
        return 1;
    panel[1] = depth_panel(h, "equivalent length ({/:Italic b})", NAN);
    add_over_depth(h, &panel[1], h->length,
                   "equivalent length from this depth downward", OVR_BLUE,
                   OVR_MARK_LINE);
    return 2;
}

ovr_status ovr_draw_depth(const ovr_drawing *drawing, ovr_chart *chart,
                          ovr_error *err)
{
    enum { NOTE = 200 };
    history h = {
        .in = {.run = drawing->runs, .arena = drawing->arena},
        .surface = drawing->options->surface ? drawing->options->surface : 1};
    ovr_panel *panel = ovr_arena_take(drawing->arena, 2, sizeof *panel, err);
    if (!panel)
        return OVR_NO_MEMORY;
    if (read_history(&h, err))
        return OVR_BAD_INPUT;
    double *worst = worst_at_depths(&h, err);
    if (!worst)
        return OVR_NO_MEMORY;
    if (ovr_stored_unresolved(h.in.run, -1, h.minimum)) {
        char *note = ovr_arena_take(drawing->arena, NOTE, 1, err);
        if (!note)
            return OVR_NO_MEMORY;
        snprintf(note, NOTE,
                 "not resolved above a depth of %.3g b, because the maximum "
                 "pressure is not (%s)",
                 ovr_unresolved_depth(h.in.run->x[1] - h.in.run->x[0]),
                 h.in.run->unresolved);
        chart->subtitle = note;
    }
    chart->rows = depth_panels(&h, worst, panel);
    chart->panel = panel;
    return OVR_OK;
}
