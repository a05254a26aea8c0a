/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "surface/order.h"
#include "base/error.h"

#include <math.h>

static void reverse(double *a, size_t n)
{
    for (size_t i = 0; i < n / 2; i++) {
        double kept = a[i];
        a[i] = a[n - 1 - i];
        a[n - 1 - i] = kept;
    }
}

static void turn_round(ovr_profile *p, size_t n)
{
    if (!(p->x[n - 1] < p->x[0]))
        return;
    reverse(p->x, n);
    reverse(p->z, n);
    for (size_t i = 0; i < n; i++)
        p->x[i] += 0; /* no -0 */
    ovr_profile_note(p, "x decreases in the file; the profile was reversed");
}

/* Equal neighbours in x come from rounding.  When all x lie within a rounding
 * step's half (and a little) of a straight line they are put on it; else
 * points of the same x are averaged. */
static bool regular_but_rounded(const ovr_profile *p, size_t n, double *first,
                                double *step)
{
    double quantum = INFINITY, middle = (double)(n - 1) / 2;
    double mean = 0, sum = 0, squares = 0;
    for (size_t i = 0; i < n; i++) {
        double t = (double)i - middle;
        mean += (p->x[i] - p->x[0]) / (double)n;
        sum += t * (p->x[i] - p->x[0]);
        squares += t * t;
        if (i && p->x[i] > p->x[i - 1])
            quantum = fmin(quantum, p->x[i] - p->x[i - 1]);
    }
    *step = sum / squares;
    *first = p->x[0] + mean - *step * middle;
    for (size_t i = 0; i < n; i++)
        if (!(fabs(p->x[i] - *first - (double)i * *step) <= 0.6 * quantum))
            return false;
    return *step > 0;
}

static size_t average_repeats(ovr_profile *p, size_t n)
{
    size_t m = 0;
    for (size_t i = 0, j; i < n; i = j, m++) {
        double sum = 0, count = 0;
        for (j = i; j < n && p->x[j] == p->x[i]; j++)
            if (!isnan(p->z[j]))
                sum += p->z[j], count++;
        p->x[m] = p->x[i];
        p->z[m] = count > 0 ? sum / count : NAN;
    }
    return m;
}

ovr_status ovr_put_in_order(ovr_profile *p, size_t *n, const long *line,
                            ovr_error *err)
{
    bool backwards = *n > 1 && p->x[*n - 1] < p->x[0];
    size_t repeats = 0, m;
    double first, step;
    for (size_t i = 1; i < *n; i++) {
        double d = backwards ? p->x[i - 1] - p->x[i] : p->x[i] - p->x[i - 1];
        repeats += d == 0;
        if (d < 0)
            return ovr_fail_at(err, OVR_BAD_INPUT, p->file, line[i],
                               "x is not monotonic: %.9g follows %.9g", p->x[i],
                               p->x[i - 1]);
    }
    if (*n > 1)
        turn_round(p, *n);
    if (!repeats)
        return OVR_OK;
    if (regular_but_rounded(p, *n, &first, &step)) {
        ovr_profile_regular(p, *n, first, step);
        ovr_profile_note(p,
                         "x repeats %zu times because of rounding; equal "
                         "spacing assumed",
                         repeats);
        return OVR_OK;
    }
    m = average_repeats(p, *n);
    ovr_profile_note(p, "x repeats: %zu points averaged into %zu", *n, m);
    *n = m;
    return OVR_OK;
}
