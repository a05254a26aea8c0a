/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Halos of rows, beyond the first and the last line (across.h). */
#include "strip/across.h"
#include "multigrid/vector.h"
#include "strip/kernels.h"

void OVR_STRIP_KERNEL(wrap)(const ovr_strip_grid *g, ovr_part rows, double *x)
{
    enum { HALO = OVR_STRIP_HALO };
    const size_t lines = g->lines;
    x += ovr_strip_row(g, rows.from);
    for (size_t i = rows.from; i < rows.to; i++, x += g->stride) {
        if (lines < HALO) {
            ovr_across_close(lines, HALO, x);
            continue;
        }
        for (size_t j = 0; j < HALO; j += VEC) {
            vec last = load(x + lines - HALO + j), first = load(x + j);
            store(x + j - HALO, last);
            store(x + lines + j, first);
        }
    }
}
