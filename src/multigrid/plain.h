/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The table "plain": every kernel once more (NAME.plain.c beside
 * NAME.kernel.c) in the shortest C that states it, node by node.  It has one
 * lane, whose places are the nodes themselves; nothing is repeated in halos.
 * Tests hold the vectors' kernels against it; simulations run on it too.
 */
#ifndef OVR_MULTIGRID_PLAIN_H
#define OVR_MULTIGRID_PLAIN_H

#undef OVR_ISA
#define OVR_ISA plain
#include "multigrid/table.h"

#endif
