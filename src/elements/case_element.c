/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Reference contact of a machine element. Gear pair: at the pitch point, with
 * the total load. Cam: at the nose, with the largest entrainment speed and load
 * of the event. Bearing: at the most heavily loaded roller. Time histories
 * relative to the reference are tables of 1601 times and of every corner.
 */
#include "elements/case_element.h"
#include "base/error.h"
#include "contact/contact.h"
#include "elements/elements.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_sort.h>

#include "base/quantity.h"

enum { UNIFORM = 1600, CORNERS = 32, POINTS = UNIFORM + 2 + CORNERS };

/* Surface 1 counts as flat if its curvature is below 1/1000 of the reference
 * curvature; larger radii are outside the range of a case. */
static const double FLATTEST = 1000;

static const double PI = 3.14159265358979323846;

/* ---------------------------------------------------- element of the case */

static bool is_given(const ovr_block *block)
{
    for (size_t k = 0; block && k < block->count; k++)
        if (block->slots[k].given)
            return true;
    return false;
}

static const char *const names[] = {"gear", "cam", "roller_bearing"};

/* Returns the section of the machine element; NULL if there is none. */
static const ovr_block *element_block(const ovr_resolved *r)
{
    for (size_t k = 0; k < sizeof names / sizeof *names; k++)
        if (is_given(ovr_block_of(r, names[k])))
            return ovr_block_of(r, names[k]);
    return NULL;
}

static ovr_status check_one(const ovr_resolved *r, const ovr_block *block,
                            ovr_error *err)
{
    for (size_t k = 0; k < sizeof names / sizeof *names; k++) {
        const ovr_block *other = ovr_block_of(r, names[k]);
        if (other != block && is_given(other))
            return ovr_fail_at(
                err, OVR_BAD_INPUT, r->c->name, other->line,
                "[%s] and [%s] are both given; a case has at most one "
                "machine element",
                block->section->name, other->section->name);
    }
    return OVR_OK;
}

/* Rejects keys and sections that a machine element already determines. */
static ovr_status check_conflicts(const ovr_resolved *r, const ovr_block *block,
                                  ovr_error *err)
{
    static const char *const keys[] = {
        "M",       "L",       "lambda",     "alphabar",     "radius",
        "speed_1", "speed_2", "mean_speed", "slide_to_roll"};
    static const char *const sections[] = {"load", "speed", "sliding", "radius",
                                           "radius_1"};
    const char *name = block->section->name;
    for (size_t k = 0; k < sizeof keys / sizeof *keys; k++) {
        const ovr_slot *slot = ovr_slot_of(r, "contact", keys[k]);
        if (slot->given)
            return ovr_fail_slot(err, slot,
                                 "already determined by [%s]; remove %s", name,
                                 keys[k]);
    }
    for (const ovr_block *b = r->c->blocks; b; b = b->next)
        if (!strcmp(b->section->name, "body") &&
            ovr_block_get(b, "radius")->given)
            return ovr_fail_slot(err, ovr_block_get(b, "radius"),
                                 "already determined by [%s]; remove radius",
                                 name);
    for (size_t k = 0; k < sizeof sections / sizeof *sections; k++) {
        const ovr_block *b = ovr_block_of(r, sections[k]);
        if (is_given(b))
            return ovr_fail_at(
                err, OVR_BAD_INPUT, r->c->name, b->line,
                "[%s] already determines the time history of %s; remove [%s]",
                name, k == 0 ? "load" : sections[k], sections[k]);
    }
    return OVR_OK;
}

/* Checks that the required keys are given. */
static ovr_status check_missing(const ovr_block *block, const char *const *keys,
                                ovr_error *err)
{
    for (; *keys; keys++)
        if (!ovr_block_get(block, *keys)->given) {
            for (size_t k = 0; k < block->count; k++)
                if (block->slots[k].given)
                    return ovr_fail_slot(err, &block->slots[k], "[%s] needs %s",
                                         block->section->name, *keys);
        }
    return OVR_OK;
}

static const char *const *needed(const ovr_resolved *r, const ovr_block *block)
{
    static const char *const gear[] = {"teeth_1", "teeth_2", "module",
                                       "face",    "speed",   NULL};
    static const char *const bearing[] = {"roller", "rollers", "length", "load",
                                          NULL};
    static const char *const law[] = {"base_radius", "face", "speed", "spring",
                                      "preload",     "lift", "rise",  NULL};
    static const char *const table[] = {
        "base_radius", "face", "speed", "spring", "preload", "file", NULL};
    if (!strcmp(block->section->name, "gear"))
        return gear;
    if (!strcmp(block->section->name, "roller_bearing"))
        return bearing;
    return r->values.element.cam.law == OVR_CAM_TABLE ? table : law;
}

ovr_status ovr_resolve_element_keys(ovr_resolved *r, ovr_error *err)
{
    ovr_element_settings *e = &r->values.element;
    const ovr_block *block = element_block(r);
    double *width = &r->values.contact.width;
    ovr_status status;
    e->gear = ovr_gear_form_default();
    e->gear.shift_1 = e->gear.shift_2 = NAN;
    e->cam = ovr_cam_form_default();
    e->bearing = ovr_bearing_form_default();
    e->power = NAN;
    if (!block)
        return OVR_OK;
    if ((status = check_one(r, block, err)) ||
        (status = check_conflicts(r, block, err)) ||
        (status = ovr_block_fill(r, block, &r->values, err)) ||
        (status = check_missing(block, needed(r, block), err)))
        return status;
    if (!isnan(*width))
        return ovr_fail_slot(err, ovr_slot_of(r, "contact", "width"),
                             "already determined by [%s]; remove width",
                             block->section->name);
    *width = !isnan(e->gear.face)        ? e->gear.face
             : !isnan(e->cam.face)       ? e->cam.face
             : !isnan(e->bearing.length) ? e->bearing.length
                                         : NAN;
    return OVR_OK;
}

/* Reads a file of two columns with units. */
static ovr_status read_table(ovr_resolved *r, const ovr_block *block,
                             const char *file, ovr_two_columns *columns,
                             ovr_error *err)
{
    const ovr_slot *slot = ovr_block_get(block, "file");
    if (!slot->given)
        return ovr_fail_slot(err, ovr_block_get(block, "sharing"),
                             "table needs 'file' in [%s]",
                             block->section->name);
    return ovr_slot_columns(slot, file, columns, &r->arena, err);
}

/* ------------------------------------------------------ reference contact */

static void set_reference(ovr_resolved *r, const ovr_element_moment *m)
{
    ovr_conditions *given = &r->values.contact;
    given->radius = m->R;
    given->speed_1 = m->u1;
    given->speed_2 = m->u2;
    given->load = m->load;
}

/* Returns the load per width given in [contact]; NAN if it is not given. */
static double contact_load(const ovr_resolved *r, double R)
{
    const ovr_conditions *given = &r->values.contact;
    if (!isnan(given->load))
        return given->load;
    return 2 * PI * R * given->hertz_pressure * given->hertz_pressure /
           given->modulus;
}

/* Rejects a load of [contact]. `keys_of_load` are the keys of the machine
 * element `by` that determine the load. */
static ovr_status check_loaded_twice(const ovr_resolved *r, const char *by,
                                     const char *keys_of_load, ovr_error *err)
{
    static const char *const keys[] = {"load", "hertz_pressure"};
    for (int k = 0; k < 2; k++) {
        const ovr_slot *slot = ovr_slot_of(r, "contact", keys[k]);
        if (slot->given)
            return ovr_fail_slot(err, slot,
                                 "already determined by [%s]; remove %s and "
                                 "change %s instead",
                                 by, keys[k], keys_of_load);
    }
    return OVR_OK;
}

/* ------------------------------------------------------------------- gears */

static ovr_gear *make_gear(const ovr_resolved *r, const ovr_block *block,
                           ovr_error *err)
{
    ovr_error why = {0};
    ovr_gear *gear = ovr_gear_create(&r->values.element.gear, NULL, &why);
    if (!gear)
        ovr_fail_in(err, r->c, block, NULL, &why);
    return gear;
}

/* Sets profile shifts that are not given: to 0, or to the value that results
 * from the centre distance. */
static void fill_shifts(ovr_gear_form *form)
{
    bool follows = !isnan(form->centre);
    if (isnan(form->shift_1) && !(follows && !isnan(form->shift_2)))
        form->shift_1 = 0;
    if (isnan(form->shift_2) && !follows)
        form->shift_2 = 0;
}

static ovr_element_moment pitch_point(const ovr_gear *gear)
{
    const ovr_gear_geometry *g = ovr_gear_of(gear);
    ovr_element_moment m = ovr_gear_at(gear, ovr_gear_time(gear, g->R1_C));
    m.load = g->whole_load;
    return m;
}

/* Computes the torque from the load at the pitch point. The gear is first made
 * with 1 N m, because its geometry does not depend on the torque. */
static ovr_status torque_by_load(ovr_resolved *r, const ovr_block *block,
                                 ovr_error *err)
{
    ovr_gear_form *form = &r->values.element.gear;
    form->torque = 1;
    ovr_gear *unit = make_gear(r, block, err);
    if (!unit)
        return OVR_BAD_INPUT;
    ovr_element_moment m = pitch_point(unit);
    ovr_gear_free(unit);
    form->torque = contact_load(r, m.R) / m.load;
    if (!isnan(form->torque))
        return OVR_OK;
    return ovr_fail_slot(err, ovr_block_get(block, "teeth_1"),
                         "[gear] needs torque or power, or load or "
                         "hertz_pressure in [contact] (the full load at the "
                         "pitch point)");
}

/* ------------------------------------------ position of a steady solution */

/* Parses a time as seconds since the beginning of the path. */
static ovr_status time_of(const char *text, double duration, double *t,
                          ovr_error *err)
{
    ovr_error why = {0};
    ovr_quantity q;
    if (ovr_quantity_read(text, OVR_DURATION, false, &q, &why))
        return ovr_fail(err, OVR_BAD_INPUT,
                        "--at %s: must be a contact position (A to E of "
                        "gears, nose of cams), an angle of the cam or a "
                        "time: %s",
                        text, why.message);
    if (!(q.value >= 0 && q.value <= duration))
        return ovr_fail(err, OVR_BAD_INPUT,
                        "--at %s: must lie within the path of contact, from "
                        "0 to %.4g ms",
                        text, 1e3 * duration);
    *t = q.value;
    return OVR_OK;
}

/* Selects a contact point A to E or a time; default: the pitch point. */
static ovr_status position_gear(ovr_resolved *r, ovr_element_moment *m,
                                ovr_error *err)
{
    const ovr_gear_geometry *g = ovr_gear_of(r->element.gear);
    const double points_R1[] = {g->R1_A, g->R1_B, g->R1_C, g->R1_D, g->R1_E};
    const char *at = r->c->standing;
    double t;
    r->element.stands = true;
    if (!*at)
        return OVR_OK;
    if (strchr("ABCDE", *at) && !at[1]) {
        t = ovr_gear_time(r->element.gear, points_R1[*at - 'A']);
        t = fmin(fmax(t, g->begin), g->end);
    } else if (time_of(at, g->end - g->begin, &t, err)) {
        return OVR_BAD_INPUT;
    } else {
        t += g->begin;
    }
    *m = ovr_gear_at(r->element.gear, t);
    return OVR_OK;
}

/* Selects an angle or a time; default: the nose. If the mean speed is negative,
 * the contact is mirrored. */
static ovr_status position_cam(ovr_resolved *r, ovr_element_moment *m,
                               ovr_error *err)
{
    const ovr_cam_event *event = ovr_cam_of(r->element.cam);
    const char *at = r->c->standing;
    double speed = r->values.element.cam.speed, t;
    ovr_error why = {0};
    ovr_quantity q;
    r->element.stands = true;
    if (!*at || !strcmp(at, "nose"))
        t = (event->nose - event->from) / speed;
    else if (!ovr_quantity_read(at, OVR_ANGLE, false, &q, &why))
        t = (q.value - event->from) / speed;
    else if (time_of(at, event->duration, &t, err))
        return OVR_BAD_INPUT;
    if (!(t >= 0 && t <= event->duration))
        return ovr_fail(
            err, OVR_BAD_INPUT,
            "--at %s: must lie within the event, from %.4g to %.4g deg", at,
            event->from * 180 / PI, event->to * 180 / PI);
    *m = ovr_cam_at(r->element.cam, t);
    if (m->u1 + m->u2 < 0) {
        m->u1 = -m->u1;
        m->u2 = -m->u2;
    }
    return OVR_OK;
}

static ovr_status resolve_gear(ovr_resolved *r, const ovr_block *block,
                               ovr_error *err)
{
    ovr_element_settings *e = &r->values.element;
    ovr_gear_form *form = &e->gear;
    ovr_status status = OVR_OK;
    fill_shifts(form);
    if (form->sharing == OVR_SHARING_TABLE) {
        ovr_two_columns table = {.name = {"distance", "share"},
                                 .maximum = 1,
                                 .of = "",
                                 .unit = {1, 1}};
        status = read_table(r, block, e->sharing_file, &table, err);
        form->shares = table.count;
        form->distance = table.x;
        form->share = table.y;
    }
    if (!status && (!isnan(form->torque) || !isnan(e->power)))
        status = check_loaded_twice(r, "gear", "gear.torque or gear.power",
                                    err);
    if (!isnan(e->power))
        form->torque = e->power / fabs(form->speed);
    if (!status && isnan(form->torque))
        status = torque_by_load(r, block, err);
    bool jumps = form->blend <= 0 && form->sharing != OVR_SHARING_TABLE;
    if (!status && jumps && form->sharing != OVR_SHARING_STIFFNESS)
        status = ovr_fail_slot(err, ovr_block_get(block, "blend"),
                               "0: the load would jump at B and D; set "
                               "gear.blend, or sharing = stiffness with tip "
                               "relief");
    if (status)
        return status;
    r->element.gear = make_gear(r, block, err);
    if (!r->element.gear)
        return OVR_BAD_INPUT;
    ovr_element_moment nominal = pitch_point(r->element.gear);
    status = r->c->standing ? position_gear(r, &nominal, err) : OVR_OK;
    if (status)
        return status;
    set_reference(r, &nominal);
    r->values.contact.hertz_pressure = NAN;
    return OVR_OK;
}

/* -------------------------------------------------------------------- cams */

/* Checks the units of a lift table. Lifts in metres or micrometres read as
 * millimetres give a plausible but wrong curvature: that of the base circle, or
 * a sharp edge. Angles in radians give a cam a sixtieth as wide. Units in the
 * header of the table are not questioned. */
static ovr_status check_lifts(const ovr_two_columns *table,
                              const ovr_block *block, double base_radius,
                              ovr_error *err)
{
    double largest = 0, angles = 0;
    for (size_t k = 0; k < table->count; k++) {
        largest = fmax(largest, fabs(table->y[k]));
        angles = fmax(angles, (table->x[k] - table->x[0]) / table->unit[0]);
    }
    if (table->named || table->count < 4) /* checked with the cam */
        return OVR_OK;
    if (angles <= 2.001 * PI)
        return ovr_fail_slot(err, ovr_block_get(block, "file"),
                             "the angles span %.3g degrees: without a header "
                             "the table must be in degrees and mm; set other "
                             "units in a header such as '%s'",
                             angles, table->example);
    if (largest >= 1e-3 * base_radius && largest <= 10 * base_radius)
        return OVR_OK;
    return ovr_fail_slot(err, ovr_block_get(block, "file"),
                         "the largest lift, %.3g mm, is %s the base radius, "
                         "%.3g mm: without a header the table must be in "
                         "degrees and mm; set other units in a header such as "
                         "'angle [deg], lift [m]'",
                         1e3 * largest,
                         largest < base_radius ? "below a thousandth of"
                                               : "above ten times",
                         1e3 * base_radius);
}

static ovr_status resolve_cam(ovr_resolved *r, const ovr_block *block,
                              ovr_error *err)
{
    ovr_element_settings *e = &r->values.element;
    ovr_error why = {0};
    ovr_status status = check_loaded_twice(
        r, "cam", "cam.spring, cam.preload or cam.mass", err);
    if (!status && e->cam.law == OVR_CAM_TABLE) {
        ovr_two_columns table = {.name = {"angle", "lift"},
                                 .minimum = -1e6,
                                 .maximum = 1e6,
                                 .of = " mm",
                                 .unit = {PI / 180, 1e-3},
                                 .header = {OVR_ANGLE, OVR_LENGTH},
                                 .example = "angle [rad], lift [mm]",
                                 .optional = true};
        status = read_table(r, block, e->lift_file, &table, err);
        if (!status)
            status = check_lifts(&table, block, e->cam.base_radius, err);
        e->cam.points = table.count;
        e->cam.angle = table.x;
        e->cam.height = table.y;
        e->cam.rounding = table.rounding;
    }
    if (status)
        return status;
    r->element.cam = ovr_cam_create(&e->cam, NULL, &why);
    if (!r->element.cam)
        return ovr_fail_in(err, r->c, block, NULL, &why);
    const ovr_cam_event *event = ovr_cam_of(r->element.cam);
    ovr_element_moment nominal = ovr_cam_at(
        r->element.cam, (event->nose - event->from) / e->cam.speed);
    double fastest = 0;
    for (int k = 0; k <= UNIFORM; k++) {
        ovr_element_moment m = ovr_cam_at(r->element.cam,
                                          event->duration * k / UNIFORM);
        fastest = fmax(fastest, fabs(m.u1 + m.u2) / 2);
        nominal.load = fmax(nominal.load, m.load);
    }
    nominal.u1 = nominal.u2 = fastest;
    status = r->c->standing ? position_cam(r, &nominal, err) : OVR_OK;
    set_reference(r, &nominal);
    return status;
}

/* ---------------------------------------------------------------- bearings */

static ovr_status resolve_bearing(ovr_resolved *r, const ovr_block *block,
                                  ovr_error *err)
{
    ovr_error why = {0};
    if (check_loaded_twice(r, "roller_bearing", "roller_bearing.load", err))
        return OVR_BAD_INPUT;
    r->element.bearing = ovr_bearing_create(&r->values.element.bearing, NULL,
                                            &why);
    if (!r->element.bearing)
        return ovr_fail_in(err, r->c, block, NULL, &why);
    ovr_element_moment nominal = ovr_bearing_contact(
        r->element.bearing, ovr_bearing_of(r->element.bearing)->heaviest);
    set_reference(r, &nominal);
    return OVR_OK;
}

ovr_status ovr_resolve_element(ovr_resolved *r, ovr_error *err)
{
    const ovr_block *block = element_block(r);
    bool moves = block && strcmp(block->section->name, "roller_bearing") != 0;
    if (r->c->standing && *r->c->standing && !moves)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "--at %s: only cases with [gear] or [cam] have "
                        "contact positions; remove the option",
                        r->c->standing);
    if (!block)
        return OVR_OK;
    if (!strcmp(block->section->name, "gear"))
        return resolve_gear(r, block, err);
    if (!strcmp(block->section->name, "cam"))
        return resolve_cam(r, block, err);
    return resolve_bearing(r, block, err);
}

bool ovr_element_moves(const ovr_resolved *r)
{
    return (r->element.gear || r->element.cam) && !r->element.stands;
}

void ovr_resolved_element_free(ovr_resolved *r)
{
    ovr_gear_free(r->element.gear);
    ovr_cam_free(r->element.cam);
    ovr_bearing_free(r->element.bearing);
}

/* --------------------------------------------------------------- histories */

typedef struct moments {
    double t[POINTS];
    size_t count;
    double end;
    double T[POINTS], load[POINTS], speed[POINTS], sliding[POINTS],
        radius[POINTS], radius_1[POINTS];
} moments;

/* Sorts uniform times from begin to end together with corners. Times too close
 * to their neighbours for a table are omitted. */
static void order_times(moments *m, double begin, double end,
                        const double *corner, size_t corners)
{
    double minimum = 1e-7 * (end - begin);
    for (int k = 0; k <= UNIFORM; k++)
        m->t[m->count++] = begin + (end - begin) * k / UNIFORM;
    for (size_t k = 0; k < corners; k++)
        if (corner[k] > begin && corner[k] < end)
            m->t[m->count++] = corner[k];
    gsl_sort(m->t, 1, m->count);
    size_t kept = 1;
    for (size_t k = 1; k < m->count; k++)
        if (m->t[k] - m->t[kept - 1] > minimum)
            m->t[kept++] = m->t[k];
    m->t[kept - 1] = end;
    m->count = kept;
}

/* Returns the ends of the blend about B and D, where the slope of the load
 * share jumps. */
static size_t gear_corners(const ovr_resolved *r, double *corner)
{
    const ovr_gear *gear = r->element.gear;
    const ovr_gear_geometry *g = ovr_gear_of(gear);
    double half = r->values.element.gear.blend / 2 * g->base_pitch;
    const double points_R1[] = {g->R1_B - half, g->R1_B, g->R1_B + half,
                                g->R1_D - half, g->R1_D, g->R1_D + half,
                                g->R1_C};
    size_t n = sizeof points_R1 / sizeof *points_R1;
    for (size_t k = 0; k < n; k++)
        corner[k] = ovr_gear_time(gear, points_R1[k]);
    return n;
}

static size_t cam_corners(const ovr_resolved *r, double *corner)
{
    const ovr_cam_event *event = ovr_cam_of(r->element.cam);
    double speed = r->values.element.cam.speed;
    size_t n = 0;
    for (int k = 0; k < 4; k++)
        corner[n++] = (event->joints[k] - event->from) / speed;
    for (size_t k = 0; k < event->reversals; k++)
        corner[n++] = (event->reversal[k] - event->from) / speed;
    return n;
}

/* Extends all histories linearly beyond the end of contact, because the last
 * step of a run may end later. A table would be constant there, and the gap at
 * the inlet, which follows from the slope of the radius (curvature.h), would
 * jump. */
static void add_beyond(moments *m)
{
    const double longest = 0.1; /* maximum step in b/u_m */
    double *const all[] = {m->T,       m->load,   m->speed,
                           m->sliding, m->radius, m->radius_1};
    size_t n = m->count++;
    double share = fmax(1, longest / (m->T[n - 1] - m->T[n - 2]));
    for (size_t k = 0; k < sizeof all / sizeof *all; k++) {
        double *v = all[k], half = fabs(v[n - 1]) / 2;
        double more = share * (v[n - 1] - v[n - 2]);
        v[n] = v[n - 1] + (k ? fmax(-half, fmin(more, half)) : more);
    }
}

static void sample_element(const ovr_resolved *r, moments *m)
{
    const ovr_conditions *given = &r->values.contact;
    double mean = (given->speed_1 + given->speed_2) / 2, corner[CORNERS];
    bool gear = r->element.gear != NULL;
    size_t corners = gear ? gear_corners(r, corner) : cam_corners(r, corner);
    double begin = gear ? ovr_gear_of(r->element.gear)->begin : 0;
    double end = gear ? ovr_gear_of(r->element.gear)->end
                      : ovr_cam_of(r->element.cam)->duration;
    order_times(m, begin, end, corner, corners);
    for (size_t k = 0; k < m->count; k++) {
        ovr_element_moment at = gear ? ovr_gear_at(r->element.gear, m->t[k])
                                     : ovr_cam_at(r->element.cam, m->t[k]);
        m->T[k] = (m->t[k] - begin) / r->contact.time;
        m->load[k] = at.load / given->load;
        m->speed[k] = (at.u1 + at.u2) / 2 / mean;
        m->sliding[k] = ovr_slip_ratio(at.u1, at.u2, mean);
        m->radius[k] = at.R / given->radius;
        m->radius_1[k] = fmax(-FLATTEST,
                              fmin(at.R_1 / given->radius, FLATTEST));
    }
    m->end = m->T[m->count - 1];
    add_beyond(m);
}

static ovr_status make_histories(ovr_resolved *r, const moments *m,
                                 ovr_error *err)
{
    ovr_setup *s = &r->setup;
    const double *const value[] = {m->load, m->speed, m->sliding, m->radius,
                                   m->radius_1};
    ovr_history **const to[] = {&s->load, &s->speed, &s->sliding, &s->radius,
                                &s->radius_1};
    ovr_history_form form = ovr_history_form_default();
    form.kind = OVR_HISTORY_TABLE;
    form.points = m->count;
    form.T = m->T;
    for (size_t k = 0; k < sizeof to / sizeof *to; k++) {
        form.value = value[k];
        *to[k] = ovr_history_create(&form, &r->arena.allocator, err);
        if (!*to[k])
            return err ? err->status : OVR_BAD_INPUT;
    }
    return OVR_OK;
}

/* Sets the end of the run: the end of contact, or an earlier time given in the
 * case. */
static ovr_status set_end(ovr_resolved *r, double end, ovr_error *err)
{
    const ovr_slot *slot = ovr_slot_of(r, "time", "end");
    double *given = &r->values.march.end;
    r->element.end = end;
    if (slot->given && *given != OVR_END_AUTO) {
        if (*given <= end * (1 + 1e-12))
            return OVR_OK;
        return ovr_fail_slot(err, slot, "%g: [%s] ends at %.4g ms (T = %.4g)",
                             *given, r->element.gear ? "gear" : "cam",
                             1e3 * end * r->contact.time, end);
    }
    *given = end;
    return OVR_OK;
}

ovr_status ovr_resolve_element_histories(ovr_resolved *r, ovr_error *err)
{
    if (!ovr_element_moves(r))
        return OVR_OK;
    moments *m = ovr_arena_take(&r->arena, 1, sizeof *m, err);
    if (!m)
        return OVR_NO_MEMORY;
    sample_element(r, m);
    /* A jump of the law's curvature cannot be convected with the material. */
    if (r->element.cam && ovr_cam_of(r->element.cam)->jumps)
        r->values.curvature = OVR_CURVATURE_IMPOSED;
    ovr_status status = make_histories(r, m, err);
    return status ? status : set_end(r, m->end, err);
}

/* ------------------------------------------------------------------ passes */

/* Sets the loads of the passes in order, relative to the largest; loads below a
 * hundredth are omitted. */
static ovr_status zone_passes(ovr_resolved *r, ovr_error *err)
{
    const ovr_bearing *bearing = r->element.bearing;
    ovr_passes_setup *p = &r->values.passes;
    double angle[OVR_ROLLERS_MAX], load[OVR_ROLLERS_MAX];
    size_t n = ovr_bearing_passes(bearing, 0, 0.01, OVR_ROLLERS_MAX, angle,
                                  load);
    double *ratio = ovr_arena_take(&r->arena, n, sizeof *ratio, err);
    if (!ratio)
        return OVR_NO_MEMORY;
    for (size_t k = 0; k < n; k++)
        ratio[k] = load[k] / ovr_bearing_of(bearing)->heaviest;
    const ovr_slot *number = ovr_slot_of(r, "passes", "number");
    if (number->given && p->number != (int)n)
        return ovr_fail_slot(err, number,
                             "%d: a point of this raceway meets %zu rollers "
                             "in one crossing of the load zone; remove "
                             "passes.number",
                             p->number, n);
    p->number = (int)n;
    p->loads = (ovr_list){n, ratio};
    return OVR_OK;
}

ovr_status ovr_resolve_element_passes(ovr_resolved *r, ovr_error *err)
{
    int passes = r->values.element.passes;
    ovr_passes_setup *p = &r->values.passes;
    const ovr_block *block = ovr_block_of(r, "roller_bearing");
    static const char *const said[] = {"loads", "spacing"};
    ovr_status status = OVR_OK;
    if (!r->element.bearing || passes == OVR_ROLLER_PASSES_NONE)
        return OVR_OK;
    for (int k = 0; k < 2; k++)
        if (ovr_slot_of(r, "passes", said[k])->given)
            return ovr_fail_slot(
                err, ovr_slot_of(r, "passes", said[k]),
                "already determined by [roller_bearing]; remove %s", said[k]);
    bool still = ovr_bearing_of(r->element.bearing)->step == 0;
    if (passes == OVR_ROLLER_PASSES_TURNS && !still)
        return ovr_fail_slot(err, ovr_block_get(block, "passes"),
                             "turns: the raceway rotates, so that the load "
                             "changes from roller to roller; use zone");
    if (passes == OVR_ROLLER_PASSES_TURNS && p->number < 2)
        return ovr_fail_slot(err, ovr_block_get(block, "passes"),
                             "turns needs passes.number");
    if (passes == OVR_ROLLER_PASSES_ZONE && still)
        return ovr_fail_slot(err, ovr_block_get(block, "passes"),
                             "zone: the ring does not rotate, and every "
                             "roller passes with the same load; use turns");
    if (passes == OVR_ROLLER_PASSES_ZONE)
        status = zone_passes(r, err);
    p->spacing = ovr_bearing_of(r->element.bearing)->spacing / r->contact.b;
    return status;
}
