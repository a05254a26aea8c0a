/* SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "base/given.h"
#include "pictures/picture.h"

ovr_panel ovr_profile_panel(const ovr_profile_view *view, ovr_arena *arena)
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
    ovr_panel panel = ovr_profile_panel(view, &arena);
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

/* The two panels draw these. */
typedef struct bearing {
    ovr_arena *arena;
    size_t count;
    double *pressure, *gap, *area, *exponential;
} bearing;

/* The exponential of Rq and slope is that of physics/mixed/keys.c. */
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
                         ovr_panel_make(pressure, "part that touches")};
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
