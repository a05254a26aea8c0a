/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Searches and sums over nodes, as in scan.kernel.c. */
#include <math.h>

#include "multigrid/plain.h"

size_t ovr_extreme_plain(size_t n, double sign, const double *x)
{
    size_t best = 0;
    for (size_t i = 1; i < n; i++)
        if (sign * x[i] < sign * x[best])
            best = i;
    return best;
}

bool ovr_positive_plain(size_t n, const double *x)
{
    for (size_t i = 0; i < n; i++)
        if (!(x[i] > 0))
            return false;
    return true;
}

double ovr_difference_plain(size_t n, const double *a, const double *b)
{
    double maximum = 0;
    for (size_t i = 0; i < n; i++)
        maximum = fmax(maximum, fabs(a[i] - b[i]));
    return maximum;
}

double ovr_gain_plain(size_t n, const double *weights, const double *a,
                      const double *b)
{
    double sum = 0;
    for (size_t i = 0; i < n; i++)
        sum += weights[i] * (b ? a[i] - b[i] : a[i]);
    return sum;
}

int ovr_peaks_plain(size_t n, const double *x, size_t *last)
{
    int count = 0;
    for (size_t i = 1; i + 1 < n; i++)
        if (x[i] > x[i - 1] && x[i] >= x[i + 1]) {
            count++;
            *last = i;
        }
    return count;
}

double ovr_mean_flow_plain(size_t n, const double u[2], const double *X,
                           const double *P, const double *q, const double *eps,
                           const double *flow)
{
    double sum = 0, count = 0;
    for (size_t i = 1; i + 2 < n; i++)
        if (P[i] > 0 && P[i + 1] > 0) {
            double twice = flow ? flow[i] : eps[i] + eps[i + 1];
            sum += u[0] * q[i] + u[1] * q[i - 1] -
                   twice / 2 * (P[i + 1] - P[i]) / (X[i + 1] - X[i]);
            count++;
        }
    return count > 0 ? sum / count : 0;
}

double ovr_flow_size_plain(size_t n, double Cu, const double *X,
                           const double *P, const double *q, const double *eps,
                           const double *flow)
{
    double sum = 0;
    for (size_t i = 0; i + 1 < n; i++) {
        double twice = flow ? flow[i] : eps[i] + eps[i + 1];
        sum += fabs(Cu * (q[i] + q[i + 1]) / 2 * (X[i + 1] - X[i]) -
                    twice / 2 * (P[i + 1] - P[i]));
    }
    return sum;
}

double ovr_deviation_plain(size_t n, const double e[3], double maximum,
                           const double *weights, const double *P,
                           const double *q, double *const past[3])
{
    double sum = 0;
    for (size_t i = 0; i < n; i++)
        if (P[i] > 0 && q[i] < maximum) {
            double off = q[i];
            for (int k = 0; k < 3; k++)
                off -= e[k] * past[k][i];
            sum += weights[i] * fabs(off);
        }
    return sum;
}

void ovr_film_sums_plain(size_t n, const double *weights, const double *q,
                         const double *H, double sums[5])
{
    for (int k = 0; k < 5; k++)
        sums[k] = 0;
    for (size_t i = 0; i < n; i++) {
        double w = weights[i], off = q[i] - q[0];
        sums[0] += w;
        sums[1] += w * H[i];
        sums[2] += w * q[i] / H[i];
        sums[3] += w * off;
        sums[4] += w * off * off;
    }
}
