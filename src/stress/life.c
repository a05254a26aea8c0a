/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Life of a raceway from the amplitudes below it.
 *
 *     ln(1/S) ~ N^e int int <A - A_u>^c z^-h dxi dz
 *
 * (G. Lundberg, A. Palmgren, Acta Polytechnica, Mech. Eng. Series 1, 1947; with
 * a limit A_u: E. Ioannides, T. A. Harris, ASME J. Tribology 107, 1985). c =
 * 31/3, h = 7/3, e = 9/8: fits to tests of 1947, convention since. Without a
 * limit the risk per length is proportional to p_h^c b^(1-h) and the life of a
 * line contact with p_h^-8.
 *
 *     i(xi) = int <A - A_u>^c z^-h dz,  lambda = int (i - i_0) dxi / i_0
 *
 * where i_0 is i of the smooth contact: lambda is the length of smooth raceway
 * whose risk equals the risk added by the feature. Both are integrals from a
 * minimum depth on and depend on it.
 *
 * A is monotone cubic in ln z between the depths (F. N. Fritsch, R. E. Carlson,
 * SIAM J. Numer. Anal. 17, 1980), the integral over ln z by Gauss's rule of 5
 * points between two depths.
 */
#include <math.h>

#include "base/given.h"
#include "stress/layered.h"
#include "stress/stress.h"

enum { PARTS = 5, MAX_DEPTHS = 1024 };

/* Gauss's points and weights on (0, 1). */
static const double gauss_at[PARTS] = {0.046910077030668004,
                                       0.23076534494715845, 0.5,
                                       0.76923465505284155, 0.953089922969332};
static const double gauss_weight[PARTS] = {
    0.11846344252809454, 0.23931433524968324, 0.28444444444444444,
    0.23931433524968324, 0.11846344252809454};

ovr_life_options ovr_life_options_default(void)
{
    const ovr_life_options defaults = {
        .exponent = 31. / 3, .depth_exponent = 7. / 3, .weibull = 9. / 8};
    return defaults;
}

/* Numbers of the interval from z[j] that depend on the depths only, computed
 * once for all points: width in ln z, z^(1-h) times Gauss's weights, and the
 * limits there. */
typedef struct interval {
    double width, weight[PARTS];
    double limit[PARTS], min_limit;
} interval;

static double limit_at(const ovr_life_options *o, double z)
{
    return o->limits ? ovr_by_depth(o->limits, o->limit_z, o->limit_A, z)
                     : o->limit;
}

static void find_intervals(const ovr_life_options *o, size_t depths,
                           const double *z, interval *of)
{
    double power = 1 - o->depth_exponent;
    for (size_t j = 0; j + 1 < depths; j++) {
        double width = log(z[j + 1] / z[j]), start = pow(z[j], power);
        of[j].width = width;
        of[j].min_limit = INFINITY;
        for (int k = 0; k < PARTS; k++) {
            of[j].weight[k] = gauss_weight[k] * width * start *
                              exp(power * width * gauss_at[k]);
            of[j].limit[k] = limit_at(o, z[j] * exp(width * gauss_at[k]));
            of[j].min_limit = fmin(of[j].min_limit, of[j].limit[k]);
        }
    }
}

/* Slope between two intervals: harmonic mean where both have one sign. */
static double inner_slope(double left, double right, double dl, double dr)
{
    if (left * right <= 0)
        return 0;
    double wl = 2 * dr + dl, wr = dr + 2 * dl;
    return (wl + wr) / (wl / left + wr / right);
}

/* dA/d ln z at depth j of n. */
static double slope(size_t n, const interval *of, const double *A, size_t j)
{
    if (n < 2)
        return 0;
    size_t l = j > 0 ? j - 1 : 0, r = j + 1 < n ? j : n - 2;
    double dl = of[l].width, dr = of[r].width;
    double left = (A[l + 1] - A[l]) / dl, right = (A[r + 1] - A[r]) / dr;
    return j == 0 || j + 1 == n ? left : inner_slope(left, right, dl, dr);
}

/* The integral between z[j] and z[j + 1]. */
static double of_interval(const ovr_life_options *o, size_t n,
                          const interval *of, const double *A, size_t j)
{
    double width = of[j].width, sum = 0;
    double m0 = slope(n, of, A, j) * width, m1 = slope(n, of, A, j + 1) * width;
    if (fmax(A[j], A[j + 1]) <= of[j].min_limit)
        return 0;
    for (int k = 0; k < PARTS; k++) {
        double t = gauss_at[k], s = 1 - t;
        double a = s * s * (1 + 2 * t) * A[j] + s * s * t * m0 +
                   t * t * (1 + 2 * s) * A[j + 1] - t * t * s * m1;
        if (a > of[j].limit[k])
            sum += of[j].weight[k] * pow(a - of[j].limit[k], o->exponent);
    }
    return sum;
}

static void risk_of(const ovr_life_options *o, size_t depths,
                    const interval *of, const double *A, double *risk)
{
    double sum = 0;
    for (size_t j = depths; j-- > 0;) {
        if (j + 1 < depths)
            sum += of_interval(o, depths, of, A, j);
        risk[j] = sum;
    }
}

void ovr_risk(const ovr_life_options *options, size_t depths, const double *z,
              const double *A, double *risk)
{
    if (!z || !A || !risk)
        return;
    ovr_life_options own;
    interval of[MAX_DEPTHS];
    if (depths > MAX_DEPTHS ||
        OVR_TAKE(ovr_life_options, &own, options, NULL) ||
        (own.limits && !(own.limit_z && own.limit_A))) {
        for (size_t j = 0; j < depths; j++)
            risk[j] = NAN;
        return;
    }
    find_intervals(&own, depths, z, of);
    risk_of(&own, depths, of, A, risk);
}

static size_t first_counted(const ovr_life_options *o, const ovr_material *m)
{
    size_t j = 0;
    while (j + 1 < m->depths && m->z[j] < o->least_depth * (1 - 1e-9))
        j++;
    return j;
}

static void find_worst(const ovr_material *m, const float *A, size_t from,
                       ovr_life_result *r)
{
    for (size_t j = from; j < m->depths; j++)
        for (size_t k = 0; k < m->points; k++)
            if (m->complete[k] &&
                (double)A[j * m->points + k] > r->worst_amplitude) {
                r->worst_amplitude = A[j * m->points + k];
                r->worst_xi = m->start + (double)k * m->step;
                r->worst_z = m->z[j];
            }
}

/* Finds the maximum utilization of the limit. If limits vary with depth, it
 * need not be at the maximum amplitude. */
static void find_used(const ovr_life_options *o, const ovr_material *m,
                      const float *A, size_t from, ovr_life_result *r)
{
    r->utilisation = r->used_xi = r->used_z = r->used_limit = NAN;
    for (size_t j = from; j < m->depths; j++) {
        double limit = limit_at(o, m->z[j]);
        for (size_t k = 0; limit > 0 && k < m->points; k++) {
            double used = (double)A[j * m->points + k] / limit;
            if (!m->complete[k] || used <= r->utilisation)
                continue;
            r->utilisation = used;
            r->used_xi = m->start + (double)k * m->step;
            r->used_z = m->z[j];
            r->used_limit = limit;
        }
    }
}

/* Work data for integrating risks point by point; arrays are by depth. */
typedef struct counting {
    interval of[MAX_DEPTHS];
    double column[MAX_DEPTHS], i[MAX_DEPTHS]; /* of the last point */
    double i_0[MAX_DEPTHS], lambda[MAX_DEPTHS];
} counting;

/* Adds the amplitudes and risks of a point to the sums for lambda. */
static void count_point(counting *c, const ovr_life_options *o,
                        const ovr_material *m, const float *A, size_t k)
{
    for (size_t j = 0; j < m->depths; j++)
        c->column[j] = A[j * m->points + k];
    risk_of(o, m->depths, c->of, c->column, c->i);
    for (size_t j = 0; m->complete[k] && j < m->depths; j++)
        c->lambda[j] += (c->i[j] - c->i_0[j]) / c->i_0[j] * m->step;
}

ovr_status ovr_life(const ovr_life_options *options, const ovr_amplitudes *of,
                    double *risk, double *length, ovr_life_result *result,
                    ovr_error *err)
{
    counting c = {0};
    ovr_life_options own, *o = &own;
    ovr_life_result made;
    if (OVR_TAKE(ovr_life_options, o, options, err) ||
        ovr_check_output_argument(result, "ovr_life_result", err))
        return OVR_BAD_INPUT;
    if (!of || !of->material || !of->A || !of->smooth)
        return ovr_fail_null(err, __func__);
    const ovr_material *m = of->material;
    if (o->limits && !(o->limit_z && o->limit_A))
        return ovr_fail_null(err, __func__);
    if (m->depths < 1 || m->depths > MAX_DEPTHS)
        return ovr_fail(err, OVR_BAD_INPUT, "%zu depths: must be 1 to %d",
                        m->depths, MAX_DEPTHS);
    size_t from = first_counted(o, m);
    made = (ovr_life_result){.least_depth = m->z[from]};
    find_intervals(o, m->depths, m->z, c.of);
    risk_of(o, m->depths, c.of, of->smooth, c.i_0);
    for (size_t k = 0; k < m->points; k++) {
        count_point(&c, o, m, of->A, k);
        made.counted += m->complete[k];
        if (risk)
            risk[k] = c.i[from];
    }
    for (size_t j = 0; j < m->depths; j++)
        c.lambda[j] = c.i_0[j] > 0 ? c.lambda[j] : NAN;
    for (size_t j = 0; length && j < m->depths; j++)
        length[j] = c.lambda[j];
    find_worst(m, of->A, from, &made);
    made.smooth_risk = c.i_0[from];
    made.equivalent_length = c.lambda[from];
    find_used(o, m, of->A, from, &made);
    *result = made;
    return OVR_OK;
}

double ovr_life_ratio(const ovr_life_options *options, double equivalent_length,
                      double raceway, double count)
{
    double added = 1 + count * equivalent_length / raceway;
    ovr_life_options own;
    if (OVR_TAKE(ovr_life_options, &own, options, NULL) || !(added > 0))
        return NAN;
    return pow(added, -1 / own.weibull);
}
