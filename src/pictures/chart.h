/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A chart: panels in rows and columns, curves in panels.  gnuplot draws it by
 * a template, from its settings and its tables.
 *
 * Axis labels use gnuplot's enhanced text ("p_h"). Titles, notes and legends
 * may come from files and are drawn unchanged.
 */
#ifndef OVR_PICTURES_CHART_H
#define OVR_PICTURES_CHART_H

#include "overroll/results.h"
#include "pictures/growing_text.h"

/* An axis in Hertzian units, or in a unit whose prefix suits the numbers. */

typedef struct ovr_axis {
    double factor;     /* from Hertzian to drawn numbers */
    const char *label; /* in gnuplot's enhanced text: "time, {/:Italic t}
                        * (s)" */
    const char *plain; /* the same without markup: "time, t (s)" */
    const char *unit;  /* "mm"; "" for Hertzian units */
} ovr_axis;

/* True for kinds with a symbol: length, pressure, height and time. */
bool ovr_axis_has(ovr_unit_kind kind);

/* Makes the axis of such a kind. `largest` is the largest Hertzian number to be
 * shown. */
ovr_status ovr_axis_make(ovr_unit_kind kind, ovr_result *result,
                         ovr_units units, double largest, ovr_axis *axis,
                         ovr_error *err);

/* Returns the largest magnitude of n numbers, ignoring NAN. */
double ovr_axis_reach(const double *values, size_t n);

/* Makes the axis of numbers in SI or without unit, which are drawn
 * unchanged. */
void ovr_axis_as_is(ovr_unit_kind kind, bool si, double largest,
                    ovr_axis *axis);

typedef enum ovr_mark {
    OVR_MARK_LINE,
    OVR_MARK_DASHED,
    OVR_MARK_DOTTED,
    OVR_MARK_POINTS,
    OVR_MARK_CROSS,
    OVR_MARK_BAND, /* no line: a light area from y to `to` */
    OVR_MARK_AREA  /* a line with a light area down to `base` */
} ovr_mark;

/* Names of the marks in templates and pages: "line". */
extern const char *const ovr_mark_names[];

enum {
    OVR_BLUE,
    OVR_AMBER,
    OVR_STEEL,
    OVR_RED,
    OVR_GREEN,
    OVR_VIOLET,
    OVR_GREY,
    OVR_WHITE, /* for images */
    OVR_INK
};

typedef struct ovr_series {
    const char *label; /* in the legend, unescaped; NULL: not in the legend */
    size_t n;
    const double *x, *y;     /* NAN interrupts the line */
    const double *to;        /* other edge of a band */
    double x_factor, factor; /* factors of x and y; 0 means 1 */
    double shift;            /* added to y after multiplication */
    ovr_mark mark;
    int colour;
    double base;         /* lower edge of an area, in drawn units */
    double width;        /* line width; 0: 2 */
    const char *letters; /* a word next to each point: "A B C"; NULL: none */
} ovr_series;

/* Colours of a uniform grid of nx by ny cells, row by row. */
typedef struct ovr_image {
    size_t nx, ny;
    const double *values; /* NULL: no image */
    double from, to;      /* range of the colours */
    bool above;           /* some values are above `to`; marked in the colour
                           * bar */
    const char *label;
    /* Contour lines at these values, "0.1 0.2": thin white and dark ones. */
    const char *contours, *bold_contours;
} ovr_image;

typedef struct ovr_panel {
    const char *note; /* text above the panel; may be unescaped */
    const char *x_label, *y_label;
    double x_from, x_to, y_from, y_to; /* NAN: from the data */
    bool log_x, log_y;
    double height; /* relative to the other rows (from the first column); 0:
                    * 1 */
    size_t count;
    ovr_series *series;
    ovr_image image;
    bool ground; /* a thin line at y = 0, with numbers only above it. A bar of
                  * round length below it is the scale of curves there */
    const char *bar_unit; /* unit of the length of the bar */
    bool equal; /* equal scales of both axes, and its own x axis: a drawing */
} ovr_panel;

typedef struct ovr_chart {
    const char *kind;     /* for templates: "snapshot" */
    const char *title;    /* at the top left; unescaped */
    const char *subtitle; /* at the top right; enhanced text */
    int width, height;    /* pixels */
    size_t rows, columns;
    bool share_x, share_y;  /* numbers at outer panels only */
    const ovr_panel *panel; /* row by row */
} ovr_chart;

/* Returns a panel whose ranges are chosen from its data. */
ovr_panel ovr_panel_make(const char *x_label, const char *y_label);

/* Adds a curve. If memory is insufficient, the curve is missing and
 * `arena->starved` is set, which drawing reports. */
void ovr_panel_add(ovr_panel *panel, ovr_arena *arena, ovr_series series);

/* Adds the line from (x0, y0) to (x1, y1) in the style of `look`; only its
 * first point if look.n = 1. */
void ovr_panel_line(ovr_panel *panel, ovr_arena *arena, double x0, double x1,
                    double y0, double y1, ovr_series look);

/* Return x and y of point i as drawn. */
double ovr_series_x(const ovr_series *series, size_t i);
double ovr_series_y(const ovr_series *series, size_t i);

typedef enum ovr_form {
    OVR_FORM_PNG,
    OVR_FORM_SVG,
    OVR_FORM_PDF,
    OVR_FORMS
} ovr_form;

/* Names of the file formats, which are also suffixes: "png". */
extern const char *const ovr_form_names[];

/* Determines the format from a path's suffix. */
ovr_status ovr_form_of(const char *path, ovr_form *form, ovr_error *err);

/* Appends the settings read by the template: everything except the numbers. */
void ovr_chart_settings(const ovr_chart *chart, ovr_form form, ovr_text *to);

/* Appends the numbers, each written with the format `digits` ("%.6g"): a table
 * for each curve, then one for each image, separated by two blank lines. */
void ovr_chart_tables(const ovr_chart *chart, const char *digits, ovr_text *to);

#endif
