/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Computes results of the gear pair, cam or bearing of a run.
 *
 * Gears: a pair of teeth dissipates the energy e per unit width along its path
 * of contact, and a new pair enters after each base pitch p. The power loss of
 * the mesh is e v/p times the length of the contact lines, face width/cos(base
 * helix angle), where v is the speed along the line of action. It equals the
 * mean power of the run times the mean number of pairs in contact. A slice of
 * helical teeth represents the whole face width.
 *
 * Cams: the energy of one event per revolution. Bearings: one roller on the
 * raceway.
 */
#include "elements/run_element.h"

#include <math.h>
#include <stdio.h>

#include "case/resolve.h"
#include "case/setup.h"
#include "elements/elements.h"
#include "physics/heat/heat.h"
#include "results/results.h"
#include "run/internal.h"
#include "run/review.h"
#include "run/summary_lines.h"
#include "surface/surfaces.h"

/* ------------------------------------------------------------------ Summary */

static const double pi = 3.14159265358979323846;

typedef struct answered {
    const ovr_run_info *run;
    const ovr_resolved *r;
    ovr_summary_taker *take;
    void *data;
} answered;

static void add_number(const answered *a, const char *key, double number)
{
    const ovr_report_sink to = {a->take, a->data};
    ovr_put_number(&to, key, number);
}

/* Returns the mean power supplied by the surfaces, W/m. NAN if the run covers
 * only a part of the element's cycle, or if its friction is unrealistic. */
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

/* Returns the distance from the pitch point along the line of action, positive
 * after it. */
static double from_pitch_point(const answered *a, double T)
{
    const ovr_gear *gear = a->r->element.gear;
    const ovr_gear_geometry *g = ovr_gear_of(gear);
    double t = g->begin + seconds(a, T) - ovr_gear_time(gear, g->R1_C);
    return t * g->base_1 * g->omega_1;
}

static void add_gear(const answered *a)
{
    const ovr_gear_geometry *g = ovr_gear_of(a->r->element.gear);
    const ovr_gear_form *form = &a->r->values.element.gear;
    const ovr_statistics *total = ovr_simulation_statistics(a->run->sim);
    double torque = g->transverse_force * g->base_1;
    double power = torque * g->omega_1;
    double width = form->face / cos(g->base_helix);
    double pitch = g->base_pitch / (g->base_1 * g->omega_1);
    double loss = mean_power(a) * width * seconds(a, a->r->element.end) / pitch;
    add_number(a, "torque_N_m", torque);
    add_number(a, "speed_rpm", g->omega_1 * 30 / pi);
    add_number(a, "power_W", power);
    add_number(a, "contact_ratio", g->contact_ratio);
    add_number(a, "overlap_ratio", g->overlap_ratio);
    add_number(a, "power_loss_W", a->run->transient ? loss : NAN);
    /* The torque is that of gear 1; if gear 1 is driven, the loss is already
     * subtracted. */
    add_number(a, "efficiency",
               !a->run->transient   ? NAN
               : form->driving == 1 ? 1 - loss / power
                                    : power / (power + loss));
    if (!a->run->transient)
        return;
    add_number(a, "way_H_min_m",
               from_pitch_point(a, total->when.H_min_located));
    add_number(a, "way_P_max_m", from_pitch_point(a, total->when.P_max));
}

/* ------------------------------------------------------------------- cams */

static double degrees_at(const answered *a, double T)
{
    const ovr_cam_form *form = &a->r->values.element.cam;
    double from = ovr_cam_of(a->r->element.cam)->from;
    return (from + form->speed * seconds(a, T)) * 180 / pi;
}

/* Returns the maximum torque that lifts the follower without friction: contact
 * force times derivative of the lift with respect to the angle, F s'. */
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

static void add_cam(const answered *a)
{
    const ovr_cam_form *form = &a->r->values.element.cam;
    const ovr_statistics *total = ovr_simulation_statistics(a->run->sim);
    double event = ovr_cam_of(a->r->element.cam)->duration;
    double loss = mean_power(a) * form->face * event * form->speed / (2 * pi);
    add_number(a, "torque_N_m", lifting_torque(a));
    add_number(a, "speed_rpm", form->speed * 30 / pi);
    add_number(a, "power_loss_W", a->run->transient ? loss : NAN);
    if (!a->run->transient)
        return;
    add_number(a, "angle_H_min_deg", degrees_at(a, total->when.H_min_located));
    add_number(a, "angle_P_max_deg", degrees_at(a, total->when.P_max));
}

/* --------------------------------------------------------------- bearings */

static void add_bearing(const answered *a)
{
    const ovr_bearing_form *form = &a->r->values.element.bearing;
    const ovr_bearing_geometry *g = ovr_bearing_of(a->r->element.bearing);
    double speed = fabs(form->speed_inner - form->speed_outer);
    add_number(a, "speed_rpm", speed * 30 / pi);
    add_number(a, "bearing_load_N", form->load);
    add_number(a, "heaviest_roller_N", g->heaviest);
    add_number(a, "rollers_loaded", g->loaded);
    add_number(a, "power_loss_W", mean_power(a) * form->length);
}

void ovr_element_summary(const ovr_run_info *run, ovr_summary_taker *take,
                         void *data)
{
    const ovr_resolved *r = run->setup->resolved;
    const answered a = {run, r, take, data};
    if (r->element.gear)
        add_gear(&a);
    if (r->element.cam)
        add_cam(&a);
    if (r->element.bearing)
        add_bearing(&a);
    if (ovr_setup_heat(run->setup) &&
        (r->element.gear || r->element.cam || r->element.bearing))
        add_number(&a, "T_supply_K", ovr_setup_heat(run->setup)->T0);
}

/* -------------------------------------------------------- Group of the file */

/* Group `element` of a result file: the operating conditions of a gear or cam
 * contact as functions of time. They are computed by the machine element, not
 * by the splines of the run. */

enum { LOOKS = 401, ARRAYS = 7 };

/* Stores lengths in b, and speeds and load relative to their reference values;
 * a flat surface has radius NAN. */
static void sample_conditions(const ovr_setup *setup,
                              double *const column[ARRAYS + 1])
{
    const ovr_gear *gear = ovr_setup_gear(setup);
    const ovr_cam *cam = ovr_setup_cam(setup);
    const ovr_gear_geometry *g = ovr_gear_of(gear);
    const ovr_contact *c = setup->contact;
    double begin = gear ? g->begin : 0;
    double end = gear ? g->end : ovr_cam_of(cam)->duration;
    double v = gear ? g->base_1 * g->omega_1 : ovr_cam_form_of(cam)->speed;
    for (size_t k = 0; k < LOOKS; k++) {
        double t = begin + (end - begin) * (double)k / (LOOKS - 1);
        ovr_element_moment m = gear ? ovr_gear_at(gear, t) : ovr_cam_at(cam, t);
        double position = gear ? (t - ovr_gear_time(gear, g->R1_C)) * v / c->b
                               : (ovr_cam_of(cam)->from + v * t) * 180 /
                                     acos(-1);
        const double values[] = {
            (t - begin) / c->time, position,        m.R / c->b,
            m.R_1 / c->b,          m.R_2 / c->b,    m.u1 / c->um,
            m.u2 / c->um,          m.load / c->load};
        for (int i = 0; i <= ARRAYS; i++)
            column[i][k] = isfinite(values[i]) ? values[i] : NAN;
    }
}

ovr_status ovr_run_keep_element(ovr_run *run, ovr_error *err)
{
    static const struct {
        const char *name, *long_name;
        ovr_unit_kind kind;
    } of[ARRAYS] = {
        {"path", "path of contact, distance from the pitch point",
         OVR_KIND_LENGTH},
        {"radius", "reduced radius", OVR_KIND_LENGTH},
        {"radius_1", "radius of surface 1", OVR_KIND_LENGTH},
        {"radius_2", "radius of surface 2", OVR_KIND_LENGTH},
        {"speed_1", "speed of surface 1 relative to the reference speed",
         OVR_KIND_NUMBER},
        {"speed_2", "speed of surface 2 relative to the reference speed",
         OVR_KIND_NUMBER},
        {"load", "load relative to the reference load", OVR_KIND_NUMBER}};
    const ovr_setup *setup = run->setup;
    bool cam = ovr_setup_cam(setup) != NULL;
    double *column[ARRAYS + 1];
    ovr_group_array array[ARRAYS];
    if (!cam && !ovr_setup_gear(setup))
        return OVR_OK;
    column[0] = ovr_arena_take(&run->arena, (ARRAYS + 1) * LOOKS,
                               sizeof *column[0], err);
    if (!column[0])
        return OVR_NO_MEMORY;
    for (int i = 1; i <= ARRAYS; i++)
        column[i] = column[0] + (size_t)i * LOOKS;
    sample_conditions(setup, column);
    for (int i = 0; i < ARRAYS; i++)
        array[i] = (ovr_group_array){.name = of[i].name,
                                     .long_name = of[i].long_name,
                                     .kind = of[i].kind,
                                     .rank = 1,
                                     .doubles = column[i + 1]};
    if (cam) {
        array[0].name = "angle";
        array[0].long_name = "cam angle (degrees)";
        array[0].kind = OVR_KIND_NUMBER;
    }
    const ovr_group_axis axis = {"moment", "time from the start of contact",
                                 OVR_KIND_TIME, LOOKS, column[0]};
    const ovr_group group = {.path = "element",
                             .axes = 1,
                             .arrays = ARRAYS,
                             .axis = &axis,
                             .array = array};
    return ovr_writer_group(run->writer, &group, false, err);
}

/* ------------------------------------------------------------------- Review */

/* True if the blend changes the load sharing. Within the blend the load of a
 * pair of spur gears rises around B and falls around D, and the load shares do
 * not follow the rule. */
static bool blends(const ovr_gear_form *f, const ovr_gear_geometry *g)
{
    return f->blend > 0 && !(g->overlap_ratio > 0) &&
           (f->sharing == OVR_SHARING_RULE ||
            f->sharing == OVR_SHARING_ELASTIC);
}

bool ovr_reference_is_scale(const ovr_setup *setup)
{
    const ovr_resolved *r = setup->resolved;
    return r->element.cam && !r->element.stands;
}

void ovr_report_element(const ovr_report_sink *to, const ovr_setup *setup)
{
    const ovr_resolved *r = setup->resolved;
    const ovr_gear *gear = r->element.gear;
    if (r->element.stands)
        return;
    if (gear || r->element.cam || r->element.bearing)
        ovr_report_line(to, "reference contact", "%s",
                        gear             ? "pitch point, total load"
                        : r->element.cam ? "radius of the nose, largest load "
                                           "and entrainment speed of the "
                                           "event; no position has all three"
                                         : "roller of the largest load");
    if (gear && blends(ovr_gear_form_of(gear), ovr_gear_of(gear)))
        ovr_report_line(to, "load at B and D",
                        "half-way through its change, which takes %.3g base "
                        "pitches (gear.blend)",
                        ovr_gear_form_of(gear)->blend);
}

static void review_blend(const ovr_setup *setup, ovr_listener *say, void *data)
{
    const ovr_gear *gear = ovr_setup_gear(setup);
    const ovr_gear_form *f = ovr_gear_form_of(gear);
    const ovr_gear_geometry *g = ovr_gear_of(gear);
    if (!gear || !blends(f, g) || f->blend <= (g->contact_ratio - 1) / 3)
        return;
    ovr_warn(
        say, data,
        "gear.blend: the load rises over %.3g base pitches, more than a "
        "third of the distance from A to B (%.3g), so that load shares there "
        "are determined by the blend",
        f->blend, g->contact_ratio - 1);
}

static void review_end(const ovr_setup *setup, ovr_listener *say, void *data)
{
    const ovr_resolved *r = setup->resolved;
    double end_of_contact = r->element.end, end = setup->march->end;
    if (!(end_of_contact > 0) || !setup->transient ||
        end >= end_of_contact * (1 - 1e-9))
        return;
    ovr_warn(say, data,
             "[time] end = %.4g: the run ends before the end of contact at "
             "%.4g (%.4g ms)",
             end, end_of_contact, 1e3 * end_of_contact * setup->contact->time);
}

/* Warns if the smallest predicted minimum film thickness is below the composite
 * roughness. */
static void review_film(const ovr_setup *setup, ovr_listener *say, void *data)
{
    ovr_station station[OVR_STATIONS_MAX];
    size_t n = ovr_setup_stations(setup, station), minimum = 0;
    double Rq = setup->surfaces ? ovr_surfaces_roughness(setup->surfaces) *
                                      setup->contact->height
                                : 0;
    for (size_t k = 1; k < n; k++)
        if (station[k].minimum < station[minimum].minimum)
            minimum = k;
    if (n == 0 || !(station[minimum].minimum < Rq))
        return;
    ovr_warn(say, data,
             "at %s the predicted minimum film thickness %.3g um is below the "
             "composite roughness Rq = %.3g um; asperities would touch, see "
             "[boundary]",
             station[minimum].name, 1e6 * station[minimum].minimum, 1e6 * Rq);
}

void ovr_review_element(const ovr_setup *setup, ovr_listener *say, void *data)
{
    if (!say)
        return;
    review_blend(setup, say, data);
    review_end(setup, say, data);
    review_film(setup, say, data);
}

void ovr_review_element_after(const ovr_setup *setup,
                              const ovr_statistics *total, ovr_listener *say,
                              void *data)
{
    const ovr_gear *gear = ovr_setup_gear(setup);
    const ovr_gear_form *f = ovr_gear_form_of(gear);
    const ovr_gear_geometry *g = ovr_gear_of(gear);
    if (!gear || !say || !blends(f, g) || !setup->transient)
        return;
    const double R1[] = {g->R1_B, g->R1_D};
    double t = g->begin + total->when.P_max * setup->contact->time;
    double v = g->base_1 * g->omega_1, maximum = f->blend * g->base_pitch;
    for (int k = 0; k < 2; k++) {
        double off = fabs(t - ovr_gear_time(gear, R1[k])) * v;
        if (!(off <= maximum))
            continue;
        ovr_warn(say, data,
                 "the maximum pressure %.4g GPa occurs %.2g mm from %c, where "
                 "the load changes within %.2g mm; it depends on that distance "
                 "(gear.blend) more than on the contact",
                 1e-9 * total->extreme.P_max * setup->contact->ph, 1e3 * off,
                 "BD"[k], 1e3 * maximum);
        return;
    }
}
