/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Panels and curves of an element's figure, as page_element.js draws them. */
#include "pictures/view_run.h"

#include <math.h>

#include "pictures/draw_element.h"
#include "pictures/pack_levels.h"

/* Labels and letters are ours: nothing in them ends a string. */
static void put_curve(ovr_text *to, const ovr_series *s, ovr_arena *arena)
{
    double *xy = ovr_arena_take(arena, 2 * s->n, sizeof *xy, NULL);
    if (!xy)
        return;
    for (size_t i = 0; i < s->n; i++) {
        xy[i] = ovr_series_x(s, i);
        xy[s->n + i] = ovr_series_y(s, i);
    }
    ovr_text_print(to,
                   "{\"label\":\"%s\",\"mark\":\"%s\",\"letters\":\"%s\","
                   "\"colour\":%d,\"width\":%.3g,",
                   s->label ? s->label : "", ovr_mark_names[s->mark],
                   s->letters ? s->letters : "", s->colour,
                   s->width > 0 ? s->width : 2);
    ovr_text_doubles(to, "x", xy, s->n);
    ovr_text_doubles(to, "y", xy + s->n, s->n);
    ovr_text_put(to, "\"kind\":0},");
}

static void put_panel(ovr_text *to, const ovr_panel *p, ovr_arena *arena)
{
    ovr_text_print(to,
                   "{\"xName\":\"%s\",\"yName\":\"%s\",\"x0\":%.9g,\"x1\":%.9g,"
                   "\"y0\":%.9g,\"y1\":%.9g,\"equal\":%d,\"curves\":[",
                   p->x_label, p->y_label, p->x_from, p->x_to, p->y_from,
                   p->y_to, p->equal);
    for (size_t k = 0; k < p->count; k++)
        put_curve(to, &p->series[k], arena);
    ovr_text_put(to, "0]}");
}

static void put_figure(ovr_text *to, const ovr_element_figure *f,
                       double seconds, ovr_arena *arena)
{
    ovr_text_put(to, "\"element\":{");
    ovr_text_doubles(to, "at", f->at, f->points);
    ovr_text_doubles(to, "x", f->x, f->points);
    ovr_text_doubles(to, "y", f->y, f->points);
    ovr_text_print(to,
                   "\"unit\":%.17g,\"begin\":%.17g,\"seconds\":%.17g,"
                   "\"panels\":[",
                   f->unit, f->begin, seconds);
    for (size_t k = 0; k < f->panels; k++) {
        ovr_text_put(to, k ? "," : "");
        put_panel(to, &f->panel[k], arena);
    }
    ovr_text_put(to, "]},");
}

void ovr_view_element(const ovr_view_run *view)
{
    ovr_arena *arena = view->arena;
    ovr_case *c;
    ovr_error err = {0};
    ovr_element_figure *figure = ovr_arena_take(arena, 1, sizeof *figure, NULL);
    ovr_setup *setup = figure ? ovr_stored_setup(view->run, &c, &err) : NULL;
    if (!setup)
        return;
    if (!ovr_element_draw(setup, NULL, arena, figure, &err))
        put_figure(view->to, figure, view->run->info->time, arena);
    ovr_setup_free(setup);
    ovr_case_free(c);
}
