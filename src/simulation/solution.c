/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "simulation/solution.h"

size_t ovr_node_after(const ovr_solution *s, double X)
{
    size_t low = 0, high = s->n - 1;
    while (high - low > 1) {
        size_t middle = low + (high - low) / 2;
        *(s->X[middle] <= X ? &low : &high) = middle;
    }
    return high;
}

double ovr_value_at(const ovr_solution *s, const double *f, double X)
{
    size_t after = ovr_node_after(s, X), first = after < 2 ? 0 : after - 2;
    double value = 0;
    if (first + 4 > s->n)
        first = s->n - 4;
    for (size_t k = first; k < first + 4; k++) {
        double weight = 1;
        for (size_t j = first; j < first + 4; j++)
            if (j != k)
                weight *= (X - s->X[j]) / (s->X[k] - s->X[j]);
        value += weight * f[k];
    }
    return value;
}
