/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Interface of the smoothers, and their parameters. */
#ifndef OVR_MULTIGRID_SMOOTHER_H
#define OVR_MULTIGRID_SMOOTHER_H

#include "multigrid/hierarchy.h"

typedef struct ovr_smoothing ovr_smoothing;

/* One relaxation of the Reynolds equation on a level whose film, properties and
 * residual are up to date. Changes P only. */
typedef void ovr_relax(ovr_hierarchy *grids, ovr_level *level,
                       const ovr_smoothing *how);

struct ovr_smoothing {
    ovr_relax *relax;
    double limit;                                    /* maximum change of P */
    double switch_value, relax_seidel, relax_dipole; /* hybrid.h */
};

#endif
