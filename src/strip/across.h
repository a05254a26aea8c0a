/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The boundary across the rolling direction: neighbours, distances, coarse
 * lines and halos at the first and the last line.
 *
 * The strip is periodic over its width W: line j is line j + lines, and line
 * `lines` is line 0.  Kernels read neighbours across from the halo of a row,
 * which the kernel `wrap` (across.kernel.c) fills.  The influence of a pressure
 * on the lines of its period, images included, is in elastic.c.
 *
 * Free ends of a roller, with P = 0 on the first and the last line, would
 * change these functions, the kernel `wrap` and the influence in elastic.c.
 */
#ifndef OVR_STRIP_ACROSS_H
#define OVR_STRIP_ACROSS_H

#include <math.h>

#include "strip/strip.h"

/* Number of mesh sizes in the width. */
static inline size_t ovr_across_intervals(size_t lines)
{
    return lines;
}

/* Mesh size across. */
static inline double ovr_across_mesh(double width, size_t lines)
{
    return width / (double)ovr_across_intervals(lines);
}

/* Number of lines of a grid with twice the mesh size across, or 0 if it has no
 * such grid. */
static inline size_t ovr_across_halved(size_t lines)
{
    return lines % 2 == 0 && lines >= 8 ? lines / 2 : 0;
}

/* Distance from one line of the coarse grid to the next, in lines of the fine
 * grid. */
static inline size_t ovr_across_spacing(size_t fine, size_t coarse)
{
    return ovr_across_intervals(fine) / ovr_across_intervals(coarse);
}

/* Coordinate of a line; the middle of the width is at 0. */
static inline double ovr_across_Y(double width, double Dy, size_t j)
{
    return -width / 2 + (double)j * Dy;
}

/* Distance Y from one place to another; the shortest of those to its images.
 */
static inline double ovr_across_offset(double width, double Y)
{
    return remainder(Y, width);
}

/* The line at place j, which is at most one width outside the lines. */
static inline size_t ovr_across_line(size_t lines, ptrdiff_t j)
{
    const ptrdiff_t period = (ptrdiff_t)lines;
    return (size_t)(j < 0 ? j + period : j >= period ? j - period : j);
}

/* Distance of two lines in lines. */
static inline size_t ovr_across_apart(size_t lines, size_t a, size_t b)
{
    size_t d = a > b ? a - b : b - a;
    return d > lines - d ? lines - d : d;
}

/* Sets `reach` elements of the halo on both sides of a row. */
static inline void ovr_across_close(size_t lines, ptrdiff_t reach, double *x)
{
    for (ptrdiff_t h = 0; h < reach; h++)
        x[(ptrdiff_t)lines + h] = x[h];
    for (ptrdiff_t h = 1; h <= reach; h++)
        x[-h] = x[(ptrdiff_t)lines - h];
}

#endif
