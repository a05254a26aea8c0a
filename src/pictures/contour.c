/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Marching squares: each square of four cells' middles is crossed by a line
 * where two of its sides are, linear along them; of the two ways through a
 * saddle the one that keeps the corners above the level apart.
 */
#include "pictures/contour.h"

#include <math.h>

/* Side s of the square goes from corner s to corner s + 1, around it. */
static const int corner_x[] = {0, 1, 1, 0, 0}, corner_y[] = {0, 0, 1, 1, 0};

typedef struct pen {
    const ovr_cells *cells;
    double level;
    double *x, *y; /* NULL: only counted */
    size_t n;
} pen;

static double value(const ovr_cells *c, size_t i, size_t j)
{
    return c->values[j * c->nx + i];
}

static void put(pen *p, double x, double y)
{
    if (p->x) {
        p->x[p->n] = x;
        p->y[p->n] = y;
    }
    p->n++;
}

/* The point of a side, in cells from the middle of the first. */
static void put_crossing(pen *p, size_t i, size_t j, int side)
{
    const ovr_cells *c = p->cells;
    size_t ia = i + (size_t)corner_x[side], ja = j + (size_t)corner_y[side];
    size_t ib = i + (size_t)corner_x[side + 1];
    size_t jb = j + (size_t)corner_y[side + 1];
    double a = value(c, ia, ja), b = value(c, ib, jb);
    double t = (p->level - a) / (b - a);
    double u = (double)ia + t * ((double)ib - (double)ia) + 0.5;
    double v = (double)ja + t * ((double)jb - (double)ja) + 0.5;
    put(p, c->x_from + (c->x_to - c->x_from) * u / (double)c->nx,
        c->y_from + (c->y_to - c->y_from) * v / (double)c->ny);
}

static void cross_square(pen *p, size_t i, size_t j)
{
    int side[4], n = 0;
    for (int s = 0; s < 4; s++) {
        double a = value(p->cells, i + (size_t)corner_x[s],
                         j + (size_t)corner_y[s]);
        double b = value(p->cells, i + (size_t)corner_x[s + 1],
                         j + (size_t)corner_y[s + 1]);
        if (isnan(a) || isnan(b))
            return;
        if ((a > p->level) != (b > p->level))
            side[n++] = s;
    }
    if (n == 4 && value(p->cells, i, j) <= p->level) {
        int first = side[0]; /* 1-2 and 3-0 in place of 0-1 and 2-3 */
        side[0] = side[1], side[1] = side[2], side[2] = side[3];
        side[3] = first;
    }
    for (int k = 0; k + 1 < n; k += 2) {
        put_crossing(p, i, j, side[k]);
        put_crossing(p, i, j, side[k + 1]);
        put(p, NAN, NAN);
    }
}

static void cross_all(pen *p)
{
    for (size_t j = 0; j + 1 < p->cells->ny; j++)
        for (size_t i = 0; i + 1 < p->cells->nx; i++)
            cross_square(p, i, j);
}

ovr_status ovr_contour(const ovr_cells *cells, double level, ovr_arena *arena,
                       ovr_series *series, ovr_error *err)
{
    pen p = {.cells = cells, .level = level};
    cross_all(&p);
    p.x = ovr_arena_take(arena, p.n + 1, sizeof *p.x, err);
    p.y = ovr_arena_take(arena, p.n + 1, sizeof *p.y, err);
    if (!p.x || !p.y)
        return OVR_NO_MEMORY;
    p.n = 0;
    cross_all(&p);
    *series = (ovr_series){.n = p.n, .x = p.x, .y = p.y, .width = 1};
    return OVR_OK;
}
