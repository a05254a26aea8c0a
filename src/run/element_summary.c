/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Sums up the gear pair, cam or bearing of a run's case.
 *
 * Gears: one pair of teeth loses the energy e a width over its way, and a new
 * one begins after each base pitch: the mesh loses e/(p/v) over the length of
 * its contact lines, face/cos of the base helix, p the base pitch and v the
 * speed along the line of action.  It is the mean power of the run times the
 * number of pairs that touch on average.  A slice of helical teeth stands for
 * the whole face.
 *
 * Cams: the energy of the event, once a turn.  Bearings: one roller on the
 * raceway.
 */
#include <math.h>

#include "case/resolve.h"
#include "elements/elements.h"
#include "physics/heat/heat.h"
#include "run/internal.h"
#include "run/lines.h"

static const double pi = 3.14159265358979323846;

typedef struct answered {
    const ovr_run_info *run;
    const ovr_resolved *r;
    ovr_summary_taker *take;
    void *data;
} answered;

static void put(const answered *a, const char *key, double number)
{
    const ovr_told to = {a->take, a->data};
    ovr_put_number(&to, key, number);
}

/* Mean power put in by the surfaces, W/m.  NAN if the run is only a part of the
 * element's cycle, or if its friction is impossible. */
static double mean_power(const answered *a)
{
    const ovr_statistics *total = ovr_simulation_statistics(a->run->sim);
    double T = ovr_simulation_state(a->run->sim)->T, end = a->r->element.end;
    if (end > 0 && !(T >= end * (1 - 1e-9)))
        return NAN;
    if (fabs(total->extreme.mu_slide) > OVR_IMPOSSIBLE_FRICTION)
        return NAN;
    return total->mean.power_in *
           ovr_kind_scale(OVR_KIND_POWER, &a->r->contact);
}

static double seconds(const answered *a, double T)
{
    return T * a->r->contact.time;
}

/* ------------------------------------------------------------------ gears */

/* Gives the distance from the pitch point along the line of action, positive
 * behind it. */
static double from_pitch_point(const answered *a, double T)
{
    const ovr_gear *gear = a->r->element.gear;
    const ovr_gear_geometry *g = ovr_gear_of(gear);
    double t = g->begin + seconds(a, T) - ovr_gear_time(gear, g->R1_C);
    return t * g->base_1 * g->omega_1;
}

static void put_gear(const answered *a)
{
    const ovr_gear_geometry *g = ovr_gear_of(a->r->element.gear);
    const ovr_gear_form *form = &a->r->values.element.gear;
    const ovr_statistics *total = ovr_simulation_statistics(a->run->sim);
    double torque = g->transverse_force * g->base_1;
    double power = torque * g->omega_1;
    double width = form->face / cos(g->base_helix);
    double pitch = g->base_pitch / (g->base_1 * g->omega_1);
    double loss = mean_power(a) * width * seconds(a, a->r->element.end) / pitch;
    put(a, "torque_N_m", torque);
    put(a, "speed_rpm", g->omega_1 * 30 / pi);
    put(a, "power_W", power);
    put(a, "contact_ratio", g->contact_ratio);
    put(a, "overlap_ratio", g->overlap_ratio);
    put(a, "power_loss_W", a->run->transient ? loss : NAN);
    /* The torque is that of gear 1, which the loss has passed where it is
     * driven. */
    put(a, "efficiency",
        !a->run->transient   ? NAN
        : form->driving == 1 ? 1 - loss / power
                             : power / (power + loss));
    if (!a->run->transient)
        return;
    put(a, "way_H_min_m", from_pitch_point(a, total->when.H_min_located));
    put(a, "way_P_max_m", from_pitch_point(a, total->when.P_max));
}

/* ------------------------------------------------------------------- cams */

static double degrees_at(const answered *a, double T)
{
    const ovr_cam_form *form = &a->r->values.element.cam;
    double from = ovr_cam_of(a->r->element.cam)->from;
    return (from + form->speed * seconds(a, T)) * 180 / pi;
}

/* The largest torque that lifts the follower: its force on the cam times the
 * follower's way by the angle, F s', without friction. */
static double lifting_torque(const answered *a)
{
    enum { LOOKS = 3600 };
    const ovr_cam *cam = a->r->element.cam;
    const ovr_cam_form *f = &a->r->values.element.cam;
    double largest = 0;
    for (int k = 0; k <= LOOKS; k++) {
        double lift[3];
        ovr_cam_lift(cam, ovr_cam_of(cam)->duration * k / LOOKS, lift);
        double force = f->preload + f->spring * lift[0] +
                       f->mass * f->speed * f->speed * lift[2];
        largest = fmax(largest, force * lift[1]);
    }
    return largest;
}

static void put_cam(const answered *a)
{
    const ovr_cam_form *form = &a->r->values.element.cam;
    const ovr_statistics *total = ovr_simulation_statistics(a->run->sim);
    double event = ovr_cam_of(a->r->element.cam)->duration;
    double loss = mean_power(a) * form->face * event * form->speed / (2 * pi);
    put(a, "torque_N_m", lifting_torque(a));
    put(a, "speed_rpm", form->speed * 30 / pi);
    put(a, "power_loss_W", a->run->transient ? loss : NAN);
    if (!a->run->transient)
        return;
    put(a, "angle_H_min_deg", degrees_at(a, total->when.H_min_located));
    put(a, "angle_P_max_deg", degrees_at(a, total->when.P_max));
}

/* --------------------------------------------------------------- bearings */

static void put_bearing(const answered *a)
{
    const ovr_bearing_form *form = &a->r->values.element.bearing;
    const ovr_bearing_geometry *g = ovr_bearing_of(a->r->element.bearing);
    double speed = fabs(form->speed_inner - form->speed_outer);
    put(a, "speed_rpm", speed * 30 / pi);
    put(a, "bearing_load_N", form->load);
    put(a, "heaviest_roller_N", g->heaviest);
    put(a, "rollers_loaded", g->loaded);
    put(a, "power_loss_W", mean_power(a) * form->length);
}

void ovr_element_summary(const ovr_run_info *run, ovr_summary_taker *take,
                         void *data)
{
    const ovr_resolved *r = (const ovr_resolved *)run->setup;
    const answered a = {run, r, take, data};
    if (r->element.gear)
        put_gear(&a);
    if (r->element.cam)
        put_cam(&a);
    if (r->element.bearing)
        put_bearing(&a);
    if (ovr_setup_heat(run->setup) &&
        (r->element.gear || r->element.cam || r->element.bearing))
        put(&a, "T_supply_K", ovr_setup_heat(run->setup)->T0);
}
