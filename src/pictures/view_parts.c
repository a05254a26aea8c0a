/* SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "elements/pictures_element.h"
#include "overroll/case.h"
#include "physics/stress/pictures_depth.h"
#include "pictures/material.h"
#include "pictures/pack_levels.h"
#include "pictures/view_run.h"
#include "stress/layered.h"
#include "surface/surfaces.h"

/* -------------------------------------------------------------------- areal */

/*
 * Maps of a strip for the page: pressure and film thickness between X = -2 and
 * 1.5, on every stride-th node and line.  The stride is the smallest one that
 * keeps the maps of all snapshots below MAX_CELLS cells.  Values are rounded to
 * LEVELS levels.  Film thicknesses are cut off at 1.2 times the largest one in
 * |X| < 0.9.
 */

enum { MAX_CELLS = 12000000, LEVELS = 2048, MAPS = 2, LONGEST_STRIDE = 4 };

typedef struct maps {
    const ovr_view_run *view;
    size_t first, stride, columns, rows, every, shots;
    double *values; /* of a snapshot in the file */
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
                       (double)m->view->shots;
        m->every = 1;
        if (cells <= MAX_CELLS)
            break;
        if (m->stride == LONGEST_STRIDE) {
            m->every = (size_t)ceil(cells / MAX_CELLS);
            break;
        }
    }
    m->shots = (m->view->shots - 1) / m->every + 1;
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

/* Levels from the smallest value, or zero, to the largest that counts. */
static ovr_status find_levels(const maps *m, int f, ovr_levels *levels,
                              ovr_error *err)
{
    double low = f ? INFINITY : 0, high = -INFINITY;
    for (size_t k = 0; k < m->shots; k++) {
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

static ovr_status put_map(const maps *m, int f, ovr_error *err)
{
    const ovr_view_run *w = m->view;
    size_t cells = m->columns * m->rows;
    uint16_t *level = ovr_arena_take(w->arena, cells * m->shots, sizeof *level,
                                     err);
    ovr_levels l;
    if (!level)
        return OVR_NO_MEMORY;
    ovr_status status = find_levels(m, f, &l, err);
    for (size_t k = 0; !status && k < m->shots; k++) {
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
    status = ovr_pack_levels(w->to, level, cells, m->shots, w->arena, err);
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
    if (!m.values || !x || !y)
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
                   m.columns, m.rows, m.every, m.shots, run->info->width,
                   shown);
    ovr_text_doubles(view->to, "x", x, m.columns);
    ovr_text_doubles(view->to, "y", y, m.rows);
    for (int f = 0; !status && f < MAPS; f++)
        status = put_map(&m, f, err);
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

/* Panels and curves of an element's figure, as pictures_page.js draws them. */

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

/* ----------------------------------------------------------------- Material */

/*
 * Plastic strain and residual stress at the end of a run, for the page: values
 * at places in the material and at depths that grow geometrically from the
 * first layer, and where the material is at each snapshot.
 */

enum { ROWS = 40, MATERIAL_COLUMNS = 400 };

typedef struct material {
    ovr_material_group in;
    int surface;
    size_t columns;
    double *cell, depth[ROWS];
} material;

static const struct {
    const char *array, *name;
    bool pure; /* a number without a unit */
} material_maps[] = {{"cumulative", "plastic strain", true},
                     {"residual_x", "residual stress along x", false},
                     {"residual_z", "residual stress along z", false},
                     {"residual_xz", "residual shear stress", false}};

static bool find_group(material *m)
{
    for (m->surface = 1; m->surface <= 2; m->surface++)
        if (ovr_material_find(&m->in, "plastic", m->surface, "cumulative") &&
            m->in.depths > 1)
            return true;
    return false;
}

/* X of the reference, the centre of the surface's first feature. */
static bool find_places(const material *m, size_t shots, size_t every,
                        double *at)
{
    ovr_case *c = NULL;
    ovr_setup *setup = ovr_stored_setup(m->in.run, &c, NULL);
    bool made = setup && !ovr_setup_prepare(setup, NULL, NULL);
    size_t n = made ? ovr_surfaces_count(setup->surfaces) : 0;
    size_t k = 0;
    while (k < n && ovr_surfaces_info(setup->surfaces, k).surface != m->surface)
        k++;
    for (size_t shot = 0; k < n && shot < shots; shot++)
        at[shot] = ovr_surfaces_centre(setup->surfaces, k,
                                       m->in.run->times[shot * every]);
    ovr_setup_free(setup);
    ovr_case_free(c);
    return k < n;
}

/* Values of the layer and of the point that a cell lies in. */
static ovr_status put_material_map(ovr_text *to, const material *m, size_t map,
                                   ovr_error *err)
{
    const ovr_material_group *in = &m->in;
    const double *v = ovr_material_read(in, material_maps[map].array,
                                        in->depths, in->points, err);
    double low = 0, high = 0;
    if (!v)
        return OVR_BAD_INPUT;
    for (size_t r = 0, j = 0; r < ROWS; r++) {
        while (j + 1 < in->depths &&
               sqrt(in->z[j] * in->z[j + 1]) < m->depth[r])
            j++;
        for (size_t c = 0; c < m->columns; c++) {
            size_t i = c * (in->points - 1) / (m->columns - 1);
            double value = v[j * in->points + i];
            m->cell[r * m->columns + c] = value;
            low = fmin(low, value);
            high = fmax(high, value);
        }
    }
    ovr_text_put(to, map ? ",{" : "{");
    ovr_text_doubles(to, "data", m->cell, ROWS * m->columns);
    ovr_text_print(to,
                   "\"name\":\"%s\",\"pure\":%d,\"low\":%.17g,\"high\":%.17g}",
                   material_maps[map].name, material_maps[map].pure, low,
                   high > low ? high : low + 1);
    return OVR_OK;
}

ovr_status ovr_view_material(const ovr_view_run *view, ovr_error *err)
{
    ovr_text *to = view->to;
    ovr_arena *arena = view->arena;
    const size_t shots = view->shots;
    material m = {.in = {.run = view->run, .arena = arena}};
    const ovr_material_group *in = &m.in;
    double *at = ovr_arena_take(arena, shots, sizeof *at, err);
    if (!at)
        return OVR_NO_MEMORY;
    if (!find_group(&m) || !find_places(&m, shots, view->every, at))
        return OVR_OK;
    m.columns = in->points > MATERIAL_COLUMNS ? MATERIAL_COLUMNS : in->points;
    m.cell = ovr_arena_take(arena, ROWS * m.columns, sizeof *m.cell, err);
    if (!m.cell || ovr_material_axes(&m.in, err))
        return OVR_BAD_INPUT;
    for (int r = 0; r < ROWS; r++)
        m.depth[r] = in->z[0] * pow(in->z[in->depths - 1] / in->z[0],
                                    (double)r / (ROWS - 1));
    ovr_text_print(to,
                   "\"material\":{\"columns\":%zu,\"rows\":%d,\"x0\":%.17g,"
                   "\"x1\":%.17g,",
                   m.columns, ROWS, in->xi[0], in->xi[in->points - 1]);
    ovr_text_doubles(to, "z", m.depth, ROWS);
    ovr_text_doubles(to, "place", at, shots);
    ovr_text_put(to, "\"fields\":[");
    ovr_status status = OVR_OK;
    for (size_t map = 0;
         !status && map < sizeof material_maps / sizeof *material_maps; map++)
        status = put_material_map(to, &m, map, err);
    ovr_text_put(to, "]},");
    return status;
}

/* ----------------------------------------------------------------- Stresses */

/*
 * The stresses below each snapshot, for the page: values at columns along x and
 * at depths that grow geometrically from D, with the scale of the whole run,
 * the largest value of a smooth contact, and where the largest of each is.
 */

enum { MAX_COLUMNS = 180, MIN_COLUMNS = 60 };
enum { MAX_VALUES = 2000000, STEPS = 1000 };

static const double DEEPEST = 2.5;

typedef struct sheet {
    ovr_depth_field field;
    size_t columns, shots, every;
    double *worst, z[ROWS];
    uint16_t *level;
    ovr_levels levels;
} sheet;

static ovr_status prepare(sheet *s, ovr_arena *arena, ovr_error *err)
{
    size_t maximum = MAX_VALUES / ROWS / s->shots;
    s->columns = maximum > MAX_COLUMNS   ? MAX_COLUMNS
                 : maximum < MIN_COLUMNS ? MIN_COLUMNS
                                         : maximum;
    for (int r = 0; r < ROWS; r++)
        s->z[r] = s->field.mesh *
                  pow(DEEPEST / s->field.mesh, (double)r / (ROWS - 1));
    /* levels fine beside the colours, and far beyond them */
    s->levels = ovr_levels_even(0, 1);
    s->levels.step = s->field.high / STEPS;
    s->levels.from = -s->levels.step * OVR_PACKED_LEVELS / 2;
    s->worst = ovr_arena_take(arena, 3 * s->shots, sizeof *s->worst, err);
    s->level = ovr_arena_take(arena, ROWS * s->columns * s->shots,
                              sizeof *s->level, err);
    return s->worst && s->level ? OVR_OK : OVR_NO_MEMORY;
}

static ovr_status fill(sheet *s, size_t shot, ovr_error *err)
{
    ovr_depth_field *f = &s->field;
    uint16_t *level = s->level + shot * ROWS * s->columns;
    double *worst = s->worst + 3 * shot;
    if (ovr_depth_field_solve(f, shot * s->every, err))
        return OVR_BAD_INPUT;
    worst[0] = f->worst.X, worst[1] = f->worst.Z, worst[2] = f->worst.value;
    for (size_t r = 0; r < ROWS; r++)
        for (size_t c = 0; c < s->columns; c++) {
            double part = (double)c / (double)(s->columns - 1);
            double X = f->x_from + part * (f->x_to - f->x_from);
            double v = ovr_depth_field_at(f, X, s->z[r]);
            level[r * s->columns + c] = ovr_level_of(&s->levels, v);
        }
    return OVR_OK;
}

/* The remedy of each snapshot whose largest stress the mesh does not resolve,
 * or "". */
static void put_unresolved(ovr_text *to, const sheet *s)
{
    const ovr_stored *run = s->field.run;
    if (!run->unresolved)
        return;
    ovr_text_put(to, "\"unresolved\":[");
    for (size_t k = 0; k < s->shots; k++) {
        const char *remedy = ovr_stored_unresolved(
            run, (ptrdiff_t)(k * s->every), s->worst[3 * k + 1]);
        ovr_text_print(to, "%s\"%s\"", k ? "," : "", remedy ? remedy : "");
    }
    ovr_text_put(to, "],");
}

/* Depths of the interfaces, where the body has layers. */
static void put_layers(ovr_text *to, const ovr_layered *body)
{
    double bottom[OVR_LAYERS_MAX];
    for (int j = 0; j < body->layers; j++)
        bottom[j] = ovr_layered_bottom(body, j);
    if (body->layers)
        ovr_text_doubles(to, "layers", bottom, (size_t)body->layers);
}

static ovr_status put(ovr_text *to, const sheet *s, ovr_arena *arena,
                      ovr_error *err)
{
    const ovr_depth_field *f = &s->field;
    bool both = f->which == OVR_STRESS_TAU_XZ;
    bool pressed = ovr_depth_field_is_pressed(f);
    ovr_status status;
    ovr_text_print(to,
                   "\"stress\":{\"name\":\"%s\",\"columns\":%zu,\"rows\":%d,"
                   "\"x0\":%.17g,\"x1\":%.17g,\"low\":%.17g,\"high\":%.17g,"
                   "\"smooth\":%.17g,\"least\":%.17g,",
                   f->name, s->columns, ROWS, f->x_from, f->x_to,
                   both || pressed ? -f->high : 0, pressed ? 0 : f->high,
                   f->smooth, f->minimum);
    ovr_text_doubles(to, "z", s->z, ROWS);
    ovr_text_doubles(to, "worst", s->worst, 3 * s->shots);
    put_layers(to, &f->coated.body);
    put_unresolved(to, s);
    ovr_text_print(to,
                   "\"levels\":%d,\"from\":%.17g,\"step\":%.17g,\"bend\":0,"
                   "\"data\":\"",
                   OVR_PACKED_LEVELS, s->levels.from, s->levels.step);
    status = ovr_pack_levels(to, s->level, ROWS * s->columns, s->shots, arena,
                             err);
    ovr_text_put(to, "\"},");
    return status;
}

ovr_status ovr_view_stress(const ovr_view_run *view, ovr_error *err)
{
    sheet s = {.shots = view->shots, .every = view->every};
    const ovr_depth_look look = {view->stress, false, 1, -1.8, 1.5};
    ovr_status status = ovr_depth_field_make(&s.field, view->run, &look,
                                             view->arena, err);
    if (!status)
        status = prepare(&s, view->arena, err);
    for (size_t k = 0; !status && k < s.shots; k++)
        status = fill(&s, k, err);
    if (!status)
        status = put(view->to, &s, view->arena, err);
    ovr_depth_field_free(&s.field);
    return status;
}
