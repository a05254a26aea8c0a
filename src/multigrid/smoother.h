/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A smoother, and how it is to relax. */
#ifndef OVR_MULTIGRID_SMOOTHER_H
#define OVR_MULTIGRID_SMOOTHER_H

#include "multigrid/hierarchy.h"

typedef struct ovr_smoothing ovr_smoothing;

/* Relaxes the Reynolds equation once on a level whose film, properties and
 * residual belong to its P.  Leaves a new P. */
typedef void ovr_relax(ovr_hierarchy *grids, ovr_level *level,
                       const ovr_smoothing *how);

struct ovr_smoothing {
    ovr_relax *relax;
    double limit;                                    /* on a change of P */
    double switch_value, relax_seidel, relax_dipole; /* hybrid.h */
};

#endif
