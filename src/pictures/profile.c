/* SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "base/given.h"
#include "pictures/picture.h"

ovr_status ovr_picture_profile(const ovr_profile_view *view, const char *title,
                               const char *path, ovr_error *err)
{
    if (!view || !path)
        return ovr_fail_null(err, __func__);
    ovr_arena arena = ovr_arena_make(NULL);
    ovr_series heights = {.n = view->n,
                          .x = view->x,
                          .y = view->z,
                          .x_factor = view->scaled_x ? 1 : 1e6,
                          .factor = view->scaled_z ? 1 : 1e6,
                          .width = 1};
    ovr_panel panel = {.x_label = view->scaled_x ? "{/:Italic x} / {/:Italic b}"
                                                 : "{/:Italic x}  [µm]",
                       .y_label = view->scaled_z
                                      ? "{/:Italic z R} / {/:Italic b}^2"
                                      : "{/:Italic z}  [µm]",
                       .x_from = NAN,
                       .x_to = NAN,
                       .y_from = NAN,
                       .y_to = NAN,
                       .count = 1,
                       .series = &heights};
    ovr_chart chart = {.kind = "profile",
                       .title = title,
                       .width = 1200,
                       .height = 500,
                       .rows = 1,
                       .columns = 1,
                       .panel = &panel};
    ovr_status status = ovr_chart_draw(&chart, NULL, path, NULL, &arena, err);
    ovr_arena_release(&arena);
    return status;
}

/* The exponential of Rq and slope (simulation/boundary_case.c) at the gaps. */
static double *exponential(const ovr_profile_numbers *n, double modulus,
                           const ovr_dry_point *points, size_t count,
                           ovr_arena *arena, ovr_error *err)
{
    double *y = ovr_arena_take(arena, count, sizeof *y, err);
    for (size_t k = 0; y && k < count; k++)
        y[k] = 0.38 * modulus * n->dq * exp(-2.15 * points[k].gap / n->q);
    return y;
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
    double *column[3], to_height = view->scaled_z ? 1 : 1e9;
    const char *pressure = view->scaled_x ? "{/:Italic p} / {/:Italic p}_h"
                                          : "{/:Italic p} / {/:Italic E}^*";
    for (int k = 0; k < 3; k++) {
        column[k] = ovr_arena_take(&arena, count, sizeof **column, err);
        for (size_t i = 0; column[k] && i < count; i++)
            column[k][i] = k == 0   ? points[i].pressure
                           : k == 1 ? points[i].gap
                                    : points[i].area;
    }
    double *law = exponential(numbers, view->scaled_x ? 2 : 1, points, count,
                              &arena, err);
    if (!column[0] || !column[1] || !column[2] || !law) {
        ovr_arena_release(&arena);
        return OVR_NO_MEMORY;
    }
    const ovr_series over_gap[] = {{.label = "the profile, pressed dry",
                                    .n = count,
                                    .x = column[1],
                                    .y = column[0],
                                    .x_factor = to_height},
                                   {.label = "exponential of Rq and slope",
                                    .n = count,
                                    .x = column[1],
                                    .y = law,
                                    .x_factor = to_height,
                                    .mark = OVR_MARK_DASHED,
                                    .colour = OVR_AMBER}};
    const ovr_series area = {
        .n = count, .x = column[0], .y = column[2], .colour = OVR_STEEL};
    ovr_panel panel[] = {
        {.x_label = view->scaled_z ? "mean gap {/:Italic R} / {/:Italic b}^2"
                                   : "mean gap  [nm]",
         .y_label = pressure,
         .x_from = NAN,
         .x_to = NAN,
         .y_from = NAN,
         .y_to = NAN,
         .log_y = true,
         .count = 2,
         .series = over_gap},
        {.x_label = pressure,
         .y_label = "part that touches",
         .x_from = NAN,
         .x_to = NAN,
         .y_from = NAN,
         .y_to = NAN,
         .log_x = true,
         .log_y = true,
         .count = 1,
         .series = &area}};
    ovr_chart chart = {.kind = "contact",
                       .title = title,
                       .width = 1200,
                       .height = 500,
                       .rows = 1,
                       .columns = 2,
                       .panel = panel};
    ovr_status status = ovr_chart_draw(&chart, NULL, path, NULL, &arena, err);
    ovr_arena_release(&arena);
    return status;
}
