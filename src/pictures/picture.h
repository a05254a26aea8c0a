/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The kinds of single pictures: each function makes a chart from runs, in an
 * arena, and passes it to a drawing function. */
#ifndef OVR_PICTURES_PICTURE_H
#define OVR_PICTURES_PICTURE_H

#include "overroll/pictures.h"
#include "pictures/chart.h"
#include "pictures/stored.h"

typedef struct ovr_drawing {
    const ovr_picture_options *options;
    const ovr_stored *runs;
    size_t count;
    ovr_arena *arena;
} ovr_drawing;

/* Opens the runs of results and stores their common units in `options`. */
ovr_status ovr_open_stored(ovr_result *const *results, size_t count,
                           ovr_picture_options *options, ovr_stored *runs,
                           ovr_arena *arena, ovr_error *err);

ovr_status ovr_draw_snapshots(const ovr_drawing *drawing, ovr_chart *chart,
                              ovr_error *err);
ovr_status ovr_draw_history(const ovr_drawing *drawing, ovr_chart *chart,
                            ovr_error *err);
ovr_status ovr_draw_trace(const ovr_drawing *drawing, ovr_chart *chart,
                          ovr_error *err);
ovr_status ovr_draw_stress(const ovr_drawing *drawing, ovr_chart *chart,
                           ovr_error *err);
ovr_status ovr_draw_risk(const ovr_drawing *drawing, ovr_chart *chart,
                         ovr_error *err);
ovr_status ovr_draw_depth(const ovr_drawing *drawing, ovr_chart *chart,
                          ovr_error *err);
ovr_status ovr_draw_plastic(const ovr_drawing *drawing, ovr_chart *chart,
                            ovr_error *err);
ovr_status ovr_draw_map(const ovr_drawing *drawing, ovr_chart *chart,
                        ovr_error *err);

ovr_status ovr_draw_areal(const ovr_drawing *drawing, ovr_chart *chart,
                          ovr_error *err);

/* Appends a user's template; NULL: the built-in one. */
ovr_status ovr_template_read(const char *path, ovr_text *to, ovr_error *err);

/* Output of a chart: a picture drawn with a template (NULL: built-in) and,
 * unless NULL, a script with its data. */
typedef struct ovr_drawn_to {
    const char *path, *script, *template_path;
} ovr_drawn_to;

ovr_status ovr_chart_draw(const ovr_chart *chart, const ovr_drawn_to *to,
                          ovr_arena *arena, ovr_error *err);

/* Appends the script that draws the chart, with its data. */
void ovr_chart_script(const ovr_chart *chart, const ovr_text *template,
                      ovr_form form, ovr_text *to);

/* Writes the script that draws the chart, with the name of `path` in its own
 * folder, and its data next to it. */
ovr_status ovr_chart_write(const ovr_chart *chart, const ovr_text *template,
                           const char *path, const char *script,
                           ovr_arena *arena, ovr_error *err);

/* Fails if the file exists, unless forced. */
ovr_status ovr_may_create(const char *path, bool force, ovr_error *err);

/* Draws a table or a study; `options` has default values. */
typedef ovr_status ovr_figure_maker(const void *of, const ovr_figure_options *o,
                                    ovr_arena *arena, ovr_error *err);
ovr_status ovr_figure_of(const void *of, const ovr_figure_options *given,
                         const ovr_allocator *allocator, ovr_figure_maker *how,
                         ovr_error *err);

/* Draws a chart; the options may set size and title. */
ovr_status ovr_figure_draw(ovr_chart *chart, const ovr_figure_options *options,
                           ovr_arena *arena, ovr_error *err);

/* True if two rows of a column are equal. */
bool ovr_table_same(const ovr_table_column *column, size_t i, size_t j);

/* Returns the column with this name, or with this part of a name after the
 * point; NULL if there is none. */
const ovr_table_column *ovr_table_named(const ovr_table *table,
                                        const char *name);

#endif
