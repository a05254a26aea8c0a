/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Contact points of a machine element, each as a steady contact in its own
 * Hertzian scaling, with film thickness by the fitted formula and Blok's flash
 * temperature.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "case/setup.h"
#include "contact/contact.h"
#include "contact/curvature.h"
#include "contact/film_formula.h"
#include "elements/case_element.h"
#include "elements/elements.h"

typedef struct listing {
    const ovr_resolved *r;
    double begin; /* start of the run in s */
    ovr_station *station;
    size_t count;
} listing;

/* Returns the thermal effusivity sqrt(k rho c). */
static double coefficient(const ovr_thermal *body)
{
    return sqrt(body->conductivity * body->density * body->heat_capacity);
}

/* Sets speeds that are equal or opposite within rounding exactly so, and -0 to
 * 0. */
static void remove_rounding(ovr_element_moment *m)
{
    double rounding = 1e-12 * fmax(fabs(m->u1), fabs(m->u2));
    if (fabs(m->u1 - m->u2) < rounding)
        m->u2 = m->u1;
    if (fabs(m->u1 + m->u2) < rounding)
        m->u2 = -m->u1;
    m->u1 = fabs(m->u1) < rounding ? 0 : m->u1;
    m->u2 = fabs(m->u2) < rounding ? 0 : m->u2;
}

static void evaluate(const ovr_resolved *r, ovr_station *s)
{
    const ovr_contact *contact = &r->contact;
    const ovr_conditions *given = &r->values.contact;
    double Cw = s->moment.load / given->load;
    double Cu = fabs(s->moment.u1 + s->moment.u2) /
                (given->speed_1 + given->speed_2);
    double c = given->radius / s->moment.R;
    ovr_instant own = ovr_instant_of(contact, Cw, Cu, c);
    double P = sqrt(Cw * c);
    ovr_film_fit fit = {NAN, NAN};
    if (r->lubricant.viscosity_law == OVR_ROELANDS)
        fit = ovr_film_fitted(own.M, own.L, ovr_density(&r->lubricant, P));
    s->pressure = P * contact->ph;
    s->half_width = own.s * contact->b;
    s->central = fit.central * Cw * contact->height;
    s->minimum = fit.minimum * Cw * contact->height;
    s->flash = ovr_flash_temperature(
        &s->moment, s->half_width, OVR_STATION_FRICTION,
        coefficient(&r->body[0].thermal), coefficient(&r->body[1].thermal));
}

static void add(listing *l, const char *name, ovr_element_moment moment)
{
    if (l->count == OVR_STATIONS_MAX)
        return;
    ovr_station *s = &l->station[l->count++];
    *s = (ovr_station){.moment = moment, .T = NAN};
    snprintf(s->name, sizeof s->name, "%s", name);
    remove_rounding(&s->moment);
    if (!l->r->element.bearing) {
        s->moment.t -= l->begin;
        s->T = s->moment.t / l->r->contact.time;
    }
    evaluate(l->r, s);
}

static void gear_stations(listing *l)
{
    const ovr_gear *gear = l->r->element.gear;
    const ovr_gear_geometry *g = ovr_gear_of(gear);
    const struct {
        const char *name;
        double R1;
    } points[] = {{"A", g->R1_A},
                  {"B", g->R1_B},
                  {"C", g->R1_C},
                  {"D", g->R1_D},
                  {"E", g->R1_E}};
    l->begin = g->begin;
    for (size_t k = 0; k < sizeof points / sizeof *points; k++) {
        double t = ovr_gear_time(gear, points[k].R1);
        /* Runs may begin later and end earlier than the path of contact. */
        bool whole = t >= g->begin && t <= g->end;
        t = fmin(fmax(t, g->begin), g->end);
        char name[24];
        snprintf(name, sizeof name, "%s%s", whole ? "" : "nearest ",
                 points[k].name);
        add(l, name, ovr_gear_at(gear, t));
    }
}

static void cam_stations(listing *l)
{
    const ovr_cam *cam = l->r->element.cam;
    const ovr_cam_event *event = ovr_cam_of(cam);
    double speed = l->r->values.element.cam.speed;
    double angle[32] = {event->from, event->to, event->nose};
    const char *name[32] = {"begin", "end", "nose"};
    size_t n = 3;
    for (size_t k = 0; k < event->reversals; k++) {
        name[n] = "turn";
        angle[n++] = event->reversal[k];
    }
    for (size_t k = 0; k < n; k++)
        if (angle[k] >= event->from && angle[k] <= event->to)
            add(l, name[k], ovr_cam_at(cam, (angle[k] - event->from) / speed));
}

static void bearing_stations(listing *l)
{
    const ovr_bearing *bearing = l->r->element.bearing;
    int n = l->r->values.element.bearing.rollers;
    for (int k = -(n - 1) / 2; k <= n / 2; k++) {
        double Q = ovr_bearing_load(bearing, k);
        char name[24];
        snprintf(name, sizeof name, "roller %d", k);
        if (Q > 0)
            add(l, name, ovr_bearing_contact(bearing, Q));
    }
}

static int by_time(const void *a, const void *b)
{
    double x = ((const ovr_station *)a)->T, y = ((const ovr_station *)b)->T;
    return (x > y) - (x < y);
}

size_t ovr_setup_stations(const ovr_setup *setup,
                          ovr_station station[OVR_STATIONS_MAX])
{
    if (!setup)
        return 0;
    const ovr_resolved *r = setup->resolved;
    listing l = {.r = r, .station = station};
    if (r->element.gear)
        gear_stations(&l);
    if (r->element.cam)
        cam_stations(&l);
    if (r->element.bearing)
        bearing_stations(&l);
    else
        qsort(station, l.count, sizeof *station, by_time);
    return l.count;
}

const ovr_gear *ovr_setup_gear(const ovr_setup *setup)
{
    return setup ? setup->resolved->element.gear : NULL;
}

const ovr_cam *ovr_setup_cam(const ovr_setup *setup)
{
    return setup ? setup->resolved->element.cam : NULL;
}

const ovr_bearing *ovr_setup_bearing(const ovr_setup *setup)
{
    return setup ? setup->resolved->element.bearing : NULL;
}
