/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Times at which a feature, one of its copies or one of its ends reaches a
 * position.
 *
 * The position X_k(T) = start + (u_k/um) I(T), where I is the integral of Cu,
 * is inverted by bisection. If the motion can reverse (entrainment speed with
 * reversals, or a history of the sliding), the time is searched in steps and
 * then bisected.
 */
#include <math.h>

#include "contact/contact.h"
#include "contact/history.h"
#include "surface/features.h"
#include "surface/surfaces.h"

double ovr_surfaces_centre(const ovr_surfaces *surfaces, size_t feature,
                           double T)
{
    if (!surfaces)
        return NAN;
    const ovr_feature *f = ovr_surfaces_feature(surfaces, feature);
    return f ? ovr_feature_centre(surfaces, f, T) : NAN;
}

/* True if the direction of motion can reverse. */
static bool may_reverse(const ovr_surfaces *surfaces)
{
    return surfaces->sliding || ovr_history_reverses(surfaces->speed);
}

/* Returns the first T in [after, until] at which the feature has moved by
 * `far`, if its motion can reverse. Searches in steps of 0.05 b/u_m, then
 * bisects. */
static double reversing_time_of(const ovr_surfaces *surfaces,
                                const ovr_feature *f, double far, double after,
                                double until)
{
    const double step = 0.05;
    enum { MAX = 100000 };
    bool above = ovr_feature_moved(surfaces, f, after) > far;
    double low = after;
    for (int k = 0; k < MAX && low < until; k++) {
        double high = fmin(low + step, until);
        if ((ovr_feature_moved(surfaces, f, high) > far) == above) {
            low = high;
            continue;
        }
        for (int m = 0; m < 60; m++) {
            double middle = 0.5 * (low + high);
            if ((ovr_feature_moved(surfaces, f, middle) > far) == above)
                low = middle;
            else
                high = middle;
        }
        return high;
    }
    return INFINITY;
}

/* Returns T in [after, until] with I(T) = way; I never decreases. */
static double time_of(const ovr_surfaces *surfaces, const ovr_feature *f,
                      double distance, double after, double until)
{
    const ovr_history *speed = surfaces->speed;
    double low = after, high = until;
    if (may_reverse(surfaces))
        return reversing_time_of(surfaces, f, f->ratio * distance, after,
                                 until);
    if (!speed)
        return distance > after && distance <= until ? distance : INFINITY;
    if (!(ovr_history_integral(speed, low) < distance) ||
        ovr_history_integral(speed, high) < distance)
        return INFINITY;
    for (int k = 0; k < 200 && high - low > 1e-15 * high; k++) {
        double middle = low + 0.5 * (high - low);
        if (ovr_history_integral(speed, middle) < distance)
            low = middle;
        else
            high = middle;
    }
    return high;
}

/* Returns the time at which the point at `offset` from the centre reaches X. */
static double time_at(const ovr_surfaces *surfaces, const ovr_feature *f,
                      double offset, double X, double until)
{
    double far = X - f->start - offset, distance = far / f->ratio;
    if (may_reverse(surfaces) && !isnan(far))
        return (f->back ? far >= 0 : far <= 0)
                   ? 0
                   : reversing_time_of(surfaces, f, far, 0, until);
    if (f->ratio == 0 || isnan(distance))
        return INFINITY;
    return distance <= 0 ? 0 : time_of(surfaces, f, distance, 0, until);
}

ovr_feature_times ovr_surfaces_times(const ovr_surfaces *surfaces,
                                     size_t feature, double inlet,
                                     double outlet, double until)
{
    if (!surfaces)
        return (ovr_feature_times){0};
    const ovr_feature *f = ovr_surfaces_feature(surfaces, feature);
    ovr_feature_times never = {INFINITY, INFINITY, INFINITY}, times;
    double first, last;
    bool back;
    if (!f)
        return never;
    back = f->back;
    first = back ? -f->behind : f->ahead;
    last = back ? f->ahead + ovr_feature_last_copy(f)
                : -f->behind - ovr_feature_last_copy(f);
    times.enters = time_at(surfaces, f, first, back ? outlet : inlet, until);
    times.centre = time_at(surfaces, f, 0, 0, until);
    times.leaves = time_at(surfaces, f, last, back ? inlet : outlet, until);
    return times;
}

/* If the motion reverses, the copies on both sides of X may reach it first. A
 * feature without copies is searched alone. */
static double reversing_arrival(const ovr_surfaces *surfaces,
                                const ovr_feature *f, double X, double after,
                                double until)
{
    bool both = ovr_is_endless(f) && f->wavelength > 0;
    double p = both ? f->wavelength : f->back ? -f->repeat : f->repeat;
    double far = X - f->start, here = ovr_feature_moved(surfaces, f, after),
           T = INFINITY;
    if (isnan(p))
        return reversing_time_of(surfaces, f, far, after, until);
    double next = floor((here - far) / p);
    for (double k = next - 1; k <= next + 2; k++)
        if (both || (k >= 0 && (!f->copies || k < (double)f->copies)))
            T = fmin(T,
                     reversing_time_of(surfaces, f, far + k * p, after, until));
    return T;
}

double ovr_surfaces_arrival(const ovr_surfaces *surfaces, size_t feature,
                            double X, double after, double until)
{
    if (!surfaces)
        return NAN;
    const ovr_feature *f = ovr_surfaces_feature(surfaces, feature);
    double distance, apart, k, gone;
    bool both;
    if (!f || f->ratio == 0)
        return INFINITY;
    if (ovr_history_reverses(surfaces->speed))
        return reversing_arrival(surfaces, f, X, after, until);
    distance = (X - f->start) / f->ratio;
    both = ovr_is_endless(f) && f->wavelength > 0;
    apart = (both ? f->wavelength : f->repeat) / fabs(f->ratio);
    gone = ovr_feature_moved(surfaces, f, after) / f->ratio;
    if (apart > 0) { /* the first copy that has not passed yet */
        k = floor((gone - distance) / apart + 1e-9) + 1;
        if (!both && k < 0)
            k = 0;
        if (f->copies && k > (double)(f->copies - 1))
            return INFINITY;
        distance += k * apart;
    }
    return time_of(surfaces, f, distance, after, until);
}
