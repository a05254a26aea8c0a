/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "results/schedule.h"
#include "results/results.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_sort.h>

/* Two times nearer than this are one. */
static double slack(double T)
{
    return 1e-10 * fmax(1, fabs(T));
}

ovr_status ovr_schedule_make(ovr_schedule *s, const ovr_write_options *o,
                             ovr_arena *arena, ovr_error *err)
{
    if (o->every_steps < 0 || !(o->every_time >= 0))
        return ovr_fail(err, OVR_BAD_INPUT,
                        "snapshots every %ld steps or every %g b/u_m: must "
                        "not be negative",
                        o->every_steps, o->every_time);
    for (size_t k = 0; k < o->time_count; k++)
        if (!isfinite(o->times[k]))
            return ovr_fail(err, OVR_BAD_INPUT,
                            "snapshots: the time %g is not finite",
                            o->times[k]);
    s->every_steps = o->every_steps;
    s->every_time = o->every_time;
    s->count = o->time_count;
    s->times = ovr_arena_take(arena, s->count, sizeof *s->times, err);
    if (!s->times)
        return OVR_NO_MEMORY;
    if (s->count) {
        memcpy(s->times, o->times, s->count * sizeof *s->times);
        gsl_sort(s->times, 1, s->count);
    }
    return OVR_OK;
}

/* Number of given times up to T. */
static size_t passed(const ovr_schedule *s, double T)
{
    size_t low = 0, high = s->count;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (s->times[middle] <= T)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/* The last multiple of every_time up to T; there is none before 0. */
static double multiple(const ovr_schedule *s, double T)
{
    return T < 0 ? -1 : floor(T / s->every_time);
}

bool ovr_schedule_due(const ovr_schedule *s, long step, double T_before,
                      double T)
{
    double from = T_before + slack(T), to = T + slack(T);
    if (s->every_steps && step % s->every_steps == 0)
        return true;
    if (s->every_time > 0 && multiple(s, to) > multiple(s, from))
        return true;
    return passed(s, to) > passed(s, from);
}

double ovr_schedule_next(const ovr_schedule *s, double T)
{
    double from = T + slack(T), next = INFINITY;
    size_t k = passed(s, from);
    if (s->every_time > 0)
        next = (multiple(s, from) + 1) * s->every_time;
    return k < s->count ? fmin(next, s->times[k]) : next;
}
