/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Kernel table of one instruction set. */
#include "multigrid/table.h"
#include "multigrid/vector.h"

const ovr_kernels OVR_KERNEL(kernels) = OVR_KERNELS(VEC);
