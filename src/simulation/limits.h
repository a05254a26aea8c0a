/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The ranges of ovr_options, for programs and for the keys of a case alike; 0
 * means automatic where that is possible. */
#ifndef OVR_SIMULATION_LIMITS_H
#define OVR_SIMULATION_LIMITS_H

#include "multigrid/deformation.h"

enum {
    OVR_SWEEPS_MOST = 100,
    OVR_MAX_CYCLES_MOST = 100000,
    OVR_CYCLES_MOST = 1000,
    OVR_ORDER_LEAST = 4, /* of the transfers of MLMI */
    OVR_ORDER_MOST = OVR_MLMI_MOST,
    OVR_RANGE_LEAST = 2, /* of their corrections, in meshes */
    OVR_RANGE_MOST = 2 * OVR_MLMI_MOST
};

#define OVR_TOLERANCE_MOST 1.0

/* Under-relaxation of the paper's smoothers. */
#define OVR_SEIDEL_LEAST 0.5
#define OVR_SEIDEL_MOST 1.0
#define OVR_DIPOLE_LEAST 0.3
#define OVR_DIPOLE_MOST 0.6

#endif
