/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "surface/local_roughness.h"

#include <math.h>

/* Integrals over a window. */
typedef struct sums {
    double width, z, squares;
} sums;

/* Adds the piece from point i to the next, or takes it away. */
static void add(sums *s, const double *x, const double *z, size_t i,
                double sign)
{
    double h = sign * (x[i + 1] - x[i]), a = z[i], b = z[i + 1];
    s->width += h;
    s->z += h * (a + b) / 2;
    s->squares += h * (a * a + a * b + b * b) / 3;
}

static double variance(const sums *s)
{
    double mean = s->z / s->width;
    return fmax(0, s->squares / s->width - mean * mean);
}

double ovr_local_roughness(size_t n, const double *x, const double *z,
                           double window)
{
    const double rounding = 1e-9;
    double squares = 0, width = 0;
    size_t end = 0;
    sums s = {0, 0, 0};
    if (n < 2)
        return 0;
    for (size_t i = 0; i + 1 < n; i++) {
        while (end + 1 < n && s.width < window * (1 - rounding))
            add(&s, x, z, end++, 1);
        if (s.width < window * (1 - rounding) && i > 0)
            break;
        squares += (x[i + 1] - x[i]) * variance(&s);
        width += x[i + 1] - x[i];
        add(&s, x, z, i, -1);
    }
    return sqrt(squares / width);
}

double ovr_local_roughness_of_wave(double amplitude, double wavelength,
                                   double window)
{
    double a = 3.14159265358979323846 * window / wavelength;
    double mean = a > 0 ? sin(a) / a : 1;
    return fabs(amplitude) * sqrt(0.5 * (1 - mean * mean));
}
