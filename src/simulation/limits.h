/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Ranges of ovr_options, for programs and for case keys; 0 means automatic
 * where this is supported. */
#ifndef OVR_SIMULATION_LIMITS_H
#define OVR_SIMULATION_LIMITS_H

#include "multigrid/deformation.h"

enum {
    OVR_SWEEPS_MAX = 100,
    OVR_MAX_CYCLES_MAX = 100000,
    OVR_CYCLES_MAX = 1000,
    OVR_ORDER_MIN = 4, /* order of the MLMI transfers */
    OVR_ORDER_MAX = OVR_MLMI_MAX,
    OVR_RANGE_MIN = 2, /* range of the MLMI corrections, in mesh sizes */
    OVR_RANGE_MAX = 2 * OVR_MLMI_MAX
};

#define OVR_TOLERANCE_MAX 1.0

/* Under-relaxation factor of the paper's smoother. */
#define OVR_SEIDEL_MIN 0.5
#define OVR_SEIDEL_MAX 1.0
#define OVR_DIPOLE_MIN 0.3
#define OVR_DIPOLE_MAX 0.6

#endif
