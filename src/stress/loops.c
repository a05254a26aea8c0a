/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "stress/loops.h"

#include <string.h>

extern const ovr_stress_loops ovr_stress_loops_base, ovr_stress_loops_plain;
#if defined __x86_64__ && !defined OVR_NO_AVX2
extern const ovr_stress_loops ovr_stress_loops_avx2;
#ifndef OVR_NO_AVX512
extern const ovr_stress_loops ovr_stress_loops_avx512;
#endif
#endif

static bool machine_runs(const ovr_stress_loops *loops)
{
#if defined __x86_64__ && !defined OVR_NO_AVX2
    __builtin_cpu_init();
#ifndef OVR_NO_AVX512
    if (loops == &ovr_stress_loops_avx512)
        return __builtin_cpu_supports("avx512f") &&
               __builtin_cpu_supports("avx512dq") &&
               __builtin_cpu_supports("avx512vl");
#endif
    if (loops == &ovr_stress_loops_avx2)
        return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#endif
    return loops == &ovr_stress_loops_base || loops == &ovr_stress_loops_plain;
}

const ovr_stress_loops *ovr_stress_loops_choose(const char *name)
{
    static const ovr_stress_loops *const best_first[] = {
#if defined __x86_64__ && !defined OVR_NO_AVX2
#ifndef OVR_NO_AVX512
        &ovr_stress_loops_avx512,
#endif
        &ovr_stress_loops_avx2,
#endif
        &ovr_stress_loops_base,
        &ovr_stress_loops_plain
    };
    for (size_t k = 0; k < sizeof best_first / sizeof *best_first; k++)
        if (machine_runs(best_first[k]) &&
            (!name || !strcmp(name, best_first[k]->name)))
            return best_first[k];
    return NULL;
}
