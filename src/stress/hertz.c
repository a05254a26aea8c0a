/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Amplitudes of all criteria in a smooth dry contact, P = sqrt(1 - X^2).
 *     C = i (w - sqrt(w - 1) sqrt(w + 1)),
 *     C' = i (1 - w / (sqrt(w - 1) sqrt(w + 1)))
 *
 * equal to McEwen's form (K. L. Johnson, Contact Mechanics, 1985, section 4.2).
 * In free rolling the path at depth z is symmetric in tau, so its circle has
 * the centre (d(x*), 0) and the radius |tau(x*)|, x* where |tau| is largest.
 */
#include <math.h>

#include "stress/element.h"
#include "stress/stress.h"

ovr_in_plane ovr_hertz_stress(double p, double q, double x, double z)
{
    double complex w = x + I * z, root = csqrt(w - 1) * csqrt(w + 1);
    ovr_potential one = {I * (w - root), I * (1 - w / root)};
    return ovr_stress_of_both(z, one, p, q);
}

/* A criterion at one depth as a function of x, in free rolling. */
typedef struct moment {
    ovr_criterion criterion;
    double alpha, poisson, z;
    double centre; /* centre of the circle, at tau = 0 */
} moment;

static double distance(const moment *m, double x)
{
    ovr_in_plane s = ovr_hertz_stress(1, 0, x, m->z);
    double shear = hypot(s.d, s.tau);
    double across = (1 - 2 * m->poisson) * s.h; /* sigma_y - their mean */
    switch (m->criterion) {
    case OVR_CRITERION_DANG_VAN:
        return hypot(s.d - m->centre, s.tau) -
               m->alpha * 2. / 3 * (1 + m->poisson) * s.h;
    case OVR_CRITERION_VON_MISES:
        return sqrt(3 * shear * shear + across * across);
    case OVR_CRITERION_TRESCA: return fmax(shear, (fabs(across) + shear) / 2);
    default: return fabs(s.tau);
    }
}

typedef double curve(const void *data, double x);

/* Golden section search for the maximum of f between left and right, to the
 * last digits. */
static double golden(curve *f, const void *data, double left, double right,
                     double *where)
{
    const double ratio = (sqrt(5) - 1) / 2;
    double low = right - ratio * (right - left);
    double high = left + ratio * (right - left);
    double f_low = f(data, low), f_high = f(data, high);
    for (int k = 0; k < 60; k++)
        if (f_low < f_high) {
            left = low, low = high, f_low = f_high;
            high = left + ratio * (right - left);
            f_high = f(data, high);
        } else {
            right = high, high = low, f_high = f_low;
            low = right - ratio * (right - left);
            f_low = f(data, low);
        }
    *where = (left + right) / 2;
    return f(data, *where);
}

/* Maximum of f on (a, b), by a scan and golden section search. */
static double maximum(curve *f, const void *data, double a, double b,
                      double *where)
{
    enum { SCAN = 64 };
    double step = (b - a) / SCAN, best = a, maximum = f(data, a);
    for (int k = 1; k <= SCAN; k++) {
        double value = f(data, a + k * step);
        if (value > maximum)
            maximum = value, best = a + k * step;
    }
    return golden(f, data, fmax(a, best - step), fmin(b, best + step), where);
}

static double along(const void *data, double x)
{
    return distance(data, x);
}

/* Amplitude of the stress history at depth z. */
static double at_depth(const void *data, double z)
{
    moment m = *(const moment *)data;
    ovr_criterion target = m.criterion;
    double x;
    m.z = z;
    if (target == OVR_CRITERION_DANG_VAN) {
        m.criterion = OVR_CRITERION_CIRCLE;
        maximum(along, &m, 0, 3, &x);
        m.centre = ovr_hertz_stress(1, 0, x, z).d;
        m.criterion = target;
    }
    return maximum(along, &m, 0, 3, &x);
}

double ovr_hertz_criterion(ovr_criterion criterion, double alpha,
                           double poisson, double *z)
{
    moment m = {criterion, alpha, poisson, 0, 0};
    double where;
    double value = maximum(at_depth, &m, 1e-3, 2, &where);
    if (z)
        *z = where;
    return value;
}
