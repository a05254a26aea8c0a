/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Draws what the material of a surface went through: the radius of the circle
 * over place and depth with the feature above it and the risk below; and the
 * same over depth alone.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "case/case.h"
#include "overroll/case.h"
#include "pictures/picture.h"
#include "results/results.h"
#include "run/forms.h"
#include "stress/stress.h"
#include "surface/surfaces.h"

enum { CELLS_X = 420, CELLS_Z = 160 };

typedef struct history {
    const ovr_drawing *s;
    int surface;
    size_t depths, points;
    double *z, *xi, *R, *smooth, *risk, *length, *S;
    bool life;
    double risk_smooth; /* NAN: not known */
    double minimum, worst, worst_xi, worst_z;
    char name[64];
} history;

static double *read_all(history *h, const char *what, size_t rows, size_t n,
                        ovr_error *err)
{
    char path[96];
    double *v = ovr_arena_take(h->s->arena, rows * n, sizeof *v, err);
    snprintf(path, sizeof path, "%s/%s", h->name, what);
    for (size_t r = 0; v && r < rows; r++)
        if (ovr_result_read(h->s->runs->result, path, r, OVR_HERTZIAN,
                            v + r * n, err))
            return NULL;
    return v;
}

/* The heights of the surface at T = 0 and the smooth risk, from the case. */
static void read_case(history *h, const double *A)
{
    const ovr_result_info *info = h->s->runs->info;
    ovr_error err = {0};
    ovr_case *c = ovr_case_read_stored(info->case_text, "case", NULL, NULL,
                                       &err);
    ovr_setup *setup = c ? ovr_case_resolve(c, NULL, &err) : NULL;

    h->minimum = 8 * (h->s->runs->x[1] - h->s->runs->x[0]);
    if (setup && !ovr_setup_prepare(setup, NULL, &err)) {
        ovr_life_options life = ovr_setup_stress(setup)->life;
        double z;
        h->minimum = fmax(8 * setup->mesh, life.least_depth);
        life.limit = ovr_setup_stress(setup)->limit_pressure *
                     ovr_hertz_criterion(
                         ovr_setup_stress(setup)->criterion,
                         ovr_setup_stress(setup)->alpha,
                         ovr_setup_stress(setup)->poisson[h->surface - 1], &z);
        double *i = A ? ovr_arena_take(h->s->arena, h->depths, sizeof *i, NULL)
                      : NULL;
        size_t from = 0;
        while (from + 1 < h->depths && h->z[from] < h->minimum * (1 - 1e-9))
            from++;
        if (i) {
            ovr_risk(&life, h->depths, h->z, A, i);
            h->risk_smooth = i[from];
        }
        double centre = 0;
        size_t n = setup->surfaces ? ovr_surfaces_count(setup->surfaces) : 0;
        for (size_t k = n; k-- > 0;)
            if (ovr_surfaces_info(setup->surfaces, k).surface == h->surface)
                centre = ovr_surfaces_centre(setup->surfaces, k, 0);
        double *X = ovr_arena_take(h->s->arena, h->points, sizeof *X, NULL);
        h->S = n ? ovr_arena_take(h->s->arena, h->points, sizeof *X, NULL)
                 : NULL;
        for (size_t k = 0; X && k < h->points; k++)
            X[k] = centre + h->xi[k];
        if (X && h->S)
            ovr_surfaces_heights(setup->surfaces, 0, h->points, X, h->S);
    }
    ovr_setup_free(setup);
    ovr_case_free(c);
}

static void find_worst(history *h)
{
    for (size_t j = 0; j < h->depths; j++)
        for (size_t k = 0; k < h->points; k++)
            if (h->z[j] >= h->minimum * (1 - 1e-9) &&
                h->R[j * h->points + k] > h->worst) {
                h->worst = h->R[j * h->points + k];
                h->worst_xi = h->xi[k];
                h->worst_z = h->z[j];
            }
}

static ovr_status read_history(history *h, ovr_error *err)
{
    const ovr_variable *R;
    char path[96];
    snprintf(h->name, sizeof h->name, "fatigue/surface_%d", h->surface);
    snprintf(path, sizeof path, "%s/circle_radius", h->name);
    R = ovr_result_find(h->s->runs->result, path);
    if (!R || R->rank != 2)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "the file has no %s: run the case with a section "
                        "[stress] (and [fatigue])",
                        h->name);
    h->depths = R->shape[0];
    h->points = R->shape[1];
    snprintf(path, sizeof path, "%s/risk", h->name);
    h->life = ovr_result_find(h->s->runs->result, path) != NULL;
    h->risk_smooth = NAN;
    h->z = read_all(h, "depth", 1, h->depths, err);
    h->xi = read_all(h, "material", 1, h->points, err);
    h->R = read_all(h, "circle_radius", h->depths, h->points, err);
    h->smooth = read_all(h, "circle_radius_smooth", 1, h->depths, err);
    if (!h->z || !h->xi || !h->R || !h->smooth || h->points < 2)
        return OVR_BAD_INPUT;
    double *A = NULL;
    if (h->life) {
        h->risk = read_all(h, "risk", 1, h->points, err);
        h->length = read_all(h, "equivalent_length", 1, h->depths, err);
        A = read_all(h, "amplitude_smooth", 1, h->depths, err);
        if (!h->risk || !h->length || !A)
            return OVR_BAD_INPUT;
    }
    read_case(h, A);
    find_worst(h);
    return OVR_OK;
}

/* --------------------------------------------------------------------- map */

static double at_cell(const history *h, double xi, double z)
{
    double u = (xi - h->xi[0]) / (h->xi[1] - h->xi[0]);
    size_t k = u > 0 ? (size_t)u : 0, j = 0;
    if (k + 2 > h->points)
        k = h->points - 2;
    while (j + 2 < h->depths && h->z[j + 1] <= z)
        j++;
    double a = u - (double)k;
    double b = log(z / h->z[j]) / log(h->z[j + 1] / h->z[j]);
    const double *low = h->R + j * h->points + k, *high = low + h->points;
    return (1 - b) * ((1 - a) * low[0] + a * low[1]) +
           b * ((1 - a) * high[0] + a * high[1]);
}

static double largest_smooth(const history *h)
{
    double maximum = 0;
    for (size_t j = 0; j < h->depths; j++)
        maximum = fmax(maximum,
                       h->z[j] >= h->minimum * (1 - 1e-9) ? h->smooth[j] : 0);
    return maximum;
}

/* Contours every 0.1, the smooth contact's largest, a cross at the worst. */
static ovr_status add_marks(const history *h, ovr_panel *panel,
                            ovr_series *series, ovr_error *err)
{
    enum { CAPACITY = 120 };
    double *mark = ovr_arena_take(h->s->arena, 2, sizeof *mark, err);
    char *thin = ovr_arena_take(h->s->arena, 2 * CAPACITY, 1, err);
    size_t used = 0;
    if (!mark || !thin)
        return OVR_NO_MEMORY;
    for (int k = 1; k <= 10 && k <= 10 * panel->image.to; k++)
        used += (size_t)snprintf(thin + used, CAPACITY - used, "%s%g",
                                 used ? " " : "", 0.1 * k);
    snprintf(thin + CAPACITY, CAPACITY, "%.9g", largest_smooth(h));
    panel->image.contours = thin;
    panel->image.bold_contours = thin + CAPACITY;
    mark[0] = h->worst_xi;
    mark[1] = log10(h->worst_z);
    *series = (ovr_series){.n = 1,
                           .x = mark,
                           .y = mark + 1,
                           .mark = OVR_MARK_CROSS,
                           .colour = OVR_RED,
                           .width = 3};
    panel->count = 1;
    return OVR_OK;
}

static ovr_status map_panel(const history *h, ovr_panel *panel, ovr_error *err)
{
    double *v = ovr_arena_take(h->s->arena, (size_t)CELLS_X * CELLS_Z,
                               sizeof *v, err);
    ovr_series *series = ovr_arena_take(h->s->arena, 1, sizeof *series, err);
    if (!v || !series)
        return OVR_NO_MEMORY;
    *panel = (ovr_panel){
        .x_label = "place in the material, b (trailing side at the left)",
        .y_label = "log_{10} depth / b",
        .x_from = h->xi[0],
        .x_to = h->xi[h->points - 1],
        .y_from = log10(h->z[h->depths - 1]),
        .y_to = log10(h->z[0]),
        .height = 2,
        .series = series};
    for (size_t r = 0; r < CELLS_Z; r++)
        for (size_t c = 0; c < CELLS_X; c++) {
            double xi = panel->x_from + (panel->x_to - panel->x_from) *
                                            ((double)c + 0.5) / CELLS_X;
            double z = panel->y_from + (panel->y_to - panel->y_from) *
                                           ((double)r + 0.5) / CELLS_Z;
            v[r * CELLS_X + c] = at_cell(h, xi, pow(10, z));
        }
    panel->image = (ovr_image){.nx = CELLS_X,
                               .ny = CELLS_Z,
                               .values = v,
                               .to = ceil(20 * fmax(h->worst, 0.25)) / 20,
                               .label = "circle {/:Italic R} / {/:Italic p}_h"};
    return add_marks(h, panel, series, err);
}

static ovr_status line_panel(const history *h, const char *label,
                             const double *y, ovr_mark mark, ovr_panel *panel,
                             ovr_error *err)
{
    ovr_series *series = ovr_arena_take(h->s->arena, 2, sizeof *series, err);
    double low = INFINITY, high = -INFINITY;
    if (!series)
        return OVR_NO_MEMORY;
    for (size_t k = 0; k < h->points; k++)
        low = fmin(low, y[k]), high = fmax(high, y[k]);
    double margin = 0.1 * fmax(high - low, 1e-12);
    *panel = (ovr_panel){
        .x_label = "place in the material, b (trailing side at the left)",
        .y_label = label,
        .x_from = h->xi[0],
        .x_to = h->xi[h->points - 1],
        .y_from = low - margin,
        .y_to = high + margin,
        .height = 0.7,
        .count = 1,
        .series = series};
    series[0] = (ovr_series){.n = h->points,
                             .x = h->xi,
                             .y = y,
                             .mark = mark,
                             .colour = OVR_STEEL,
                             .base = low - margin};
    return OVR_OK;
}

/* i / i_0 on a logarithmic axis; nothing of it where i_0 is not known. */
static ovr_status risk_panel(const history *h, ovr_panel *panel, ovr_error *err)
{
    double *v = ovr_arena_take(h->s->arena, h->points, sizeof *v, err);
    if (!v)
        return OVR_NO_MEMORY;
    for (size_t k = 0; k < h->points; k++)
        v[k] = fmax(h->risk[k] / h->risk_smooth, 1e-3);
    ovr_status status = line_panel(h, "risk / smooth", v, OVR_MARK_LINE, panel,
                                   err);
    panel->log_y = true;
    double low = INFINITY, high = 0;
    for (size_t k = 0; k < h->points; k++)
        low = fmin(low, v[k]), high = fmax(high, v[k]);
    panel->y_from = pow(10, floor(log10(low)));
    panel->y_to = pow(10, ceil(log10(fmax(high, 2))));
    return status;
}

ovr_status ovr_draw_risk(const ovr_drawing *drawing, ovr_chart *chart,
                         ovr_error *err)
{
    const ovr_picture_options *o = drawing->options;
    history h = {.s = drawing, .surface = o->surface ? o->surface : 1};
    ovr_panel *panel = ovr_arena_take(drawing->arena, 3, sizeof *panel, err);
    char *note = ovr_arena_take(drawing->arena, 200, 1, err);
    size_t rows = 0;
    if (!panel || !note)
        return OVR_NO_MEMORY;
    if (read_history(&h, err))
        return OVR_BAD_INPUT;
    if (h.S && line_panel(&h, "surface, b^2/R", h.S, OVR_MARK_AREA,
                          &panel[rows++], err))
        return OVR_NO_MEMORY;
    if (map_panel(&h, &panel[rows++], err))
        return OVR_NO_MEMORY;
    if (h.life && h.risk_smooth > 0 && risk_panel(&h, &panel[rows++], err))
        return OVR_NO_MEMORY;
    snprintf(
        note, 200,
        "worst R %.3g p_h at %.3g b, %.3g b deep; smooth %.3g; from %.3g b "
        "down",
        h.worst, h.worst_xi, h.worst_z, largest_smooth(&h), h.minimum);
    chart->subtitle = note;
    chart->rows = rows;
    chart->panel = panel;
    return OVR_OK;
}

/* ------------------------------------------------------------------- depth */

static ovr_series over_depth(const history *h, const double *y,
                             const char *label, int colour, ovr_mark mark)
{
    return (ovr_series){.label = label,
                        .n = h->depths,
                        .x = h->z,
                        .y = y,
                        .colour = colour,
                        .mark = mark};
}

/* The worst circle at each depth; NULL: no memory. */
static double *worst_at_depths(const history *h, ovr_error *err)
{
    double *worst = ovr_arena_take(h->s->arena, h->depths, sizeof *worst, err);
    for (size_t j = 0; worst && j < h->depths; j++)
        for (size_t k = 0; k < h->points; k++)
            worst[j] = fmax(worst[j], h->R[j * h->points + k]);
    return worst;
}

/* Circles above, equivalent lengths below, where there are any; how many. */
static size_t depth_panels(const history *h, const double *worst,
                           ovr_series *series, ovr_panel *panel)
{
    series[0] = over_depth(h, worst, "worst circle R / ph", OVR_RED,
                           OVR_MARK_LINE);
    series[1] = over_depth(h, h->smooth, "smooth contact", OVR_STEEL,
                           OVR_MARK_DASHED);
    panel[0] = (ovr_panel){.x_label = "depth / b",
                           .y_label = "R / p_h",
                           .x_from = h->z[0],
                           .x_to = h->z[h->depths - 1],
                           .y_from = 0,
                           .y_to = NAN,
                           .log_x = true,
                           .count = 2,
                           .series = series};
    if (!h->length || !isfinite(h->length[0]))
        return 1;
    series[2] = over_depth(h, h->length,
                           "equivalent length / b, counted from this depth "
                           "down",
                           OVR_BLUE, OVR_MARK_LINE);
    panel[1] = panel[0];
    panel[1].y_label = "equivalent length / b";
    panel[1].y_from = NAN;
    panel[1].count = 1;
    panel[1].series = series + 2;
    return 2;
}

ovr_status ovr_draw_depth(const ovr_drawing *drawing, ovr_chart *chart,
                          ovr_error *err)
{
    const ovr_picture_options *o = drawing->options;
    history h = {.s = drawing, .surface = o->surface ? o->surface : 1};
    ovr_panel *panel = ovr_arena_take(drawing->arena, 2, sizeof *panel, err);
    ovr_series *series = ovr_arena_take(drawing->arena, 4, sizeof *series, err);
    if (!panel || !series)
        return OVR_NO_MEMORY;
    if (read_history(&h, err))
        return OVR_BAD_INPUT;
    double *worst = worst_at_depths(&h, err);
    if (!worst)
        return OVR_NO_MEMORY;
    chart->rows = depth_panels(&h, worst, series, panel);
    chart->panel = panel;
    return OVR_OK;
}
