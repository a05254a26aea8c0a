/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Stribeck curve of a study: friction coefficient, fluid friction part (dashed)
 * and asperity load share against speed, with a line for each value of a second
 * key.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/error.h"
#include "base/given.h"
#include "pictures/picture.h"

enum { LINES = 8, LABEL = 120 };

typedef struct curves {
    const ovr_table *t;
    const ovr_table_column *speed, *by, *mu, *film, *share;
    size_t row[LINES], lines; /* one row per line */
    char label[LINES][LABEL];
} curves;

static ovr_status choose_speed(curves *of, const char *asked, ovr_error *err)
{
    static const char *const speeds[] = {"mean_speed", "speed_1", "speed_2",
                                         "mean_speed_m_per_s"};
    of->speed = asked ? ovr_table_named(of->t, asked) : NULL;
    for (size_t k = 0; !asked && !of->speed && k < 4; k++)
        of->speed = ovr_table_named(of->t, speeds[k]);
    if (of->speed)
        return OVR_OK;
    return ovr_fail(err, OVR_BAD_INPUT,
                    "a Stribeck curve needs a study over contact.mean_speed, "
                    "or another key with --against");
}

static ovr_status choose(curves *of, const ovr_figure_options *o,
                         ovr_error *err)
{
    const ovr_table_column *c;
    ovr_status status = choose_speed(of, o->x, err);
    if (status)
        return status;
    of->mu = ovr_table_named(of->t, "mu_slide");
    of->film = ovr_table_named(of->t, "mu_film");
    of->share = ovr_table_named(of->t, "contact_share");
    if (!of->mu || !of->film || !of->share)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "the table has no contact_share and mu_film; its "
                        "case needs [boundary]");
    if (o->by && *o->by)
        of->by = ovr_table_named(of->t, o->by);
    if (o->by && *o->by && !of->by)
        return ovr_fail(err, OVR_BAD_INPUT, "the table has no column '%s'",
                        o->by);
    for (size_t k = 0; !o->by && !of->by && (c = ovr_table_at(of->t, k)); k++)
        if (c->varied && c != of->speed)
            of->by = c;
    return OVR_OK;
}

/* Names a line, "Rq = 50 nm". */
static void name_line(const ovr_table_column *by, size_t row, char label[LABEL])
{
    double value = by->number[row];
    bool nm = !strcmp(by->unit, "m") && fabs(value) < 1e-5;
    if (isfinite(value))
        snprintf(label, LABEL, "%.40s = %.4g %.20s", by->name,
                 nm ? value * 1e9 : value, nm ? "nm" : by->unit);
    else
        snprintf(label, LABEL, "%.40s = %.60s", by->name,
                 by->text ? by->text[row] : "?");
}

static ovr_status find_lines(curves *of, ovr_error *err)
{
    for (size_t i = 0; i < ovr_table_rows(of->t); i++) {
        size_t l = 0;
        while (l < of->lines && of->by &&
               !ovr_table_same(of->by, i, of->row[l]))
            l++;
        if (l < of->lines)
            continue;
        if (l == LINES)
            return ovr_fail(
                err, OVR_BAD_INPUT,
                "%s has more than %d values; use --lines none, or another key",
                of->by->name, LINES);
        of->row[of->lines++] = i;
        if (!of->by)
            continue;
        name_line(of->by, i, of->label[l]);
    }
    return OVR_OK;
}

/* Sorts by insertion; a line has some dozens of points. */
static void sort(size_t n, size_t *at, const double *speed)
{
    for (size_t k = 1; k < n; k++) {
        size_t now = at[k], j = k;
        for (; j && speed[at[j - 1]] > speed[now]; j--)
            at[j] = at[j - 1];
        at[j] = now;
    }
}

/* Adds a line's quantity against speed. */
static void add_line(const curves *of, size_t line, const ovr_table_column *c,
                     ovr_series look, ovr_panel *to, ovr_arena *arena)
{
    size_t rows = ovr_table_rows(of->t), n = 0;
    double *x = ovr_arena_take(arena, 2 * rows, sizeof *x, NULL);
    size_t *at = ovr_arena_take(arena, rows, sizeof *at, NULL);
    if (!x || !at)
        return;
    for (size_t i = 0; i < rows; i++)
        if ((!of->by || ovr_table_same(of->by, i, of->row[line])) &&
            isfinite(c->number[i]) && of->speed->number[i] > 0)
            at[n++] = i;
    sort(n, at, of->speed->number);
    for (size_t k = 0; k < n; k++) {
        x[k] = of->speed->number[at[k]];
        x[rows + k] = fabs(c->number[at[k]]);
    }
    look.n = n;
    look.x = x;
    look.y = x + rows;
    look.colour = (int)(line % (OVR_GREY + 1));
    ovr_panel_add(to, arena, look);
}

static ovr_status draw_curves(const curves *of, const ovr_figure_options *o,
                              ovr_arena *arena, ovr_error *err)
{
    const char *speed = "mean speed  [m/s]";
    ovr_panel panel[] = {ovr_panel_make(speed, "coefficient of friction"),
                         ovr_panel_make(speed, "asperity load share")};
    for (size_t l = 0; l < of->lines; l++) {
        const ovr_series mu = {.label = of->by ? of->label[l] : "friction"};
        add_line(of, l, of->mu, mu, &panel[0], arena);
        add_line(of, l, of->share, (ovr_series){0}, &panel[1], arena);
    }
    for (size_t l = 0; l < of->lines; l++) {
        const ovr_series film = {.label = l ? NULL : "fluid friction",
                                 .mark = OVR_MARK_DASHED};
        add_line(of, l, of->film, film, &panel[0], arena);
    }
    for (int k = 0; k < 2; k++) {
        panel[k].y_from = 0;
        panel[k].log_x = true;
    }
    ovr_chart chart = {.kind = "stribeck",
                       .width = 960,
                       .height = 760,
                       .rows = 2,
                       .columns = 1,
                       .share_x = true,
                       .panel = panel};
    return ovr_figure_draw(&chart, o, arena, err);
}

static ovr_status draw(const void *table, const ovr_figure_options *o,
                       ovr_arena *arena, ovr_error *err)
{
    curves of = {.t = table};
    ovr_status status = choose(&of, o, err);
    if (!status)
        status = find_lines(&of, err);
    return status ? status : draw_curves(&of, o, arena, err);
}

ovr_status ovr_figure_stribeck(const ovr_table *table,
                               const ovr_figure_options *given,
                               const ovr_allocator *allocator, ovr_error *err)
{
    if (!table)
        return ovr_fail_null(err, __func__);
    return ovr_figure_of(table, given, allocator, draw, err);
}
