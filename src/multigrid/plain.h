/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The table "plain": every kernel once more (NAME.plain.c beside
 * NAME.kernel.c) in the shortest C that states it, node by node.  It has one
 * lane, whose places are the nodes themselves; nothing is repeated in halos.
 * Tests hold the vectors' kernels against it; simulations run on it too.
 */
#ifndef OVR_MULTIGRID_PLAIN_H
#define OVR_MULTIGRID_PLAIN_H

#undef OVR_ISA
#define OVR_ISA plain
#include "multigrid/table.h"

/* a0, a1, a2 of row i: row 1 has no q_{-1}. */
static inline void ovr_row_weights(const ovr_weights *w, ptrdiff_t i,
                                   double a[3])
{
    a[0] = i > 1 ? w->a0 : w->a0_first;
    a[1] = i > 1 ? w->a1 : w->a1_first;
    a[2] = i > 1 ? w->a2 : 0;
}

#endif
