/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A chart: panels in rows and columns, curves in panels.  gnuplot draws it by
 * a template, from its settings and its tables.
 *
 * Labels of axes are written by us, in gnuplot's enhanced text ("p_h");
 * titles, notes and legends may be anybody's, and are drawn as they are.
 */
#ifndef OVR_PICTURES_CHART_H
#define OVR_PICTURES_CHART_H

#include "overroll/results.h"
#include "pictures/growing_text.h"

/*
 * An axis is drawn in a Hertzian scale, or in a unit whose prefix suits the
 * numbers.
 */

typedef struct ovr_axis {
    double factor;     /* from the Hertzian number to the one drawn */
    const char *label; /* enhanced text of gnuplot: "time, {/:Italic t} (s)" */
    const char *plain; /* the same without markup: "time, t (s)" */
    const char *unit;  /* "mm"; "" when Hertzian */
} ovr_axis;

/* Kinds that have a symbol: length, pressure, height and time. */
bool ovr_axis_has(ovr_unit_kind kind);

/* Makes an axis of one of these.  `largest` is the largest Hertzian number that
 * the axis will show. */
ovr_status ovr_axis_make(ovr_unit_kind kind, ovr_result *result,
                         ovr_units units, double largest, ovr_axis *axis,
                         ovr_error *err);

/* The largest magnitude of n numbers, those that are NAN left out. */
double ovr_axis_reach(const double *values, size_t n);

/* The same for numbers in SI, or bare ones, as they are. */
void ovr_axis_as_is(ovr_unit_kind kind, bool si, double largest,
                    ovr_axis *axis);

typedef enum ovr_mark {
    OVR_MARK_LINE,
    OVR_MARK_DASHED,
    OVR_MARK_DOTTED,
    OVR_MARK_POINTS,
    OVR_MARK_CROSS,
    OVR_MARK_BAND, /* no line: the colour, faint, from y to `to` */
    OVR_MARK_AREA  /* a line with the colour, faint, down to `base` */
} ovr_mark;

/* Their names, as templates and pages have them: "line". */
extern const char *const ovr_mark_names[];

enum {
    OVR_BLUE,
    OVR_AMBER,
    OVR_STEEL,
    OVR_RED,
    OVR_GREEN,
    OVR_VIOLET,
    OVR_GREY,
    OVR_WHITE, /* on images */
    OVR_INK,
    OVR_COLOURS
};

typedef struct ovr_series {
    const char *label; /* in the legend, foreign; NULL: not there */
    size_t n;
    const double *x, *y;     /* NAN breaks the line */
    const double *to;        /* of a band: its other edge */
    double x_factor, factor; /* multiply x and y; 0 means 1 */
    double shift;            /* added to y after the factor */
    ovr_mark mark;
    int colour;
    double base;         /* of an area, as drawn */
    double width;        /* of the line; 0: 2 */
    const char *letters; /* a word beside each point: "A B C"; NULL: none */
} ovr_series;

/* Colours over an even grid of nx by ny cells, row by row. */
typedef struct ovr_image {
    size_t nx, ny;
    const double *values; /* NULL: no image */
    double from, to;      /* of the colours */
    bool above;           /* some values are above `to`, which is marked */
    const char *label;
    /* lines at these values, "0.1 0.2": thin white ones, dark ones */
    const char *contours, *bold_contours;
} ovr_image;

typedef struct ovr_panel {
    const char *note; /* above it; may be foreign */
    const char *x_label, *y_label;
    double x_from, x_to, y_from, y_to; /* NAN: from the data */
    bool log_x, log_y;
    double height; /* relative to the other rows (first column); 0: 1 */
    size_t count;
    ovr_series *series;
    ovr_image image;
    bool ground; /* a thin line at y = 0, and numbers only above it; below it,
                    where anything is, a bar of round length is the scale */
    const char *bar_unit; /* behind that length */
    bool equal; /* one scale for both axes, and an x of its own: a drawing */
} ovr_panel;

typedef struct ovr_chart {
    const char *kind;     /* for templates: "snapshot" */
    const char *title;    /* at the top left; foreign */
    const char *subtitle; /* at the top right; ours, enhanced */
    int width, height;    /* pixels */
    size_t rows, columns;
    bool share_x, share_y;  /* numbers at the outer panels only */
    const ovr_panel *panel; /* row by row */
} ovr_chart;

/* Returns a panel whose axes follow from its data. */
ovr_panel ovr_panel_make(const char *x_label, const char *y_label);

/* Adds a curve.  Without memory the curve is missing and `arena->starved` is
 * set, which drawing reports. */
void ovr_panel_add(ovr_panel *panel, ovr_arena *arena, ovr_series series);

/* Adds the line from (x0, y0) to (x1, y1) with the other members of `look`; its
 * first point alone where look.n = 1. */
void ovr_panel_line(ovr_panel *panel, ovr_arena *arena, double x0, double x1,
                    double y0, double y1, ovr_series look);

/* x and y of point i as they are drawn. */
double ovr_series_x(const ovr_series *series, size_t i);
double ovr_series_y(const ovr_series *series, size_t i);

typedef enum ovr_form {
    OVR_FORM_PNG,
    OVR_FORM_SVG,
    OVR_FORM_PDF,
    OVR_FORMS
} ovr_form;

/* Their names, which suffixes are too: "png". */
extern const char *const ovr_form_names[];

/* The form that a path's suffix names. */
ovr_status ovr_form_of(const char *path, ovr_form *form, ovr_error *err);

/* Appends what the template reads: all but the numbers. */
void ovr_chart_settings(const ovr_chart *chart, ovr_form form, ovr_text *to);

/* Appends the numbers, each written as `digits` says ("%.6g"): a table for each
 * curve, then one for each image, two blank lines between them. */
void ovr_chart_tables(const ovr_chart *chart, const char *digits, ovr_text *to);

#endif
