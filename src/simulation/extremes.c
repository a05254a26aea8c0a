/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "simulation/extremes.h"

#include <math.h>

double ovr_vertex(const double *X, const double *v, size_t i, double *value)
{
    double left = X[i] - X[i - 1], right = X[i + 1] - X[i];
    double up = (v[i] - v[i - 1]) / left, down = (v[i + 1] - v[i]) / right;
    double curvature = 2 * (down - up) / (left + right);
    double slope = (up * right + down * left) / (left + right);
    double shift = curvature != 0 ? -slope / curvature : 0;
    double gain = shift * (slope + 0.5 * shift * curvature);
    if (!(-left <= shift && shift <= right) ||
        !(fabs(gain) <= 0.05 * fabs(v[i])))
        shift = gain = 0;
    *value = v[i] + gain;
    return X[i] + shift;
}

bool ovr_maximum_is_resolved(size_t n, const double *v, size_t i)
{
    double left = i > 1 ? v[i - 2] : v[0];
    double right = i + 2 < n ? v[i + 2] : v[n - 1];
    return !((left + right) / 2 < 2.0 / 3 * v[i]);
}

int ovr_prominent_maxima(size_t n, const double *P, size_t *last)
{
    double low = P[0]; /* lowest since the last that stood out */
    int count = 0;
    for (size_t i = 1; i + 1 < n; i++) {
        low = P[i] < low ? P[i] : low;
        if (!(P[i] > P[i - 1] && P[i] >= P[i + 1]))
            continue;
        if (P[i] > low + OVR_PROMINENCE)
            count++;
        else if (!count || !(P[i] > P[*last]))
            continue; /* nothing, or a lower one of the same maximum */
        *last = i;
        low = P[i];
    }
    return count;
}
