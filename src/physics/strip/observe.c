/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Numbers of a strip.  Each line is observed as a line contact (observe.c).
 * Loads, flows, forces and powers are means over the lines, per unit of width.
 * Minimum film thickness and maximum pressure are those of all lines.  Between
 * lines they are located by a parabola through three lines, as along x.
 * Spike, number of maxima and end of the film are those of the shown line.
 */
#include <math.h>
#include <string.h>

#include "contact/contact.h"
#include "physics/strip/strip.h"
#include "simulation/observe.h"
#include "simulation/quantity_row.h"
#include "strip/across.h"

/* Numbers of lines whose mean is that of the strip. */
static const size_t means[] = {offsetof(ovr_observation, H_cen),
                               offsetof(ovr_observation, P_cen),
                               offsetof(ovr_observation, load),
                               offsetof(ovr_observation, H_mean),
                               offsetof(ovr_observation, F_slide),
                               offsetof(ovr_observation, F_roll),
                               offsetof(ovr_observation, F_slope_1),
                               offsetof(ovr_observation, F_slope_2),
                               offsetof(ovr_observation, power_dissipated),
                               offsetof(ovr_observation, limiting_share)};
enum { MEANS = sizeof means / sizeof *means };

static double *number(ovr_observation *o, size_t k)
{
    return (double *)(void *)((char *)o + means[k]);
}

static double mean_of(const ovr_observation *o, size_t k)
{
    return *(const double *)(const void *)((const char *)o + means[k]);
}

/* Returns the extreme of a parabola through the values of line j and of its
 * neighbours, and its Y in *at. */
static double vertex_across(const ovr_strip_solver *s, const double *value,
                            size_t j, double *at)
{
    const double W = s->form->width, Dy = ovr_across_mesh(W, s->lines);
    double left = value[ovr_across_line(s->lines, (ptrdiff_t)j - 1)];
    double right = value[ovr_across_line(s->lines, (ptrdiff_t)j + 1)];
    double bend = left - 2 * value[j] + right, slope = (right - left) / 2;
    double off = bend != 0 ? -slope / bend : 0;
    if (!(fabs(off) <= 1) || fabs(off) < 1e-9) /* rounding errors */
        off = 0;
    *at = ovr_across_offset(W, s->Y[j] + off * Dy);
    return value[j] + off * (slope + off * bend / 2);
}

/* Mean mass flow along x; sets the flows of the mass balance. */
static double mass_flow(ovr_strip_solver *s, const ovr_simulation *sim)
{
    const ovr_strip_level *finest = ovr_strip_finest(s);
    const ovr_strip_grid *g = &finest->grid;
    const ovr_strip_fields *f = &finest->f;
    const double Cu = ovr_history_value(sim->histories.speed, sim->state.T);
    double sum = 0, count = 0;
    for (size_t i = 0; i + 1 < s->n; i++) {
        size_t a = ovr_strip_row(g, i), b = a + g->stride;
        size_t before = i ? a - g->stride : a;
        double row = 0;
        for (size_t j = 0; j < s->lines; j++) {
            /* Linear extrapolation to the half node, as in the wedge. */
            double q = i ? 1.5 * f->q[a + j] - 0.5 * f->q[before + j]
                         : 0.5 * (f->q[a + j] + f->q[b + j]);
            double flow = Cu * q -
                          g->D * f->along[a + j] * (f->P[b + j] - f->P[a + j]);
            row += flow;
            if (f->P[a + j] > 0 && f->P[b + j] > 0) {
                sum += flow;
                count++;
            }
        }
        if (i == 0)
            s->flow[0] = row / (double)ovr_across_intervals(s->lines);
        if (i == s->middle)
            s->flow[1] = row / (double)ovr_across_intervals(s->lines);
    }
    return count > 0 ? sum / count : 0;
}

/* Inflow - flow through X = 0 - stored change between them, relative to their
 * mean size. */
static double mass_balance(const ovr_strip_solver *s)
{
    const double *T = s->march.T;
    double t1 = T[0] - T[1], before = T[1] - T[2];
    if (!(t1 > 0))
        return 0;
    double r = before > 0 ? t1 / before : 1;
    double stored = ((1 + 2 * r) / (1 + r) * s->mass[0] - (1 + r) * s->mass[1] +
                     r * r / (1 + r) * s->mass[2]) /
                    t1;
    double size = (fabs(s->flow[0]) + fabs(s->flow[1]) + fabs(stored)) / 2;
    return size > 0 ? (s->flow[0] - s->flow[1] - stored) / size : 0;
}

/* Sums over lines, and the lines with the extremes. */
typedef struct lines {
    double sum[MEANS];
    double Rq, H_mean, H_cen, P_cen; /* sums of squares */
    double H_cen_least, H_cen_most;
    double P_unresolved, X_unresolved; /* largest height of a spike */
    ovr_observation low, high;  /* observations with the extremes at nodes */
    size_t low_line, high_line; /* lines with the extremes between nodes */
} lines;

/* Adds line j. */
static void add_line(ovr_strip_solver *s, const ovr_observation *o, size_t j,
                     lines *all)
{
    double *low = s->located[0], *high = s->located[1];
    for (size_t m = 0; m < MEANS; m++)
        all->sum[m] += mean_of(o, m);
    all->Rq += o->film_Rq * o->film_Rq;
    all->H_mean += o->H_mean * o->H_mean;
    all->H_cen += o->H_cen * o->H_cen;
    all->P_cen += o->P_cen * o->P_cen;
    all->H_cen_least = fmin(all->H_cen_least, o->H_cen);
    all->H_cen_most = fmax(all->H_cen_most, o->H_cen);
    low[j] = o->H_min_located;
    high[j] = o->P_max_located;
    if (o->H_min < all->low.H_min)
        all->low = *o;
    if (o->P_max > all->high.P_max)
        all->high = *o;
    if (o->P_unresolved > all->P_unresolved) {
        all->P_unresolved = o->P_unresolved;
        all->X_unresolved = o->X_unresolved;
    }
    if (all->low_line == s->lines || low[j] < low[all->low_line])
        all->low_line = j;
    if (all->high_line == s->lines || high[j] > high[all->high_line])
        all->high_line = j;
}

/* Observes every line; the shown line is the last, and its numbers remain in
 * *o. */
static lines observe_lines(ovr_simulation *sim, ovr_strip_solver *s,
                           ovr_observation *o)
{
    const ovr_observation conditions = *o;
    lines all = {.H_cen_least = INFINITY,
                 .H_cen_most = -INFINITY,
                 .low = {.H_min = INFINITY, .H_min_located = INFINITY},
                 .high = {.P_max = -INFINITY, .P_max_located = -INFINITY},
                 .low_line = s->lines,
                 .high_line = s->lines};
    for (size_t k = 1; k <= s->lines; k++) {
        size_t j = (s->shown + k) % s->lines;
        *o = conditions;
        ovr_strip_show(sim, s, j);
        ovr_observe_line(sim, o);
        add_line(s, o, j, &all);
    }
    return all;
}

/* Standard deviation over the lines, from the sum of squares. */
static double deviation(const ovr_strip_solver *s, double squares, double mean)
{
    return sqrt(fmax(
        squares / (double)ovr_across_intervals(s->lines) - mean * mean, 0));
}

/* Computes means over the lines, and standard deviations of the central values.
 */
static void set_means(const ovr_simulation *sim, const ovr_strip_solver *s,
                      const lines *all, ovr_observation *o)
{
    const double count = (double)ovr_across_intervals(s->lines);
    for (size_t m = 0; m < MEANS; m++)
        *number(o, m) = all->sum[m] / count;
    o->film_Rq = sqrt(all->Rq / count +
                      fmax(all->H_mean / count - o->H_mean * o->H_mean, 0));
    o->lambda_ratio = sim->shapes.roughness > 0
                          ? o->H_mean / sim->shapes.roughness
                          : NAN;
    o->more[OVR_STRIP_FILM_LOW] = all->H_cen_least;
    o->more[OVR_STRIP_FILM_HIGH] = all->H_cen_most;
    o->more[OVR_STRIP_FILM_SPREAD] = deviation(s, all->H_cen, o->H_cen);
    o->more[OVR_STRIP_PRESSURE_SPREAD] = deviation(s, all->P_cen, o->P_cen);
}

/* Minimum film thickness and maximum pressure of all lines, and the minimum
 * film thickness of the run. */
static void set_extremes(ovr_strip_solver *s, const lines *all,
                         ovr_observation *o)
{
    const ovr_observation *low = &all->low, *high = &all->high;
    o->H_min = low->H_min;
    o->X_min = low->X_min;
    o->H_min_cavity = low->H_min_cavity;
    o->X_min_cavity = low->X_min_cavity;
    o->X_min_located = low->X_min_located;
    o->H_min_located = vertex_across(s, s->located[0], all->low_line,
                                     &o->more[OVR_STRIP_Y_MIN]);
    o->P_max = high->P_max;
    o->X_P_max = high->X_P_max;
    o->X_P_max_located = high->X_P_max_located;
    o->P_unresolved = all->P_unresolved;
    o->X_unresolved = all->X_unresolved;
    o->P_max_resolved = ovr_is_resolved(o->P_max, o->P_unresolved);
    o->P_max_located = vertex_across(s, s->located[1], all->high_line,
                                     &o->more[OVR_STRIP_Y_MAX]);
    if (o->H_min_located < s->least[0]) {
        s->least[0] = o->H_min_located;
        s->least[1] = o->more[OVR_STRIP_Y_MIN];
    }
    o->more[OVR_STRIP_Y_LEAST] = s->least[1];
}

void ovr_strip_observe(ovr_simulation *sim, void *own, ovr_observation *o)
{
    ovr_strip_solver *s = own;
    const lines all = observe_lines(sim, s, o);
    set_means(sim, s, &all, o);
    set_extremes(s, &all, o);
    o->mass_flow = mass_flow(s, sim);
    o->mass_balance = mass_balance(s);
    ovr_friction_forces(sim, o);
}

void ovr_strip_unknown(ovr_observation *o)
{
    for (int k = OVR_STRIP_Y_MIN; k <= OVR_STRIP_Y_LEAST; k++)
        o->more[k] = NAN;
}

#define ACROSS(name, key, si, kind, place, ...)                                \
    OVR_NUMBER_ROW(name, key, si, kind, more[OVR_STRIP_##place],               \
                   OVR_PHYSICS_STRIP, __VA_ARGS__)

const ovr_observable ovr_strip_quantities[OVR_STRIP_QUANTITIES] = {
    ACROSS("y_min_film_thickness", "Y_min", NULL, LENGTH, Y_MIN,
           "Y of the minimum film thickness",
           COMMENT("position across rolling"),
           LABEL("Y of the minimum film thickness")),
    ACROSS("y_max_pressure", "Y_P_max", NULL, LENGTH, Y_MAX,
           "Y of the maximum pressure", COMMENT("position across rolling"),
           LABEL("Y of the maximum pressure")),
    ACROSS("central_film_thickness_min", "H_cen_low", "central_film_low_m",
           HEIGHT, FILM_LOW, "minimum film thickness at x = 0",
           COMMENT("over all lines of the strip"),
           LABEL("minimum film thickness at x = 0"),
           SMALLEST("H_cen_low_overall"), EXTREME_REPORTED),
    ACROSS("central_film_thickness_max", "H_cen_high", "central_film_high_m",
           HEIGHT, FILM_HIGH, "maximum film thickness at x = 0",
           COMMENT("over all lines of the strip"),
           LABEL("maximum film thickness at x = 0")),
    ACROSS("central_film_thickness_deviation", "H_cen_deviation",
           "central_film_deviation_m", HEIGHT, FILM_SPREAD,
           "film thickness variation at x = 0",
           COMMENT("standard deviation across rolling"),
           LABEL("film thickness variation at x = 0")),
    ACROSS("central_pressure_deviation", "P_cen_deviation",
           "central_pressure_deviation_Pa", PRESSURE, PRESSURE_SPREAD,
           "pressure variation at x = 0",
           COMMENT("standard deviation across rolling")),
    ACROSS(NULL, "Y_H_min_overall", NULL, LENGTH, Y_LEAST,
           "Y of the minimum film thickness over the run",
           COMMENT("position across rolling"))};
