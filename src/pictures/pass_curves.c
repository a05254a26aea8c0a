/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Several passes: film thickness, and inlet meniscus or rim heights, against
 * the pass number. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/given.h"
#include "pictures/chart.h"
#include "pictures/picture.h"

typedef struct line {
    const char *name, *label;
    int colour;
} line;

/* Adds lines with points; the first determines the axis. */
static ovr_status add_lines(const ovr_table *t, const line *lines, size_t count,
                            ovr_unit_kind kind, ovr_panel *panel,
                            ovr_arena *arena, ovr_error *err)
{
    const ovr_table_column *pass = ovr_table_named(t, "pass");
    ovr_axis axis = {0};
    for (size_t k = 0; k < 2 * count; k++) {
        const line *l = &lines[k % count];
        const ovr_table_column *c = ovr_table_named(t, l->name);
        if (!pass || !c)
            return ovr_fail(err, OVR_BAD_INPUT,
                            "no '%s' in the file: not a file of several "
                            "passes",
                            pass ? l->name : "pass");
        if (k == 0)
            ovr_axis_as_is(kind, *c->unit,
                           ovr_axis_reach(c->number, ovr_table_rows(t)), &axis);
        ovr_panel_add(
            panel, arena,
            (ovr_series){.label = k < count ? l->label : NULL,
                         .n = ovr_table_rows(t),
                         .x = pass->number,
                         .y = c->number,
                         .factor = axis.factor,
                         .colour = l->colour,
                         .mark = k < count ? OVR_MARK_LINE : OVR_MARK_POINTS,
                         .width = k < count ? 0 : 2.4});
    }
    panel->y_label = axis.label;
    return OVR_OK;
}

static bool is_known(const ovr_table *t, const char *name)
{
    const ovr_table_column *c = ovr_table_named(t, name);
    for (size_t i = 0; c && i < ovr_table_rows(t); i++)
        if (isfinite(c->number[i]))
            return true;
    return false;
}

/* Returns "rim height (um)" from "film thickness, h (um)". */
static const char *name_rims(const char *label, ovr_arena *arena,
                             ovr_error *err)
{
    enum { CAPACITY = 120 };
    const char *unit = strrchr(label, '(');
    char *text = ovr_arena_take(arena, CAPACITY, 1, err);
    if (text)
        snprintf(text, CAPACITY, "rim height %.80s", unit ? unit : "");
    return text ? text : label;
}

/* True without features: minimum and mean film thickness are equal. */
static bool is_steady(const ovr_table *t)
{
    const ovr_table_column *minimum = ovr_table_named(
        t, "least_central_film_thickness");
    const ovr_table_column *mean = ovr_table_named(t, "central_film_thickness");
    for (size_t i = 0; minimum && mean && i < ovr_table_rows(t); i++)
        if (minimum->number[i] < (1 - 1e-6) * mean->number[i])
            return false;
    return true;
}

static ovr_status draw(const void *table, const ovr_figure_options *o,
                       ovr_arena *arena, ovr_error *err)
{
    const ovr_table *t = table;
    static const line films[] = {
        {"central_film_thickness", "central film thickness, mean", OVR_AMBER},
        {"min_film_thickness", "minimum film thickness", OVR_BLUE},
        {"least_central_film_thickness", "central film thickness, minimum",
         OVR_RED}};
    static const line menisci[] = {
        {"meniscus", "inlet meniscus position", OVR_STEEL}};
    static const line rims[] = {
        {"shoulder_height_leading", "leading rim height", OVR_BLUE},
        {"shoulder_height_trailing", "trailing rim height", OVR_RED}};
    bool starved = is_known(t, menisci[0].name);
    bool dented = !starved && is_known(t, rims[0].name);
    double rows = (double)ovr_table_rows(t);
    ovr_panel panel[2];
    ovr_status status;
    for (int k = 0; k < 2; k++)
        panel[k] = (ovr_panel){.x_label = "pass number",
                               .x_from = 1 - 0.04 * rows,
                               .x_to = rows + 0.04 * rows,
                               .y_from = k ? NAN : 0,
                               .y_to = NAN};
    ovr_chart chart = {.kind = "passes",
                       .width = 960,
                       .height = 720,
                       .rows = starved || dented ? 2 : 1,
                       .columns = 1,
                       .share_x = true,
                       .panel = panel};
    status = add_lines(t, films, is_steady(t) ? 2 : 3, OVR_KIND_HEIGHT,
                       &panel[0], arena, err);
    if (!status && dented)
        status = add_lines(t, rims, 2, OVR_KIND_HEIGHT, &panel[1], arena, err);
    if (!status && dented)
        panel[1].y_label = name_rims(panel[1].y_label, arena, err);
    if (!status && starved)
        status = add_lines(t, menisci, 1, OVR_KIND_LENGTH, &panel[1], arena,
                           err);
    return status ? status : ovr_figure_draw(&chart, o, arena, err);
}

ovr_status ovr_figure_passes(const ovr_table *passes,
                             const ovr_figure_options *given,
                             const ovr_allocator *allocator, ovr_error *err)
{
    if (!passes)
        return ovr_fail_null(err, __func__);
    return ovr_figure_of(passes, given, allocator, draw, err);
}
