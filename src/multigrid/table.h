/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Declares and lists the kernels of one instruction set, named OVR_ISA. */
#ifndef OVR_MULTIGRID_TABLE_H
#define OVR_MULTIGRID_TABLE_H

#include "multigrid/kernels.h"

#define OVR_TEXT(x) #x
#define OVR_NAME(x) OVR_TEXT(x)

/* clang-format off */
/* NOLINTBEGIN(bugprone-macro-parentheses): a type, and a list */
#define OVR_KERNEL_DECLARED(type, name, arguments) \
    type OVR_KERNEL(name) arguments;
/* NOLINTEND(bugprone-macro-parentheses) */
#define OVR_KERNEL_ENTRY(type, name, arguments) .name = OVR_KERNEL(name),
#define OVR_KERNELS(number_of_lanes) \
    {.name = OVR_NAME(OVR_ISA), .lanes = (number_of_lanes), \
     OVR_EACH_KERNEL(OVR_KERNEL_ENTRY)}
/* clang-format on */

OVR_EACH_KERNEL(OVR_KERNEL_DECLARED)

extern const ovr_kernels OVR_KERNEL(kernels);

#endif
