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
