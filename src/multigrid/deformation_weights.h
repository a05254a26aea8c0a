/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef OVR_MULTIGRID_DEFORMATION_WEIGHTS_H
#define OVR_MULTIGRID_DEFORMATION_WEIGHTS_H

#include <stddef.h>

/* Weights at the distances 1, 3, ..., 2h - 1 to either side for interpolating
 * the kernel beyond the range.  Lagrange's for 2h > range or h > 6. */
void ovr_mlmi_weights(size_t h, size_t range, double weight[]);

/* The same by the fit itself, also where a table has its result. */
void ovr_mlmi_fit_weights(size_t h, size_t range, double weight[]);

#endif
