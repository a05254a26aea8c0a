/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Form removal from profiles: mean, line, polynomial, circle, or automatic
 * choice.
 *
 * Circle. With x measured from the middle of the trace, the sine of the slope
 * is S + K x, where K is the curvature. The height is
 *
 *     z(x) = h + x (2S + K x)/(c_0 + c),  c = sqrt(1 - (S + K x)^2),
 *
 * with c_0 = c(0). There is no division by K: K = 0 is a line, K > 0 a concave
 * circle, and the radius is 1/|K|. The circle minimizes the sum of squared
 * height differences (Gauss-Newton method). The start is h = S = K = 0, so that
 * the first step yields the least-squares parabola. With q = S (2S + K x)/(c_0
 * + c) + c_0,
 *
 *     dz/dS = x q/(c c_0),  dz/dK = x^2 q^2/((1 + S (S + K x) + c c_0) c).
 *
 * If heights are in units of eta metres and lengths in units of ell metres, the
 * sine is e (S + K x) with e = eta/ell. If only the units b and b^2/R are
 * known, e is 0, and the circle becomes a parabola.
 *
 * The automatic choice tries a line, a circle and polynomials of degree 4 and
 * 6. A later form is used only if its residual has less than a quarter of the
 * variance.
 */
#include "surface/form.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "surface/conditioning.h"

/* ----------------------------------------------------------------- circle */

typedef struct circle {
    double h, S, K;
    double middle; /* origin of x */
    double e;
} circle;

/* Returns the height at x and its derivatives by h, S and K; false outside the
 * circle. */
static bool on_circle(const circle *o, double x, double *z, double by[3])
{
    double s = o->e * (o->S + o->K * x), s0 = o->e * o->S;
    double c = sqrt(1 - s * s), c0 = sqrt(1 - s0 * s0), q;
    if (!(c > 0.05 && c0 > 0.05)) /* steeper than 87 degrees */
        return false;
    q = s0 * (s + s0) / (c0 + c) + c0;
    *z = o->h + x * (2 * o->S + o->K * x) / (c0 + c);
    by[0] = 1;
    by[1] = x * q / (c * c0);
    by[2] = x * x * q * q / ((1 + s0 * s + c * c0) * c);
    return true;
}

/* Returns the sum of squared residuals and computes the normal equations of the
 * next step; INFINITY if the circle does not extend over the whole trace. */
static double normal(const circle *o, const ovr_points *of, double A[3][3],
                     double g[3])
{
    const double *x = of->x, *z = of->y;
    double sum = 0;
    memset(A, 0, 9 * sizeof(double));
    memset(g, 0, 3 * sizeof(double));
    for (size_t i = 0; i < of->n; i++) {
        double w = ovr_share(of->n, x, i), at, by[3], r;
        if (!on_circle(o, x[i] - o->middle, &at, by))
            return INFINITY;
        r = z[i] - at;
        sum += w * r * r;
        for (int j = 0; j < 3; j++) {
            g[j] += w * by[j] * r;
            for (int k = 0; k < 3; k++)
                A[j][k] += w * by[j] * by[k];
        }
    }
    return sum;
}

/* Solves A d = g by elimination; A is symmetric and positive definite. */
static bool solve(double A[3][3], const double g[3], double d[3])
{
    for (int k = 0; k < 3; k++)
        d[k] = g[k];
    for (int k = 0; k < 3; k++) {
        if (!(A[k][k] > 0))
            return false;
        for (int i = k + 1; i < 3; i++) {
            double f = A[i][k] / A[k][k];
            for (int j = k; j < 3; j++)
                A[i][j] -= f * A[k][j];
            d[i] -= f * d[k];
        }
    }
    for (int k = 2; k >= 0; k--) {
        for (int j = k + 1; j < 3; j++)
            d[k] -= A[k][j] * d[j];
        d[k] /= A[k][k];
    }
    return isfinite(d[0]) && isfinite(d[1]) && isfinite(d[2]);
}

static circle moved(const circle *o, const double d[3], double by)
{
    circle next = *o;
    next.h += by * d[0];
    next.S += by * d[1];
    next.K += by * d[2];
    return next;
}

/* Performs one Gauss-Newton step, halved until the residual decreases; false if
 * it does not. */
static bool improve(circle *o, const ovr_points *of, double *left)
{
    double A[3][3], g[3], d[3], unused[3][3], aside[3];
    normal(o, of, A, g);
    if (!solve(A, g, d))
        return false;
    for (double by = 1; by > 1e-3; by /= 2) {
        circle next = moved(o, d, by);
        double sum = normal(&next, of, unused, aside);
        if (sum < *left) {
            bool gained = *left - sum > 1e-14 * *left;
            *o = next;
            *left = sum;
            return gained;
        }
    }
    return false;
}

static circle fit_circle(const ovr_points *of, double e)
{
    circle o = {0, 0, 0, (of->x[0] + of->x[of->n - 1]) / 2, e};
    double A[3][3], g[3], left = normal(&o, of, A, g);
    for (int step = 0; step < 100 && improve(&o, of, &left);)
        step++;
    return o;
}

static void subtract_circle(const circle *o, size_t n, const double *x,
                            double *z)
{
    double at, by[3];
    for (size_t i = 0; i < n; i++)
        if (on_circle(o, x[i] - o->middle, &at, by))
            z[i] -= at;
}

/* ------------------------------------------------------------------ forms */

/* Returns the ratio of the profile's height unit to its length unit, 0 if
 * unknown. */
static double ratio(const ovr_profile *p)
{
    double along = p->view.scaled_x ? p->b : 1;
    double across = p->view.scaled_z ? p->height : 1;
    return along > 0 && across > 0 ? across / along : 0;
}

/* Writes "circle of radius 12.7 mm, a crown": R = ell/(e K), in units of R if
 * only b and b^2/R are known. */
static void name_circle(const ovr_profile *p, const circle *o, char *text,
                        size_t capacity)
{
    const char *shape = o->K > 0 ? "a hollow" : "a crown";
    double along = p->view.scaled_x ? p->b : 1;
    if (o->e > 0)
        snprintf(text, capacity, "circle of radius %s, %s,",
                 ovr_metres(along / fabs(o->e * o->K)).text, shape);
    else
        snprintf(text, capacity, "circle of radius %.4g R, %s,", 1 / fabs(o->K),
                 shape);
}

enum { CIRCLE = -1, FORM_NAME = 80 };

/* The first n points of a profile; `work` has 3 n elements. */
typedef struct trace {
    ovr_profile *p;
    size_t n;
    double *work;
} trace;

/* Subtracts a polynomial of the given degree, or the circle, from the heights z
 * of the trace; writes its name to `text`. */
static void subtract_form(const trace *t, int degree, double *z,
                          char text[FORM_NAME])
{
    const double *x = t->p->x;
    if (degree == CIRCLE) {
        circle o = fit_circle(&(ovr_points){t->n, x, z}, ratio(t->p));
        subtract_circle(&o, t->n, x, z);
        name_circle(t->p, &o, text, FORM_NAME);
        return;
    }
    ovr_level(t->n, x, z, degree, t->work);
    if (degree < 2)
        snprintf(text, FORM_NAME, "%s", degree ? "line" : "mean");
    else
        snprintf(text, FORM_NAME, "polynomial of degree %d", degree);
}

static double root_mean_square(size_t n, const double *x, const double *z)
{
    double sum = 0, mean = 0, length = x[n - 1] - x[0];
    for (size_t i = 0; i < n; i++)
        mean += z[i] * ovr_share(n, x, i) / length;
    for (size_t i = 0; i < n; i++)
        sum += (z[i] - mean) * (z[i] - mean) * ovr_share(n, x, i) / length;
    return sqrt(sum);
}

static ovr_status subtract_best_form(const trace *t, double dust,
                                     ovr_error *err)
{
    static const int degrees[] = {CIRCLE, 4, 6};
    ovr_profile *p = t->p;
    char best[FORM_NAME], other[FORM_NAME];
    double line, left;
    double *kept = ovr_arena_take(&p->arena, t->n, 2 * sizeof *kept, err);
    double *tried;
    if (!kept)
        return OVR_NO_MEMORY;
    tried = kept + t->n;
    memcpy(kept, p->z, t->n * sizeof *kept);
    subtract_form(t, 1, p->z, best);
    line = left = root_mean_square(t->n, p->x, p->z);
    for (size_t k = 0; k < 3 && left > dust; k++) {
        double now;
        memcpy(tried, kept, t->n * sizeof *tried);
        subtract_form(t, degrees[k], tried, other);
        now = root_mean_square(t->n, p->x, tried);
        if (!(now < left / 2))
            continue;
        left = now;
        memcpy(p->z, tried, t->n * sizeof *tried);
        memcpy(best, other, sizeof best);
    }
    ovr_profile_note(p,
                     "levelled (auto): %s subtracted; it leaves Pq %s, a "
                     "line %s",
                     best, ovr_across(p, left).text, ovr_across(p, line).text);
    return OVR_OK;
}

static double largest(size_t n, const double *z)
{
    double maximum = 0;
    for (size_t i = 0; i < n; i++)
        maximum = fmax(maximum, fabs(z[i]));
    return maximum;
}

ovr_status ovr_take_form(ovr_profile *p, const ovr_conditioning *how, size_t n,
                         double *work, ovr_error *err)
{
    const trace t = {p, n, work};
    double dust = 1e-14 * largest(n, p->z); /* rounding error, not roughness */
    ovr_status status = OVR_OK;
    if (how->level == OVR_LEVEL_NONE)
        return OVR_OK;
    if (how->level == OVR_LEVEL_ENDS) {
        ovr_level_ends(n, p->x, p->z);
        ovr_profile_note(p, "levelled: line through its ends subtracted");
    } else if (how->level == OVR_LEVEL_AUTO) {
        status = subtract_best_form(&t, dust, err);
    } else {
        char text[FORM_NAME];
        subtract_form(&t,
                      how->level == OVR_LEVEL_MEAN     ? 0
                      : how->level == OVR_LEVEL_LINE   ? 1
                      : how->level == OVR_LEVEL_CIRCLE ? CIRCLE
                                                       : how->degree,
                      p->z, text);
        ovr_profile_note(p, "levelled: %s subtracted", text);
    }
    if (!status && largest(n, p->z) < dust)
        memset(p->z, 0, n * sizeof *p->z);
    return status;
}
