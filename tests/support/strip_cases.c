/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "strip_cases.h"

#include <math.h>
#include <stdio.h>

#include "contact/film_formula.h"
#include "test.h"

void test_strip_march(test_strip *s, ovr_strip_march *march, double tolerance)
{
    ovr_error err = {0};
    CHECK_OK(ovr_strip_march_create(march, &s->strip, 2, &s->arena, &err),
             &err);
    march->gap = test_strip_gap;
    march->data = s;
    march->force = acos(0);
    march->tolerance = tolerance;
    ovr_strip_march_begin(march, 0);
}

enum { DENT, SCRATCH, WAVE, ROUGH, KINDS };

static const char *const kinds[] = {"dent", "scratch", "wave", "rough"};

static void add(test_strip *s, test_bump b)
{
    s->bump[s->bumps++] = b;
}

/* Draws features that move with u. Their heights are proportional to the film
 * thickness H. */
static void draw_features(test_strip *s, int kind, double H, double u,
                          uint64_t *seed)
{
    double x = test_random(seed, -1.8, -1.3), y = test_random(seed, 0, 2);
    double size = test_random(seed, 0.3, 1.2) * H;
    if (kind == DENT || kind == SCRATCH)
        add(s, (test_bump){.A = -size,
                           .width = test_random(seed, 0.15, 0.4),
                           .x = x,
                           .y = y,
                           .u = u,
                           .round = kind == DENT});
    if (kind == DENT) /* in addition, a bump */
        add(s, (test_bump){.A = 0.3 * size,
                           .width = test_random(seed, 0.15, 0.4),
                           .x = x - 0.5,
                           .y = y + 1,
                           .u = u,
                           .round = true});
    if (kind == WAVE)
        add(s, (test_bump){.A = 0.4 * size,
                           .along = test_random(seed, 0.5, 3),
                           .across = floor(test_random(seed, 0, 4)) / 2,
                           .u = u,
                           .grow = 1});
    /* Waves longer than 0.3 b with Rq = H/lambda. */
    double lambda = exp(test_random(seed, 0, log(5)));
    for (int k = 0; kind == ROUGH && k < 40; k++)
        add(s, (test_bump){.A = H / lambda * sqrt(2. / 40),
                           .along = test_random(seed, -3.3, 3.3),
                           .across = floor(test_random(seed, -6, 7)) / 2,
                           .x = test_random(seed, 0, 10),
                           .u = u,
                           .grow = 1});
}

static size_t coarsest_of(double M)
{
    return M < 90 ? 33 : 65;
}

static void march_on(strip_survey *found, test_strip *s, double u, size_t n,
                     int kind)
{
    ovr_strip_march march;
    long cycles = found->cycles, retries = found->retries;
    long flagged = found->flagged;
    int steps = n > 200 ? 100 : 50, worst = 0;
    test_strip_march(s, &march, kind == DENT || kind == SCRATCH ? 1e-3 : 1e-2);
    march.characteristic = true;
    march.carried = u;
    double D = test_strip_finest(s)->grid.D;
    for (int step = 1; step <= steps; step++) {
        ovr_strip_step done = ovr_strip_march_attempt(&march, step * D);
        found->steps++;
        found->cycles += done.cycles;
        found->retries += done.attempts - 1;
        found->flagged += !done.solved;
        worst = done.cycles > worst ? done.cycles : worst;
        if (!(done.imbalance < 1)) {
            found->failed++;
            printf("failed at step %d, R %g; ", step, done.imbalance);
            break;
        }
        ovr_strip_march_accept(&march);
    }
    printf("%.2f cycles per step (worst %d), %ld retries, %ld flagged\n",
           (double)(found->cycles - cycles) / steps, worst,
           found->retries - retries, found->flagged - flagged);
}

void strip_survey_add(strip_survey *found, unsigned seed, size_t n)
{
    uint64_t draws = seed * 7919u + 5;
    double M = exp(test_random(&draws, log(2), log(400)));
    double L = test_random(&draws, 2, 20), SRR = test_random(&draws, -2, 2);
    if (test_random(&draws, 0, 1) < 0.3)
        SRR = 0;
    int kind = (int)test_random(&draws, 0, KINDS);
    /* Thin films need finer grids. */
    double H = ovr_film_central_moes(M, L);
    size_t nodes = M > 100 && n < 257 ? 257 : n;
    size_t lines = (nodes - 1) / 4;
    ovr_strip_shape shape = test_strip_shape(nodes, lines);
    shape.coarsest = coarsest_of(M);
    test_strip *s = test_strip_make(M, L, shape, NULL);
    s->strip.logarithmic = true;
    draw_features(s, kind, H, 1 + SRR / 2, &draws);
    const ovr_strip_full how = {.gap = test_strip_gap,
                                .data = s,
                                .force = acos(0),
                                .speed = 1,
                                .half_width = 1,
                                .film = ovr_film_central_moes(M, L),
                                .cycling = ovr_strip_steady(&s->strip.fluid),
                                .cycles = 3,
                                .max_cycles = 40,
                                .tolerance = 1e-4};
    int cycles;
    ovr_strip_defect d = ovr_strip_solve(&s->strip, &how, &cycles);
    printf("seed %u M %.1f L %.1f SRR %.2f %s %zu: steady %d cycles R %.1e; ",
           seed, M, L, SRR, kinds[kind], nodes, cycles, d.imbalance);
    found->cases++;
    if (ovr_strip_below(d, 1e-4)) {
        march_on(found, s, 1 + SRR / 2, nodes, kind);
    } else {
        found->unsolved_steady++;
        printf("not solved\n");
    }
    test_strip_free(s);
}

void strip_survey_check(const strip_survey *found)
{
    printf("%d strips: %d steady films not solved; %ld steps, %.2f cycles a "
           "step, %ld retries, %ld flagged, %ld failed\n",
           found->cases, found->unsolved_steady, found->steps,
           (double)found->cycles / (double)found->steps, found->retries,
           found->flagged, found->failed);
    assert_int_equal(found->unsolved_steady, 0);
    assert_int_equal(found->failed, 0);
    assert_true(found->flagged * 1000 <= found->steps);
    assert_true(found->retries * 100 <= found->steps);
}
