/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "pictures/pen.h"

#include <math.h>
#include <string.h>
#include <strings.h>

ovr_status ovr_form_of(const char *path, ovr_form *form, ovr_error *err)
{
    static const char *const suffix[] = {".png", ".svg", ".pdf"};
    size_t length = strlen(path);
    for (int k = 0; k < 3; k++)
        if (length > 4 && strcasecmp(path + length - 4, suffix[k]) == 0) {
            *form = (ovr_form)k;
            return OVR_OK;
        }
    return ovr_fail(err, OVR_BAD_INPUT,
                    "%s: a picture's name ends in .png, .svg or .pdf", path);
}

/* ------------------------------------------------------------------- data */

static double factor_of(double factor)
{
    return factor != 0 ? factor : 1;
}

/* Numbers that gnuplot reads as missing break a line. */
static void put_value(ovr_pen *p, double value)
{
    if (isfinite(value))
        ovr_text_print(p->data, p->digits, value);
    else
        ovr_text_put(p->data, "NaN");
}

static void put_series(ovr_pen *p, const ovr_series *s)
{
    for (size_t i = 0; i < s->n; i++) {
        put_value(p, s->x[i] * factor_of(s->x_factor));
        ovr_text_put(p->data, " ");
        put_value(p, s->y[i] * factor_of(s->factor) + s->shift);
        if (s->mark == OVR_MARK_BAND) {
            ovr_text_put(p->data, " ");
            put_value(p, s->to[i] * factor_of(s->factor) + s->shift);
        }
        ovr_text_put(p->data, "\n");
    }
}

static void put_image(ovr_pen *p, const ovr_image *image)
{
    for (size_t j = 0; j < image->ny; j++) {
        for (size_t i = 0; i < image->nx; i++) {
            put_value(p, image->values[j * image->nx + i]);
            ovr_text_put(p->data, " ");
        }
        ovr_text_put(p->data, "\n");
    }
}

void ovr_pen_data(ovr_pen *p, const ovr_panel *panel)
{
    size_t tables = panel->count + (panel->image.values != NULL);
    for (size_t k = 0; k < tables; k++) {
        const char *label = k < panel->count ? panel->series[k].label : NULL;
        if (p->apart)
            ovr_text_print(p->data, "%s# %s: %s, %s\n", p->tables ? "\n\n" : "",
                           label ? label : "-", panel->x_label, panel->y_label);
        else
            ovr_text_print(p->data, "$d%zu << EOD\n", p->tables);
        if (k < panel->count)
            put_series(p, &panel->series[k]);
        else
            put_image(p, &panel->image);
        if (!p->apart)
            ovr_text_put(p->data, "EOD\n");
        p->tables++;
    }
}

void ovr_pen_source(ovr_pen *p, size_t table)
{
    if (p->apart)
        ovr_text_print(p->to, "data index %zu", table);
    else
        ovr_text_print(p->to, "$d%zu", table);
}

/* ------------------------------------------------------------------ style */

static void put_terminal(ovr_pen *p)
{
    const ovr_chart *c = p->chart;
    double scale = p->em / 20;
    if (p->form == OVR_FORM_PNG)
        ovr_text_print(p->to,
                       "set terminal pngcairo size %d,%d enhanced font "
                       "'Sans,%.4g' linewidth %.3g background '#ffffff'\n",
                       c->width, c->height, 13 * scale, scale);
    else if (p->form == OVR_FORM_SVG)
        ovr_text_print(p->to,
                       "set terminal svg size %d,%d dynamic enhanced font "
                       "'Helvetica,Arial,sans-serif,%.4g' linewidth %.3g "
                       "background '#ffffff'\n",
                       c->width, c->height, 17 * scale, scale);
    else
        ovr_text_print(p->to,
                       "set terminal pdfcairo size %.4gin,%.4gin enhanced font "
                       "'Sans,%.4g' linewidth %.3g background '#ffffff'\n",
                       c->width / 160.0, c->height / 160.0, 9 * scale,
                       0.6 * scale);
}

static void put_style(ovr_pen *p)
{
    ovr_text_put(p->to,
                 "set encoding utf8\n"
                 "set border 3 lw 1 lc rgb '#606870'\n"
                 "set tics out nomirror scale 0.6 textcolor rgb '#303840'\n"
                 "set grid xtics ytics lt 1 lw 0.6 lc rgb '#e4e8ec'\n"
                 "unset key\n"
                 "set minussign\n"
                 "unset colorbox\n"
                 "unset title\n");
}

void ovr_pen_begin(ovr_pen *p)
{
    put_terminal(p);
    put_style(p);
}
