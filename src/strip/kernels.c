/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "strip/kernels.h"

#include <string.h>

extern const ovr_strip_kernels ovr_strip_kernels_base;
#if defined __x86_64__ && !defined OVR_NO_AVX2
extern const ovr_strip_kernels ovr_strip_kernels_avx2;
#ifndef OVR_NO_AVX512
extern const ovr_strip_kernels ovr_strip_kernels_avx512;
#endif
#endif

const ovr_strip_kernels *ovr_strip_kernels_of(const ovr_kernels *kernels)
{
    static const ovr_strip_kernels *const all[] = {
#if defined __x86_64__ && !defined OVR_NO_AVX2
#ifndef OVR_NO_AVX512
        &ovr_strip_kernels_avx512,
#endif
        &ovr_strip_kernels_avx2,
#endif
        &ovr_strip_kernels_base
    };
    for (size_t k = 0; k < sizeof all / sizeof *all; k++)
        if (!strcmp(all[k]->name, kernels->name))
            return all[k];
    return &ovr_strip_kernels_base;
}
