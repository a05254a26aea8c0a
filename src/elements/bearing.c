/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Cylindrical roller bearing with a radial load of constant direction.
 *
 * The roller at the angle psi_k from the load carries
 *
 *   Q_k = K (d cos psi_k - clearance/2)+^(10/9),  sum Q_k cos psi_k = load,
 *
 * where d is the displacement of the inner ring. The stiffness K of the two
 * contacts in series follows from Palmgren's approach of a roller and a
 * raceway, 3.84e-5 Q^0.9/l^0.8 (mm, N; Harris, Rolling Bearing Analysis).
 * Without sliding the raceways have the speeds v = omega d/2, the cage rotates
 * at (v_i + v_o)/pitch, and a roller at (v_o - v_i)/roller.
 *
 * A point of the raceway of contact k rotates by omega_k relative to the load.
 * It meets the next roller after the time 2 pi/(n |omega_k - cage|), at an
 * angle larger by 2 pi omega_k/(n |omega_k - cage|). The load of that roller is
 * computed with all rollers in the positions of that time.
 */
#include "elements/elements.h"

#include <math.h>

#include "base/arena.h"
#include "base/error.h"

static const double pi = 3.14159265358979323846;

struct ovr_bearing {
    ovr_bearing_form form;
    ovr_bearing_geometry g;
    double first; /* angle of roller 0, measured from the load */
    ovr_arena arena;
};

ovr_bearing_form ovr_bearing_form_default(void)
{
    return (ovr_bearing_form){.roller = NAN,
                              .length = NAN,
                              .inner = NAN,
                              .pitch = NAN,
                              .load = NAN,
                              .contact = 1,
                              .position = OVR_ROLLER_BELOW,
                              .stiffness = NAN};
}

/* ---------------------------------------------------- load distribution */

/* Returns the load of a roller at the angle psi for the displacement d. */
static double roller_load(const ovr_bearing *bearing, double d, double psi)
{
    double approach = d * cos(psi) - bearing->form.clearance / 2;
    return approach > 0 ? bearing->g.stiffness * pow(approach, 10.0 / 9) : 0;
}

static double resultant(const ovr_bearing *bearing, double d, double first)
{
    int n = bearing->form.rollers;
    double sum = 0;
    for (int k = 0; k < n; k++) {
        double psi = first + 2 * pi * k / n;
        sum += roller_load(bearing, d, psi) * cos(psi);
    }
    return sum;
}

/* Returns the displacement at which the rollers, one of them at `first`, carry
 * the bearing load. The resultant increases with the displacement. Bisection is
 * fast enough. */
static double displaced(const ovr_bearing *bearing, double first)
{
    double load = bearing->form.load, low = 0;
    double high = fabs(bearing->form.clearance) +
                  pow(load / bearing->g.stiffness, 0.9);
    while (resultant(bearing, high, first) < load)
        high *= 2;
    for (int k = 0; k < 200 && high - low > 1e-17 * high; k++) {
        double middle = 0.5 * (low + high);
        if (middle <= low || middle >= high)
            break;
        if (resultant(bearing, middle, first) < load)
            low = middle;
        else
            high = middle;
    }
    return 0.5 * (low + high);
}

/* --------------------------------------------------------------- checks */

static ovr_status check_form(const ovr_bearing_form *f, ovr_error *err)
{
    const ovr_needed all[] = {
        {"roller", f->roller, false},
        {"length", f->length, false},
        {"load", f->load, false},
        {"inner", isnan(f->inner) ? 1 : f->inner, false},
        {"pitch", isnan(f->pitch) ? 1 : f->pitch, false},
        {"stiffness", isnan(f->stiffness) ? 1 : f->stiffness, false}};
    if (ovr_check_needed(all, sizeof all / sizeof *all, err))
        return OVR_BAD_INPUT;
    if (isnan(f->inner) == isnan(f->pitch))
        return ovr_fail_about(err, "pitch",
                              isnan(f->inner)
                                  ? "inner or pitch must be set"
                                  : "inner and pitch determine each other; "
                                    "remove one of the two");
    if (f->rollers < 3 || f->rollers > OVR_ROLLERS_MAX)
        return ovr_fail_about(err, "rollers", "rollers = %d: must be 3 to %d",
                              f->rollers, OVR_ROLLERS_MAX);
    if (f->contact != 1 && f->contact != 2)
        return ovr_fail_about(err, "contact", "contact must be inner or outer");
    if (!isfinite(f->clearance) || !isfinite(f->angle))
        return ovr_fail_about(err, "clearance", "clearance: must be finite");
    if (!(fabs(f->slip) < 2))
        return ovr_fail_about(err, "slip", "slip = %g: must be below 2",
                              f->slip);
    return OVR_OK;
}

static ovr_status check_geometry(const ovr_bearing *bearing, ovr_error *err)
{
    const ovr_bearing_form *f = &bearing->form;
    const ovr_bearing_geometry *g = &bearing->g;
    if (!(g->inner > 0))
        return ovr_fail_about(err, "pitch",
                              "a pitch circle of %.4g mm leaves no space for "
                              "an inner ring with rollers of %.4g mm",
                              1e3 * g->pitch, 1e3 * f->roller);
    if (g->pitch * sin(pi / f->rollers) < f->roller)
        return ovr_fail_about(err, "rollers",
                              "%d rollers of %.4g mm do not fit on a pitch "
                              "circle of %.4g mm",
                              f->rollers, 1e3 * f->roller, 1e3 * g->pitch);
    if (fabs(f->speed_inner - f->speed_outer) <=
        1e-12 * fmax(fabs(f->speed_inner), fabs(f->speed_outer)))
        return ovr_fail_about(err, "speed_inner",
                              f->speed_inner == 0
                                  ? "speed_inner and speed_outer are both 0: "
                                    "the rollers do not roll"
                                  : "speed_inner and speed_outer are equal: "
                                    "the rollers do not roll");
    return OVR_OK;
}

/* ------------------------------------------------------------- geometry */

static double raceway(const ovr_bearing *bearing)
{
    return bearing->form.contact == 1 ? bearing->g.inner : bearing->g.outer;
}

static double ring_speed(const ovr_bearing *bearing)
{
    return bearing->form.contact == 1 ? bearing->form.speed_inner
                                      : bearing->form.speed_outer;
}

/* Returns the angle of roller 0, measured from the load. */
static double first_angle(const ovr_bearing_form *f)
{
    if (f->position == OVR_ROLLER_AT)
        return f->angle;
    return f->position == OVR_GAP_BELOW ? pi / f->rollers : 0;
}

static void measure(ovr_bearing *bearing)
{
    const ovr_bearing_form *f = &bearing->form;
    ovr_bearing_geometry *g = &bearing->g;
    g->inner = isnan(f->pitch) ? f->inner
                               : f->pitch - f->roller - f->clearance / 2;
    g->outer = g->inner + 2 * f->roller + f->clearance;
    g->pitch = (g->inner + g->outer) / 2;
    /* Palmgren's formula in mm and N. Each of the two contacts in series has
     * half of the total approach. */
    double one = pow(pow(1e3 * f->length, 0.8) / 3.84e-5 / 2, 10.0 / 9);
    g->stiffness = isnan(f->stiffness) ? one * pow(1e3, 10.0 / 9)
                                       : f->stiffness;
    double v_inner = f->speed_inner * g->inner / 2;
    double v_outer = f->speed_outer * g->outer / 2;
    g->cage = (v_inner + v_outer) / g->pitch;
    g->spin = (v_outer - v_inner) / f->roller;
    double passing = fabs(ring_speed(bearing) - g->cage);
    g->spacing = pi * raceway(bearing) / f->rollers;
    g->period = 2 * pi / (f->rollers * passing);
    g->step = 2 * pi * ring_speed(bearing) / (f->rollers * passing);
}

static void distribute(ovr_bearing *bearing)
{
    ovr_bearing_geometry *g = &bearing->g;
    g->displacement = displaced(bearing, bearing->first);
    for (int k = 0; k < bearing->form.rollers; k++) {
        double Q = ovr_bearing_load(bearing, k);
        g->heaviest = fmax(g->heaviest, Q);
        g->loaded += Q > 0;
    }
}

/* -------------------------------------------------------------- creation */

ovr_bearing *ovr_bearing_create(const ovr_bearing_form *form,
                                const ovr_allocator *allocator, ovr_error *err)
{
    ovr_arena arena = ovr_arena_make(allocator);
    ovr_bearing *bearing;
    if (!form) {
        ovr_fail(err, OVR_BAD_INPUT, "the input argument (bearing) is NULL");
        return NULL;
    }
    bearing = ovr_arena_take(&arena, 1, sizeof *bearing, err);
    if (bearing) {
        bearing->form = *form;
        if (!check_form(form, err)) {
            measure(bearing);
            bearing->first = first_angle(form);
            if (!check_geometry(bearing, err)) {
                distribute(bearing);
                bearing->arena = arena;
                return bearing;
            }
        }
    }
    ovr_arena_release(&arena);
    return NULL;
}

void ovr_bearing_free(ovr_bearing *bearing)
{
    if (bearing) {
        ovr_arena arena = bearing->arena;
        ovr_arena_release(&arena);
    }
}

const ovr_bearing_geometry *ovr_bearing_of(const ovr_bearing *bearing)
{
    return bearing ? &bearing->g : NULL;
}

const ovr_bearing_form *ovr_bearing_form_of(const ovr_bearing *bearing)
{
    return bearing ? &bearing->form : NULL;
}

/* --------------------------------------------------------------- results */

double ovr_bearing_load(const ovr_bearing *bearing, int k)
{
    if (!bearing)
        return NAN;
    return roller_load(bearing, bearing->g.displacement,
                       bearing->first + 2 * pi * k / bearing->form.rollers);
}

ovr_element_moment ovr_bearing_contact(const ovr_bearing *bearing, double load)
{
    if (!bearing)
        return (ovr_element_moment){0};
    const ovr_bearing_form *f = &bearing->form;
    double d = raceway(bearing), D = f->roller;
    double side = f->contact == 1 ? 1 : -1;
    double u = fabs(ring_speed(bearing) - bearing->g.cage) * d / 2;
    double mean = u / (1 + f->slip / 2);
    return (ovr_element_moment){.R = D * d / (2 * (d + side * D)),
                                .R_1 = side * d / 2,
                                .R_2 = D / 2,
                                .u1 = u,
                                .u2 = mean * (1 - f->slip / 2),
                                .load = load / f->length};
}

size_t ovr_bearing_passes(const ovr_bearing *bearing, double phase,
                          double minimum, size_t capacity, double *angle,
                          double *load)
{
    if (!bearing || !angle || !load)
        return 0;
    double step = bearing->g.step, largest = 0;
    int reach = step != 0 ? (int)floor(pi / fabs(step)) + 1 : 0;
    size_t count = 0;
    for (int j = -reach; j <= reach; j++) {
        double psi = phase + j * step;
        if (cos(psi) > 0 && fabs(psi) < pi)
            largest = fmax(largest,
                           roller_load(bearing, displaced(bearing, psi), psi));
    }
    for (int j = -reach; j <= reach && count < capacity; j++) {
        double psi = phase + j * step, Q;
        if (!(cos(psi) > 0 || step == 0) || fabs(psi) >= pi)
            continue;
        Q = roller_load(bearing, displaced(bearing, psi), psi);
        if (Q <= 0 || Q < minimum * largest)
            continue;
        angle[count] = psi;
        load[count++] = Q;
    }
    return count;
}
