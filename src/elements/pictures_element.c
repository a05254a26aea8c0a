/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Draws a machine element to scale, and its operating conditions. */
#include "elements/pictures_element.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "case/case.h"
#include "case/setup.h"
#include "elements/elements.h"

enum { LOOKS = 800, NAME = 160 };

static const double pi = 3.14159265358979323846;

/* A figure that is being drawn. */
typedef struct sketch {
    const ovr_setup *setup;
    const ovr_stored *run; /* or NULL */
    ovr_arena *arena;
    ovr_element_figure *to;
    ovr_error *err;
    /* Sampled times: positions on the axis; values of four panels; positions of
     * the contact. */
    double *at, *value[4], *x, *y;
} sketch;

/* --------------------------------------------------------------- contents */

static void add(sketch *s, ovr_panel *panel, ovr_series series)
{
    ovr_panel_add(panel, s->arena, series);
}

static void add_outline(sketch *s, ovr_panel *panel, const ovr_outline *o,
                        ovr_series look)
{
    look.n = o->n;
    look.x = o->x;
    look.y = o->y;
    look.x_factor = look.factor = 1e3;
    add(s, panel, look);
}

static ovr_panel *drawing_panel(sketch *s)
{
    ovr_panel *panel = &s->to->panel[s->to->panels++];
    *panel = (ovr_panel){.x_label = "position, {/:Italic x} (mm)",
                         .y_label = "position, {/:Italic y} (mm)",
                         .equal = true,
                         .height = 2.6};
    return panel;
}

static ovr_panel *history_panel(sketch *s, const char *x_label,
                                const char *y_label, double from, double till)
{
    ovr_panel *panel = &s->to->panel[s->to->panels++];
    *panel = ovr_panel_make(x_label, y_label);
    panel->x_from = from;
    panel->x_to = till;
    return panel;
}

/* Sets the range of the panel's values, including 0, with a margin. */
static void set_range(ovr_panel *panel)
{
    double low = 0, high = 0;
    for (size_t k = 0; k < panel->count; k++)
        for (size_t i = 0; i < panel->series[k].n; i++) {
            double v = ovr_series_y(&panel->series[k], i);
            if (isfinite(v) && panel->series[k].mark != OVR_MARK_DOTTED) {
                low = fmin(low, v);
                high = fmax(high, v);
            }
        }
    double margin = 0.06 * (high - low);
    panel->y_from = low < 0 ? low - margin : 0;
    panel->y_to = high + margin;
}

/* Adds vertical dotted lines at marked positions. */
static void add_uprights(sketch *s, ovr_panel *panel, const double *at,
                         size_t n)
{
    ovr_outline o = ovr_outline_make(s->arena);
    for (size_t k = 0; k < n; k++) {
        ovr_outline_add(&o, at[k], panel->y_from);
        ovr_outline_add(&o, at[k], panel->y_to);
        ovr_outline_break(&o);
    }
    add(s, panel,
        (ovr_series){.n = o.n,
                     .x = o.x,
                     .y = o.y,
                     .mark = OVR_MARK_DOTTED,
                     .colour = OVR_GREY,
                     .width = 1.2});
}

/* Axis of the panels, with marks. */
typedef struct course {
    const char *axis;
    double from, till;
    const double *mark;
    size_t marks;
} course;

/* Adds minimum and central film thickness of the run; the axis is a multiple of
 * its time. */
static void add_film(sketch *s, const course *c)
{
    static const struct {
        const char *name, *label;
        int colour;
    } films[] = {
        {"central_film_thickness", "central film thickness", OVR_AMBER},
        {"min_film_thickness", "minimum film thickness", OVR_RED}};
    if (!s->run || s->run->info->steps == 0)
        return;
    ovr_panel *panel = history_panel(
        s, c->axis, "film thickness, {/:Italic h} (µm)", c->from, c->till);
    const ovr_result_info *info = s->run->info;
    double *T = ovr_stored_history(s->run, "time", 1, s->arena, s->err);
    if (!T)
        return;
    for (size_t k = 0; k < info->steps; k++)
        T[k] = s->to->begin + s->to->unit * T[k] * info->time;
    for (int k = 0; k < 2; k++) {
        double *H = ovr_stored_history(s->run, films[k].name, 1, s->arena,
                                       s->err);
        if (H)
            add(s, panel,
                (ovr_series){.label = films[k].label,
                             .n = info->steps,
                             .x = T,
                             .y = H,
                             .factor = 1e6 * info->height,
                             .colour = films[k].colour});
    }
    set_range(panel);
    add_uprights(s, panel, c->mark, c->marks);
}

/* Curves of a panel, at most two. */
typedef struct over_moments {
    const char *label[2]; /* NULL: a single curve */
    int colour[2];
} over_moments;

static void add_panel(sketch *s, const course *c, const char *y_label,
                      size_t first, const over_moments *curves)
{
    ovr_panel *panel = history_panel(s, c->axis, y_label, c->from, c->till);
    for (size_t k = 0; k < 2 && curves->label[k]; k++)
        add(s, panel,
            (ovr_series){.label = curves->label[k],
                         .n = LOOKS + 1,
                         .x = s->at,
                         .y = s->value[first + k],
                         .colour = curves->colour[k]});
    set_range(panel);
    add_uprights(s, panel, c->mark, c->marks);
}

/* Adds radius, speeds, load and the film thickness of the run; `of`: names of
 * the surfaces. */
static void add_course(sketch *s, const course *c, const char *const of[2])
{
    add_panel(s, c, "radius, {/:Italic R} (mm)", 0,
              &(over_moments){{"reduced radius"}, {OVR_INK}});
    add_panel(s, c, "speed, {/:Italic u} (m/s)", 1,
              &(over_moments){{of[0], of[1]}, {OVR_BLUE, OVR_GREEN}});
    add_panel(s, c, "load, {/:Italic w} (kN/m)", 3,
              &(over_moments){{"load"}, {OVR_VIOLET}});
    add_film(s, c);
}

static bool allocate_workspace(sketch *s, size_t n)
{
    s->at = ovr_arena_take(s->arena, 7 * n, sizeof *s->at, s->err);
    for (size_t k = 0; s->at && k < 4; k++)
        s->value[k] = s->at + (k + 1) * n;
    if (s->at) {
        s->x = s->at + 5 * n;
        s->y = s->at + 6 * n;
    }
    return s->at != NULL;
}

/* Stores the operating conditions at sample k, and converts its position from m
 * to mm. */
static void note_moment(sketch *s, int k, const ovr_element_moment *m)
{
    s->value[0][k] = 1e3 * m->R;
    s->value[1][k] = m->u1;
    s->value[2][k] = m->u2;
    s->value[3][k] = 1e-3 * m->load;
    s->x[k] *= 1e3;
    s->y[k] *= 1e3;
    s->to->points = (size_t)k + 1;
    s->to->at = s->at;
    s->to->x = s->x;
    s->to->y = s->y;
}

static void name_it(sketch *s, const char *text)
{
    s->to->title = ovr_arena_text(s->arena, text, s->err);
}

/* -------------------------------------------------------------------- gears */

static void draw_teeth(sketch *s, double R1)
{
    const ovr_gear_geometry *g = ovr_gear_of(ovr_setup_gear(s->setup));
    const ovr_gear_form *form = ovr_gear_form_of(ovr_setup_gear(s->setup));
    ovr_panel *panel = drawing_panel(s);
    for (int gear = 1; gear <= 2; gear++) {
        ovr_outline teeth = ovr_outline_make(s->arena);
        ovr_outline_teeth(&teeth, form, g, gear, R1);
        add_outline(s, panel, &teeth,
                    (ovr_series){.label = gear == 1 ? "gear 1" : "gear 2",
                                 .colour = gear == 1 ? OVR_BLUE : OVR_GREEN});
    }
    /* Line of action between the base circles, and the path of contact on
     * it. */
    ovr_outline line = ovr_outline_make(s->arena);
    ovr_outline path = line, points = line;
    const double ends[] = {0, g->line > 0 ? g->line : g->R1_E + g->base_pitch};
    const double marks[] = {g->R1_A, g->R1_B, g->R1_C, g->R1_D, g->R1_E};
    double x, y, span = g->R1_E - g->R1_A;
    for (int k = 0; k < 2; k++) {
        double end = fmin(fmax(ends[k], g->R1_A - span), g->R1_E + span);
        ovr_gear_place(form, g, end, &x, &y);
        ovr_outline_add(&line, x, y);
        ovr_gear_place(form, g, k ? g->R1_E : g->R1_A, &x, &y);
        ovr_outline_add(&path, x, y);
    }
    for (int k = 0; k < 5; k++) {
        ovr_gear_place(form, g, marks[k], &x, &y);
        ovr_outline_add(&points, x, y);
    }
    add_outline(s, panel, &line,
                (ovr_series){.label = "line of action",
                             .mark = OVR_MARK_DOTTED,
                             .colour = OVR_GREY});
    add_outline(s, panel, &path,
                (ovr_series){.label = "path of contact", .colour = OVR_RED});
    add_outline(s, panel, &points,
                (ovr_series){.mark = OVR_MARK_POINTS,
                             .letters = "A B C D E",
                             .colour = OVR_INK,
                             .width = 2.4});
    double half = 0.55e3 * (span + 2.5 * form->module);
    panel->x_from = -1.6 * half;
    panel->x_to = 1.6 * half;
    panel->y_from = -half;
    panel->y_to = half;
}

static void gear_moments(sketch *s)
{
    const ovr_gear *gear = ovr_setup_gear(s->setup);
    const ovr_gear_geometry *g = ovr_gear_of(gear);
    const ovr_gear_form *form = ovr_gear_form_of(ovr_setup_gear(s->setup));
    for (int k = 0; k <= LOOKS; k++) {
        double t = g->begin + (g->end - g->begin) * k / LOOKS;
        ovr_element_moment m = ovr_gear_at(gear, t);
        double distance = t * g->base_1 * g->omega_1;
        double R1 = form->driving == 1 ? g->R1_A + distance
                                       : g->R1_E - distance;
        s->at[k] = 1e3 * (t - g->begin);
        ovr_gear_place(form, g, R1, &s->x[k], &s->y[k]);
        note_moment(s, k, &m);
    }
}

static void draw_gear(sketch *s)
{
    const ovr_gear *gear = ovr_setup_gear(s->setup);
    const ovr_gear_geometry *g = ovr_gear_of(gear);
    const ovr_gear_form *form = ovr_gear_form_of(ovr_setup_gear(s->setup));
    const double R1[] = {g->R1_A, g->R1_B, g->R1_C, g->R1_D, g->R1_E};
    double marks[5], end = 1e3 * (g->end - g->begin);
    char text[NAME];
    snprintf(text, sizeof text,
             "%d and %d teeth, module %.4g mm: contact ratio %.4g",
             form->teeth_1, form->teeth_2, 1e3 * form->module,
             g->contact_ratio);
    name_it(s, text);
    for (int k = 0; k < 5; k++)
        marks[k] = 1e3 * (ovr_gear_time(gear, R1[k]) - g->begin);
    s->to->unit = 1e3;
    gear_moments(s);
    draw_teeth(s, g->R1_C);
    const course c = {"time, {/:Italic t} (ms)", 0, end, marks, 5};
    add_course(s, &c,
               (const char *const[]){"surface of gear 1", "surface of gear 2"});
}

/* --------------------------------------------------------------------- cams */

/* Draws a follower; returns its outer radius in m. */
static double draw_follower(sketch *s, ovr_outline *to)
{
    const ovr_cam *cam = ovr_setup_cam(s->setup);
    const ovr_cam_form *form = ovr_cam_form_of(cam);
    const ovr_cam_event *event = ovr_cam_of(cam);
    double at = 0.5 * (event->from + event->to), lift[3];
    ovr_cam_lift(cam, (at - event->from) / form->speed, lift);
    double r = form->base_radius + lift[0];
    if (form->follower == OVR_FOLLOWER_FLAT) {
        double half = 0.8 * form->base_radius;
        ovr_outline_add(to, r * cos(at) + half * sin(at),
                        r * sin(at) - half * cos(at));
        ovr_outline_add(to, r * cos(at) - half * sin(at),
                        r * sin(at) + half * cos(at));
        return r;
    }
    r += form->roller_radius;
    ovr_outline_arc(to, r * cos(at), r * sin(at), form->roller_radius, 0,
                    2 * pi);
    return r + form->roller_radius;
}

static void draw_cam_outline(sketch *s)
{
    const ovr_cam *cam = ovr_setup_cam(s->setup);
    const ovr_cam_form *form = ovr_cam_form_of(ovr_setup_cam(s->setup));
    const ovr_cam_event *event = ovr_cam_of(cam);
    ovr_panel *panel = drawing_panel(s);
    ovr_outline whole = ovr_outline_make(s->arena);
    ovr_outline part = whole, follower = whole, turns = whole;
    double x, y, size = 0;
    for (int k = 0; k <= LOOKS; k++) {
        double angle = event->from + 2 * pi * k / LOOKS;
        ovr_cam_place(cam, form, angle, &x, &y);
        ovr_outline_add(&whole, x, y);
        size = fmax(size, hypot(x, y));
        ovr_cam_place(cam, form,
                      event->from + (event->to - event->from) * k / LOOKS, &x,
                      &y);
        ovr_outline_add(&part, x, y);
    }
    for (size_t k = 0; k < event->reversals; k++) {
        ovr_cam_place(cam, form, event->reversal[k], &x, &y);
        ovr_outline_add(&turns, x, y);
    }
    size = fmax(size, draw_follower(s, &follower));
    add_outline(s, panel, &whole,
                (ovr_series){.label = "cam", .colour = OVR_GREY});
    add_outline(s, panel, &part,
                (ovr_series){.label = "range of the run",
                             .colour = OVR_BLUE,
                             .width = 3});
    add_outline(s, panel, &follower,
                (ovr_series){.label = "follower", .colour = OVR_GREEN});
    if (event->reversals)
        add_outline(s, panel, &turns,
                    (ovr_series){.label = "reversals of the entrainment speed",
                                 .mark = OVR_MARK_POINTS,
                                 .colour = OVR_RED,
                                 .width = 2.4});
    panel->x_from = -1.6e3 * size;
    panel->x_to = 1.6e3 * size;
    panel->y_from = -1.1e3 * size;
    panel->y_to = 1.1e3 * size;
}

static void cam_moments(sketch *s)
{
    const ovr_cam *cam = ovr_setup_cam(s->setup);
    const ovr_cam_form *form = ovr_cam_form_of(cam);
    const ovr_cam_event *event = ovr_cam_of(cam);
    for (int k = 0; k <= LOOKS; k++) {
        double t = event->duration * k / LOOKS;
        double angle = event->from + form->speed * t;
        ovr_element_moment m = ovr_cam_at(cam, t);
        s->at[k] = angle * 180 / pi;
        ovr_cam_place(cam, form, angle, &s->x[k], &s->y[k]);
        note_moment(s, k, &m);
    }
}

static void draw_cam(sketch *s)
{
    const ovr_cam *cam = ovr_setup_cam(s->setup);
    const ovr_cam_form *form = ovr_cam_form_of(ovr_setup_cam(s->setup));
    const ovr_cam_event *event = ovr_cam_of(cam);
    double degree = 180 / pi, turns[16];
    double from = event->from * degree, till = event->to * degree;
    char text[NAME];
    snprintf(text, sizeof text, "cam, %s follower: base radius %.4g mm",
             form->follower == OVR_FOLLOWER_FLAT ? "flat" : "roller",
             1e3 * form->base_radius);
    name_it(s, text);
    for (size_t k = 0; k < event->reversals; k++)
        turns[k] = event->reversal[k] * degree;
    cam_moments(s);
    s->to->unit = form->speed * degree;
    s->to->begin = from;
    draw_cam_outline(s);
    const course c = {"angle of the cam (degrees)", from, till, turns,
                      event->reversals};
    add_course(s, &c,
               (const char *const[]){"surface of the cam", "of the follower"});
}

/* ----------------------------------------------------------------- bearings */

/* Converts an angle measured from the load, which points down, to one measured
 * from +x. */
static double upright(double psi)
{
    return psi - pi / 2;
}

static double first_angle(const ovr_bearing_form *form)
{
    return form->position == OVR_ROLLER_AT   ? form->angle
           : form->position == OVR_GAP_BELOW ? pi / form->rollers
                                             : 0;
}

/* Draws rollers, and bars outside the ring with lengths proportional to their
 * loads. */
static void draw_rollers(sketch *s, ovr_outline *rollers, ovr_outline *bars)
{
    const ovr_bearing *bearing = ovr_setup_bearing(s->setup);
    const ovr_bearing_form *form = ovr_bearing_form_of(bearing);
    const ovr_bearing_geometry *g = ovr_bearing_of(bearing);
    double out = g->outer / 2, longest = 0.35 * out;
    for (int k = 0; k < form->rollers; k++) {
        double angle = upright(first_angle(form) + 2 * pi * k / form->rollers);
        double Q = ovr_bearing_load(bearing, k);
        double far = out + longest * Q / g->heaviest;
        ovr_outline_arc(rollers, g->pitch / 2 * cos(angle),
                        g->pitch / 2 * sin(angle), form->roller / 2, 0, 2 * pi);
        ovr_outline_break(rollers);
        if (Q <= 0)
            continue;
        ovr_outline_add(bars, out * cos(angle), out * sin(angle));
        ovr_outline_add(bars, far * cos(angle), far * sin(angle));
        ovr_outline_break(bars);
    }
}

static void draw_rings(sketch *s, const double *met, size_t count)
{
    const ovr_bearing *bearing = ovr_setup_bearing(s->setup);
    const ovr_bearing_form *form = ovr_bearing_form_of(bearing);
    const ovr_bearing_geometry *g = ovr_bearing_of(bearing);
    ovr_panel *panel = drawing_panel(s);
    ovr_outline inner = ovr_outline_make(s->arena);
    ovr_outline outer = inner, rollers = inner, bars = inner, points = inner;
    double out = g->outer / 2;
    ovr_outline_arc(&inner, 0, 0, g->inner / 2, 0, 2 * pi);
    ovr_outline_arc(&outer, 0, 0, out, 0, 2 * pi);
    draw_rollers(s, &rollers, &bars);
    double track = form->contact == 1 ? g->inner / 2 : out;
    for (size_t k = 0; k < count; k++)
        ovr_outline_add(&points, track * cos(upright(met[k])),
                        track * sin(upright(met[k])));
    add_outline(s, panel, &inner,
                (ovr_series){.label = "raceways", .colour = OVR_STEEL});
    add_outline(s, panel, &outer, (ovr_series){.colour = OVR_STEEL});
    add_outline(
        s, panel, &rollers,
        (ovr_series){.label = "rollers", .colour = OVR_BLUE, .width = 1.4});
    add_outline(s, panel, &bars,
                (ovr_series){.label = "load of a roller",
                             .colour = OVR_RED,
                             .width = 5});
    add_outline(s, panel, &points,
                (ovr_series){.label = "roller positions met by a raceway point",
                             .mark = OVR_MARK_POINTS,
                             .colour = OVR_AMBER,
                             .width = 3});
    double size = 1.4e3 * out;
    panel->x_from = -1.4 * size;
    panel->x_to = 1.4 * size;
    panel->y_from = -size;
    panel->y_to = size;
}

/* Draws the load of a roller as a function of its angle, the present rollers,
 * and those that a point of the raceway meets. */
static void draw_bearing(sketch *s)
{
    static const char *const axis = "angle from the load (degrees)";
    const ovr_bearing *bearing = ovr_setup_bearing(s->setup);
    const ovr_bearing_form *form = ovr_bearing_form_of(bearing);
    const ovr_bearing_geometry *g = ovr_bearing_of(bearing);
    double *met = s->value[0], *load = s->value[1], *stand = s->value[2];
    double degree = 180 / pi;
    char text[NAME];
    size_t count = ovr_bearing_passes(bearing, 0, 0.01, OVR_ROLLERS_MAX, met,
                                      load);
    double first = first_angle(form);
    snprintf(text, sizeof text,
             "%d rollers under %.4g N: the heaviest carries %.4g N",
             form->rollers, form->load, g->heaviest);
    name_it(s, text);
    draw_rings(s, met, count);
    ovr_panel *p = history_panel(s, axis, "load of a roller (N)", -180, 180);
    for (int k = 0; k < form->rollers; k++) {
        double angle = remainder(first + 2 * pi * k / form->rollers, 2 * pi);
        s->at[k] = angle * degree;
        stand[k] = ovr_bearing_load(bearing, k);
    }
    for (size_t k = 0; k < count; k++)
        met[k] *= degree;
    add(s, p,
        (ovr_series){.label = "loaded rollers",
                     .n = (size_t)form->rollers,
                     .x = s->at,
                     .y = stand,
                     .mark = OVR_MARK_CROSS,
                     .colour = OVR_BLUE});
    add(s, p,
        (ovr_series){.label = "rollers met by a point of the raceway",
                     .n = count,
                     .x = met,
                     .y = load,
                     .mark = OVR_MARK_POINTS,
                     .colour = OVR_AMBER,
                     .width = 3});
    set_range(p);
}

/* -------------------------------------------------------- complete figure */

ovr_status ovr_element_draw(const ovr_setup *setup, const ovr_stored *run,
                            ovr_arena *arena, ovr_element_figure *figure,
                            ovr_error *err)
{
    ovr_error own = {0};
    sketch s = {
        .setup = setup, .run = run, .arena = arena, .to = figure, .err = &own};
    *figure = (ovr_element_figure){.panels = 0};
    if (!ovr_setup_gear(setup) && !ovr_setup_cam(setup) &&
        !ovr_setup_bearing(setup))
        return ovr_fail(err, OVR_BAD_INPUT,
                        "only cases with [gear], [cam] or [roller_bearing] "
                        "have a machine element to draw");
    if (allocate_workspace(&s, ovr_setup_bearing(setup) ? OVR_ROLLERS_MAX
                                                        : LOOKS + 1)) {
        if (ovr_setup_gear(setup))
            draw_gear(&s);
        else if (ovr_setup_cam(setup))
            draw_cam(&s);
        else
            draw_bearing(&s);
    }
    if (!own.status)
        return OVR_OK;
    if (err)
        *err = own;
    return own.status;
}

ovr_chart ovr_element_chart(const ovr_element_figure *figure,
                            const ovr_picture_options *o)
{
    return (ovr_chart){
        .kind = "element",
        .title = o->title ? o->title : figure->title,
        .width = o->width > 0 ? o->width : 1000,
        .height = o->height > 0 ? o->height : (int)(560 + 180 * figure->panels),
        .rows = figure->panels,
        .columns = 1,
        .share_x = true,
        .panel = figure->panel};
}

ovr_status ovr_draw_element(const ovr_drawing *drawing, ovr_chart *chart,
                            ovr_error *err)
{
    ovr_element_figure *figure = ovr_arena_take(drawing->arena, 1,
                                                sizeof *figure, err);
    ovr_case *c;
    if (!figure)
        return OVR_NO_MEMORY;
    ovr_setup *setup = ovr_stored_setup(drawing->runs, &c, err);
    if (!setup)
        return OVR_BAD_INPUT;
    ovr_status status = ovr_element_draw(setup, drawing->runs, drawing->arena,
                                         figure, err);
    ovr_setup_free(setup);
    ovr_case_free(c);
    if (!status)
        *chart = ovr_element_chart(figure, drawing->options);
    return status;
}
