/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The kernel table "plain": all kernels in plain C (NAME.plain.c for
 * NAME.kernel.c), node by node. There is one lane, in the order of the nodes,
 * and halos are not copied. Tests compare the vector kernels with these;
 * simulations can use them too.
 */
#ifndef OVR_MULTIGRID_PLAIN_H
#define OVR_MULTIGRID_PLAIN_H

#undef OVR_ISA
#define OVR_ISA plain
#include "multigrid/table.h"

#endif
