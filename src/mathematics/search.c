/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "mathematics/search.h"

#include <float.h>
#include <math.h>
#include <string.h>

enum { ATTEMPTS = 6, STEPS = 200, ABOUT = 5 };

/* A value q at x; s is x on the search axis, linear or logarithmic. */
typedef struct point {
    double s, q;
} point;

typedef struct searching {
    const ovr_search *p;
    ovr_search_result *r;
    bool geometric;
    point known[OVR_SEARCH_MAX]; /* in the order of evaluation */
    size_t count;
    ovr_error *err;
} searching;

/* ------------------------------------------------------------------- axis */

/* True if points between the ends have equal ratios (a logarithmic axis). */
static bool is_geometric(double from, double to)
{
    double ratio = fabs(to) > fabs(from) ? to / from : from / to;
    return from * to > 0 && ratio >= 4;
}

static double along(const searching *w, double x)
{
    if (!w->geometric)
        return x;
    return x > 0 ? log(x) : -log(-x);
}

/* Converts s to x; at the ends returns exactly the given values. */
static double x_of(const searching *w, double s)
{
    const ovr_search *p = w->p;
    double x = s;
    if (s == along(w, p->from))
        return p->from;
    if (s == along(w, p->to))
        return p->to;
    if (w->geometric)
        x = p->from > 0 ? exp(s) : -exp(-s);
    return fmin(fmax(x, p->from), p->to);
}

/* Returns a relative distance at s along the axis; near x = 0 relative to a
 * hundredth of the range. */
static double distance(const searching *w, double s, double relative)
{
    if (w->geometric)
        return relative;
    return relative * fmax(fabs(s), 0.01 * (w->p->to - w->p->from));
}

/* True if q is above the target; for an inequality, true if it holds. */
static bool is_above(const searching *w, double q)
{
    return w->p->sense < 0 ? q <= w->p->target : q >= w->p->target;
}

/* ------------------------------------------------------------- evaluations */

static ovr_status evaluate(searching *w, size_t n, const double *s, double *q)
{
    double x[OVR_SEARCH_MAX] = {0};
    ovr_status status;
    if (w->count + n > OVR_SEARCH_MAX)
        return ovr_fail(w->err, OVR_BAD_INPUT,
                        "the search did not end within %d evaluations; use a "
                        "narrower range or a larger tolerance",
                        OVR_SEARCH_MAX);
    for (size_t k = 0; k < n; k++) {
        x[k] = x_of(w, s[k]);
        q[k] = NAN;
    }
    status = w->p->evaluate(w->p->data, n, x, q, w->err);
    for (size_t k = 0; !status && k < n; k++)
        w->known[w->count++] = (point){s[k], q[k]};
    return status;
}

/* ------------------------------------------------------------------- scan */

static ovr_status scan(searching *w, point *to, size_t n)
{
    double a = along(w, w->p->from), b = along(w, w->p->to);
    double s[OVR_SEARCH_MAX], q[OVR_SEARCH_MAX];
    ovr_status status;
    for (size_t k = 0; k < n; k++)
        s[k] = k + 1 == n ? b : a + (b - a) * (double)k / (double)(n - 1);
    status = evaluate(w, n, s, q);
    for (size_t k = 0; !status && k < n; k++)
        to[k] = (point){s[k], q[k]};
    return status;
}

/* Determines from the scan the range of the function and whether it is
 * monotone within 1e-4 of that range. */
static void judge(searching *w, const point *p, size_t n)
{
    ovr_search_result *r = w->r;
    double last = NAN, up = 0, down = 0, first = NAN;
    r->minimum = INFINITY;
    r->maximum = -INFINITY;
    for (size_t k = 0; k < n; k++) {
        if (isnan(p[k].q))
            continue;
        r->minimum = fmin(r->minimum, p[k].q);
        r->maximum = fmax(r->maximum, p[k].q);
        up = fmax(up, p[k].q - last); /* NAN before the first value: ignored */
        down = fmax(down, last - p[k].q);
        first = isnan(last) ? p[k].q : first;
        r->from = isnan(last) ? x_of(w, p[k].s) : r->from;
        r->to = x_of(w, p[k].s);
        last = p[k].q;
    }
    r->rises = last > first;
    r->monotone = fmin(up, down) <= 1e-4 * (r->maximum - r->minimum);
}

/* ------------------------------------------------------------------ bracket */

typedef struct bracket {
    point a, b; /* on different sides of the target */
    bool found;
} bracket;

/* Bisects between the last value and a point without a value for a further
 * change of side. */
static ovr_status bisect_towards(searching *w, point good, double bad,
                                 bracket *found)
{
    ovr_status status = OVR_OK;
    for (int k = 0; !status && k < ATTEMPTS && !found->found; k++) {
        point m = {(good.s + bad) / 2, NAN};
        status = evaluate(w, 1, &m.s, &m.q);
        if (isnan(m.q))
            bad = m.s;
        else if (is_above(w, m.q) == is_above(w, good.q))
            good = m;
        else
            *found = (bracket){good.s < m.s ? good : m, good.s < m.s ? m : good,
                               true};
        if (good.s < bad)
            w->r->to = x_of(w, fmax(good.s, along(w, w->r->to)));
        else
            w->r->from = x_of(w, fmin(good.s, along(w, w->r->from)));
    }
    return status;
}

/* Lists all changes of side between neighbouring values. */
static size_t list_changes(searching *w, const point *p, size_t n,
                           bracket *changes)
{
    const point *last = NULL;
    size_t count = 0;
    for (size_t k = 0; k < n; k++) {
        if (isnan(p[k].q))
            continue;
        if (last && is_above(w, last->q) != is_above(w, p[k].q))
            changes[count++] = (bracket){*last, p[k], true};
        last = &p[k];
    }
    w->r->places = count < OVR_SEARCH_PLACES ? count : OVR_SEARCH_PLACES;
    for (size_t k = 0; k < w->r->places; k++) {
        w->r->place[k][0] = x_of(w, changes[k].a.s);
        w->r->place[k][1] = x_of(w, changes[k].b.s);
    }
    return count;
}

/* Returns the outermost sign change of an inequality. The condition must not
 * hold at the outer end of the range. */
static bracket outermost(searching *w, const bracket *changes, size_t count)
{
    bool largest = w->p->which > 0;
    bracket c = changes[largest ? count - 1 : 0];
    c.found = !is_above(w, largest ? c.b.q : c.a.q);
    if (!c.found)
        w->r->end = OVR_SEARCH_BEYOND;
    return c;
}

static ovr_status find_bracket(searching *w, const point *p, size_t n,
                               bracket *found)
{
    bracket changes[OVR_SEARCH_MAX];
    size_t count = list_changes(w, p, n, changes), first = 0, last = n - 1;
    ovr_status status = OVR_OK;
    found->found = false;
    w->r->end = OVR_SEARCH_MISSED;
    if (count > 1 && !w->p->which)
        w->r->end = OVR_SEARCH_SEVERAL;
    else if (count)
        *found = w->p->which ? outermost(w, changes, count) : changes[0];
    if (count)
        return OVR_OK;
    while (first < n && isnan(p[first].q))
        first++;
    while (last > first && isnan(p[last].q))
        last--;
    if (first == n) {
        w->r->end = OVR_SEARCH_NOTHING;
        return OVR_OK;
    }
    if (last + 1 < n)
        status = bisect_towards(w, p[last], p[last + 1].s, found);
    if (!status && !found->found && first > 0)
        status = bisect_towards(w, p[first], p[first - 1].s, found);
    if (!status && !found->found && w->p->sense && is_above(w, p[first].q))
        w->r->end = OVR_SEARCH_BEYOND;
    return status;
}

/* ------------------------------------------------------------------ Brent */

/* Finds a bracket without the point `bad` that has no value: bisects towards it
 * from both ends in turn. */
static ovr_status bracket_without(searching *w, bracket *in, double bad,
                                  int *attempts)
{
    point near = in->a, far = in->b;
    ovr_status status = OVR_OK;
    in->found = false;
    while (!status && !in->found && (*attempts)++ < ATTEMPTS) {
        point m = {(near.s + bad) / 2, NAN};
        status = evaluate(w, 1, &m.s, &m.q);
        if (isnan(m.q)) {
            bad = m.s;
            continue;
        }
        if (is_above(w, m.q) != is_above(w, near.q)) {
            *in = (bracket){near, m, true};
            break;
        }
        near = far; /* alternates the ends */
        far = m;
    }
    return status;
}

/* Least-squares parabola in s - s0 by orthogonal polynomials: its slope at s0,
 * and the standard deviation of n values about it with n - 3 degrees of
 * freedom. */
typedef struct fitted {
    double slope, scatter;
} fitted;

static fitted parabola(const point *p, size_t n, double s0, double half)
{
    double A[3][4] = {{0}}, c[3], sum = 0;
    for (size_t k = 0; k < n; k++) {
        double t = (p[k].s - s0) / half, v[4] = {1, t, t * t, p[k].q - p[0].q};
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 4; j++)
                A[i][j] += v[i] * v[j];
    }
    for (int i = 0; i < 3; i++)
        for (int j = i + 1; j < 3; j++) {
            double f = A[j][i] / A[i][i];
            for (int l = i; l < 4; l++)
                A[j][l] -= f * A[i][l];
        }
    for (int i = 2; i >= 0; i--) {
        c[i] = A[i][3];
        for (int j = i + 1; j < 3; j++)
            c[i] -= A[i][j] * c[j];
        c[i] /= A[i][i];
    }
    for (size_t k = 0; k < n; k++) {
        double t = (p[k].s - s0) / half;
        sum += pow(p[k].q - p[0].q - (c[0] + t * (c[1] + t * c[2])), 2);
    }
    return (fitted){c[1] / half, sqrt(sum / (double)(n - 3))};
}

/* Lists the values within sqrt(tolerance) of s0. In this range a parabola
 * approximates smooth functions within the tolerance. */
static size_t list_about(const searching *w, double s0, double half, point *to)
{
    size_t n = 0;
    for (size_t k = 0; k < w->count; k++)
        if (fabs(w->known[k].s - s0) <= 1.001 * half && !isnan(w->known[k].q))
            to[n++] = w->known[k];
    return n;
}

/* Computes slope and scatter from the known values near s0; false if there are
 * too few. */
static bool judge_about(searching *w, double s0)
{
    point p[OVR_SEARCH_MAX];
    double half = distance(w, s0, sqrt(w->p->tolerance));
    size_t n = list_about(w, s0, half, p);
    if (n < ABOUT)
        return false;
    fitted found = parabola(p, n, s0, half);
    w->r->slope = found.slope;
    w->r->scatter = found.scatter;
    w->r->scatters = !w->p->exact &&
                     w->r->scatter >
                         fabs(w->r->slope) * distance(w, s0, w->p->tolerance);
    if (w->geometric) /* chain rule for s = ln x */
        w->r->slope /= fabs(x_of(w, s0));
    return isfinite(w->r->slope);
}

/* Evaluates further points on both sides of the answer. */
static ovr_status probe(searching *w, double s0)
{
    static const double at[] = {1, -1, 0.5, -0.5, 0.75, -0.75, 0.25};
    double half = distance(w, s0, sqrt(w->p->tolerance)), s[ABOUT], q[ABOUT];
    point p[OVR_SEARCH_MAX];
    size_t known = list_about(w, s0, half, p), n = 0;
    for (size_t k = 0; k < sizeof at / sizeof *at && known + n < ABOUT; k++) {
        double x = s0 + at[k] * half;
        if (x > along(w, w->p->from) && x < along(w, w->p->to))
            s[n++] = x;
    }
    return n ? evaluate(w, n, s, q) : OVR_OK;
}

/* Returns the step from b by inverse quadratic interpolation or the secant; NAN
 * if bisection is better (Brent, 4.2). */
static double interpolated(point a, point b, point c, double middle, double e)
{
    double s = b.q / a.q, p, q, r;
    if (a.s == c.s) {
        p = 2 * middle * s;
        q = 1 - s;
    } else {
        q = a.q / c.q;
        r = b.q / c.q;
        p = s * (2 * middle * q * (q - r) - (b.s - a.s) * (r - 1));
        q = (q - 1) * (r - 1) * (s - 1);
    }
    if (p > 0)
        q = -q;
    else
        p = -p;
    return 2 * p < fmin(3 * middle * q, fabs(e * q)) ? p / q : NAN;
}

/* Solves q = target by Brent's method. *in becomes the last bracket with the
 * better end first; *bad is the argument of a missing value. */
static ovr_status brent(searching *w, bracket *in, double *bad)
{
    double target = w->p->target, e, d;
    point a = in->a, b = in->b, c;
    ovr_status status = OVR_OK;
    a.q -= target;
    b.q -= target;
    c = a;
    d = e = b.s - a.s;
    *bad = NAN;
    for (int k = 0; !status && k < STEPS; k++) {
        double close, middle, step;
        if (is_above(w, b.q + target) == is_above(w, c.q + target)) {
            c = a;
            d = e = b.s - a.s;
        }
        if (fabs(c.q) < fabs(b.q)) {
            a = b;
            b = c;
            c = a;
        }
        close = 2 * DBL_EPSILON * fabs(b.s) +
                0.5 * distance(w, b.s, w->p->tolerance);
        middle = 0.5 * (c.s - b.s);
        in->a = (point){b.s, b.q + target};
        in->b = (point){c.s, c.q + target};
        if (fabs(middle) <= close ||
            (!w->p->sense && !w->p->exact &&
             fabs(b.q) <= 1e-10 * fabs(target)) ||
            (!w->p->exact && judge_about(w, b.s) && w->r->scatters))
            break;
        step = fabs(e) >= close && fabs(a.q) > fabs(b.q)
                   ? interpolated(a, b, c, middle, e)
                   : NAN;
        e = isnan(step) ? middle : d;
        d = isnan(step) ? middle : step;
        a = b;
        b.s += fabs(d) > close ? d : copysign(close, middle);
        status = evaluate(w, 1, &b.s, &b.q);
        if (!status && isnan(b.q)) {
            *bad = b.s;
            break;
        }
        b.q -= target;
    }
    return status;
}

/* ------------------------------------------------------------------ answer */

/* Stores the answer: for an equation the bracket end closer to the target, for
 * an inequality the end that satisfies it. */
static void store_answer(searching *w, const bracket *in)
{
    ovr_search_result *r = w->r;
    bool second = w->p->sense && !is_above(w, in->a.q);
    r->end = OVR_SEARCH_FOUND;
    r->value = x_of(w, second ? in->b.s : in->a.s);
    r->at_value = second ? in->b.q : in->a.q;
    r->low = x_of(w, fmin(in->a.s, in->b.s));
    r->high = x_of(w, fmax(in->a.s, in->b.s));
}

static ovr_status close_in(searching *w, bracket *in)
{
    int attempts = 0;
    double bad;
    ovr_status status = brent(w, in, &bad);
    while (!status && !isnan(bad)) {
        w->r->end = OVR_SEARCH_BROKEN;
        status = bracket_without(w, in, bad, &attempts);
        if (status || !in->found)
            return status;
        status = brent(w, in, &bad);
    }
    if (status)
        return status;
    store_answer(w, in);
    if (!judge_about(w, along(w, w->r->value)) &&
        (status = probe(w, along(w, w->r->value))) == OVR_OK &&
        !judge_about(w, along(w, w->r->value))) {
        w->r->slope = (in->b.q - in->a.q) /
                      (x_of(w, in->b.s) - x_of(w, in->a.s));
        w->r->scatter = NAN;
        w->r->scatters = false;
    }
    return status;
}

ovr_status ovr_search_run(const ovr_search *search, ovr_search_result *result,
                          ovr_error *err)
{
    searching w = {.p = search, .r = result, .err = err};
    point points[OVR_SEARCH_MAX / 2];
    size_t n = search->scan ? search->scan : OVR_SEARCH_SCAN;
    bracket in = {.found = false};
    ovr_status status;
    *result = (ovr_search_result){.end = OVR_SEARCH_NOTHING,
                                  .value = NAN,
                                  .at_value = NAN,
                                  .low = NAN,
                                  .high = NAN,
                                  .slope = NAN,
                                  .scatter = NAN,
                                  .from = NAN,
                                  .to = NAN};
    w.geometric = is_geometric(search->from, search->to);
    n = n > OVR_SEARCH_MAX / 2 ? OVR_SEARCH_MAX / 2 : n < 2 ? 2 : n;
    status = scan(&w, points, n);
    if (status)
        return status;
    judge(&w, points, n);
    status = find_bracket(&w, points, n, &in);
    return !status && in.found ? close_in(&w, &in) : status;
}
