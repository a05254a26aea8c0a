/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Draws what has yielded below a surface: its profile before and after, the
 * strain that has flowed and the stress that stays, place by depth. */
#include <math.h>
#include <stdio.h>

#include "pictures/picture.h"
#include "results/results.h"

enum { CELLS_X = 420, CELLS_Z = 120 };

typedef struct yielded {
    const ovr_drawing *of;
    const char *group;
    size_t depths, points;
    double *z, *xi, *before, *after, *flowed, *residual;
    double from, to; /* xi of what has yielded, and some more */
} yielded;

static double *read_all(const yielded *y, const char *what, size_t rows,
                        size_t n, ovr_error *err)
{
    char path[96];
    double *v = ovr_arena_take(y->of->arena, rows * n, sizeof *v, err);
    snprintf(path, sizeof path, "%s/%s", y->group, what);
    for (size_t r = 0; v && r < rows; r++)
        if (ovr_result_read(y->of->runs->result, path, r, OVR_HERTZIAN,
                            v + r * n, err))
            return NULL;
    return v;
}

/* The range is where anything flowed, with as much again on both sides; else
 * all. */
static void find_range(yielded *y)
{
    double low = INFINITY, high = -INFINITY;
    for (size_t i = 0; i < y->points * y->depths; i++)
        if (y->flowed[i] > 0) {
            low = fmin(low, y->xi[i % y->points]);
            high = fmax(high, y->xi[i % y->points]);
        }
    double margin = fmax(high - low, 0.2);
    y->from = fmax(y->xi[0], low - margin);
    y->to = fmin(y->xi[y->points - 1], high + margin);
    if (!(high >= low)) {
        y->from = y->xi[0];
        y->to = y->xi[y->points - 1];
    }
}

static ovr_status read_group(yielded *y, ovr_error *err)
{
    char path[96];
    snprintf(path, sizeof path, "%s/cumulative", y->group);
    const ovr_variable *v = ovr_result_find(y->of->runs->result, path);
    if (!v || v->rank != 2 || v->shape[1] < 2)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "the file has no %s: run the case with a section "
                        "[plastic]",
                        y->group);
    y->depths = v->shape[0];
    y->points = v->shape[1];
    y->z = read_all(y, "depth", 1, y->depths, err);
    y->xi = read_all(y, "material", 1, y->points, err);
    y->before = read_all(y, "profile_before", 1, y->points, err);
    y->after = read_all(y, "profile_after", 1, y->points, err);
    y->flowed = read_all(y, "cumulative", y->depths, y->points, err);
    y->residual = read_all(y, "residual_x", y->depths, y->points, err);
    if (!y->z || !y->xi || !y->before || !y->after || !y->flowed ||
        !y->residual)
        return OVR_BAD_INPUT;
    find_range(y);
    return OVR_OK;
}

static const char place[] = "place in the material, b (trailing side at the "
                            "left)";

static ovr_status profile_panel(const yielded *y, ovr_panel *panel,
                                ovr_error *err)
{
    ovr_series *series = ovr_arena_take(y->of->arena, 2, sizeof *series, err);
    if (!series)
        return OVR_NO_MEMORY;
    series[0] = (ovr_series){.label = "before",
                             .n = y->points,
                             .x = y->xi,
                             .y = y->before,
                             .mark = OVR_MARK_DASHED,
                             .colour = OVR_STEEL};
    series[1] = series[0];
    series[1].label = "after";
    series[1].y = y->after;
    series[1].mark = OVR_MARK_LINE;
    series[1].colour = OVR_RED;
    *panel = (ovr_panel){.x_label = place,
                         .y_label = "profile, b^2/R",
                         .x_from = y->from,
                         .x_to = y->to,
                         .y_from = NAN,
                         .y_to = NAN,
                         .count = 2,
                         .series = series};
    return OVR_OK;
}

/* The value of the layer and point that a cell lies in, over the logarithm of
 * the depth. */
static double at_cell(const yielded *y, const double *v, double xi, double z)
{
    double u = (xi - y->xi[0]) / (y->xi[1] - y->xi[0]) + 0.5;
    size_t k = u > 0 ? (size_t)u : 0, j = 0;
    if (k >= y->points)
        k = y->points - 1;
    while (j + 1 < y->depths && sqrt(y->z[j] * y->z[j + 1]) < z)
        j++;
    return v[j * y->points + k];
}

static ovr_status map_panel(const yielded *y, const double *v, bool signs,
                            const char *label, ovr_panel *panel, ovr_error *err)
{
    double *cells = ovr_arena_take(y->of->arena, (size_t)CELLS_X * CELLS_Z,
                                   sizeof *cells, err);
    double maximum = 0;
    if (!cells)
        return OVR_NO_MEMORY;
    *panel = (ovr_panel){.x_label = place,
                         .y_label = "log_{10} depth / b",
                         .x_from = y->from,
                         .x_to = y->to,
                         .y_from = log10(y->z[y->depths - 1]),
                         .y_to = log10(y->z[0]),
                         .height = 1.3};
    for (size_t r = 0; r < CELLS_Z; r++)
        for (size_t c = 0; c < CELLS_X; c++) {
            double xi = y->from +
                        (y->to - y->from) * ((double)c + 0.5) / CELLS_X;
            double z = panel->y_from + (panel->y_to - panel->y_from) *
                                           ((double)r + 0.5) / CELLS_Z;
            double *cell = &cells[r * CELLS_X + c];
            *cell = at_cell(y, v, xi, pow(10, z));
            maximum = fmax(maximum, fabs(*cell));
        }
    maximum = maximum > 0 ? maximum : 1;
    panel->image = (ovr_image){.nx = CELLS_X,
                               .ny = CELLS_Z,
                               .values = cells,
                               .from = signs ? -maximum : 0,
                               .to = maximum,
                               .label = label};
    return OVR_OK;
}

ovr_status ovr_draw_plastic(const ovr_drawing *drawing, ovr_chart *chart,
                            ovr_error *err)
{
    enum { PANELS = 3, NOTE = 200 };
    const ovr_picture_options *o = drawing->options;
    yielded y = {.of = drawing,
                 .group = o->surface == 2 ? "plastic/surface_2"
                                          : "plastic/surface_1"};
    ovr_panel *panel = ovr_arena_take(drawing->arena, PANELS, sizeof *panel,
                                      err);
    char *note = ovr_arena_take(drawing->arena, NOTE, 1, err);
    if (!panel || !note)
        return OVR_NO_MEMORY;
    if (read_group(&y, err) || profile_panel(&y, &panel[0], err) ||
        map_panel(&y, y.flowed, false, "plastic strain", &panel[1], err) ||
        map_panel(&y, y.residual, true,
                  "residual {/Symbol s}_x / {/:Italic p}_h", &panel[2], err))
        return OVR_BAD_INPUT;
    snprintf(note, NOTE, "plastic strain up to %.3g", panel[1].image.to);
    chart->subtitle = note;
    chart->rows = PANELS;
    chart->panel = panel;
    return OVR_OK;
}
