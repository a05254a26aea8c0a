/* SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include "base/given.h"
#include "pictures/picture.h"
#include "surface/areal.h"

/* Makes a panel with the heights of a profile. */
static ovr_panel profile_panel(const ovr_profile_view *view, ovr_arena *arena)
{
    ovr_series heights = {.n = view->n,
                          .x = view->x,
                          .y = view->z,
                          .x_factor = view->scaled_x ? 1 : 1e6,
                          .factor = view->scaled_z ? 1 : 1e6,
                          .width = 1};
    ovr_panel panel = ovr_panel_make(
        view->scaled_x ? "position, {/:Italic x} ({/:Italic b})"
                       : "position, {/:Italic x} (µm)",
        view->scaled_z ? "height, {/:Italic z} ({/:Italic b}^2/{/:Italic R})"
                       : "height, {/:Italic z} (µm)");
    ovr_panel_add(&panel, arena, heights);
    return panel;
}

ovr_status ovr_picture_profile(const ovr_profile_view *view, const char *title,
                               const char *path, ovr_error *err)
{
    if (!view || !path)
        return ovr_fail_null(err, __func__);
    ovr_arena arena = ovr_arena_make(NULL);
    ovr_panel panel = profile_panel(view, &arena);
    ovr_chart chart = {.kind = "profile",
                       .title = title,
                       .width = 1200,
                       .height = 500,
                       .rows = 1,
                       .columns = 1,
                       .panel = &panel};
    ovr_status status = ovr_chart_draw(&chart, &(ovr_drawn_to){.path = path},
                                       &arena, err);
    ovr_arena_release(&arena);
    return status;
}

/* Data of the two panels of asperity contact. */
typedef struct bearing {
    ovr_arena *arena;
    size_t count;
    double *pressure, *gap, *area, *exponential;
} bearing;

/* Computes the curves. The exponential law from Rq and slope is that of
 * physics/mixed/keys.c. */
static ovr_status lay_out(bearing *b, const ovr_profile_numbers *n,
                          double modulus, const ovr_dry_point *points,
                          ovr_error *err)
{
    double **const all[] = {&b->pressure, &b->gap, &b->area, &b->exponential};
    for (size_t k = 0; k < sizeof all / sizeof *all; k++)
        if (!(*all[k] = ovr_arena_take(b->arena, b->count, sizeof **all[k],
                                       err)))
            return OVR_NO_MEMORY;
    for (size_t i = 0; i < b->count; i++) {
        b->pressure[i] = points[i].pressure;
        b->gap[i] = points[i].gap;
        b->area[i] = points[i].area;
        b->exponential[i] = 0.38 * modulus * n->dq *
                            exp(-2.15 * points[i].gap / n->q);
    }
    return OVR_OK;
}

static ovr_status draw_bearing(const bearing *b, const ovr_profile_view *view,
                               const char *title, const char *path,
                               ovr_error *err)
{
    const size_t count = b->count;
    const char *pressure = view->scaled_x
                               ? "pressure, {/:Italic p} ({/:Italic p}_h)"
                               : "pressure, {/:Italic p} ({/:Italic E}^*)";
    const char *gap =
        view->scaled_z ? "mean gap, {/:Italic h} ({/:Italic b}^2/{/:Italic R})"
                       : "mean gap, {/:Italic h} (nm)";
    const ovr_series dry = {.label = "dry contact of the profile",
                            .n = count,
                            .x = b->gap,
                            .y = b->pressure,
                            .x_factor = view->scaled_z ? 1 : 1e9};
    ovr_series law = dry;
    law.label = "exponential of Rq and slope";
    law.y = b->exponential;
    law.mark = OVR_MARK_DASHED;
    law.colour = OVR_AMBER;
    ovr_panel panel[] = {ovr_panel_make(gap, pressure),
                         ovr_panel_make(pressure, "contact length fraction")};
    ovr_panel_add(&panel[0], b->arena, dry);
    ovr_panel_add(&panel[0], b->arena, law);
    ovr_panel_add(
        &panel[1], b->arena,
        (ovr_series){
            .n = count, .x = b->pressure, .y = b->area, .colour = OVR_STEEL});
    panel[0].log_y = panel[1].log_y = panel[1].log_x = true;
    ovr_chart chart = {.kind = "contact",
                       .title = title,
                       .width = 1200,
                       .height = 500,
                       .rows = 1,
                       .columns = 2,
                       .panel = panel};
    return ovr_chart_draw(&chart, &(ovr_drawn_to){.path = path}, b->arena, err);
}

ovr_status ovr_picture_contact(const ovr_profile_view *view,
                               const ovr_profile_numbers *numbers,
                               const ovr_dry_point *points, size_t count,
                               const char *title, const char *path,
                               ovr_error *err)
{
    if (!view || !numbers || !points || !path)
        return ovr_fail_null(err, __func__);
    ovr_arena arena = ovr_arena_make(NULL);
    bearing b = {.arena = &arena, .count = count};
    ovr_status status = lay_out(&b, numbers, view->scaled_x ? 2 : 1, points,
                                err);
    if (!status)
        status = draw_bearing(&b, view, title, path, err);
    ovr_arena_release(&arena);
    return status;
}

/* ---------------------------------------------------------------------- map */

/* Map of an areal surface: heights about their least-squares plane as colours,
 * to scale. The line that is used as the profile is marked and drawn below.
 * Cells are means over blocks of points, at most 600 along a side. The colours
 * end at the quantiles 0.001 and 0.999 of the cells. */

enum { SIDE = 600, WIDTH = 1200, MARGINS = 180, PROFILE_HEIGHT = 320 };

typedef struct cells {
    size_t nx, ny;    /* number of cells */
    size_t block;     /* points along the side of a cell */
    double *values;   /* row by row; NAN: no height */
    double low, high; /* range of the colours */
    bool above;       /* some cells are higher */
} cells;

/* Returns the mean height of a cell above the plane. */
static double cell_height(const ovr_areal *a, const double plane[3],
                          size_t block, size_t column, size_t row)
{
    size_t i_end = (size_t)fmin((double)(column + block), (double)a->nx);
    size_t j_end = (size_t)fmin((double)(row + block), (double)a->ny);
    double sum = 0, count = 0;
    for (size_t j = row; j < j_end; j++)
        for (size_t i = column; i < i_end; i++) {
            double z = a->z[j * a->nx + i];
            if (isnan(z))
                continue;
            sum += z - plane[0] - plane[1] * (double)i - plane[2] * (double)j;
            count++;
        }
    return count > 0 ? sum / count : NAN;
}

static int compare(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static ovr_status find_colours(cells *c, ovr_arena *arena, ovr_error *err)
{
    size_t all = c->nx * c->ny, n = 0;
    double *sorted = ovr_arena_take(arena, all, sizeof *sorted, err);
    if (!sorted)
        return OVR_NO_MEMORY;
    for (size_t k = 0; k < all; k++)
        if (!isnan(c->values[k]))
            sorted[n++] = c->values[k];
    qsort(sorted, n, sizeof *sorted, compare);
    c->low = n ? sorted[(n - 1) / 1000] : 0;
    c->high = n ? sorted[n - 1 - (n - 1) / 1000] : 0;
    if (!(c->high > c->low))
        c->high = c->low + 1e-30;
    c->above = n && sorted[n - 1] > c->high;
    return OVR_OK;
}

static ovr_status make_cells(const ovr_areal *a, double factor, cells *c,
                             ovr_arena *arena, ovr_error *err)
{
    double plane[3];
    size_t longer = a->nx > a->ny ? a->nx : a->ny;
    c->block = (longer + SIDE - 1) / SIDE;
    c->nx = (a->nx + c->block - 1) / c->block;
    c->ny = (a->ny + c->block - 1) / c->block;
    c->values = ovr_arena_take(arena, c->nx * c->ny, sizeof *c->values, err);
    if (!c->values)
        return OVR_NO_MEMORY;
    ovr_areal_plane(a, plane);
    for (size_t j = 0; j < c->ny; j++)
        for (size_t i = 0; i < c->nx; i++)
            c->values[j * c->nx + i] = factor * cell_height(a, plane, c->block,
                                                            i * c->block,
                                                            j * c->block);
    return find_colours(c, arena, err);
}

/* Makes the panel of the map, with cells centred at their points. */
static ovr_panel map_panel(const ovr_areal *a, const cells *c,
                           const ovr_profile_view *view, double factor,
                           ovr_arena *arena)
{
    double dx = factor * a->dx, dy = factor * a->dy, block = (double)c->block;
    ovr_panel panel = ovr_panel_make(
        a->scaled_x ? "position, {/:Italic x} ({/:Italic b})"
                    : "position, {/:Italic x} (µm)",
        a->scaled_x ? "position, {/:Italic y} ({/:Italic b})"
                    : "position, {/:Italic y} (µm)");
    panel.x_from = -dx / 2;
    panel.y_from = -dy / 2;
    panel.x_to = panel.x_from + dx * block * (double)c->nx;
    panel.y_to = panel.y_from + dy * block * (double)c->ny;
    panel.image = (ovr_image){
        .nx = c->nx,
        .ny = c->ny,
        .values = c->values,
        .from = c->low,
        .to = c->high,
        .above = c->above,
        .label = a->scaled_z
                     ? "height, {/:Italic z} ({/:Italic b}^2/{/:Italic R})"
                     : "height, {/:Italic z} (µm)"};
    ovr_panel_line(&panel, arena, factor * view->line[0],
                   factor * view->line[2], factor * view->line[1],
                   factor * view->line[3],
                   (ovr_series){.colour = OVR_WHITE, .width = 1.6});
    return panel;
}

/* Returns the height of the map relative to its width: to scale, limited to
 * 1/12 to 1. */
static double map_height(const ovr_panel *map)
{
    double ratio = (map->y_to - map->y_from) / (map->x_to - map->x_from);
    return (WIDTH - MARGINS) * fmax(1.0 / 12, fmin(ratio, 1));
}

ovr_status ovr_picture_areal(const ovr_areal *areal,
                             const ovr_profile_view *view, const char *title,
                             const char *path, ovr_error *err)
{
    if (!areal || !view || !path)
        return ovr_fail_null(err, __func__);
    if (!areal->z || areal->nx < 2 || areal->ny < 2)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "an areal surface has two rows of two points at least");
    ovr_arena arena = ovr_arena_make(NULL);
    cells c = {0};
    ovr_status status = make_cells(areal, areal->scaled_z ? 1 : 1e6, &c, &arena,
                                   err);
    if (!status) {
        double factor = areal->scaled_x ? 1 : 1e6;
        ovr_panel panel[] = {map_panel(areal, &c, view, factor, &arena),
                             profile_panel(view, &arena)};
        double height = map_height(&panel[0]);
        panel[0].height = height / PROFILE_HEIGHT;
        panel[0].equal = true;
        panel[1].x_label = areal->scaled_x
                               ? "position along the line ({/:Italic b})"
                               : "position along the line (µm)";
        ovr_chart chart = {.kind = "profile",
                           .title = title,
                           .width = WIDTH,
                           .height = (int)height + PROFILE_HEIGHT + MARGINS,
                           .rows = 2,
                           .columns = 1,
                           .panel = panel};
        status = ovr_chart_draw(&chart, &(ovr_drawn_to){.path = path}, &arena,
                                err);
    }
    ovr_arena_release(&arena);
    return status;
}
