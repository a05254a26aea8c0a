/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Draws one picture: reads results, makes a chart, runs gnuplot. */
#include "pictures/picture.h"
#include "elements/pictures_element.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "base/given.h"
#include "base/text.h"
#include "pictures/gnuplot.h"
#include "pictures/page.h"

ovr_picture_options ovr_picture_options_default(void)
{
    const ovr_picture_options defaults = {.x_from = NAN,
                                          .x_to = NAN,
                                          .P_to = NAN,
                                          .H_to = NAN,
                                          .T_from = NAN,
                                          .T_to = NAN,
                                          .along = NAN};
    return defaults;
}

ovr_status ovr_may_create(const char *path, bool force, ovr_error *err)
{
    if (!path)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "the file name of the picture is missing");
    if (!force && access(path, F_OK) == 0)
        return ovr_fail(err, OVR_BAD_INPUT, "%s exists; --force replaces it",
                        path);
    return OVR_OK;
}

/* --------------------------------------------------------------- template */

/* Reads the user's template; its line "@chart@" is replaced by the built-in
 * one. */
static ovr_status read_template(FILE *file, const char *path, ovr_text *to,
                                ovr_error *err)
{
    char line[4096];
    while (fgets(line, sizeof line, file))
        if (strcmp(line, "@chart@\n") == 0)
            ovr_text_add(to, ovr_template_text, ovr_template_bytes);
        else
            ovr_text_put(to, line);
    if (ferror(file))
        return ovr_fail(err, OVR_IO, "%s: cannot be read: %s", path,
                        strerror(errno));
    return ovr_text_status(to, err);
}

ovr_status ovr_template_read(const char *path, ovr_text *to, ovr_error *err)
{
    if (!path) {
        ovr_text_add(to, ovr_template_text, ovr_template_bytes);
        return ovr_text_status(to, err);
    }
    FILE *file = fopen(path, "rb");
    if (!file)
        return ovr_fail(err, OVR_BAD_INPUT, "template %s: cannot be read: %s",
                        path, strerror(errno));
    ovr_status status = read_template(file, path, to, err);
    fclose(file);
    return status;
}

/* ------------------------------------------------------- script and data */

/* Returns the path of SCRIPT with another suffix. */
static char *beside(const char *script, const char *suffix, ovr_arena *arena,
                    ovr_error *err)
{
    const char *slash = strrchr(script, '/');
    const char *dot = strrchr(slash ? slash : script, '.');
    size_t stem = dot ? (size_t)(dot - script) : strlen(script);
    char *path = ovr_arena_take(arena, stem + strlen(suffix) + 1, 1, err);
    if (path) {
        memcpy(path, script, stem);
        memcpy(path + stem, suffix, strlen(suffix) + 1);
    }
    return path;
}

static const char *base_name(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash ? slash + 1 : path;
}

ovr_status ovr_chart_write(const ovr_chart *chart, const ovr_text *template,
                           const char *path, const char *script,
                           ovr_arena *arena, ovr_error *err)
{
    ovr_text all = ovr_text_make(arena), data = ovr_text_make(arena);
    char *data_path = beside(script, ".dat", arena, err);
    ovr_form form;
    ovr_status status = data_path ? ovr_form_of(path, &form, err)
                                  : OVR_NO_MEMORY;
    if (status)
        return status;
    ovr_text_put(&all, "# Drawn by overroll; to draw it again: gnuplot THIS\n"
                       "set output ");
    status = ovr_gnuplot_path(&all, base_name(path), err);
    ovr_text_put(&all, "\ndata = ");
    if (!status)
        status = ovr_gnuplot_path(&all, base_name(data_path), err);
    ovr_text_put(&all, "\n");
    ovr_chart_settings(chart, form, &all);
    ovr_text_put(&all, "\n# The template:\n");
    ovr_text_add(&all, template->data, template->length);
    ovr_chart_tables(chart, "%.17g", &data);
    if (!status)
        status = ovr_text_save(&data, data_path, err);
    return status ? status : ovr_text_save(&all, script, err);
}

void ovr_chart_script(const ovr_chart *chart, const ovr_text *template,
                      ovr_form form, ovr_text *to)
{
    ovr_text_put(to, "$data << EOD\n");
    ovr_chart_tables(chart, "%.6g", to);
    ovr_text_put(to, "EOD\ndata = '$data'\n");
    ovr_chart_settings(chart, form, to);
    ovr_text_add(to, template->data, template->length);
}

ovr_status ovr_chart_draw(const ovr_chart *chart, const ovr_drawn_to *to,
                          ovr_arena *arena, ovr_error *err)
{
    ovr_text text = ovr_text_make(arena), template = ovr_text_make(arena);
    ovr_gnuplot *gnuplot = ovr_arena_take(arena, 1, sizeof *gnuplot, err);
    ovr_form form;
    ovr_status status = arena->starved
                            ? ovr_fail(err, OVR_NO_MEMORY, "out of memory")
                            : ovr_form_of(to->path, &form, err);
    if (!status)
        status = ovr_template_read(to->template_path, &template, err);
    if (!status && to->script)
        status = ovr_chart_write(chart, &template, to->path, to->script, arena,
                                 err);
    if (!status) {
        ovr_chart_script(chart, &template, form, &text);
        status = ovr_text_status(&text, err);
    }
    if (!status)
        status = ovr_gnuplot_start(gnuplot, err);
    if (status)
        return status;
    status = ovr_gnuplot_ask(gnuplot, &text, to->path, err);
    if (!status)
        status = ovr_gnuplot_wait(gnuplot, err);
    ovr_gnuplot_stop(gnuplot);
    return status;
}

/* ---------------------------------------------------------------- picture */

/* A kind of picture: functions that draw one or several results, and its
 * default size. */
typedef struct maker {
    const char *name;
    ovr_status (*draw)(const ovr_drawing *drawing, ovr_chart *chart,
                       ovr_error *err);
    const char *alone; /* message if only one result can be drawn; or NULL */
    int height;
    bool snapshots; /* drawn from snapshots instead of the history or stress
                     * histories */
} maker;

static const maker makers[] = {
    [OVR_PICTURE_SNAPSHOT] = {"snapshot", ovr_draw_snapshots, NULL, 720, true},
    [OVR_PICTURE_HISTORY] = {"history", ovr_draw_history, NULL, 720, false},
    [OVR_PICTURE_MAP] = {"map", ovr_draw_map, "a map shows one result", 800,
                         true},
    [OVR_PICTURE_TRACE] = {"trace", ovr_draw_trace, NULL, 720, true},
    [OVR_PICTURE_STRESS] = {"stress", ovr_draw_stress,
                            "a picture of stresses shows one result", 960,
                            true},
    [OVR_PICTURE_RISK] = {"risk", ovr_draw_risk,
                          "a picture of risk shows one result", 960, false},
    [OVR_PICTURE_DEPTH] = {"depth", ovr_draw_depth,
                           "a picture against depth shows one result", 800,
                           false},
    [OVR_PICTURE_ELEMENT] = {"element", ovr_draw_element,
                             "a picture of a machine element shows one result",
                             0, false},
    [OVR_PICTURE_PLASTIC] = {"plastic", ovr_draw_plastic,
                             "a picture of plastic deformation shows one "
                             "result",
                             1000, false},
    [OVR_PICTURE_AREAL] = {"areal", ovr_draw_areal,
                           "maps across rolling show one result", 960, true}};

static ovr_status draw(const ovr_drawing *drawing, ovr_error *err)
{
    const ovr_picture_options *o = drawing->options;
    const maker *by = &makers[o->kind];
    const ovr_drawn_to target = {o->path, o->script, o->template_path};
    ovr_chart chart = {
        .title = ovr_stored_title(drawing->runs, drawing->count, o->title),
        .width = o->width > 0 ? o->width : 1280,
        .height = o->height > 0 ? o->height : by->height,
        .columns = 1,
        .share_x = true};
    if (by->alone && drawing->count > 1)
        return ovr_fail(err, OVR_BAD_INPUT, "%s only", by->alone);
    ovr_status status = by->draw(drawing, &chart, err);
    chart.kind = by->name;
    if (status == OVR_OK)
        status = ovr_chart_draw(&chart, &target, drawing->arena, err);
    return status;
}

ovr_status ovr_open_stored(ovr_result *const *results, size_t count,
                           ovr_picture_options *o, ovr_stored *runs,
                           ovr_arena *arena, ovr_error *err)
{
    ovr_status status = OVR_OK;
    for (size_t k = 0; status == OVR_OK && k < count; k++)
        status = ovr_stored_make(&runs[k], results[k],
                                 o->names ? o->names[k] : NULL, arena, err);
    for (size_t k = 0;
         status == OVR_OK && k < count && makers[o->kind].snapshots; k++)
        status = ovr_stored_need_snapshots(&runs[k], err);
    if (status == OVR_OK)
        status = ovr_common_units(runs, count, &o->units, err);
    if (status == OVR_OK)
        ovr_stored_relate(runs, count, o->units);
    return status;
}

ovr_status ovr_picture(ovr_result *const *results, size_t count,
                       const ovr_picture_options *options,
                       const ovr_allocator *allocator, ovr_error *err)
{
    ovr_picture_options own, *o = &own;
    if (OVR_TAKE(ovr_picture_options, o, options, err))
        return OVR_BAD_INPUT;
    if (!results)
        return ovr_fail_null(err, __func__);
    locale_t before = ovr_plain_begin();
    ovr_arena arena = ovr_arena_make(allocator);
    ovr_stored *runs = ovr_arena_take(&arena, count, sizeof *runs, err);
    ovr_drawing drawing = {o, runs, count, &arena};
    ovr_status status = runs ? ovr_may_create(o->path, o->force, err)
                             : OVR_NO_MEMORY;
    ovr_form form;
    if (status == OVR_OK)
        status = ovr_form_of(o->path, &form, err);
    if (status == OVR_OK)
        status = ovr_open_stored(results, count, o, runs, &arena, err);
    if (status == OVR_OK)
        status = draw(&drawing, err);
    ovr_arena_release(&arena);
    ovr_plain_end(before);
    return status;
}

ovr_status ovr_picture_element(const ovr_setup *setup,
                               const ovr_picture_options *given,
                               const ovr_allocator *allocator, ovr_error *err)
{
    ovr_picture_options own, *o = &own;
    if (OVR_TAKE(ovr_picture_options, o, given, err))
        return OVR_BAD_INPUT;
    if (!setup)
        return ovr_fail_null(err, __func__);
    locale_t before = ovr_plain_begin();
    ovr_arena arena = ovr_arena_make(allocator);
    ovr_element_figure figure;
    ovr_form form;
    ovr_status status = ovr_may_create(o->path, o->force, err);
    if (!status)
        status = ovr_form_of(o->path, &form, err);
    if (!status)
        status = ovr_element_draw(setup, NULL, &arena, &figure, err);
    if (!status) {
        const ovr_drawn_to target = {o->path, o->script, o->template_path};
        ovr_chart chart = ovr_element_chart(&figure, o);
        status = ovr_chart_draw(&chart, &target, &arena, err);
    }
    ovr_arena_release(&arena);
    ovr_plain_end(before);
    return status;
}

/* ----------------------------------------------------- pictures of tables */

bool ovr_table_same(const ovr_table_column *c, size_t i, size_t j)
{
    return c->text ? strcmp(c->text[i], c->text[j]) == 0
                   : c->number[i] == c->number[j];
}

const ovr_table_column *ovr_table_named(const ovr_table *t, const char *name)
{
    const ovr_table_column *c;
    for (size_t k = 0; (c = ovr_table_at(t, k)); k++) {
        const char *dot = strrchr(c->name, '.');
        if (!strcmp(c->name, name) || (dot && !strcmp(dot + 1, name)))
            break;
    }
    return c;
}

ovr_status ovr_figure_of(const void *of, const ovr_figure_options *given,
                         const ovr_allocator *allocator, ovr_figure_maker *how,
                         ovr_error *err)
{
    ovr_figure_options own;
    if (OVR_TAKE(ovr_figure_options, &own, given, err))
        return OVR_BAD_INPUT;
    locale_t before = ovr_plain_begin();
    ovr_arena arena = ovr_arena_make(allocator);
    ovr_form form;
    ovr_status status = ovr_may_create(own.path, own.force, err);
    if (!status)
        status = ovr_form_of(own.path, &form, err);
    if (!status)
        status = how(of, &own, &arena, err);
    ovr_arena_release(&arena);
    ovr_plain_end(before);
    return status;
}

ovr_status ovr_figure_draw(ovr_chart *chart, const ovr_figure_options *o,
                           ovr_arena *arena, ovr_error *err)
{
    const ovr_drawn_to target = {o->path, o->script, o->template_path};
    chart->title = o->title;
    if (o->width > 0)
        chart->width = o->width;
    if (o->height > 0)
        chart->height = o->height;
    return ovr_chart_draw(chart, &target, arena, err);
}
