/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Measures the peak performance of this machine: multiply-adds in registers for
 * each instruction set, and a triad c = a + s b for a given total of bytes. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#ifdef __x86_64__
#include <immintrin.h>
#endif

#include "bench.h"
#include "multigrid/kernels.h"
#include "support/test.h"

/* Number of independent sums, more than the latency of an addition times the
 * number of units. */
enum { CHAINS = 12, TURNS = 2000 };

#ifdef __clang__
#define IN_REGISTERS _Pragma("unroll")
#else
#define IN_REGISTERS _Pragma("GCC unroll 32")
#endif

/* Defines a loop of TURNS x CHAINS vector operations v <- v m + c. */
/* clang-format off */
#define FLOPS(name, attributes, type, start, step)                             \
    attributes static void name(void *data)                                    \
    {                                                                          \
        type v[CHAINS], m = start(0.999), c = start(0.001);                    \
        IN_REGISTERS                                                           \
        for (int k = 0; k < CHAINS; k++)                                       \
            v[k] = start(k);                                                   \
        for (int t = 0; t < TURNS; t++) {                                      \
            IN_REGISTERS                                                       \
            for (int k = 0; k < CHAINS; k++)                                   \
                v[k] = step(v[k], m, c);                                       \
        }                                                                      \
        IN_REGISTERS                                                           \
        for (int k = 1; k < CHAINS; k++)                                       \
            v[0] = step(v[0], m, v[k]);                                        \
        memcpy(data, &v[0], sizeof(double));                                   \
    }
/* clang-format on */

#ifdef __x86_64__
#define PLAIN_STEP(v, m, c) _mm_add_pd(_mm_mul_pd(v, m), c)
FLOPS(flops_base, , __m128d, _mm_set1_pd, PLAIN_STEP)
FLOPS(flops_avx2, __attribute__((target("avx2,fma"))), __m256d, _mm256_set1_pd,
      _mm256_fmadd_pd)
FLOPS(flops_avx512, __attribute__((target("avx512f"))), __m512d, _mm512_set1_pd,
      _mm512_fmadd_pd)
#else
#define PLAIN_START(x) (double)(x)
#define PLAIN_STEP(v, m, c) ((v) * (m) + (c))
FLOPS(flops_base, , double, PLAIN_START, PLAIN_STEP)
#endif

double bench_peak_flops(const char *set)
{
    double sink, flops = 2. * TURNS * CHAINS * (double)bench_lanes(set);
    bench_work work = {flops_base, &sink, 0};
#ifdef __x86_64__
    if (!strcmp(set, "avx2"))
        work.run = flops_avx2;
    if (!strcmp(set, "avx512"))
        work.run = flops_avx512;
#endif
    bench_measure(1, &work, 1e-3, 15);
    return flops / work.seconds;
}

double bench_lanes(const char *set)
{
    return (double)ovr_kernels_choose(set)->lanes;
}

typedef struct triad {
    size_t n;
    double *a, *b, *c;
} triad;

static void run_triad(void *data)
{
    const triad *t = data;
    ovr_kernels_choose(NULL)->combine(t->n, 1, t->a, 0.5, t->b, t->c);
}

double bench_bandwidth(size_t bytes)
{
    /* the three arrays have different offsets in a page */
    enum { APART = 11 * 8 };
    size_t n = bytes / 24 / 8 * 8, all = 3 * (n + APART);
    double *memory = aligned_alloc(64, all * sizeof *memory);
    triad t = {n, memory, memory + n + APART, memory + 2 * (n + APART)};
    bench_work work = {run_triad, &t, 0};
    for (size_t i = 0; i < all; i++)
        memory[i] = 1;
    bench_measure(1, &work, 1e-3, bytes > (size_t)1 << 26 ? 5 : 15);
    free(memory);
    return 24. * (double)n / work.seconds;
}
