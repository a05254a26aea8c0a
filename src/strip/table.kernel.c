/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Strip kernel table of one instruction set. */
#include "multigrid/vector.h"
#include "strip/kernels.h"

#define TEXT(x) #x
#define NAME(x) TEXT(x)
/* clang-format off */
/* NOLINTNEXTLINE(bugprone-macro-parentheses) */
#define DECLARED(type, name, arguments) type OVR_STRIP_KERNEL(name) arguments;
#define ENTRY(type, name, arguments) .name = OVR_STRIP_KERNEL(name),
/* clang-format on */

OVR_STRIP_EACH_KERNEL(DECLARED)

extern const ovr_strip_kernels OVR_STRIP_KERNEL(kernels);

const ovr_strip_kernels OVR_STRIP_KERNEL(kernels) = {
    .name = NAME(OVR_ISA), OVR_STRIP_EACH_KERNEL(ENTRY)};
