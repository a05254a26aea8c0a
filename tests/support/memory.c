/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "memory.h"

#include <math.h>

double test_memory_error(const ovr_memory *m, double longest)
{
    double maximum = 0;
    for (int k = 0; k <= 1000; k++) {
        double t = m->dT * pow(longest / m->dT, k / 1000.), sum = 0;
        for (int i = 0; i < m->banks * OVR_MODES; i++)
            sum += m->weight[i] * exp(-m->rate[i] * (t - m->dT));
        double M = m->warmth.at ? m->warmth.at(m->warmth.data, t) : 1;
        maximum = fmax(maximum, fabs(sqrt(t) * sum / M - 1));
    }
    return maximum;
}
