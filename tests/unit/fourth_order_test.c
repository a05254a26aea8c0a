/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Fourth-order correction (multigrid/fourth_order.h): each part alone compared
 * with manufactured pressures, film thicknesses and coefficients, and the
 * vector kernels with the plain ones. */
#include <gsl/gsl_integration.h>
#include <math.h>

#include "support/kernels.h"
#include "support/test.h"

enum { N = 449 };

/* A grid on [-1, 1] of a table, with the correction's arrays. */
typedef struct corrected {
    test_grid grid;
    ovr_fourth c;
} corrected;

static corrected make(const ovr_kernels *run, size_t n, double from, double to)
{
    corrected made = {.grid = test_grid_make(run, n)};
    const ovr_band *band = &made.grid.band;
    static const ovr_fluid newtonian = {0};
    made.c = (ovr_fourth){.fluid = &newtonian,
                          .D = (to - from) / (double)(n - 1),
                          .Cu = 1,
                          .log_eps = band->b[0],
                          .flux = band->b[1],
                          .mask = band->b[2],
                          .F = band->b[3],
                          .gap = band->b[4],
                          .local = OVR_FOURTH_LOCAL};
    return made;
}

static void fill(const test_grid *grid, double *to, double (*f)(double),
                 double from, double D)
{
    double values[2 * N];
    for (size_t i = 0; i < grid->n; i++)
        values[i] = f ? f(from + D * (double)i) : 0;
    grid->run->pack(&grid->lanes, values, to);
}

static void correct(const corrected *of)
{
    const test_grid *grid = &of->grid;
    grid->run->fourth_mask(&grid->lanes, grid->f.P, of->c.mask);
    grid->run->fourth_order(&grid->lanes, &of->c, &grid->f, grid->w);
}

static double one(double X)
{
    (void)X;
    return 1;
}

static double tiny(double X)
{
    (void)X;
    return 1e-200;
}

/* P = (2 + X) e^X, eps = e^(-X^2 - 2 P), q = P */
static double pressure(double X)
{
    return (2 + X) * exp(X);
}

static double slope(double X)
{
    return (3 + X) * exp(X);
}

static double coefficient(double X)
{
    return exp(-X * X - 2 * pressure(X));
}

/* d/dX(eps dP/dX) */
static double diffusion(double X)
{
    double p = slope(X);
    return coefficient(X) * ((4 + X) * exp(X) - (2 * X + 2 * p) * p);
}

/* Largest error of second and fourth order of a part on a grid. */
typedef struct errors {
    double second, fourth;
} errors;

static void worst(errors *e, double second, double fourth)
{
    e->second = fmax(e->second, fabs(second));
    e->fourth = fmax(e->fourth, fabs(fourth));
}

static double opening(double X)
{
    return 1.5 + 0.3 * sin(3 * X);
}

/* Between X and Y, of both nodes or with their gaps in line. */
static double between(double X, double Y, bool gap)
{
    double f = coefficient(X), g = coefficient(Y), a, b;
    a = pow(opening(X), 3);
    b = pow(opening(Y), 3);
    return gap ? (f / a + g / b) / (1 / a + 1 / b) : (f + g) / 2;
}

/* The equation's own second-order terms beside what corrects them, where the
 * coefficient is interpolated by logarithms (all upstream) or not. */
static errors poiseuille(const ovr_kernels *run, size_t n, bool upstream,
                         bool gap)
{
    corrected of = make(run, n, -1, 1);
    const test_grid *g = &of.grid;
    double D = of.c.D, F[2 * N];
    errors e = {0};
    of.c.first = 0, of.c.end = upstream ? (ptrdiff_t)n : 0;
    fill(g, g->f.P, pressure, -1, D);
    fill(g, g->f.eps, coefficient, -1, D);
    fill(g, g->f.q, NULL, -1, D);
    fill(g, g->w, NULL, -1, D);
    if (gap) {
        test_grid_gap(&of.grid);
        fill(g, g->f.H, opening, -1, D);
        fill(g, g->f.deps, NULL, -1, D);
        run->faces(&(ovr_fluid){0}, &g->lanes, &g->f);
    }
    correct(&of);
    g->run->unpack(&g->lanes, of.c.F, F);
    for (size_t i = OVR_FOURTH_MARGIN; i + OVR_FOURTH_MARGIN < n; i++) {
        double X = -1 + D * (double)i, l = X - D, r = X + D;
        double N2 = (between(l, X, gap) * (pressure(l) - pressure(X)) +
                     between(X, r, gap) * (pressure(r) - pressure(X))) /
                    (D * D);
        worst(&e, N2 - diffusion(X), N2 - F[i] - diffusion(X));
    }
    ovr_arena_release(&of.grid.arena);
    return e;
}

static errors by_logarithms(const ovr_kernels *run, size_t n)
{
    return poiseuille(run, n, true, false);
}

static errors by_values(const ovr_kernels *run, size_t n)
{
    return poiseuille(run, n, false, false);
}

static errors by_logarithms_and_gap(const ovr_kernels *run, size_t n)
{
    return poiseuille(run, n, true, true);
}

static errors by_values_and_gap(const ovr_kernels *run, size_t n)
{
    return poiseuille(run, n, false, true);
}

/* rho, m = 1/eta and eps = rho H^3 m, d ln m/dP and d rho/dP of P. */
static double density(double X)
{
    return 1 + 0.1 * pressure(X);
}

static double fluidity_of(double X)
{
    double P = pressure(X);
    return exp(-2 * P + 0.1 * P * P);
}

static double log2_fluidity(double X)
{
    return log2(fluidity_of(X));
}

static double flow_of(double X)
{
    return density(X) * pow(opening(X), 3) * fluidity_of(X);
}

static double log_slope(double X)
{
    return -2 + 0.2 * pressure(X);
}

/* rho H^3 m dP/dX */
static double poiseuille_flux(double X)
{
    return flow_of(X) * slope(X);
}

/* By reduced pressures, beside logarithmic means. */
static errors by_reduced_pressure(const ovr_kernels *run, size_t n)
{
    corrected of = make(run, n, -1, 1);
    const test_grid *g = &of.grid;
    const ovr_fields *f = &g->f;
    double D = of.c.D, F[2 * N], flow[2 * N];
    errors e = {0};
    test_grid_logarithmic(&of.grid);
    of.c.reduced = true;
    of.c.rise = g->band.delta;
    of.c.first = of.c.end = 0;
    fill(g, f->P, pressure, -1, D);
    fill(g, f->H, opening, -1, D);
    fill(g, f->rho, density, -1, D);
    fill(g, f->eps, flow_of, -1, D);
    fill(g, f->deps, NULL, -1, D);
    fill(g, f->log_slope, log_slope, -1, D);
    fill(g, f->log_fluidity, log2_fluidity, -1, D);
    fill(g, f->q, NULL, -1, D);
    fill(g, g->w, NULL, -1, D);
    run->faces(&(ovr_fluid){0}, &g->lanes, f);
    correct(&of);
    run->unpack(&g->lanes, of.c.F, F);
    run->unpack(&g->lanes, f->flow, flow);
    for (size_t i = OVR_FOURTH_MARGIN; i + OVR_FOURTH_MARGIN < n; i++) {
        const double h = 1e-5;
        double X = -1 + D * (double)i, l = X - D, r = X + D;
        double exact = (poiseuille_flux(X + h) - poiseuille_flux(X - h)) /
                       (2 * h);
        double N2 = (flow[i - 1] * (pressure(l) - pressure(X)) +
                     flow[i] * (pressure(r) - pressure(X))) /
                    (2 * D * D);
        worst(&e, N2 - exact, N2 - F[i] - exact);
    }
    ovr_arena_release(&of.grid.arena);
    return e;
}

static errors wedge(const ovr_kernels *run, size_t n)
{
    corrected of = make(run, n, -1, 1);
    const test_grid *g = &of.grid;
    double D = of.c.D, F[2 * N];
    errors e = {0};
    fill(g, g->f.P, one, -1, D);
    fill(g, g->f.eps, tiny, -1, D);
    fill(g, g->f.q, pressure, -1, D);
    fill(g, g->w, NULL, -1, D);
    correct(&of);
    g->run->unpack(&g->lanes, of.c.F, F);
    for (size_t i = OVR_FOURTH_MARGIN; i + OVR_FOURTH_MARGIN < n; i++) {
        double X = -1 + D * (double)i;
        double N2 = -(1.5 * pressure(X) - 2 * pressure(X - D) +
                      0.5 * pressure(X - 2 * D)) /
                    D;
        worst(&e, N2 + slope(X), N2 - F[i] + slope(X));
    }
    ovr_arena_release(&of.grid.arena);
    return e;
}

/* (1 - X^2)^6 on the contact, as smooth as order four wants it. */
static double dome(double X)
{
    return X * X < 1 ? pow(1 - X * X, 6) : 0;
}

static double weighted(double X, void *at)
{
    double distance = fabs(X - *(double *)at);
    return distance > 0 ? dome(X) * log(distance) : 0;
}

/* (1/pi) int P ln|X - X'| dX' by adaptive quadrature */
static double deformation(double X)
{
    enum { SIZE = 200 };
    double points[3] = {-1, X, 1}, value, error;
    gsl_integration_workspace *workspace = gsl_integration_workspace_alloc(
        SIZE);
    gsl_function f = {weighted, &X};
    gsl_integration_qagp(&f, points, 3, 1e-13, 1e-13, SIZE, workspace, &value,
                         &error);
    gsl_integration_workspace_free(workspace);
    return value / 3.14159265358979323846;
}

static errors film(const ovr_kernels *run, size_t n)
{
    corrected of = make(run, n, -1.5, 1.5);
    const test_grid *g = &of.grid;
    double D = of.c.D, w[2 * N], gap[2 * N];
    errors e = {0};
    for (size_t i = 0; i < n; i++) {
        w[i] = 0;
        for (size_t j = 0; j < n; j++)
            w[i] += dome(-1.5 + D * (double)j) *
                    ovr_deformation_kernel(fabs((double)i - (double)j), D);
    }
    fill(g, g->f.P, dome, -1.5, D);
    fill(g, g->f.eps, one, -1.5, D);
    fill(g, g->f.q, one, -1.5, D);
    g->run->pack(&g->lanes, w, g->w);
    correct(&of);
    g->run->unpack(&g->lanes, of.c.gap, gap);
    for (size_t i = n / 4; i < n - n / 4; i += n / 16) {
        double exact = deformation(-1.5 + D * (double)i);
        worst(&e, w[i] - exact, w[i] - gap[i] - exact);
    }
    ovr_arena_release(&of.grid.arena);
    return e;
}

/* Twice the nodes: a quarter of the error, and a sixteenth. */
static void falls(errors (*part)(const ovr_kernels *, size_t))
{
    const ovr_kernels *run;
    for (int k = 0; (run = test_kernels(k)); k++) {
        errors coarse = part(run, 113), fine = part(run, 225);
        double second = log2(coarse.second / fine.second);
        double fourth = log2(coarse.fourth / fine.fourth);
        assert_true(second > 1.7 && second < 2.3);
        assert_true(fourth > 3.7 && fourth < 4.5);
    }
}

TEST(poiseuille_upstream_is_of_fourth_order)
{
    falls(by_logarithms);
    falls(by_logarithms_and_gap);
}

TEST(poiseuille_downstream_is_of_fourth_order)
{
    falls(by_values);
    falls(by_values_and_gap);
}

TEST(reduced_pressure_is_of_fourth_order)
{
    falls(by_reduced_pressure);
}

TEST(wedge_is_of_fourth_order)
{
    falls(wedge);
}

TEST(film_is_of_fourth_order)
{
    falls(film);
}

static void arrays_of(const test_grid *grid, ovr_fourth *c)
{
    *c = (ovr_fourth){.fluid = &grid->fluid,
                      .D = grid->D,
                      .Cu = 0.7,
                      .first = 0,
                      .end = (ptrdiff_t)ceil(4 / grid->D),
                      .log_eps = grid->band.b[0],
                      .flux = grid->band.b[1],
                      .rise = grid->band.delta,
                      .mask = grid->band.b[2],
                      .F = grid->band.b[3],
                      .gap = grid->band.b[4],
                      .reduced = grid->fluid.logarithmic &&
                                 grid->fluid.lubricant.rheology ==
                                     OVR_NEWTONIAN,
                      .local = OVR_FOURTH_LOCAL};
}

/* |a - b| against the largest terms that a row is the difference of. */
static void compare(const test_grid *plain, const test_grid *other)
{
    const ovr_fields *f = &plain->f;
    const double *here = test_grid_read(other, other->band.b[2]);
    double half = 0.5 / (plain->D * plain->D);
    assert_memory_equal(here, plain->band.b[2], N * sizeof(double));
    here = test_grid_read(other, other->band.b[4]);
    for (size_t i = 0; i < N; i++)
        CHECK_NEAR(here[i], plain->band.b[4][i], 1e-15);
    here = test_grid_read(other, other->band.b[3]);
    for (size_t i = OVR_FOURTH_MARGIN; i + OVR_FOURTH_MARGIN < N; i++) {
        double eps = 0, size;
        for (int d = -3; d <= 3; d++)
            eps = fmax(eps, f->eps[(ptrdiff_t)i + d]);
        size = 4 * half * eps * f->P[i] + 8 * f->q[i] / plain->D;
        CHECK_NEAR(here[i], plain->band.b[3][i], 1e-13 * (size + 1));
    }
}

TEST(vectors_agree_with_the_plain_one)
{
    const ovr_kernels *run;
    for (int k = 6; (run = test_kernels(k / 6)); k++) {
        corrected plain = {.grid = test_grid_make(test_kernels(0), N)};
        corrected other = {.grid = test_grid_make(run, N)};
        if (k % 3 == 1) {
            test_grid_gap(&plain.grid);
            test_grid_gap(&other.grid);
        } else if (k % 3 == 2) {
            test_grid_logarithmic(&plain.grid);
            test_grid_logarithmic(&other.grid);
        }
        if (k % 6 >= 3) {
            test_grid_thin(&plain.grid, 0.2, 0.4);
            test_grid_thin(&other.grid, 0.2, 0.4);
        }
        test_grid_fill(&plain.grid, 11);
        for (size_t i = 0; i < N; i++)
            plain.grid.w[i] = sin(0.1 * (double)i);
        test_grid_copy(&plain.grid, &other.grid);
        arrays_of(&plain.grid, &plain.c);
        arrays_of(&other.grid, &other.c);
        correct(&plain);
        correct(&other);
        compare(&plain.grid, &other.grid);
        ovr_arena_release(&plain.grid.arena);
        ovr_arena_release(&other.grid.arena);
    }
}
