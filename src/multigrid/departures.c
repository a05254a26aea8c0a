/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Values at the departure points of paths (departures.h). */
#include "multigrid/departures.h"

#include <math.h>

/* Value at node i, also outside the grid: 0 beyond the end where material
 * enters, the end value beyond the other. */
static double value(size_t n, const double *v, ptrdiff_t i, double meshes)
{
    if (i >= 0 && i < (ptrdiff_t)n)
        return v[i];
    if ((i < 0) == (meshes >= 0))
        return 0;
    return v[i < 0 ? 0 : n - 1];
}

/* Limits the distance of departure points to this many domain lengths. */
static double bounded(size_t n, double meshes)
{
    double maximum = 2 * (double)n;
    return fmax(-maximum, fmin(meshes, maximum));
}

ovr_departures ovr_departures_of(size_t n, double meshes)
{
    ovr_departures f = {.n = n, .meshes = bounded(n, meshes)};
    double whole = floor(-f.meshes);
    ptrdiff_t size = (ptrdiff_t)n, first = (ptrdiff_t)whole - 1;
    ptrdiff_t from = first < 0 ? -first : 0, to = size - 3 - first;
    from = from < size ? from : size;
    to = to < from ? from : to < size ? to : size;
    f.first = first;
    f.from = (size_t)from;
    f.to = (size_t)to;
    ovr_cubic_weights(-f.meshes - whole, f.c);
    return f;
}

double ovr_departures_at(const ovr_departures *departures, const double *v,
                         size_t i)
{
    ptrdiff_t at = (ptrdiff_t)i + departures->first;
    double sum = 0;
    for (ptrdiff_t k = 0; k < 4; k++)
        sum += departures->c[k] *
               value(departures->n, v, at + k, departures->meshes);
    return sum;
}

void ovr_carry_along(const ovr_departures *f, const double *v, double *to)
{
    const double *from = v + f->first;
    const double c[4] = {f->c[0], f->c[1], f->c[2], f->c[3]};
    for (size_t i = 0; i < f->from; i++)
        to[i] = ovr_departures_at(f, v, i);
    for (size_t i = f->from; i < f->to; i++)
        to[i] = c[0] * from[i] + c[1] * from[i + 1] + c[2] * from[i + 2] +
                c[3] * from[i + 3];
    for (size_t i = f->to; i < f->n; i++)
        to[i] = ovr_departures_at(f, v, i);
}

/* Adding 2 makes the number positive, because conversion to an integer rounds
 * towards zero. */
void ovr_film_departures(size_t n, double meshes, const double *u,
                         const double *v, double *at_departures)
{
    const ptrdiff_t last = (ptrdiff_t)n - 1;
    const double beyond = (double)(last + 1);
    for (size_t i = 0; i < n; i++) {
        double at = (double)i - meshes * u[i];
        /* NAN becomes a valid index */
        at = !(at > -1) ? -1 : at > beyond ? beyond : at;
        ptrdiff_t first = (ptrdiff_t)(at + 2) - 2;
        double a = first >= 0 && first <= last ? v[first] : 0;
        double b = first + 1 <= last ? v[first + 1] : 0;
        at_departures[i] = a + (at - (double)first) * (b - a);
    }
}
