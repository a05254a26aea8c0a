/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Panels are placed by hand, in units of the letter height, so that legends,
 * labels and numbers have the room they need at any size of the picture.
 * A legend stands above its panel, where no curve is.
 */
#include "pictures/chart.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "pictures/pen.h"

static const struct {
    const char *line, *area;
} colours[OVR_COLOURS] = {
    [OVR_BLUE] = {"#1d5fa8", "#dce8f5"},  [OVR_AMBER] = {"#c96a00", "#fbe3bd"},
    [OVR_STEEL] = {"#4a5560", "#b9c2ca"}, [OVR_RED] = {"#b3202a", "#f6dcdd"},
    [OVR_GREEN] = {"#2a7f4f", "#d8eee1"}, [OVR_VIOLET] = {"#6b4ba1", "#e7e0f2"},
    [OVR_GREY] = {"#8a929a", "#e6e9ec"},  [OVR_WHITE] = {"#ffffff", "#ffffff"},
    [OVR_INK] = {"#101418", "#101418"},
};

/* ----------------------------------------------------------------- panels */

/* Margins of the picture, in letter heights. */
static const double left_em = 5.2, right_em = 1.2, bottom_em = 3.4;

static double top_em(const ovr_chart *c)
{
    bool head = (c->title && *c->title) || (c->subtitle && *c->subtitle);
    return head ? 1.9 : 0.3;
}

typedef struct box {
    double left, right, bottom, top;
} box;

static double row_height(const ovr_chart *c, size_t row)
{
    double height = c->panel[row * c->columns].height;
    return height > 0 ? height : 1;
}

/* Characters of UTF-8 text, as many as are drawn. */
static double letters(const char *text)
{
    double count = 0;
    for (; *text && count < 60; text++)
        count += (*text & 0xc0) != 0x80;
    return count;
}

/* ---------------------------------------------------------------- legends */

static const double LEGEND_ROW = 1.3; /* letter heights */

static double entry_em(const ovr_series *s)
{
    return 3.2 + 0.53 * letters(s->label);
}

/* Letter heights from the left panel's edge to the picture's right one. */
static double legend_room(const ovr_pen *p)
{
    return p->chart->width / p->em - left_em - right_em;
}

static size_t legend_rows(const ovr_pen *p, const ovr_panel *panel)
{
    size_t rows = 0;
    double used = 0;
    for (size_t k = 0; k < panel->count; k++) {
        const ovr_series *s = &panel->series[k];
        double wide = s->label ? entry_em(s) : 0;
        if (!s->label)
            continue;
        if (!rows || used + wide > legend_room(p))
            used = 0, rows++;
        used += wide;
    }
    return rows;
}

/* Above a row's panels, of which the first has the legend. */
static double legend_em(const ovr_pen *p, size_t row)
{
    const ovr_chart *c = p->chart;
    size_t rows = legend_rows(p, &c->panel[row * c->columns]);
    return rows ? 1.7 + LEGEND_ROW * (double)(rows - 1) : 0.3;
}

static box place(const ovr_pen *p, size_t row, size_t column)
{
    const ovr_chart *c = p->chart;
    double em = p->em / c->width, em_y = p->em / c->height;
    double gap_x = (c->share_y ? 1.0 : left_em + 0.4) * em;
    double gap_y = (c->share_x ? 0.5 : bottom_em) * em_y;
    double legends = 0, down = 0, sum = 0, above = 0;
    double rows = (double)c->rows, columns = (double)c->columns;
    double width = (1 - (left_em + right_em) * em - (columns - 1) * gap_x) /
                   columns;
    double height;
    box b;
    for (size_t k = 0; k < c->rows; k++) {
        sum += row_height(c, k);
        above += k < row ? row_height(c, k) : 0;
        legends += legend_em(p, k) * em_y;
        down += k <= row ? legend_em(p, k) * em_y : 0;
    }
    height = 1 - (top_em(c) + bottom_em) * em_y - legends - (rows - 1) * gap_y;
    b.left = left_em * em + (double)column * (width + gap_x);
    b.right = b.left + width;
    b.top = 1 - top_em(c) * em_y - (double)row * gap_y - down -
            height * above / sum;
    b.bottom = b.top - height * row_height(c, row) / sum;
    return b;
}

static void put_range(ovr_pen *p, char axis, double from, double to, bool log)
{
    ovr_text_print(p->to, "set %crange [", axis);
    if (!isnan(from))
        ovr_text_print(p->to, "%.9g", from);
    else
        ovr_text_put(p->to, "*");
    ovr_text_put(p->to, ":");
    if (!isnan(to))
        ovr_text_print(p->to, "%.9g", to);
    else
        ovr_text_put(p->to, "*");
    ovr_text_print(p->to, "]\n%s logscale %c\n", log ? "set" : "unset", axis);
}

static void put_axes(ovr_pen *p, const ovr_panel *panel, size_t row,
                     size_t column)
{
    const ovr_chart *c = p->chart;
    bool low = !c->share_x || row + 1 == c->rows;
    bool first = !c->share_y || column == 0;
    put_range(p, 'x', panel->x_from, panel->x_to, panel->log_x);
    put_range(p, 'y', panel->y_from, panel->y_to, panel->log_y);
    ovr_text_print(p->to, "set xlabel \"%s\" offset 0,%g\n",
                   low ? panel->x_label : "",
                   p->form == OVR_FORM_SVG ? 0.8 : 0.3);
    ovr_text_print(p->to, "set ylabel \"%s\" offset 0.6,0\n",
                   first ? panel->y_label : "");
    ovr_text_print(p->to, "set format x \"%s\"\nset format y \"%s\"\n",
                   low ? "%g" : "", first ? "%g" : "");
}

static void put_label(ovr_pen *p, const char *text, const char *where)
{
    if (!text || !*text)
        return;
    ovr_text_put(p->to, "set label ");
    ovr_text_gnuplot(p->to, text);
    ovr_text_print(p->to, " noenhanced at %s textcolor rgb '#202830'\n", where);
}

static const char *dash_of(const ovr_series *s)
{
    return s->mark == OVR_MARK_DASHED   ? "'-'"
           : s->mark == OVR_MARK_DOTTED ? "'.'"
                                        : "solid";
}

static double width_of(const ovr_series *s)
{
    return s->width > 0 ? s->width : 2;
}

static void put_curve(ovr_pen *p, const ovr_series *s, size_t table)
{
    if (s->mark == OVR_MARK_BAND) {
        ovr_pen_source(p, table);
        ovr_text_print(p->to,
                       " using 1:2:3 with filledcurves fillstyle solid "
                       "fillcolor rgb '%s'",
                       colours[s->colour].area);
        return;
    }
    if (s->mark == OVR_MARK_AREA) {
        ovr_pen_source(p, table);
        ovr_text_print(p->to,
                       " using 1:2 with filledcurves y=%.9g fillstyle solid "
                       "fillcolor rgb '%s', \\\n  ",
                       s->base, colours[s->colour].area);
    }
    ovr_pen_source(p, table);
    if (s->mark == OVR_MARK_CROSS)
        ovr_text_print(p->to, " using 1:2 with points pt 2 ps 1.6 lw %.3g",
                       width_of(s));
    else if (s->mark == OVR_MARK_POINTS)
        ovr_text_print(p->to, " using 1:2 with points pt 7 ps %.3g",
                       width_of(s) / 3);
    else
        ovr_text_print(p->to, " using 1:2 with lines dt %s lw %.3g", dash_of(s),
                       width_of(s));
    ovr_text_print(p->to, " lc rgb '%s'", colours[s->colour].line);
}

/* Values above the last colour: an arrow on from its end. */
static void put_above(ovr_pen *p, const ovr_image *m, box where)
{
    double x = where.right + 1.6 * p->em / p->chart->width;
    char at[80];
    if (!m->above)
        return;
    snprintf(at, sizeof at, "screen %.5f,%.5f center", x,
             where.top + 0.8 * p->em / p->chart->height);
    put_label(p, "\342\226\262 above", at); /* a triangle */
}

static void put_colour_map(ovr_pen *p, const ovr_panel *panel, size_t table,
                           box where)
{
    const ovr_image *m = &panel->image;
    double dx = (panel->x_to - panel->x_from) / (double)m->nx;
    double dy = (panel->y_to - panel->y_from) / (double)m->ny;
    ovr_text_print(p->to,
                   "set palette defined (0 '#1b1044', 0.2 '#3b3a8c', 0.4 "
                   "'#2a7a98', 0.6 '#45a882', 0.8 '#c9cf52', 1 '#fff3b0')\n"
                   "set cbrange [%.9g:%.9g]\nset format cb \"%%g\"\n"
                   "set cblabel \"%s\" offset character 1.2,0\n"
                   "set colorbox user origin screen %.5g,%.5g size screen "
                   "%.5g,%.5g\nunset grid\n",
                   m->from, m->to, m->label,
                   where.right + 1.0 * p->em / p->chart->width, where.bottom,
                   1.2 * p->em / p->chart->width, where.top - where.bottom);
    put_above(p, m, where);
    ovr_text_put(p->to, "plot ");
    ovr_pen_source(p, table);
    ovr_text_print(p->to,
                   " matrix using (%.9g+%.9g*$1):(%.9g+%.9g*$2):3 with image",
                   panel->x_from + dx / 2, dx, panel->y_from + dy / 2, dy);
}

static void put_curves(ovr_pen *p, const ovr_panel *panel, size_t table,
                       bool image)
{
    if (!image && panel->count)
        ovr_text_put(p->to, "plot ");
    for (size_t k = 0; k < panel->count; k++) {
        if (k > 0 || image)
            ovr_text_put(p->to, ", \\\n  ");
        put_curve(p, &panel->series[k], table + k);
    }
    ovr_text_put(p->to, "\n");
}

/* 1, 2 or 5 times a power of ten, at most `most` of them in a span. */
static double nice_step(double span, double most)
{
    double least = span / most, power = pow(10, floor(log10(least)));
    double digit = least / power;
    return power * (digit <= 1 ? 1 : digit <= 2 ? 2 : digit <= 5 ? 5 : 10);
}

static void put_tics(ovr_pen *p, const ovr_panel *panel, box b)
{
    double span = panel->x_to - panel->x_from;
    double wide = (b.right - b.left) * p->chart->width / p->em;
    double high = (b.top - b.bottom) * p->chart->height / p->em;
    ovr_text_print(p->to, "set xtics autofreq offset 0,%g\n",
                   p->form == OVR_FORM_SVG ? 0.4 : 0.0);
    ovr_text_put(p->to, "set ytics autofreq\n");
    if (span > 0 && !panel->log_x)
        ovr_text_print(p->to, "set xtics %.9g\n",
                       nice_step(span, fmin(wide / 3.6, 9)));
    if (!panel->ground && !panel->log_y && panel->y_to > panel->y_from)
        ovr_text_print(
            p->to, "set ytics %.9g\n",
            nice_step(panel->y_to - panel->y_from, fmin(high / 1.6, 10)));
    if (!panel->ground)
        return;
    high *= panel->y_to / (panel->y_to - panel->y_from);
    ovr_text_print(p->to,
                   "set ytics 0,%.9g\n"
                   "set arrow from graph 0, first 0 to graph 1, first 0 "
                   "nohead lw 1 lc rgb '#606870' front\n",
                   nice_step(panel->y_to, fmin(high / 1.6, 10)));
}

/* gnuplot's own legend is no wider than its panel; this one is as wide as the
 * picture, in as many rows as it takes. */
static void put_legend(ovr_pen *p, const ovr_panel *panel, box b)
{
    double em = p->em / p->chart->width, row = p->em / p->chart->height;
    size_t rows = legend_rows(p, panel), at_row = 0;
    double used = 0;
    for (size_t k = 0; k < panel->count; k++) {
        const ovr_series *s = &panel->series[k];
        double x, y, wide = s->label ? entry_em(s) : 0;
        char at[80];
        if (!s->label)
            continue;
        if (used > 0 && used + wide > legend_room(p))
            used = 0, at_row++;
        x = b.left + (0.3 + used) * em;
        y = b.top + (0.75 + LEGEND_ROW * (double)(rows - 1 - at_row)) * row;
        ovr_text_print(p->to,
                       "set arrow from screen %.5f,%.5f to screen %.5f,%.5f "
                       "nohead dt %s lw %.3g lc rgb '%s'\n",
                       x, y, x + 1.5 * em, y, dash_of(s), width_of(s) + 0.5,
                       colours[s->colour].line);
        snprintf(at, sizeof at, "screen %.5f,%.5f left", x + 1.9 * em, y);
        put_label(p, s->label, at);
        used += wide;
    }
}

/* What stands below y = 0 has no numbers: a bar in their place. */
static void put_bar(ovr_pen *p, const ovr_panel *panel, box b)
{
    double span = -panel->y_from, length, x, low, high;
    double em_x = p->em / p->chart->width;
    double high_em = (b.top - b.bottom) * p->chart->height / p->em;
    char at[80], text[60];
    if (!panel->ground || !(span > 0) ||
        high_em * span / (panel->y_to + span) < 1.5)
        return;
    length = nice_step(0.6 * span, 1.2);
    x = b.left - 0.6 * em_x;
    low = b.bottom + 0.3 * p->em / p->chart->height;
    high = low + (b.top - b.bottom) * length / (panel->y_to + span);
    ovr_text_print(p->to,
                   "set arrow from screen %.5f,%.5f to screen %.5f,%.5f heads "
                   "size screen 0.003,90 lw 1.5 lc rgb '#202830' front\n",
                   x, low, x, high);
    snprintf(text, sizeof text, "%g%s%s", length,
             panel->bar_unit && *panel->bar_unit ? " " : "",
             panel->bar_unit ? panel->bar_unit : "");
    snprintf(at, sizeof at, "screen %.5f,%.5f right front", x - 0.5 * em_x,
             (low + high) / 2);
    put_label(p, text, at);
}

static void put_head(ovr_pen *p, box b)
{
    const ovr_chart *c = p->chart;
    double y = 1 - 1.0 * p->em / c->height;
    char at[80];
    snprintf(at, sizeof at, "screen %.5f,%.5f left", b.left, y);
    put_label(p, c->title, at);
    snprintf(at, sizeof at, "screen %.5f,%.5f right",
             1 - right_em * p->em / c->width, y);
    if (c->subtitle && *c->subtitle)
        ovr_text_print(p->to,
                       "set label \"%s\" at %s textcolor rgb '#202830'\n",
                       c->subtitle, at);
}

/* Panels above and below an image are as wide as it is. */
static bool has_image(const ovr_chart *c)
{
    for (size_t k = 0; k < c->rows * c->columns; k++)
        if (c->panel[k].image.values)
            return true;
    return false;
}

static void put_panel(ovr_pen *p, size_t row, size_t column, size_t table)
{
    const ovr_panel *panel = &p->chart->panel[row * p->chart->columns + column];
    box b = place(p, row, column);
    if (has_image(p->chart))
        b.right -= 5.5 * p->em / p->chart->width;
    ovr_text_print(p->to,
                   "\nset lmargin at screen %.5f\nset rmargin at screen %.5f\n"
                   "set bmargin at screen %.5f\nset tmargin at screen %.5f\n"
                   "unset label\nunset arrow\n",
                   b.left, b.right, b.bottom, b.top);
    put_axes(p, panel, row, column);
    put_tics(p, panel, b);
    if (row == 0 && column == 0)
        put_head(p, b);
    if (column == 0)
        put_legend(p, panel, b);
    put_label(p, panel->note, "graph 0.03,0.92 left front");
    if (column == 0)
        put_bar(p, panel, b);
    if (panel->image.values)
        put_colour_map(p, panel, table + panel->count, b);
    put_curves(p, panel, table, panel->image.values != NULL);
}

/* ----------------------------------------------------------------- charts */

static void put_chart(ovr_pen *p)
{
    const ovr_chart *c = p->chart;
    size_t table = 0;
    ovr_text_put(p->to, "set multiplot\n");
    for (size_t row = 0; row < c->rows; row++)
        for (size_t column = 0; column < c->columns; column++) {
            const ovr_panel *panel = &c->panel[row * c->columns + column];
            put_panel(p, row, column, table);
            table += panel->count + (panel->image.values != NULL);
        }
    ovr_text_put(p->to, "unset multiplot\n");
}

static void put_all_data(ovr_pen *p)
{
    for (size_t k = 0; k < p->chart->rows * p->chart->columns; k++)
        ovr_pen_data(p, &p->chart->panel[k]);
}

/* Letters grow with the picture, and stay readable in a small one. */
static double letter_height(const ovr_chart *chart)
{
    return 20 * fmax(chart->width / 1280.0, 0.62);
}

void ovr_chart_script(const ovr_chart *chart, ovr_form form, ovr_text *script)
{
    ovr_pen p = {
        chart, form, script, script, false, "%.6g", letter_height(chart), 0};
    ovr_pen_begin(&p);
    put_all_data(&p);
    put_chart(&p);
}

void ovr_chart_split(const ovr_chart *chart, ovr_form form, ovr_text *script,
                     ovr_text *data)
{
    ovr_pen p = {chart, form, script, data, true, "%.17g", letter_height(chart),
                 0};
    ovr_pen_begin(&p);
    put_all_data(&p);
    put_chart(&p);
}
