/* SPDX-License-Identifier: GPL-3.0-or-later */
/* This instruction set's table of kernels. */
#include "multigrid/table.h"
#include "multigrid/vector.h"

const ovr_kernels OVR_KERNEL(kernels) = OVR_KERNELS(VEC);
