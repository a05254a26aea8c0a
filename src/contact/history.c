/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Time histories of load, speed etc., relative to the reference values.
 *
 * Ramps follow the quintic smoothstep s(y) = 6 y^5 - 15 y^4 + 10 y^3, whose
 * first and second derivatives vanish at both ends, so that second-order time
 * schemes keep their order; its integral is y^6 - 3 y^5 + 5/2 y^4.
 *
 * Tables are interpolated by GSL's Steffen spline. It has a continuous slope
 * and stays within the range of neighbouring points, so that a speed table
 * without negative values has none in between; cubic and Akima splines
 * overshoot. Beyond its ends a table is constant.
 *
 * GSL's error handler, which aborts the program, is called if a point is
 * outside the spline, if the points do not increase, and if malloc fails. The
 * first is checked in advance; for the others the handler is switched off.
 */
#include "base/given.h"
#include "contact/contact.h"

#include <gsl/gsl_errno.h>
#include <math.h>

#include "base/arena.h"
#include "base/error.h"
#include "base/interpolation.h"
#include "contact/history_keys.h"

const ovr_word ovr_history_words[] = {
    {"constant", OVR_HISTORY_CONSTANT}, {"ramp", OVR_HISTORY_RAMP},
    {"sine", OVR_HISTORY_SINE},         {"step", OVR_HISTORY_STEP},
    {"table", OVR_HISTORY_TABLE},       {NULL, 0}};
const ovr_word ovr_time_unit_words[] = {
    {"b/um", 0}, {"s", 1}, {"ms", 2}, {"us", 3}, {NULL, 0}};

struct ovr_history {
    ovr_history_form form;
    gsl_interp *interp; /* for tables */
    double *T, *value;
    double *integral; /* for tables: from the first point to each point */
    double minimum;   /* minimum of all values before scaling */
    double scale;     /* factor of all values */
    ovr_arena arena;
};

ovr_history_form ovr_history_form_default(void)
{
    const ovr_history_form defaults = {.kind = OVR_HISTORY_CONSTANT,
                                       .from = 1,
                                       .to = 1,
                                       .period = 1,
                                       .mean = 1};
    return defaults;
}

/* --------------------------------------------------------------- checks */

static ovr_status check_table(const ovr_history_form *form, ovr_error *err)
{
    if (form->points < 2)
        return ovr_fail_about(err, "file",
                              "table: needs at least two points, has %zu",
                              form->points);
    for (size_t i = 0; i < form->points; i++) {
        if (!isfinite(form->T[i]) || !isfinite(form->value[i]))
            return ovr_fail_about(err, "file",
                                  "table: point %zu is not a number: times and "
                                  "values must be finite",
                                  i + 1);
        if (i && !(form->T[i] > form->T[i - 1]))
            return ovr_fail_about(err, "file",
                                  "table: times must increase: point %zu at %g "
                                  "follows %g",
                                  i + 1, form->T[i], form->T[i - 1]);
    }
    return OVR_OK;
}

static ovr_status check_form(const ovr_history_form *form, ovr_error *err)
{
    if (form->kind == OVR_HISTORY_TABLE)
        return check_table(form, err);
    if (form->kind == OVR_HISTORY_CONSTANT)
        return OVR_OK;
    if (!isfinite(form->start))
        return ovr_fail_about(err, "start", "start must be finite");
    if (form->kind == OVR_HISTORY_SINE) {
        if (!(form->period > 0 && isfinite(form->period)))
            return ovr_fail_about(
                err, "period", "period = %g: must be positive", form->period);
        if (!isfinite(form->amplitude))
            return ovr_fail_about(err, "amplitude", "amplitude must be finite");
        return OVR_OK;
    }
    if (!(form->duration >= 0 && isfinite(form->duration)))
        return ovr_fail_about(err, "duration",
                              "duration = %g: must be zero or positive",
                              form->duration);
    if (!isfinite(form->from))
        return ovr_fail_about(err, "from", "from must be finite");
    if (!isfinite(form->to))
        return ovr_fail_about(err, "to", "to must be finite");
    return OVR_OK;
}

/* ------------------------------------------------------------- creation */

/* Upper bound of the bytes per point in GSL's Steffen state. */
enum { GSL_BYTES_A_POINT = 8 * sizeof(double) };

static ovr_status probe_memory(const ovr_history *history, ovr_error *err)
{
    ovr_arena probe = ovr_arena_make(&history->arena.allocator);
    void *got = ovr_arena_take(&probe, history->form.points + 64,
                               GSL_BYTES_A_POINT, err);
    ovr_arena_release(&probe);
    return got ? OVR_OK : OVR_NO_MEMORY;
}

/* Integral from point k to T, which is between points k and k + 1. */
static double beyond_point(const ovr_history *history, size_t k, double T)
{
    double sum = 0;
    gsl_interp_eval_integ_e(history->interp, history->T, history->value,
                            history->T[k], T, NULL, &sum);
    return sum;
}

static ovr_status make_table(ovr_history *history, const ovr_history_form *form,
                             ovr_error *err)
{
    size_t n = form->points;
    history->T = ovr_arena_take(&history->arena, n, sizeof(double), err);
    history->value = ovr_arena_take(&history->arena, n, sizeof(double), err);
    history->integral = ovr_arena_take(&history->arena, n, sizeof(double), err);
    if (!history->T || !history->value || !history->integral ||
        probe_memory(history, err))
        return OVR_NO_MEMORY;
    for (size_t i = 0; i < n; i++) {
        history->T[i] = form->T[i];
        history->value[i] = form->value[i];
    }
    history->interp = ovr_interpolation(n < 3 ? gsl_interp_linear
                                              : gsl_interp_steffen,
                                        n, history->T, history->value, err);
    if (!history->interp)
        return OVR_NO_MEMORY;
    history->integral[0] = 0;
    for (size_t i = 1; i < n; i++)
        history->integral[i] = history->integral[i - 1] +
                               beyond_point(history, i - 1, history->T[i]);
    return OVR_OK;
}

static double table_min(const ovr_history *history)
{
    double minimum = history->value[0];
    for (size_t i = 1; i < history->form.points; i++)
        minimum = fmin(minimum, history->value[i]);
    return minimum;
}

static double minimum(const ovr_history *history)
{
    const ovr_history_form *form = &history->form;
    switch (form->kind) {
    case OVR_HISTORY_TABLE: return table_min(history);
    case OVR_HISTORY_SINE: return form->mean - fabs(form->amplitude);
    case OVR_HISTORY_RAMP:
    case OVR_HISTORY_STEP: return fmin(form->from, form->to);
    case OVR_HISTORY_CONSTANT: break;
    }
    return 1;
}

ovr_history *ovr_history_create(const ovr_history_form *given,
                                const ovr_allocator *allocator, ovr_error *err)
{
    ovr_arena arena = ovr_arena_make(allocator);
    ovr_history *history;
    ovr_history_form own, *form = &own;
    if (OVR_TAKE(ovr_history_form, form, given, err) || check_form(form, err))
        return NULL;
    history = ovr_arena_take(&arena, 1, sizeof *history, err);
    if (!history)
        return NULL;
    history->form = *form;
    history->scale = 1;
    history->form.T = history->form.value = NULL;
    history->arena = arena;
    if (form->kind == OVR_HISTORY_TABLE && make_table(history, form, err)) {
        ovr_history_free(history);
        return NULL;
    }
    history->minimum = minimum(history);
    return history;
}

void ovr_history_free(ovr_history *history)
{
    ovr_arena arena;
    if (!history)
        return;
    if (history->interp)
        gsl_interp_free(history->interp);
    arena = history->arena;
    ovr_arena_release(&arena);
}

ovr_status ovr_history_scale(ovr_history **history, double factor,
                             const ovr_allocator *allocator, ovr_error *err)
{
    const ovr_history_form constant = ovr_history_form_default();
    if (!*history)
        *history = ovr_history_create(&constant, allocator, err);
    if (!*history)
        return OVR_NO_MEMORY;
    (*history)->scale *= factor;
    return OVR_OK;
}

/* --------------------------------------------------------------- values */

static double smoothstep(double y)
{
    return y * y * y * (10 + y * (6 * y - 15));
}

/* At T = start the value is still `from`, so that a run starting there begins
 * before the jump. */
static double ramp_value(const ovr_history_form *form, double T)
{
    double t = T - form->start;
    if (t <= 0)
        return form->from;
    if (t >= form->duration)
        return form->to;
    return form->from +
           (form->to - form->from) * smoothstep(t / form->duration);
}

static double table_value(const ovr_history *history, double T)
{
    size_t n = history->form.points;
    double value = NAN;
    if (T <= history->T[0])
        return history->value[0];
    if (T >= history->T[n - 1])
        return history->value[n - 1];
    gsl_interp_eval_e(history->interp, history->T, history->value, T, NULL,
                      &value);
    return value;
}

static double sine_phase(const ovr_history_form *form, double T)
{
    return 2 * 3.14159265358979323846 * (T - form->start) / form->period;
}

double ovr_history_end(const ovr_history *history)
{
    const ovr_history_form *form = history ? &history->form : NULL;
    if (!ovr_history_varies(history))
        return 0;
    if (form->kind == OVR_HISTORY_TABLE)
        return history->T[form->points - 1];
    return form->kind == OVR_HISTORY_SINE ? INFINITY
                                          : form->start + form->duration;
}

static double unscaled(const ovr_history *history, double T)
{
    const ovr_history_form *form = &history->form;
    switch (form->kind) {
    case OVR_HISTORY_CONSTANT: break;
    case OVR_HISTORY_RAMP:
    case OVR_HISTORY_STEP: return ramp_value(form, T);
    case OVR_HISTORY_SINE:
        if (T > form->start)
            return form->mean + form->amplitude * sin(sine_phase(form, T));
        return form->mean;
    case OVR_HISTORY_TABLE: return table_value(history, T);
    }
    return 1;
}

double ovr_history_value(const ovr_history *history, double T)
{
    if (!history)
        return 1;
    return isnan(T) ? history->scale : history->scale * unscaled(history, T);
}

double ovr_slip_at(const ovr_contact *c, const ovr_history *speed,
                   const ovr_history *sliding, double T)
{
    if (sliding)
        return ovr_history_value(sliding, T);
    return ovr_history_value(speed, T) * (c->u1_ratio - c->u2_ratio);
}

double ovr_speed_at(const ovr_contact *c, const ovr_history *speed,
                    const ovr_history *sliding, int k, double T)
{
    double V = ovr_slip_at(c, speed, sliding, T);
    return ovr_history_value(speed, T) + (k ? -V : V) / 2;
}

bool ovr_history_varies(const ovr_history *history)
{
    return history && history->form.kind != OVR_HISTORY_CONSTANT;
}

double ovr_history_min(const ovr_history *history)
{
    return history ? history->scale * history->minimum : 1;
}

bool ovr_history_reverses(const ovr_history *history)
{
    return ovr_history_min(history) < 0;
}

bool ovr_history_begins_backward(const ovr_history *history)
{
    const double soon = 1e-3;
    double Cu = ovr_history_value(history, 0);
    return Cu < 0 || (!(Cu > 0) && ovr_history_integral(history, soon) < 0);
}

/* --------------------------------------------------------------- slopes */

/* 30 y^2 (1 - y)^2 */
static double ramp_slope(const ovr_history_form *form, double T)
{
    double y = (T - form->start) / form->duration;
    if (!(form->duration > 0) || !(y > 0 && y < 1))
        return 0;
    return (form->to - form->from) / form->duration * 30 * y * y * (1 - y) *
           (1 - y);
}

static double sine_slope(const ovr_history_form *form, double T)
{
    const double turn = 2 * 3.14159265358979323846 / form->period;
    if (T < form->start)
        return 0;
    return form->amplitude * turn * cos(sine_phase(form, T));
}

/* At the ends, returns the slope inside. It also does so for an interval after
 * the last point, in which the last step of a run to that point may end. */
static double table_slope(const ovr_history *history, double T)
{
    const double *t = &history->T[history->form.points - 1];
    double slope = 0;
    if (T >= history->T[0] && T <= t[0] + (t[0] - t[-1]))
        gsl_interp_eval_deriv_e(history->interp, history->T, history->value,
                                fmin(T, t[0]), NULL, &slope);
    return slope;
}

static double unscaled_slope(const ovr_history *history, double T)
{
    switch (history->form.kind) {
    case OVR_HISTORY_CONSTANT: break;
    case OVR_HISTORY_RAMP:
    case OVR_HISTORY_STEP: return ramp_slope(&history->form, T);
    case OVR_HISTORY_SINE: return sine_slope(&history->form, T);
    case OVR_HISTORY_TABLE: return table_slope(history, T);
    }
    return 0;
}

double ovr_history_slope(const ovr_history *history, double T)
{
    return ovr_history_varies(history) && !isnan(T)
               ? history->scale * unscaled_slope(history, T)
               : 0;
}

/* ------------------------------------------------------------ integrals */

/* The three functions below are integrals from the start (or first point) of
 * the history to T. */

static double ramp_integral(const ovr_history_form *form, double T)
{
    double t = T - form->start, d = form->duration, y;
    if (t <= 0)
        return form->from * t;
    if (t >= d)
        return (form->from + form->to) * d / 2 + form->to * (t - d);
    y = t / d;
    return form->from * t +
           (form->to - form->from) * d * y * y * y * y * (2.5 + y * (y - 3));
}

static double sine_integral(const ovr_history_form *form, double T)
{
    double half = sin(sine_phase(form, T) / 2);
    if (T <= form->start)
        return form->mean * (T - form->start);
    /* 1 - cos(phase) = 2 sin^2(phase/2), without cancellation */
    return form->mean * (T - form->start) + form->amplitude * form->period /
                                                3.14159265358979323846 * half *
                                                half;
}

static double table_integral(const ovr_history *history, double T)
{
    size_t n = history->form.points;
    double first = history->T[0], last = history->T[n - 1];
    if (T <= first)
        return (T - first) * history->value[0];
    if (T >= last)
        return history->integral[n - 1] + (T - last) * history->value[n - 1];
    size_t k = gsl_interp_bsearch(history->T, T, 0, n - 1);
    return history->integral[k] + beyond_point(history, k, T);
}

static double unscaled_integral(const ovr_history *history, double T)
{
    const ovr_history_form *form = &history->form;
    switch (form->kind) {
    case OVR_HISTORY_CONSTANT: break;
    case OVR_HISTORY_RAMP:
    case OVR_HISTORY_STEP:
        return ramp_integral(form, T) - ramp_integral(form, 0);
    case OVR_HISTORY_SINE:
        return sine_integral(form, T) - sine_integral(form, 0);
    case OVR_HISTORY_TABLE:
        return table_integral(history, T) - table_integral(history, 0);
    }
    return T;
}

double ovr_history_integral(const ovr_history *history, double T)
{
    return history ? history->scale * unscaled_integral(history, T) : T;
}

double ovr_surface_speed(const ovr_history *speed, const ovr_history *sliding,
                         double ratio, int surface, double T)
{
    double Cu = ovr_history_value(speed, T);
    if (!sliding)
        return ratio * Cu;
    return Cu + (surface == 1 ? 0.5 : -0.5) * ovr_history_value(sliding, T);
}

double ovr_surface_distance(const ovr_history *speed,
                            const ovr_history *sliding, double ratio,
                            int surface, double T)
{
    double distance = ovr_history_integral(speed, T);
    if (!sliding)
        return ratio * distance;
    return distance +
           (surface == 1 ? 0.5 : -0.5) * ovr_history_integral(sliding, T);
}
