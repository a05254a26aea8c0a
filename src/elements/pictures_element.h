/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A gear pair, cam or bearing drawn to scale, and its operating conditions, for
 * pictures and for the page. */
#ifndef OVR_ELEMENTS_PICTURES_ELEMENT_H
#define OVR_ELEMENTS_PICTURES_ELEMENT_H

#include "elements/elements.h"
#include "overroll/case.h"
#include "pictures/picture.h"

enum { OVR_ELEMENT_PANELS = 5 };

/* The first panel is the drawing in mm. The others show operating conditions
 * along one axis: time (gears), angle (cams) or position (bearings). */
typedef struct ovr_element_figure {
    ovr_panel panel[OVR_ELEMENT_PANELS];
    size_t panels;
    const char *title;
    /* Position of the contact in the drawing as a function of the axis; points
     * 0: it does not move. */
    size_t points;
    const double *at, *x, *y;
    double unit, begin; /* scale and origin of the axis: unit times a time in s,
                         * and begin */
} ovr_element_figure;

/* Draws the machine element of a setup; OVR_BAD_INPUT without one. Includes the
 * film thickness of a run, unless NULL. */
ovr_status ovr_element_draw(const ovr_setup *setup, const ovr_stored *run,
                            ovr_arena *arena, ovr_element_figure *figure,
                            ovr_error *err);

/* Returns the figure as a chart, which uses the data of both arguments. */
ovr_chart ovr_element_chart(const ovr_element_figure *figure,
                            const ovr_picture_options *options);

ovr_status ovr_draw_element(const ovr_drawing *drawing, ovr_chart *chart,
                            ovr_error *err);

/* ---------------------------------------------------------------- outlines */

/* Polyline for appending: x and y in m; NAN interrupts it. */
typedef struct ovr_outline {
    ovr_arena *arena;
    double *x, *y;
    size_t n, capacity;
    bool failed;
} ovr_outline;

ovr_outline ovr_outline_make(ovr_arena *arena);
void ovr_outline_add(ovr_outline *to, double x, double y);
void ovr_outline_break(ovr_outline *to);

/* Appends an arc about a centre; angles are measured from +x. */
void ovr_outline_arc(ovr_outline *to, double x, double y, double radius,
                     double from, double till);

/* Appends teeth of gear 1 or 2 near the contact at the position R1 on the path
 * of contact. The pitch point is at 0, 0 and the line of centres is vertical;
 * gear 1 is below and moves to +x. */
void ovr_outline_teeth(ovr_outline *to, const ovr_gear_form *form,
                       const ovr_gear_geometry *g, int gear, double R1);

/* Computes the position of the contact at R1 on the path of contact. */
void ovr_gear_place(const ovr_gear_form *form, const ovr_gear_geometry *g,
                    double R1, double *x, double *y);

/* Computes the contact of a cam at an angle and the direction of the follower's
 * motion there, in a frame that rotates with the cam. */
void ovr_cam_place(const ovr_cam *cam, const ovr_cam_form *form, double angle,
                   double *x, double *y);

#endif
