/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The kernel of the thermal memory compared with M(t)/sqrt(t). */
#ifndef TESTS_SUPPORT_MEMORY_H
#define TESTS_SUPPORT_MEMORY_H

#include "physics/heat/solids.h"

/* Maximum relative error of the kernel from dT to `longest`. */
double test_memory_error(const ovr_memory *memory, double longest);

#endif
