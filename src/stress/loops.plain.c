/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The loops in plain C. */
#include <complex.h>
#include <math.h>

#include "stress/circle.h"
#include "stress/loops.h"

static double complex product(ovr_bins a, ovr_bins b, size_t k)
{
    return ((double)a.re[k] + I * (double)a.im[k]) *
           ((double)b.re[k] + I * (double)b.im[k]);
}

static void store(float *waves, size_t k, double complex value)
{
    waves[2 * k] = (float)creal(value);
    waves[2 * k + 1] = (float)cimag(value);
}

static void spread(size_t bins, size_t n, const ovr_load_bins *load,
                   size_t loads, float *waves)
{
    for (size_t k = 1; k < bins; k++) {
        double complex a = 0, b = 0;
        for (size_t l = 0; l < loads; l++) {
            a += product(load[l].A, load[l].P, k);
            b += product(load[l].B, load[l].P, k);
        }
        store(waves, k, a + I * b);
        store(waves, n - k, conj(a) + I * conj(b));
    }
}

static void states(size_t n, const float *shear, const float *mean,
                   const ovr_state_constants *c, const ovr_node_states *to)
{
    for (size_t i = 0; i < n; i++) {
        to->d[i] = shear[2 * i];
        to->tau[i] = shear[2 * i + 1];
        to->h[i] = mean[2 * i];
        double half = (double)to->d[i] + (double)c->half, t = to->tau[i];
        double middle = (double)c->mean - (double)to->h[i];
        double y = (double)c->across -
                   2 * (double)c->poisson * (double)to->h[i];
        double shearing = hypot(half, t), one = middle + shearing;
        double three = middle - shearing;
        to->in_plane[i] = (float)(shearing * shearing);
        to->von_mises[i] = (float)(((one - y) * (one - y) +
                                    (y - three) * (y - three) +
                                    (three - one) * (three - one)) /
                                   2);
        to->tresca[i] = (float)(fmax(fmax(fabs(one - y), fabs(y - three)),
                                     fabs(one - three)) /
                                2);
    }
}

static void extents(size_t n, const float *d, const float *tau, float cosine,
                    float sine, float *high, float *low)
{
    for (size_t i = 0; i < n; i++) {
        float v = d[i] * cosine + tau[i] * sine;
        high[i] = fmaxf(high[i], v);
        low[i] = fminf(low[i], v);
    }
}

static void raise(size_t n, const float *v, float *high)
{
    for (size_t i = 0; i < n; i++)
        high[i] = fmaxf(high[i], v[i]);
}

static void lower(size_t n, const float *v, float *low)
{
    for (size_t i = 0; i < n; i++)
        low[i] = fminf(low[i], v[i]);
}

static float largest(size_t n, const float *v)
{
    float maximum = 0;
    for (size_t i = 0; i < n; i++)
        maximum = fmaxf(maximum, v[i]);
    return maximum;
}

static void circles(size_t n, const float *rows, size_t pitch, float *radius)
{
    for (size_t i = 0; i < n; i++) {
        double high[OVR_HALF_DIRECTIONS], low[OVR_HALF_DIRECTIONS];
        for (size_t m = 0; m < OVR_HALF_DIRECTIONS; m++) {
            high[m] = rows[m * pitch + i];
            low[m] = rows[(m + OVR_HALF_DIRECTIONS) * pitch + i];
        }
        radius[i] = (float)ovr_circle_of_extents(high, low);
    }
}

extern const ovr_stress_loops ovr_stress_loops_plain;
const ovr_stress_loops ovr_stress_loops_plain = {
    "plain", spread, states, extents, raise, lower, largest, circles};
