/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Parts of the strip: elastic sums, kernels of all instruction sets, a cycle
 * from a solution, memory. */
#include <gsl/gsl_integration.h>
#include <gsl/gsl_sf_bessel.h>
#include <math.h>
#include <stdlib.h>

#include "multigrid/influence.h"
#include "strip/across.h"
#include "strip/kernels.h"
#include "support/strip.h"
#include "support/test.h"

/* A mode that is constant across presses as the line contact does. */
TEST(constant_mode_is_the_line_contact)
{
    const ovr_influence line = {0};
    double k[40];
    ovr_strip_influence(0, 0.043, 40, 1, k);
    for (size_t d = 0; d < 40; d++)
        CHECK_NEAR(-k[d], ovr_influence_at(&line, (double)d, 0.043), 1e-13);
}

static double bessel(double x, void *k)
{
    return gsl_sf_bessel_K0(*(double *)k * fabs(x)) / acos(-1);
}

/* Integral of K0(k |X|)/pi over the mesh at d. */
static double quadrature(gsl_integration_workspace *space, double k, double d,
                         double D)
{
    gsl_function f = {bessel, &k};
    double sum = 0, part, error;
    double from = d > 0 ? (d - 0.5) * D : 0, to = (d + 0.5) * D;
    gsl_integration_qags(&f, from, to, 1e-14, 1e-12, 1000, space, &part,
                         &error);
    sum = d > 0 ? part : 2 * part;
    return sum;
}

TEST(waves_across_agree_with_quadrature)
{
    gsl_integration_workspace *space = gsl_integration_workspace_alloc(1000);
    static const double waves[] = {0.3, 3.1, 40, 400};
    const double D = 0.043;
    for (size_t m = 0; m < sizeof waves / sizeof *waves; m++) {
        double k[12];
        ovr_strip_influence(waves[m], D, 12, 1, k);
        for (size_t d = 0; d < 12; d++)
            CHECK_NEAR(k[d], quadrature(space, waves[m], (double)d, D), 1e-11);
    }
    gsl_integration_workspace_free(space);
}

/* Neighbours, distances, halos and coarse lines agree with coordinates on a
 * circle of circumference W. */
TEST(lines_are_on_a_circle)
{
    static const size_t counts[] = {4, 5, 7, 8, 20, 48};
    const double W = 1.7, turn = 2 * acos(-1) / W;
    for (size_t c = 0; c < sizeof counts / sizeof *counts; c++) {
        const size_t n = counts[c], coarse = ovr_across_halved(n);
        const double Dy = ovr_across_mesh(W, n);
        double row[48 + 2 * OVR_STRIP_HALO], *x = row + OVR_STRIP_HALO;
        for (size_t j = 0; j < n; j++)
            x[j] = sin(turn * ovr_across_Y(W, Dy, j));
        ovr_across_close(n, OVR_STRIP_HALO, x);
        for (ptrdiff_t j = -(ptrdiff_t)n; j < 2 * (ptrdiff_t)n; j++) {
            double value = sin(turn * (-W / 2 + (double)j * Dy));
            size_t line = ovr_across_line(n, j);
            assert_true(line < n);
            CHECK_NEAR(x[line], value, 1e-13);
            if (j >= -OVR_STRIP_HALO && j < (ptrdiff_t)n + OVR_STRIP_HALO)
                CHECK_NEAR(x[j], value, 1e-13);
            double apart = ovr_across_offset(W, (double)(j - 1) * Dy);
            CHECK_NEAR((double)ovr_across_apart(n, line, 1) * Dy, fabs(apart),
                       1e-13);
        }
        for (size_t j = 0; j < coarse; j++)
            CHECK_NEAR(ovr_across_Y(W, ovr_across_mesh(W, coarse), j),
                       ovr_across_Y(W, Dy, j * ovr_across_spacing(n, coarse)),
                       1e-13);
        assert_int_equal(coarse, n == 8 || n >= 20 ? n / 2 : 0);
    }
}

/* Deformation of random pressures against the sums of all nodes by all. */
TEST(transforms_give_direct_sums)
{
    static const size_t sizes[][2] = {{17, 4}, {29, 7}, {33, 10}, {57, 20}};
    uint64_t seed = 3;
    for (size_t c = 0; c < 4; c++) {
        test_strip *s = test_strip_make(
            20, 10, test_strip_shape(sizes[c][0], sizes[c][1]), NULL);
        ovr_strip_level *level = &s->strip.level[s->strip.finest];
        const ovr_strip_grid *g = &level->grid;
        const size_t modes = g->lines / 2 + 1;
        const double turn = 2 * acos(-1) / (double)g->lines;
        double *k = calloc(g->n * modes, sizeof *k);
        for (size_t q = 0; q < modes; q++)
            ovr_strip_influence((double)q * turn / g->Dy, g->D, g->n, modes,
                                k + q);
        for (size_t i = 1; i + 1 < g->n; i++)
            for (size_t j = 0; j < g->lines; j++)
                level->f.P[ovr_strip_row(g, i) + j] = test_random(&seed, 0, 1);
        ovr_strip_deform(&s->strip, level, level->f.P, level->f.w);
        for (size_t i = 0; i < g->n; i++)
            for (size_t j = 0; j < g->lines; j++) {
                double sum = 0;
                for (size_t a = 0; a < g->n; a++)
                    for (size_t b = 0; b < g->lines; b++)
                        for (size_t q = 0; q < g->lines; q++) {
                            size_t mode = q < modes ? q : g->lines - q;
                            size_t d = i > a ? i - a : a - i;
                            double e = (double)((j + g->lines - b) * q);
                            sum += k[d * modes + mode] * cos(turn * e) *
                                   test_strip_at(s, level->f.P, a, b) /
                                   (double)g->lines;
                        }
                CHECK_NEAR(test_strip_at(s, level->f.w, i, j), -sum, 1e-12);
            }
        free(k);
        test_strip_free(s);
    }
}

static const test_bump dent = {
    .A = -0.08, .width = 0.3, .x = -0.2, .y = 0.9, .round = true};

/* All instruction sets take the same steps to the same solution. */
TEST(instruction_sets_agree)
{
    static const char *const sets[] = {"base", "avx2", "avx512"};
    for (int logarithmic = 0; logarithmic < 2; logarithmic++) {
        test_strip *first = NULL;
        for (size_t k = 0; k < sizeof sets / sizeof *sets; k++) {
            if (!ovr_kernels_choose(sets[k]))
                continue;
            test_strip *s = test_strip_make(20, 10, test_strip_shape(129, 28),
                                            sets[k]);
            s->bump[s->bumps++] = dent;
            s->strip.logarithmic = logarithmic;
            test_strip_solve(s, 1e-9);
            const ovr_strip_fields *f = &test_strip_finest(s)->f;
            for (size_t i = 0; first && i < 129; i++)
                for (size_t j = 0; j < 28; j++) {
                    const ovr_strip_fields *o = &test_strip_finest(first)->f;
                    CHECK_NEAR(test_strip_at(s, f->P, i, j),
                               test_strip_at(first, o->P, i, j), 1e-9);
                    CHECK_NEAR(test_strip_at(s, f->H, i, j),
                               test_strip_at(first, o->H, i, j), 1e-9);
                }
            if (first)
                test_strip_free(s);
            else
                first = s;
        }
        test_strip_free(first);
    }
}

/* Coarse grids add nothing to a solution, whichever way lines are coupled. */
TEST(solution_stays_in_a_cycle)
{
    for (int zebra = 0; zebra < 2; zebra++) {
        test_strip *s = test_strip_make(20, 10, test_strip_shape(129, 28),
                                        NULL);
        s->bump[s->bumps++] = dent;
        test_strip_solve(s, 1e-11);
        ovr_strip_cycling how = ovr_strip_steady(&s->strip.fluid);
        how.smoothing.zebra = zebra;
        double H0 = s->strip.H0;
        ovr_strip_level *finest = &s->strip.level[s->strip.finest];
        ovr_strip_cycle(&s->strip, s->strip.finest, &how);
        ovr_strip_defect d = ovr_strip_defect_of(&s->strip, finest);
        CHECK_NEAR(d.imbalance, 0, 1e-11);
        CHECK_NEAR(s->strip.H0, H0, 1e-12);
        test_strip_free(s);
    }
}

/* Sum of |r| of the nodes up to `reach` rows and lines from a node. */
static double residual_about(const test_strip *s, size_t i, size_t j,
                             size_t reach)
{
    const ovr_strip_level *level = test_strip_finest(s);
    const size_t lines = level->grid.lines;
    double sum = 0;
    for (size_t a = i - reach; a <= i + reach; a++)
        for (size_t b = 0; b <= 2 * reach; b++)
            sum += fabs(test_strip_at(s, level->f.r, a,
                                      (j + lines - reach + b) % lines));
    return sum;
}

/* Newton's method on patches converges with second order where two spots are
 * disturbed, one of them at the side of the period. */
TEST(patches_are_solved_by_newton)
{
    static const size_t spot[2][2] = {{60, 14}, {58, 1}};
    test_strip *s = test_strip_make(20, 10, test_strip_shape(129, 28), NULL);
    s->bump[s->bumps++] = dent;
    test_strip_solve(s, 1e-11);
    ovr_strip_level *level = &s->strip.level[s->strip.finest];
    const ovr_strip_cycling how = ovr_strip_steady(&s->strip.fluid);
    for (size_t k = 0; k < 2; k++)
        level->f.P[ovr_strip_row(&level->grid, spot[k][0]) + spot[k][1]] +=
            3e-3;
    ovr_strip_refresh(&s->strip, level);
    ovr_strip_defect_of(&s->strip, level);
    double r[4][2];
    for (int step = 0; step < 4; step++) {
        for (size_t k = 0; k < 2; k++)
            r[step][k] = residual_about(s, spot[k][0], spot[k][1], 3);
        printf("residuals %.2e %.2e\n", r[step][0], r[step][1]);
        double worst = fmax(r[step][0], r[step][1]);
        size_t solved = ovr_strip_spots(&s->strip, level, &how.smoothing,
                                        1e-3 * worst);
        assert_in_range(solved, 1, 12);
        ovr_strip_defect_of(&s->strip, level);
    }
    for (size_t k = 0; k < 2; k++) {
        assert_true(r[2][k] < 1e-2 * r[1][k]);
        assert_true(r[3][k] < 1e-4 * r[2][k]);
    }
    test_strip_free(s);
}

static ovr_status create(void *unused, const ovr_allocator *hook,
                         ovr_error *err)
{
    (void)unused;
    const ovr_strip_shape shape = test_strip_shape(65, 16);
    ovr_arena arena = ovr_arena_make(hook);
    ovr_strip strip = {0};
    ovr_status status = ovr_strip_create(&strip, &shape,
                                         ovr_kernels_choose(NULL), &arena, err);
    ovr_strip_release(&strip);
    ovr_arena_release(&arena);
    return status;
}

TEST(memory_that_is_not_there_is_an_error)
{
    assert_true(test_every_allocation(create, NULL) > 4);
}

TEST(grids_that_cannot_be_are_refused)
{
    ovr_strip strip = {0};
    ovr_arena arena = ovr_arena_make(NULL);
    ovr_error err = {0};
    const ovr_strip_shape shape = test_strip_shape(65, 3);
    ovr_strip_create(&strip, &shape, ovr_kernels_choose(NULL), &arena, &err);
    CHECK_ERROR(&err, OVR_BAD_INPUT, "no coarse grid");
    ovr_strip_release(&strip);
    ovr_arena_release(&arena);
}
