/* SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "elements/pictures_element.h"
#include "overroll/case.h"
#include "pictures/view_data.h"
#include "surface/surfaces.h"

/* -------------------------------------------------------------------- areal */

/* Maps of a strip for the page: pressure and film thickness between X = -2 and
 * 1.5, on every stride-th node and line. The stride is the smallest that keeps
 * the maps of all snapshots below MAX_CELLS cells. Values are rounded to LEVELS
 * levels. Film thickness is limited to 1.2 times its maximum in |X| < 0.9. */

enum { MAX_CELLS = 12000000, LEVELS = 2048, MAPS = 2, LONGEST_STRIDE = 4 };

typedef struct maps {
    const ovr_view_run *view;
    size_t first, stride, columns, rows, every, snapshots;
    double *values; /* values in a stored snapshot */
} maps;

static const struct {
    const char *key, *name;
} fields[MAPS] = {{"P", "pressure"}, {"H", "film_thickness"}};

/* Chooses nodes, lines and snapshots. */
static void choose(maps *m)
{
    const ovr_stored *run = m->view->run;
    const ovr_result_info *info = run->info;
    size_t last = info->nodes;
    while (m->first + 2 < info->nodes && run->x[m->first] < -2)
        m->first++;
    while (last > m->first + 2 && run->x[last - 1] > 1.5)
        last--;
    for (m->stride = 1;; m->stride++) {
        m->columns = (last - m->first - 1) / m->stride + 1;
        m->rows = (info->lines - 1) / m->stride + 1;
        double cells = (double)(MAPS * m->columns * m->rows) *
                       (double)m->view->snapshots;
        m->every = 1;
        if (cells <= MAX_CELLS)
            break;
        if (m->stride == LONGEST_STRIDE) {
            m->every = (size_t)ceil(cells / MAX_CELLS);
            break;
        }
    }
    m->snapshots = (m->view->snapshots - 1) / m->every + 1;
}

/* Reads a field of the k-th stored snapshot. */
static ovr_status read_map(const maps *m, int f, size_t k, ovr_error *err)
{
    return ovr_result_areal(m->view->run->result, fields[f].name,
                            k * m->every * m->view->every, OVR_HERTZIAN,
                            m->values, err);
}

static double value_at(const maps *m, size_t i, size_t j)
{
    return m->values[j * m->stride * m->view->run->info->nodes + m->first +
                     i * m->stride];
}

/* Chooses levels from the minimum, or zero, to the largest significant
 * value. */
static ovr_status find_levels(const maps *m, int f, ovr_levels *levels,
                              ovr_error *err)
{
    double low = f ? INFINITY : 0, high = -INFINITY;
    for (size_t k = 0; k < m->snapshots; k++) {
        if (read_map(m, f, k, err))
            return OVR_IO;
        for (size_t i = 0; i < m->columns; i++) {
            double x = m->view->run->x[m->first + i * m->stride];
            for (size_t j = 0; j < m->rows; j++) {
                low = fmin(low, value_at(m, i, j));
                if (!f || fabs(x) < 0.9)
                    high = fmax(high, value_at(m, i, j));
            }
        }
    }
    double span = f ? 1.2 * high - low : high - low;
    *levels = (ovr_levels){low, (span > 0 ? span : 1) / (LEVELS - 1), 0};
    return OVR_OK;
}

static ovr_status append_map(const maps *m, int f, ovr_error *err)
{
    const ovr_view_run *w = m->view;
    size_t cells = m->columns * m->rows;
    uint16_t *level = ovr_arena_take(w->arena, cells * m->snapshots,
                                     sizeof *level, err);
    ovr_levels l;
    if (!level)
        return OVR_NO_MEMORY;
    ovr_status status = find_levels(m, f, &l, err);
    for (size_t k = 0; !status && k < m->snapshots; k++) {
        status = read_map(m, f, k, err);
        for (size_t c = 0; !status && c < cells; c++) {
            double v = value_at(m, c % m->columns, c / m->columns);
            double at = (v - l.from) / l.step;
            level[k * cells + c] =
                (uint16_t)(at > 0 ? fmin(at + 0.5, LEVELS - 1) : 0);
        }
    }
    if (status)
        return status;
    ovr_text_print(w->to,
                   "\"%s\":{\"levels\":%d,\"from\":%.17g,\"step\":%.17g,"
                   "\"bend\":0,\"data\":\"",
                   fields[f].key, LEVELS, l.from, l.step);
    status = ovr_pack_levels(w->to, level, cells, m->snapshots, w->arena, err);
    ovr_text_put(w->to, "\"},");
    return status;
}

ovr_status ovr_view_areal(const ovr_view_run *view, ovr_error *err)
{
    const ovr_stored *run = view->run;
    maps m = {.view = view};
    if (run->info->lines < 2 || !run->pressure || !run->film)
        return OVR_OK;
    choose(&m);
    m.values = ovr_arena_take(view->arena, run->info->nodes * run->info->lines,
                              sizeof *m.values, err);
    double *x = ovr_arena_take(view->arena, m.columns, sizeof *x, err);
    double *y = ovr_arena_take(view->arena, run->info->lines, sizeof *y, err);
    if (ovr_arena_status(view->arena))
        return OVR_NO_MEMORY;
    double shown = NAN;
    ovr_status status = ovr_result_across(run->result, &shown, err);
    if (!status)
        status = ovr_result_y(run->result, OVR_HERTZIAN, y, err);
    for (size_t i = 0; i < m.columns; i++)
        x[i] = run->x[m.first + i * m.stride];
    for (size_t j = 0; j < m.rows; j++)
        y[j] = y[j * m.stride];
    ovr_text_print(view->to,
                   "\"areal\":{\"columns\":%zu,\"rows\":%zu,\"every\":%zu,"
                   "\"shots\":%zu,\"width\":%.17g,\"shown\":%.17g,",
                   m.columns, m.rows, m.every, m.snapshots, run->info->width,
                   shown);
    ovr_text_doubles(view->to, "x", x, m.columns);
    ovr_text_doubles(view->to, "y", y, m.rows);
    for (int f = 0; !status && f < MAPS; f++)
        status = append_map(&m, f, err);
    if (m.stride > 1 || m.every > 1)
        ovr_text_print(view->to,
                       "\"coarser\":\"maps have every node of %zu along x and "
                       "across and every snapshot of %zu\"},",
                       m.stride, m.every);
    else
        ovr_text_put(view->to, "\"coarser\":\"\"},");
    return status;
}

/* ------------------------------------------------------------------ Element */

/* Panels and curves of an element's figure, as drawn by pictures_page.js. */

/* Writes a curve. Labels and letters need no escaping. */
static void append_curve(ovr_text *to, const ovr_series *s, ovr_arena *arena)
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

static void append_panel(ovr_text *to, const ovr_panel *p, ovr_arena *arena)
{
    ovr_text_print(to,
                   "{\"xName\":\"%s\",\"yName\":\"%s\",\"x0\":%.9g,\"x1\":%.9g,"
                   "\"y0\":%.9g,\"y1\":%.9g,\"equal\":%d,\"curves\":[",
                   p->x_label, p->y_label, p->x_from, p->x_to, p->y_from,
                   p->y_to, p->equal);
    for (size_t k = 0; k < p->count; k++)
        append_curve(to, &p->series[k], arena);
    ovr_text_put(to, "0]}");
}

static void append_figure(ovr_text *to, const ovr_element_figure *f,
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
        append_panel(to, &f->panel[k], arena);
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
        append_figure(view->to, figure, view->run->info->time, arena);
    ovr_setup_free(setup);
    ovr_case_free(c);
}
