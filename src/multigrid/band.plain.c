/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "multigrid/plain.h"

/* Pentadiagonal elimination without pivoting: row i, with column i + d in b[d +
 * 2], is subtracted from the two rows below it. */
void ovr_band_solve_plain(const ovr_lanes *g, const ovr_band *band)
{
    double *const *b = band->b, *x = band->delta, next = 0, after = 0;
    for (size_t i = 0; i < g->n; i++)
        for (size_t m = 1; m <= 2 && i + m < g->n; m++) {
            double factor = b[2 - m][i + m] / b[2][i];
            b[3 - m][i + m] -= factor * b[3][i];
            b[4 - m][i + m] -= factor * b[4][i];
            x[i + m] -= factor * x[i];
        }
    for (size_t i = g->n; i-- > 0;) {
        x[i] = (x[i] - b[3][i] * next - b[4][i] * after) / b[2][i];
        after = next;
        next = x[i];
    }
}
