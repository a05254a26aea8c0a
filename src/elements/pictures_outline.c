/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Outlines of teeth and cams for scale drawings.
 *
 * Teeth, in the transverse section: half a tooth subtends at the radius r the
 * angle
 *
 *   psi(r) = (pi/2 + 2 x tan a_n)/z + inv a_t - inv(acos(r_b/r)).
 *
 * For an internal gear z < 0, and the formula gives minus the half angle of the
 * ring's tooth. The gears are rotated so that the flanks meet at the contact
 * point; the active flank of gear 1 faces gear 2. Teeth extend 1.25 modules
 * below the reference circle and have no fillets.
 *
 * Cams: position of the contact on the cam, with the unit vectors e_r and e_t
 * at the follower's angle:
 *
 *   flat    (rb + s) e_r + s' e_t
 *   roller  r e_r - rr (r e_r - s' e_t)/sqrt(r^2 + s'^2)
 */
#include <math.h>
#include <stdlib.h>

#include "elements/elements.h"
#include "elements/pictures_element.h"

static const double pi = 3.14159265358979323846;

ovr_outline ovr_outline_make(ovr_arena *arena)
{
    return (ovr_outline){.arena = arena};
}

static bool grow(ovr_outline *to)
{
    size_t capacity = to->capacity ? 2 * to->capacity : 512;
    double *x = ovr_arena_take(to->arena, capacity, sizeof *x, NULL);
    double *y = ovr_arena_take(to->arena, capacity, sizeof *y, NULL);
    if (!x || !y)
        return false;
    for (size_t k = 0; k < to->n; k++)
        x[k] = to->x[k], y[k] = to->y[k];
    to->x = x;
    to->y = y;
    to->capacity = capacity;
    return true;
}

void ovr_outline_add(ovr_outline *to, double x, double y)
{
    if (to->failed || (to->n == to->capacity && !grow(to))) {
        to->failed = true;
        return;
    }
    to->x[to->n] = x;
    to->y[to->n++] = y;
}

void ovr_outline_break(ovr_outline *to)
{
    ovr_outline_add(to, NAN, NAN);
}

void ovr_outline_arc(ovr_outline *to, double x, double y, double radius,
                     double from, double till)
{
    enum { PARTS = 180 };
    for (int k = 0; k <= PARTS; k++) {
        double angle = from + (till - from) * k / PARTS;
        ovr_outline_add(to, x + radius * cos(angle), y + radius * sin(angle));
    }
}

/* -------------------------------------------------------------------- gears */

typedef struct wheel {
    double y;      /* y of its centre */
    double side;   /* side of the contact: 1 above the centre, -1 below */
    double mirror; /* -1: gear 2 drives, and the line of action is inclined the
                    * other way */
    double base, tip, foot;
    double half, reference; /* half the tooth angle, and inv a_t */
    int teeth;
} wheel;

static double involute(double cosine)
{
    return tan(acos(cosine)) - acos(cosine);
}

/* Returns half the angle of a tooth at radius r, also for a ring gear. */
static double half_tooth(const wheel *w, double r)
{
    double psi = w->half + w->reference - involute(fmin(1, w->base / r));
    return w->teeth < 0 ? -psi : psi;
}

static wheel wheel_of(const ovr_gear_form *f, const ovr_gear_geometry *g,
                      int gear)
{
    int z = gear == 1 ? f->teeth_1 : f->teeth_2;
    double d = gear == 1 ? g->d_1 : g->d_2;
    double base = gear == 1 ? g->base_1 : g->base_2;
    double x = gear == 1 ? g->shift_1 : g->shift_2;
    double rw = fabs(base) / cos(g->working_angle);
    wheel w = {.base = fabs(base),
               .teeth = z,
               .tip = (gear == 1 ? g->tip_1 : g->tip_2) / 2,
               .foot = fabs(d / 2 + f->module * (x - 1.25)),
               .half = (pi / 2 + 2 * x * tan(f->pressure_angle)) / z,
               .reference = involute(2 * base / d)};
    /* An external gear 1 and a ring gear 2 have their centres below the pitch
     * point, the others above. */
    bool below = (gear == 1) == (z > 0);
    w.y = below ? -rw : rw;
    w.side = below ? 1 : -1;
    w.mirror = f->driving == 1 ? 1 : -1;
    return w;
}

void ovr_gear_place(const ovr_gear_form *form, const ovr_gear_geometry *g,
                    double R1, double *x, double *y)
{
    double distance = R1 - g->R1_C;
    *x = (form->driving == 1 ? distance : -distance) * cos(g->working_angle);
    *y = distance * sin(g->working_angle);
}

/* Appends a point of the wheel; `angle` is measured from the line of centres,
 * positive to +x. */
static void add_polar(ovr_outline *to, const wheel *w, double r, double angle)
{
    ovr_outline_add(to, w->mirror * r * sin(angle),
                    w->y + w->side * r * cos(angle));
}

/* Appends one flank of the tooth about `centre`, from radius `from` to
 * `till`. */
static void add_flank(ovr_outline *to, const wheel *w, double centre,
                      double side, double from, double till)
{
    enum { PARTS = 24 };
    for (int k = 0; k <= PARTS; k++) {
        double r = from + (till - from) * k / PARTS;
        add_polar(to, w, r, centre + side * half_tooth(w, fmax(r, w->base)));
    }
}

void ovr_outline_teeth(ovr_outline *to, const ovr_gear_form *form,
                       const ovr_gear_geometry *g, int gear, double R1)
{
    const wheel w = wheel_of(form, g, gear);
    double x, y;
    ovr_gear_place(form, g, R1, &x, &y);
    double r = hypot(x, y - w.y);
    double at = atan2(w.mirror * x, w.side * (y - w.y));
    /* The active flank of gear 1 faces +x, the active flank of gear 2 faces
     * -x. */
    double push = gear == 1 ? 1 : -1;
    double centre = at - push * half_tooth(&w, r),
           pitch = 2 * pi / abs(w.teeth);
    for (int j = -3; j <= 3; j++) {
        double tooth = centre + j * pitch;
        add_flank(to, &w, tooth, -1, w.foot, w.tip);
        add_flank(to, &w, tooth, 1, w.tip, w.foot);
    }
}

/* --------------------------------------------------------------------- cams */

void ovr_cam_place(const ovr_cam *cam, const ovr_cam_form *form, double angle,
                   double *x, double *y)
{
    double lift[3], radial, across;
    ovr_cam_lift(cam, (angle - ovr_cam_of(cam)->from) / form->speed, lift);
    if (form->follower == OVR_FOLLOWER_FLAT) {
        radial = form->base_radius + lift[0];
        across = lift[1];
    } else {
        double r = form->base_radius + form->roller_radius + lift[0];
        double q = hypot(r, lift[1]);
        radial = r - form->roller_radius * r / q;
        across = form->roller_radius * lift[1] / q;
    }
    *x = radial * cos(angle) - across * sin(angle);
    *y = radial * sin(angle) + across * cos(angle);
}
