/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Work and memory of a strip grow as n log n and n. */
#include <math.h>
#include <stdio.h>
#include <time.h>

#include "support/strip.h"
#include "support/test.h"

/* Operations of the transforms of a deformation. */
static double operations(const ovr_strip_elastic *e)
{
    const fftw_plan *const plans[] = {e->to_modes, e->from_modes, e->to_waves,
                                      e->from_waves};
    double sum = 0;
    for (size_t k = 0; k < 4; k++) {
        size_t all = k < 2 ? e->n : e->modes, block = k < 2 ? 16 : 8;
        for (size_t part = 0; part < 2; part++) {
            double add, mul, fma;
            size_t times = part ? all % block > 0 : all / block;
            if (!times)
                continue;
            assert_non_null(plans[k][part]);
            fftw_flops(plans[k][part], &add, &mul, &fma);
            sum += (double)times * (add + mul + 2 * fma);
        }
    }
    return sum;
}

static double cpu_seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* From 65 x 16 to 2049 x 1024 nodes.  Times are reported only. */
TEST(cost_is_n_log_n)
{
    double first = 0;
    for (int k = 1; k <= 6; k++) {
        size_t n = ((size_t)32 << k) + 1, lines = (size_t)8 << k;
        if (k == 6)
            lines = 1024;
        double nodes = (double)n * (double)lines, spectrum = 2 * nodes;
        test_strip *s = test_strip_make(20, 10, test_strip_shape(n, lines),
                                        NULL);
        double flops = operations(&test_strip_finest(s)->elastic) /
                       (spectrum * log2(spectrum));
        if (k == 1)
            first = flops;
        assert_true(flops < 1.5 * first);
        ovr_strip_level *level = &s->strip.level[s->strip.finest];
        double start = cpu_seconds();
        for (int times = 0; times < 3; times++)
            ovr_strip_deform(&s->strip, level, level->f.P, level->f.w);
        double each = (cpu_seconds() - start) / 3;
        double bytes = (double)s->arena.bytes / nodes;
        printf("%5zu x %4zu nodes: %.2f operations for each n log2 n, %.1f ns "
               "a node, %.0f bytes a node\n",
               n, lines, flops, 1e9 * each / nodes, bytes);
        if (k > 3)
            assert_true(bytes <= 400);
        test_strip_free(s);
    }
}
