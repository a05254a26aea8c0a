/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Model problems of section 5 of the paper with the kernel of the library:
 *
 *     [eps_{i-1/2} (P_{i-1} - P_i) + eps_{i+1/2} (P_{i+1} - P_i)]/D^2
 *         - (H_i - H_{i-1})/D = f_i,     H = -K P/pi
 *
 * (equation 8 divided by D; equation 9 if eps is constant), P = 0 at both ends.
 * The problems are linear. Therefore a relaxation is measured on random errors
 * of a problem with zero solution, and multigrid is the correction scheme. */
#include "support/deformation.h"
#include "support/test.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/arena.h"
#include "multigrid/deformation.h"
#include "multigrid/field.h"

enum { LEVELS = 12 };

typedef struct grid {
    size_t n;
    double D, bound; /* switch: Gauss-Seidel where eps > bound */
    double *P, *w, *eps, *f, *r, *delta;
    double k[3];
    test_deformation deformation;
} grid;

typedef struct model {
    ovr_arena arena;
    grid grid[LEVELS];
    int coarsest;
    double seidel, dipole; /* under-relaxation */
} model;

static void make_grid(model *m, int level, double eps_of(double))
{
    ovr_error err = {0};
    grid *g = &m->grid[level];
    double **all[] = {&g->P, &g->w, &g->eps, &g->f, &g->r, &g->delta};
    g->n = ((size_t)7 << level) + 1;
    g->D = 5.5 / (double)(g->n - 1);
    for (size_t k = 0; k < 6; k++)
        assert_non_null(*all[k] = ovr_field(&m->arena, g->n, &err));
    for (int d = 0; d < 3; d++)
        g->k[d] = ovr_deformation_kernel(d, g->D);
    for (size_t i = 0; i < g->n; i++)
        g->eps[i] = eps_of(-4 + (double)i * g->D);
    g->deformation = test_deformation_plan("base", g->n, g->D, 10, 16,
                                           &m->arena);
}

static model *make_model(int coarsest, int finest, double eps_of(double))
{
    ovr_error err = {0};
    ovr_arena arena = ovr_arena_make(NULL);
    model *m = ovr_arena_take(&arena, 1, sizeof *m, &err);
    assert_non_null(m);
    m->arena = arena;
    m->coarsest = coarsest;
    m->seidel = 1;
    m->dipole = 0.6;
    for (int l = coarsest; l <= finest; l++)
        make_grid(m, l, eps_of);
    return m;
}

static void free_model(model *m)
{
    ovr_arena arena = m->arena;
    ovr_arena_release(&arena);
}

static double row(const grid *g, size_t i)
{
    const double *P = g->P, *e = g->eps, *w = g->w;
    return 0.5 / (g->D * g->D) *
               ((e[i - 1] + e[i]) * (P[i - 1] - P[i]) +
                (e[i] + e[i + 1]) * (P[i + 1] - P[i])) +
           (w[i] - w[i - 1]) / g->D;
}

static void film(grid *g)
{
    test_deform(&g->deformation, g->P, g->w);
}

static double residual(grid *g)
{
    double sum = 0;
    film(g);
    for (size_t i = 1; i + 1 < g->n; i++) {
        g->r[i] = g->f[i] - row(g, i);
        sum += g->r[i] * g->r[i];
    }
    return sqrt(sum * g->D);
}

/* The paper's hybrid sweep: film as it was when the sweep began. */
static void relax(const model *m, grid *g)
{
    const double *e = g->eps;
    double h = 0.5 / (g->D * g->D), elastic = (g->k[0] - g->k[1]) / g->D;
    double next = (g->k[1] - g->k[0]) / g->D;
    film(g);
    memset(g->delta, 0, g->n * sizeof(double));
    for (size_t i = 1; i + 1 < g->n; i++) {
        double r = g->f[i] - row(g, i);
        double own = elastic - h * (e[i - 1] + 2 * e[i] + e[i + 1]);
        double before = next + h * (e[i - 1] + e[i]);
        if (0.25 * (e[i - 1] + 2 * e[i] + e[i + 1]) > g->bound)
            g->P[i] += m->seidel * r / own;
        else
            g->delta[i] = m->dipole * r / (own - before);
    }
    for (size_t i = 1; i + 1 < g->n; i++)
        g->P[i] += g->delta[i] - g->delta[i + 1];
}

/* ------------------------------------------------- one grid, random errors */

static void random_error(grid *g, uint64_t *state)
{
    for (size_t i = 1; i + 1 < g->n; i++)
        g->P[i] = test_random(state, -1, 1);
}

static double size_of_error(const grid *g)
{
    double sum = 0;
    for (size_t i = 0; i < g->n; i++)
        sum += g->P[i] * g->P[i];
    return sqrt(sum);
}

/* Factor a sweep after many: above 1 the relaxation diverges. */
static double growth(const model *m, grid *g)
{
    enum { BEFORE = 60, SWEEPS = 40 };
    uint64_t state = 7;
    double size;
    random_error(g, &state);
    for (int k = 0; k < BEFORE; k++)
        relax(m, g);
    size = size_of_error(g);
    for (int k = 0; k < SWEEPS; k++)
        relax(m, g);
    return pow(size_of_error(g) / size, 1. / SWEEPS);
}

/* Adds |e_k|^2 of the sine modes k = n/2..n-2, the high frequencies. */
static void add_power(const grid *g, double *power)
{
    const double step = acos(-1.0) / (double)(g->n - 1);
    for (size_t k = g->n / 2; k + 1 < g->n; k++) {
        double sum = 0;
        for (size_t i = 1; i + 1 < g->n; i++)
            sum += g->P[i] * sin(step * (double)(i * k));
        power[k] += sum * sum;
    }
}

/* Largest amplitude factor of high-frequency components in one sweep, over
 * many random errors. */
static double smoothing_rate(const model *m, grid *g)
{
    enum { TRIALS = 60, MAX = 512 };
    double before[MAX] = {0}, after[MAX] = {0}, worst = 0;
    uint64_t state = 5;
    assert_true(g->n <= MAX);
    for (int t = 0; t < TRIALS; t++) {
        random_error(g, &state);
        add_power(g, before);
        relax(m, g);
        add_power(g, after);
    }
    for (size_t k = g->n / 2; k + 1 < g->n; k++)
        worst = fmax(worst, sqrt(after[k] / before[k]));
    return worst;
}

/* -------------------------------------------------------------- multigrid */

static void restrict_residual(const grid *fine, grid *coarse)
{
    const double *r = fine->r;
    for (size_t I = 1; I + 1 < coarse->n; I++)
        coarse->f[I] = 0.25 * (r[2 * I - 1] + 2 * r[2 * I] + r[2 * I + 1]);
    memset(coarse->P, 0, coarse->n * sizeof(double));
}

static void correct(const grid *coarse, grid *fine)
{
    for (size_t I = 0; I + 1 < coarse->n; I++) {
        fine->P[2 * I] += coarse->P[I];
        fine->P[2 * I + 1] += 0.5 * (coarse->P[I] + coarse->P[I + 1]);
    }
}

/* V(2,2) (index 1) or W(2,2) (index 2); many sweeps on the coarsest grid. */
static void cycle(model *m, int level, int index)
{
    grid *g = &m->grid[level];
    int sweeps = level == m->coarsest ? 50 : 2;
    for (int s = 0; s < sweeps; s++)
        relax(m, g);
    if (level == m->coarsest)
        return;
    residual(g);
    restrict_residual(g, &m->grid[level - 1]);
    for (int c = 0; c < index; c++)
        cycle(m, level - 1, index);
    correct(&m->grid[level - 1], g);
    for (int s = 0; s < sweeps; s++)
        relax(m, g);
}

/* Mean factor on the residual a cycle, of a random right-hand side, after the
 * first two cycles. */
static double cycle_factor(model *m, int finest, int index)
{
    enum { FIRST = 2, CYCLES = 8 };
    grid *g = &m->grid[finest];
    uint64_t state = 3;
    double begun;
    memset(g->P, 0, g->n * sizeof(double));
    for (size_t i = 1; i + 1 < g->n; i++)
        g->f[i] = test_random(&state, -1, 1);
    for (int c = 0; c < FIRST; c++)
        cycle(m, finest, index);
    begun = residual(g);
    for (int c = 0; c < CYCLES; c++)
        cycle(m, finest, index);
    return pow(residual(g) / begun, 1. / CYCLES);
}

/* ------------------------------------------------------------------ tests */

/* eps/D^2 = ratio everywhere, level 6. */
static double constant_eps;

static double constant(double X)
{
    (void)X;
    return constant_eps;
}

static model *constant_model(double ratio, bool seidel, double dipole)
{
    enum { LEVEL = 6 };
    const double D = 5.5 / (7 << LEVEL);
    model *m;
    constant_eps = ratio * D * D;
    m = make_model(LEVEL, LEVEL, constant);
    m->dipole = dipole;
    m->grid[LEVEL].bound = seidel ? -1 : INFINITY;
    return m;
}

static double measured(double of(const model *, grid *), double ratio,
                       bool seidel, double dipole)
{
    model *m = constant_model(ratio, seidel, dipole);
    double value = of(m, &m->grid[6]);
    free_model(m);
    return value;
}

/* "The lower limit of the stability range is approximately eps/D = 0.01":
 * that is eps/D^2 = 0.8 at level 6; here it lies between 0.5 and 8. */
TEST(test_gauss_seidel_stability)
{
    for (double ratio = 8; ratio < 1e4; ratio *= 4)
        assert_true(measured(growth, ratio, true, 1) < 1.001);
    for (double ratio = 0.5; ratio > 1e-4; ratio /= 4)
        assert_true(measured(growth, ratio, true, 1) > 1.2);
}

/* Unstable for large eps, unless under-relaxed by 0.6. */
TEST(test_dipole_stability)
{
    assert_true(measured(growth, 100, false, 1) > 1.2);
    assert_true(measured(growth, 1, false, 1) > 1.2);
    assert_true(measured(growth, 0, false, 1) < 1.001);
    for (double ratio = 1e-4; ratio < 1e4; ratio *= 10)
        assert_true(measured(growth, ratio, false, 0.6) < 1.001);
}

TEST(test_smoothing_rates)
{
    double seidel = measured(smoothing_rate, 1e4, true, 1);
    double dipole = measured(smoothing_rate, 0, false, 0.5);
    print_message("# smoothing rates: Gauss-Seidel %.2f (paper 0.5), dipole "
                  "%.2f (paper 0.4)\n",
                  seidel, dipole);
    CHECK_NEAR(seidel, 0.5, 0.07);
    CHECK_NEAR(dipole, 0.4, 0.07);
}

/* Equation 10. */
static double varying(double X)
{
    return fabs(X) > 1 ? pow(X, 6) : 0;
}

static double varying_factor(int finest, int index)
{
    model *m = make_model(1, finest, varying);
    double factor;
    for (int l = 1; l <= finest; l++)
        m->grid[l].bound = 0.01 * m->grid[l].D; /* the paper's switch */
    factor = cycle_factor(m, finest, index);
    free_model(m);
    return factor;
}

/* According to the paper V(2,2) and W(2,2) reduce the error by one order of
 * magnitude per cycle. This holds for W; V achieves half of it. */
TEST(test_hybrid_cycles)
{
    for (int finest = 7; finest <= 9; finest++) {
        double V = varying_factor(finest, 1), W = varying_factor(finest, 2);
        print_message("# level %d: factor %.2f per V(2,2), %.2f per W(2,2)\n",
                      finest, V, W);
        assert_true(V < 0.4);
        assert_true(W < 0.16);
    }
}
