/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "strip.h"

#include <math.h>
#include <stdlib.h>

#include "contact.h"
#include "contact/film_formula.h"
#include "test.h"

ovr_strip_shape test_strip_shape(size_t n, size_t lines)
{
    return (ovr_strip_shape){.n = n,
                             .lines = lines,
                             .coarsest = 33,
                             .X_a = -4,
                             .X_b = 1.5,
                             .width = 2};
}

test_strip *test_strip_make(double M, double L, ovr_strip_shape shape,
                            const char *set)
{
    test_strip *s = calloc(1, sizeof *s);
    assert_non_null(s);
    test_contact contact = test_contact_make(M, L);
    ovr_error err = {0};
    s->arena = ovr_arena_make(NULL);
    s->M = M;
    s->L = L;
    s->period = shape.width;
    CHECK_OK(ovr_strip_create(&s->strip, &shape, ovr_kernels_choose(set),
                              &s->arena, &err),
             &err);
    s->strip.fluid = (ovr_fluid){.lubricant = contact.lubricant,
                                 .lambda = contact.contact.lambda,
                                 .by_gap = true};
    return s;
}

void test_strip_free(test_strip *s)
{
    ovr_strip_release(&s->strip);
    ovr_arena_release(&s->arena);
    free(s);
}

/* Computes the factors g of Y in S = A growth (f_0 g_0 + f_1 g_1), f of X. */
static void across(const test_bump *b, double period, double y, double g[2])
{
    const double turn = 2 * acos(-1);
    g[0] = 1;
    g[1] = 0;
    if (b->along != 0 || b->across != 0) {
        g[0] = cos(turn * b->across * y);
        g[1] = -sin(turn * b->across * y);
        return;
    }
    y -= period * floor(y / period + 0.5);
    if (b->round)
        g[0] = 0;
    for (int image = -1; b->round && image <= 1; image++)
        g[0] += exp(-pow((y - image * period) / b->width, 2));
}

static void along(const test_bump *b, double x, double f[2])
{
    const double turn = 2 * acos(-1);
    f[0] = exp(-x * x / (b->width * b->width));
    f[1] = 0;
    if (b->along != 0 || b->across != 0) {
        f[0] = cos(turn * b->along * x);
        f[1] = sin(turn * b->along * x);
    }
}

static double growth(const test_bump *b, double T)
{
    double t = b->grow > 0 ? fmax(0, fmin(1, T / b->grow)) : 1;
    return t * t * t * (10 - 15 * t + 6 * t * t);
}

void test_strip_gap(void *strip, double T, const ovr_strip_grid *grid,
                    ptrdiff_t from, size_t n, double *gap)
{
    const test_strip *s = strip;
    double *g = calloc(2 * grid->lines, sizeof *g);
    assert_non_null(g);
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < grid->lines; j++) {
            double X = grid->X_a + (double)(from + (ptrdiff_t)i) * grid->D;
            gap[i * grid->stride + j] = 0.5 * X * X;
        }
    for (int k = 0; k < s->bumps; k++) {
        const test_bump *b = &s->bump[k];
        double A = b->A * growth(b, T), f[2];
        for (size_t j = 0; j < grid->lines; j++)
            across(b, s->period, (double)j * grid->Dy - b->y, g + 2 * j);
        for (size_t i = 0; i < n; i++) {
            double X = grid->X_a + (double)(from + (ptrdiff_t)i) * grid->D;
            along(b, X - b->x - b->u * T, f);
            for (size_t j = 0; j < grid->lines; j++)
                gap[i * grid->stride + j] -= A * (f[0] * g[2 * j] +
                                                  f[1] * g[2 * j + 1]);
        }
    }
    free(g);
}

void test_strip_solve(test_strip *s, double tolerance)
{
    const ovr_strip_full how = {.gap = test_strip_gap,
                                .data = s,
                                .force = acos(0),
                                .speed = 1,
                                .half_width = 1,
                                .film = ovr_film_central_moes(s->M, s->L),
                                .cycling = ovr_strip_steady(&s->strip.fluid),
                                .cycles = 2,
                                .max_cycles = 40,
                                .tolerance = tolerance};
    int cycles;
    ovr_strip_defect d = ovr_strip_solve(&s->strip, &how, &cycles);
    CHECK_NEAR(d.imbalance, 0, tolerance);
    CHECK_NEAR(d.load, 0, 10 * tolerance);
}

const ovr_strip_level *test_strip_finest(const test_strip *s)
{
    return &s->strip.level[s->strip.finest];
}

double test_strip_at(const test_strip *s, const double *x, size_t i, size_t j)
{
    const ovr_strip_grid *g = &test_strip_finest(s)->grid;
    return x[ovr_strip_row(g, i) + j % g->lines];
}

double test_strip_smallest(const test_strip *s, const double *x)
{
    const ovr_strip_grid *g = &test_strip_finest(s)->grid;
    double best = INFINITY;
    for (size_t i = 1; i + 1 < g->n; i++)
        for (size_t j = 0; j < g->lines; j++)
            best = fmin(best, test_strip_at(s, x, i, j));
    return best;
}

double test_strip_largest(const test_strip *s, const double *x)
{
    const ovr_strip_grid *g = &test_strip_finest(s)->grid;
    double best = -INFINITY;
    for (size_t i = 1; i + 1 < g->n; i++)
        for (size_t j = 0; j < g->lines; j++)
            best = fmax(best, test_strip_at(s, x, i, j));
    return best;
}
