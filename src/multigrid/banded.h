/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Linear systems of a band, by Gaussian elimination with pivots in columns:
 * A_ij = 0 beyond |i - j| <= OVR_BAND. */
#ifndef OVR_MULTIGRID_BANDED_H
#define OVR_MULTIGRID_BANDED_H

#include <stdbool.h>
#include <stddef.h>

#include "base/arena.h"

/* WIDTH: of a row, with what pivoting fills in. */
enum { OVR_BAND = 8, OVR_BAND_WIDTH = 3 * OVR_BAND + 1 };

typedef struct ovr_banded {
    double *row; /* A_ij at i WIDTH + j - i + BAND; then the upper factor, with
                    the inverse of its diagonal */
    double *factor; /* BAND of each column, those of the lower one */
    size_t *pivot;
} ovr_banded;

ovr_status ovr_banded_take(ovr_banded *A, size_t n, ovr_arena *arena,
                           ovr_error *err);

/* The factors of n rows, in place; false: it is singular. */
bool ovr_banded_factor(ovr_banded *A, size_t n);

/* A x = b, in place. */
void ovr_banded_solve(const ovr_banded *A, size_t n, double *x);

#endif
