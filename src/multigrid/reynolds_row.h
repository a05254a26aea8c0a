/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The wedge's weights by vectors of rows: for kernels. */
#ifndef OVR_MULTIGRID_REYNOLDS_ROW_H
#define OVR_MULTIGRID_REYNOLDS_ROW_H

#include "multigrid/kernels.h"
#include "multigrid/vector.h"

typedef struct wedge {
    vec a0, a1, a2;
} wedge;

static inline wedge inner_wedge(const ovr_weights *w)
{
    return (wedge){all(w->a0), all(w->a1), all(w->a2)};
}

/* Of vector 1: row 1, its first element, is of first order. */
static inline wedge first_wedge(const ovr_weights *w)
{
    wedge c = inner_wedge(w);
    c.a0[0] = w->a0_first;
    c.a1[0] = w->a1_first;
    c.a2[0] = 0;
    return c;
}

#endif
