/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The table of plain kernels. */
#include "multigrid/plain.h"

const ovr_kernels ovr_kernels_plain = OVR_KERNELS(1);
