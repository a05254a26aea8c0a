/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One picture: read, chart, gnuplot. */
#include "pictures/picture.h"
#include "base/sized.h"

#include <errno.h>
#include <math.h>
#include <string.h>
#include <unistd.h>

#include "base/plain.h"
#include "pictures/gnuplot.h"

void ovr_picture_options_fill(ovr_picture_options *options)
{
    const ovr_picture_options defaults = {.x_from = NAN,
                                          .x_to = NAN,
                                          .P_to = NAN,
                                          .H_to = NAN,
                                          .T_from = NAN,
                                          .T_to = NAN};
    ovr_sized_fill(options, &defaults, sizeof defaults);
}

ovr_status ovr_may_create(const char *path, bool force, ovr_error *err)
{
    if (!force && access(path, F_OK) == 0)
        return ovr_fail(err, OVR_BAD_INPUT, "%s exists; --force replaces it",
                        path);
    return OVR_OK;
}

/* ------------------------------------------------------- script and data */

/* SCRIPT without its suffix, and another one. */
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

/* The script draws, in its own folder, a picture of the same name. */
static ovr_status write_script(const ovr_chart *chart, const char *path,
                               const char *script, ovr_arena *arena,
                               ovr_error *err)
{
    ovr_text text = ovr_text_make(arena), data = ovr_text_make(arena);
    ovr_text output = ovr_text_make(arena), input = ovr_text_make(arena);
    ovr_text all = ovr_text_make(arena);
    char *data_path = beside(script, ".dat", arena, err);
    ovr_form form;
    ovr_status status = data_path ? ovr_form_of(path, &form, err)
                                  : OVR_NO_MEMORY;
    if (status == OVR_OK)
        status = ovr_gnuplot_path(&output, base_name(path), err);
    if (status == OVR_OK)
        status = ovr_gnuplot_path(&input, base_name(data_path), err);
    if (status != OVR_OK)
        return status;
    ovr_chart_split(chart, form, &text, &data);
    ovr_text_put(&all, "# Drawn by overroll; to draw it again: gnuplot THIS\n");
    ovr_text_print(&all, "data = %.*s\nset output %.*s\n", (int)input.length,
                   input.data, (int)output.length, output.data);
    ovr_text_add(&all, text.data, text.length);
    status = ovr_text_status(&text, err);
    if (status == OVR_OK)
        status = ovr_text_save(&data, data_path, err);
    if (status == OVR_OK)
        status = ovr_text_save(&all, script, err);
    return status;
}

ovr_status ovr_chart_write(const ovr_chart *chart, const char *path,
                           const char *script, const ovr_allocator *allocator,
                           ovr_error *err)
{
    ovr_arena arena = ovr_arena_make(allocator);
    ovr_status status = write_script(chart, path, script, &arena, err);
    ovr_arena_release(&arena);
    return status;
}

ovr_status ovr_chart_draw(const ovr_chart *chart, const char *path,
                          const char *script, ovr_arena *arena, ovr_error *err)
{
    ovr_text text = ovr_text_make(arena);
    ovr_gnuplot *gnuplot = ovr_arena_take(arena, 1, sizeof *gnuplot, err);
    ovr_form form;
    ovr_status status = gnuplot ? ovr_form_of(path, &form, err) : OVR_NO_MEMORY;
    if (status == OVR_OK && script)
        status = write_script(chart, path, script, arena, err);
    if (status == OVR_OK) {
        ovr_chart_script(chart, form, &text);
        status = ovr_text_status(&text, err);
    }
    if (status == OVR_OK)
        status = ovr_gnuplot_start(gnuplot, err);
    if (status != OVR_OK)
        return status;
    status = ovr_gnuplot_ask(gnuplot, &text, path, err);
    if (status == OVR_OK)
        status = ovr_gnuplot_wait(gnuplot, err);
    ovr_gnuplot_stop(gnuplot);
    return status;
}

/* ---------------------------------------------------------------- picture */

typedef ovr_status draw_kind(const ovr_drawing *drawing, ovr_chart *chart,
                             ovr_error *err);

static ovr_status draw(const ovr_drawing *drawing, ovr_error *err)
{
    static draw_kind *const kinds[] = {
        [OVR_PICTURE_SNAPSHOT] = ovr_draw_snapshots,
        [OVR_PICTURE_HISTORY] = ovr_draw_history,
        [OVR_PICTURE_MAP] = ovr_draw_map,
        [OVR_PICTURE_TRACE] = ovr_draw_trace,
        [OVR_PICTURE_STRESS] = ovr_draw_stress,
        [OVR_PICTURE_RISK] = ovr_draw_risk,
        [OVR_PICTURE_DEPTH] = ovr_draw_depth};
    const ovr_picture_options *o = drawing->options;
    ovr_chart chart;
    ovr_status status = kinds[o->kind](drawing, &chart, err);
    if (status == OVR_OK)
        status = ovr_chart_draw(&chart, o->path, o->script, drawing->arena,
                                err);
    return status;
}

/* The others are made of the history, or of what the material went through. */
static bool of_snapshots(ovr_picture_kind kind)
{
    return kind != OVR_PICTURE_HISTORY && kind != OVR_PICTURE_RISK &&
           kind != OVR_PICTURE_DEPTH;
}

ovr_status ovr_open_stored(ovr_result *const *results, size_t count,
                           ovr_picture_options *o, ovr_stored *runs,
                           ovr_arena *arena, ovr_error *err)
{
    ovr_status status = OVR_OK;
    for (size_t k = 0; status == OVR_OK && k < count; k++)
        status = ovr_stored_make(&runs[k], results[k],
                                 o->names ? o->names[k] : NULL, arena, err);
    for (size_t k = 0; status == OVR_OK && k < count && of_snapshots(o->kind);
         k++)
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
    if (OVR_SIZED_TAKE(ovr_picture_options, o, options, err))
        return OVR_BAD_INPUT;
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
