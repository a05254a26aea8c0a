/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * What writes a chart's script: its data as tables, the terminal and the style
 * that all charts have.
 */
#ifndef OVR_PICTURES_PEN_H
#define OVR_PICTURES_PEN_H

#include "pictures/chart.h"

typedef struct ovr_pen {
    const ovr_chart *chart;
    ovr_form form;
    ovr_text *to, *data;
    bool apart;         /* the data; else in the script */
    const char *digits; /* of the data */
    double em;          /* letter height, pixels */
    size_t tables;
} ovr_pen;

/* Terminal and style. */
void ovr_pen_begin(ovr_pen *pen);

/* The tables of a panel: one for each series, and one for an image. */
void ovr_pen_data(ovr_pen *pen, const ovr_panel *panel);

/* How the script names a table. */
void ovr_pen_source(ovr_pen *pen, size_t table);

#endif
