/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Lines of equal value on an even grid. */
#ifndef OVR_PICTURES_CONTOUR_H
#define OVR_PICTURES_CONTOUR_H

#include "base/arena.h"
#include "pictures/chart.h"

/* An even grid of cells over x_from ... x_to, y_from ... y_to, row by row, as
 * an image has it. */
typedef struct ovr_cells {
    size_t nx, ny;
    const double *values;
    double x_from, x_to, y_from, y_to;
} ovr_cells;

/* The lines where the values are `level`, as pieces divided by NAN. */
ovr_status ovr_contour(const ovr_cells *cells, double level, ovr_arena *arena,
                       ovr_series *series, ovr_error *err);

#endif
