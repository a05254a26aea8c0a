/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Steady strips against independent solutions.  These are the line contact,
 * dense Newton solutions and values of another program.  Also tests the order
 * of the error and symmetries.
 */
#include <gsl/gsl_integration.h>
#include <gsl/gsl_linalg.h>
#include <math.h>
#include <stdlib.h>

#include "contact/contact.h"
#include "overroll/simulation.h"
#include "support/contact.h"
#include "support/strip.h"
#include "support/test.h"

/* Largest distance of H of all lines from the line contact's. */
static double distance(const test_strip *s, const ovr_state *line)
{
    const ovr_strip_level *finest = test_strip_finest(s);
    double most = fabs(s->strip.H0 - line->H0);
    for (size_t i = 0; i < finest->grid.n; i++)
        for (size_t j = 0; j < finest->grid.lines; j++) {
            double H = test_strip_at(s, finest->f.H, i, j);
            most = fmax(most, fabs(H - line->H[i]));
        }
    return most;
}

/* Where nothing varies across every line is a line contact, with either mean
 * between nodes.  Its program sums the deformation by MLMI, to 1e-9. */
TEST(uniform_strip_is_the_line_contact)
{
    enum { LEVEL = 5, N = (7 << LEVEL) + 1 };
    static const double contacts[][2] = {{5, 5}, {20, 10}, {100, 8}};
    for (size_t c = 0; c < sizeof contacts / sizeof *contacts; c++) {
        double M = contacts[c][0], L = contacts[c][1];
        for (int logarithmic = 0; logarithmic < 2; logarithmic++) {
            ovr_options o = test_options();
            o.faces = logarithmic ? OVR_FACES_LOGARITHMIC : OVR_FACES_GAP;
            o.level = LEVEL;
            o.tolerance = 1e-10;
            o.mlmi_order = 12;
            o.mlmi_range = 24;
            ovr_simulation *line = test_simulation(M, L, &o);
            ovr_error err = {0};
            CHECK_OK(ovr_simulation_steady(line, &err), &err);
            ovr_strip_shape shape = test_strip_shape(N, 56);
            shape.coarsest = M > 90 ? 57 : 29;
            test_strip *s = test_strip_make(M, L, shape, NULL);
            s->strip.logarithmic = logarithmic;
            test_strip_solve(s, 1e-10);
            double apart = distance(s, ovr_simulation_state(line));
            CHECK_NEAR(apart, 0, 3e-9);
            test_strip_free(s);
            ovr_simulation_free(line);
        }
    }
}

/* An Eyring film that slides, by closed integrals in the line contact. */
TEST(uniform_thinning_strip_is_the_line_contact)
{
    enum { LEVEL = 5, N = (7 << LEVEL) + 1 };
    static const double laws[][2] = {{0.334, 0.5}, {0.1335, 1}};
    for (size_t k = 0; k < 2; k++) {
        double Sigma0 = laws[k][0], SRR = laws[k][1];
        ovr_error err = {0};
        test_contact c = test_contact_make(20, 10);
        c.contact.u1_ratio = 1 + SRR / 2;
        c.contact.u2_ratio = 1 - SRR / 2;
        c.lubricant.rheology = OVR_EYRING;
        c.lubricant.Sigma0 = Sigma0;
        ovr_options o = test_options();
        o.level = LEVEL;
        o.tolerance = 1e-10;
        o.mlmi_order = 12;
        o.mlmi_range = 24;
        for (int logarithmic = 0; logarithmic < 2; logarithmic++) {
            o.faces = logarithmic ? OVR_FACES_LOGARITHMIC : OVR_FACES_GAP;
            ovr_simulation *line = ovr_simulation_create(
                &c.contact, &c.lubricant, &o, NULL, &err);
            assert_non_null(line);
            CHECK_OK(ovr_simulation_steady(line, &err), &err);
            ovr_strip_shape shape = test_strip_shape(N, 56);
            shape.coarsest = 29;
            test_strip *s = test_strip_make(20, 10, shape, NULL);
            s->strip.logarithmic = logarithmic;
            s->strip.fluid.lubricant = c.lubricant;
            s->strip.fluid.sliding = SRR;
            test_strip_solve(s, 1e-10);
            double apart = distance(s, ovr_simulation_state(line));
            CHECK_NEAR(apart, 0, 2e-8);
            test_strip_free(s);
            ovr_simulation_free(line);
        }
    }
}

/* ------------------------------------------------------------ Dense Newton */

/* The discrete equations of a strip written down once more, node by node. */
typedef struct dense {
    test_contact contact;
    size_t n, lines;
    double D, Dy, H0;
    bool logarithmic;
    double Sigma0, slide; /* of the law of Eyring, or 0 */
    double *k;            /* n x lines */
    double *gap, *P, *H, *q, *phi;
} dense;

static double at_lines(const dense *d, const double *modes, size_t rows,
                       size_t line)
{
    double sum = 0;
    for (size_t q = 0; q < d->lines; q++) {
        size_t mode = q <= d->lines / 2 ? q : d->lines - q;
        sum += modes[rows * (d->lines / 2 + 1) + mode] *
               cos(2 * acos(-1) * (double)(q * line) / (double)d->lines);
    }
    return sum / (double)d->lines;
}

static double *numbers(size_t n)
{
    double *x = calloc(n, sizeof *x);
    assert_non_null(x);
    return x;
}

static dense dense_make(const test_strip *s)
{
    const ovr_strip_level *level = test_strip_finest(s);
    const ovr_strip_grid *g = &level->grid;
    dense d = {.contact = test_contact_make(s->M, s->L),
               .n = g->n,
               .lines = g->lines,
               .D = g->D,
               .Dy = g->Dy,
               .H0 = s->strip.H0,
               .logarithmic = s->strip.logarithmic};
    if (s->strip.fluid.lubricant.rheology != OVR_NEWTONIAN) {
        d.Sigma0 = s->strip.fluid.lubricant.Sigma0;
        d.slide = fabs(s->strip.fluid.sliding) / (12 * d.Sigma0);
    }
    size_t all = d.n * d.lines, modes = d.lines / 2 + 1;
    double **to[] = {&d.k, &d.gap, &d.P, &d.H, &d.q, &d.phi};
    for (size_t k = 0; k < sizeof to / sizeof *to; k++)
        *to[k] = numbers(all);
    double *by_mode = numbers(d.n * modes);
    for (size_t q = 0; q < modes; q++)
        ovr_strip_influence(2 * acos(-1) * (double)q / ((double)d.lines * d.Dy),
                            d.D, d.n, modes, by_mode + q);
    for (size_t i = 0; i < d.n; i++)
        for (size_t j = 0; j < d.lines; j++) {
            d.k[i * d.lines + j] = at_lines(&d, by_mode, i, j);
            d.gap[i * d.lines + j] = test_strip_at(s, level->f.gap, i, j);
            d.P[i * d.lines + j] = test_strip_at(s, level->f.P, i, j);
        }
    free(by_mode);
    return d;
}

static void dense_free(dense *d)
{
    double *all[] = {d->k, d->gap, d->P, d->H, d->q, d->phi};
    for (size_t k = 0; k < sizeof all / sizeof *all; k++)
        free(all[k]);
}

static double influence(const dense *d, size_t a, size_t b)
{
    size_t i = a / d->lines, j = a % d->lines;
    size_t c = b / d->lines, e = b % d->lines;
    size_t rows = i > c ? i - c : c - i;
    return d->k[rows * d->lines + (j + d->lines - e) % d->lines];
}

static void properties(dense *d, size_t k)
{
    const ovr_lubricant *oil = &d->contact.lubricant;
    double rho = ovr_density(oil, d->P[k]);
    d->q[k] = rho * d->H[k];
    d->phi[k] = rho / (ovr_viscosity(oil, d->P[k]) * d->contact.contact.lambda);
}

static void film(dense *d)
{
    for (size_t a = 0; a < d->n * d->lines; a++) {
        d->H[a] = d->H0 + d->gap[a];
        for (size_t b = 0; b < d->n * d->lines; b++)
            d->H[a] += influence(d, a, b) * d->P[b];
        properties(d, a);
    }
}

/* E/eps of Eyring's law by Gauss points and Newton's method for the mean
 * stress. The gradients are those along X and across. */
static double thinned(double s_N, double gx, double gy, bool across)
{
    enum { POINTS = 24 };
    gsl_integration_glfixed_table *rule = gsl_integration_glfixed_table_alloc(
        POINTS);
    double place[POINTS], weight[POINTS];
    for (size_t k = 0; k < POINTS; k++)
        gsl_integration_glfixed_point(-1, 1, k, &place[k], &weight[k], rule);
    gsl_integration_glfixed_table_free(rule);
    double ax = asinh(s_N), ay = 0, flow = 0;
    for (int step = 0; step < 60; step++) {
        double F[2] = {-s_N, 0}, D[3] = {0, 0, 0};
        flow = 0;
        for (int k = 0; k < POINTS; k++) {
            double s = place[k], w = 0.5 * weight[k];
            double tx = ax + s * gx, ty = ay + s * gy, t = hypot(tx, ty);
            double f = t > 1e-6 ? sinh(t) / t : 1;
            double c = t > 1e-4 ? (cosh(t) - f) / (t * t) : 1. / 3;
            F[0] += w * f * tx;
            F[1] += w * f * ty;
            D[0] += w * (f + c * tx * tx);
            D[1] += w * c * tx * ty;
            D[2] += w * (f + c * ty * ty);
            flow += w * s * f * (across ? ty : tx);
        }
        double det = D[0] * D[2] - D[1] * D[1];
        double dx = -(D[2] * F[0] - D[1] * F[1]) / det;
        double dy = -(D[0] * F[1] - D[1] * F[0]) / det;
        ax += fmax(-1, fmin(1, dx));
        ay += fmax(-1, fmin(1, dy));
        if (fabs(dx) + fabs(dy) < 1e-11)
            break;
    }
    return 3 * flow / (across ? gy : gx);
}

/* Central difference of P across or along at node k. */
static double slope(const dense *d, size_t k, bool across)
{
    size_t m = d->lines, i = k / m, j = k % m;
    if (across)
        return (d->P[i * m + (j + 1) % m] - d->P[i * m + (j + m - 1) % m]) /
               (2 * d->Dy);
    return (d->P[k + m] - d->P[k - m]) / (2 * d->D);
}

/* Flow from a to b, times the distance. */
static double flow(const dense *d, size_t a, size_t b, bool across)
{
    double H = d->H[a], G = d->H[b], A = pow(H, 3), B = pow(G, 3);
    double f = d->phi[a], g = d->phi[b], mean = 0.5 * (f + g);
    double rho = d->q[a] / H, other_rho = d->q[b] / G;
    double m = f / rho, n = g / other_rho; /* 1/eta */
    if (d->logarithmic)
        mean = 0.5 * (rho + other_rho) *
               (fabs(m - n) > 1e-7 * m ? (m - n) / log(m / n) : m);
    double eps = mean * 2 / (1 / A + 1 / B), dP = d->P[b] - d->P[a];
    if (!(d->Sigma0 > 0))
        return -eps * dP;
    double films = (H + G) / (4 * d->Sigma0);
    double own = films * dP / (across ? d->Dy : d->D);
    double other = 0.5 * films * (slope(d, a, !across) + slope(d, b, !across));
    double c = d->slide * (d->q[a] / H + d->q[b] / G) * H * H * G * G /
               (H * H + G * G);
    own = fmax(fabs(own), 1e-4);
    return -eps * dP *
           thinned(c / eps, across ? fabs(other) : own,
                   across ? own : fabs(other), across);
}

/* Flow in less flow out of node (i, j). */
static double equation(const dense *d, size_t i, size_t j)
{
    const size_t m = d->lines, k = i * m + j;
    const double *q = d->q;
    double along = (flow(d, k - m, k, false) - flow(d, k, k + m, false)) /
                   (d->D * d->D);
    double across = (flow(d, i * m + (j + m - 1) % m, k, true) -
                     flow(d, k, i * m + (j + 1) % m, true)) /
                    (d->Dy * d->Dy);
    double wedge = i == 1 ? q[k] - q[k - m]
                          : 1.5 * q[k] - 2 * q[k - m] + 0.5 * q[k - 2 * m];
    return along + across - wedge / d->D;
}

static void equations(const dense *d, double *r)
{
    double load = acos(0) * (double)d->lines;
    for (size_t i = 1; i + 1 < d->n; i++)
        for (size_t j = 0; j < d->lines; j++) {
            *r++ = equation(d, i, j);
            load -= d->D * d->P[i * d->lines + j];
        }
    *r = load;
}

/* Column c of the Jacobian by differences; the film is linear in P. */
static void column(dense *d, size_t c, const double *r, double *moved)
{
    const double h = 1e-7;
    const size_t all = d->n * d->lines, m = all - 2 * d->lines;
    double *copy = numbers(all), *place = c < m ? &d->P[c + d->lines] : &d->H0;
    double kept = *place;
    for (size_t k = 0; k < all; k++)
        copy[k] = d->H[k];
    *place = kept + h;
    for (size_t k = 0; k < all; k++) {
        d->H[k] += c < m ? h * influence(d, k, c + d->lines) : h;
        properties(d, k);
    }
    equations(d, moved);
    for (size_t k = 0; k <= m; k++)
        moved[k] = (moved[k] - r[k]) / h;
    *place = kept;
    for (size_t k = 0; k < all; k++) {
        d->H[k] = copy[k];
        properties(d, k);
    }
    free(copy);
}

static double newton_step(dense *d)
{
    const size_t m = (d->n - 2) * d->lines;
    gsl_matrix *J = gsl_matrix_alloc(m + 1, m + 1);
    gsl_vector *x = gsl_vector_alloc(m + 1);
    gsl_permutation *p = gsl_permutation_alloc(m + 1);
    double *r = numbers(m + 1), *moved = numbers(m + 1), biggest = 0;
    int sign;
    film(d);
    equations(d, r);
    for (size_t c = 0; c <= m; c++) {
        column(d, c, r, moved);
        for (size_t k = 0; k <= m; k++)
            gsl_matrix_set(J, k, c, moved[k]);
    }
    for (size_t k = 0; k <= m; k++) {
        bool dry = k < m && d->P[k + d->lines] <= 0 && r[k] <= 0;
        for (size_t c = 0; dry && c <= m; c++)
            gsl_matrix_set(J, k, c, k == c);
        gsl_vector_set(x, k, dry ? 0 : -r[k]);
    }
    gsl_linalg_LU_decomp(J, p, &sign);
    gsl_linalg_LU_svx(J, p, x);
    for (size_t k = 0; k < m; k++) {
        double *P = &d->P[k + d->lines], before = *P;
        *P = fmax(0, *P + gsl_vector_get(x, k));
        biggest = fmax(biggest, fabs(*P - before));
    }
    d->H0 += gsl_vector_get(x, m);
    free(r);
    free(moved);
    gsl_matrix_free(J);
    gsl_vector_free(x);
    gsl_permutation_free(p);
    return biggest;
}

/* From the solution with all pressures disturbed by up to 1 %. */
static void solve_dense(dense *d)
{
    uint64_t seed = 11;
    double change = 1;
    for (size_t k = 0; k < d->n * d->lines; k++)
        d->P[k] *= test_random(&seed, 0.99, 1.01);
    for (int step = 0; step < 15 && change > 1e-12; step++)
        change = newton_step(d);
    CHECK_NEAR(change, 0, 1e-12);
    film(d);
}

static const test_bump dent = {
    .A = -0.08, .width = 0.3, .x = -0.2, .y = 1, .round = true};

/* Largest distances of H0, H and P. */
static void compare_dense(const test_strip *s, double tolerance)
{
    dense d = dense_make(s);
    solve_dense(&d);
    CHECK_NEAR(s->strip.H0, d.H0, tolerance);
    const ovr_strip_fields *f = &test_strip_finest(s)->f;
    for (size_t i = 0; i < d.n; i++)
        for (size_t j = 0; j < d.lines; j++) {
            CHECK_NEAR(test_strip_at(s, f->P, i, j), d.P[i * d.lines + j],
                       tolerance);
            CHECK_NEAR(test_strip_at(s, f->H, i, j), d.H[i * d.lines + j],
                       tolerance);
        }
    dense_free(&d);
}

static test_strip *coarse_dent(bool logarithmic)
{
    ovr_strip_shape shape = test_strip_shape(33, 8);
    shape.coarsest = 17;
    test_strip *s = test_strip_make(8, 6, shape, NULL);
    s->bump[s->bumps++] = dent;
    s->strip.logarithmic = logarithmic;
    return s;
}

TEST(round_dent_agrees_with_dense_newton)
{
    for (int logarithmic = 0; logarithmic < 2; logarithmic++) {
        test_strip *s = coarse_dent(logarithmic);
        test_strip_solve(s, 1e-11);
        assert_int_equal(s->strip.finest, 1);
        compare_dense(s, 1e-10);
        test_strip_free(s);
    }
}

/* Five points across the film: 1e-6 of E at these gradients, and of P where it
 * is steep. */
TEST(shear_thinning_dent_agrees_with_dense_newton)
{
    test_strip *s = coarse_dent(true);
    s->strip.fluid.lubricant.rheology = OVR_EYRING;
    s->strip.fluid.lubricant.Sigma0 = 0.6;
    s->strip.fluid.sliding = 0.5;
    test_strip_solve(s, 1e-10);
    compare_dense(s, 1e-5);
    test_strip_free(s);
}

/* A dense Newton solution of another program: 65 x 16 nodes. */
TEST(round_dent_agrees_with_another_program)
{
    test_strip *s = test_strip_make(20, 10, test_strip_shape(65, 16), NULL);
    s->bump[s->bumps++] = dent;
    test_strip_solve(s, 1e-11);
    const ovr_strip_fields *f = &test_strip_finest(s)->f;
    CHECK_NEAR(s->strip.H0, -0.511178596607, 1e-10);
    CHECK_NEAR(test_strip_smallest(s, f->H), 0.071372626219, 1e-10);
    CHECK_NEAR(test_strip_largest(s, f->P), 1.028361469795, 1e-10);
    test_strip_free(s);
}

/* -------------------------------------------------------------- Finer grids */

/* A dent of one film at X = -0.2, width 0.3: of another multigrid program, on
 * 129 x 32 nodes, and extrapolated from four grids with its uncertainty.  That
 * program stopped at R = 1e-7 or after 16 cycles, which is 1e-5 at M = 100. */
typedef struct truth {
    double M, A;
    double H0, H_cen, H_min, P_max;
    double H_cen_exact, unsure;
} truth;

static const truth truths[] = {{5, -0.4, -0.181702625, 0.408857442, 0.324242727,
                                1.787953512, 0.4093759, 3.3e-6},
                               {20, -0.084, -0.509890054, 0.083203965,
                                0.072389135, 1.031803126, 0.08402248, 1.4e-6},
                               {100, -0.0132, -0.583965145, 0.012043193,
                                0.010437823, 1.00528211, 0.01332941, 5.3e-6}};

static test_strip *solved(const truth *t, int grid, bool logarithmic)
{
    test_strip *s = test_strip_make(
        t->M, 10, test_strip_shape(((size_t)32 << grid) + 1, (size_t)8 << grid),
        NULL);
    s->bump[s->bumps] = dent;
    s->bump[s->bumps++].A = t->A;
    s->strip.logarithmic = logarithmic;
    test_strip_solve(s, 1e-7);
    return s;
}

TEST(steady_dents_agree_with_another_program)
{
    for (size_t k = 0; k < sizeof truths / sizeof *truths; k++) {
        const truth *t = &truths[k];
        test_strip *s = solved(t, 2, false);
        const ovr_strip_fields *f = &test_strip_finest(s)->f;
        double stopped = t->M > 90 ? 1e-7 : 2e-8;
        CHECK_NEAR(s->strip.H0, t->H0, stopped);
        CHECK_NEAR(ovr_strip_centre(test_strip_finest(s), f->H), t->H_cen,
                   stopped);
        CHECK_NEAR(test_strip_smallest(s, f->H), t->H_min, 5e-8);
        CHECK_NEAR(test_strip_largest(s, f->P), t->P_max, 1e-6 * t->P_max);
        test_strip_free(s);
    }
}

/* Grids of 65 to 513 nodes: H_cen converges with second order, to the same
 * number with both means between nodes, which differ by more on each grid. */
TEST(central_film_converges_with_second_order)
{
    for (size_t k = 0; k < 2; k++)
        for (int logarithmic = 0; logarithmic < 2; logarithmic++) {
            double H[4];
            for (int grid = 0; grid < 4; grid++) {
                test_strip *s = solved(&truths[k], grid + 1, logarithmic);
                H[grid] = ovr_strip_centre(test_strip_finest(s),
                                           test_strip_finest(s)->f.H);
                test_strip_free(s);
            }
            double order = log2((H[2] - H[1]) / (H[3] - H[2]));
            assert_true(order > 1.75);
            CHECK_NEAR(H[3] + (H[3] - H[2]) / 3, truths[k].H_cen_exact,
                       4 * truths[k].unsure);
        }
}

/* --------------------------------------------------------------- Symmetries */

static test_strip *two_dents(double shift, double mirror, int periods)
{
    ovr_strip_shape shape = test_strip_shape(129, 28 * (size_t)periods);
    shape.width *= periods;
    test_strip *s = test_strip_make(20, 10, shape, NULL);
    for (int p = 0; p < periods; p++) {
        s->bump[s->bumps] = dent;
        s->bump[s->bumps++].y = mirror * 0.6 + shift + 2 * p;
        s->bump[s->bumps] = dent;
        s->bump[s->bumps].A = 0.03;
        s->bump[s->bumps].x = 0.3;
        s->bump[s->bumps++].y = mirror * 1.1 + shift + 2 * p;
    }
    s->strip.logarithmic = true;
    test_strip_solve(s, 1e-11);
    return s;
}

/* P and H of a at line j are those of b at line j' = sign j + shift. */
static void compare(const test_strip *a, const test_strip *b, bool mirrored,
                    size_t shift)
{
    const ovr_strip_fields *f = &test_strip_finest(a)->f;
    const ovr_strip_fields *o = &test_strip_finest(b)->f;
    const ovr_strip_grid *g = &test_strip_finest(a)->grid;
    CHECK_NEAR(a->strip.H0, b->strip.H0, 1e-11);
    for (size_t i = 0; i < g->n; i++)
        for (size_t j = 0; j < g->lines; j++) {
            size_t k = mirrored ? 2 * g->lines - j : j + shift;
            CHECK_NEAR(test_strip_at(a, f->H, i, j),
                       test_strip_at(b, o->H, i, k), 1e-11);
            CHECK_NEAR(test_strip_at(a, f->P, i, j),
                       test_strip_at(b, o->P, i, k), 1e-9);
        }
}

TEST(place_across_does_not_matter)
{
    test_strip *s = two_dents(0, 1, 1);
    test_strip *shifted = two_dents(5 * 2. / 28, 1, 1);
    test_strip *mirrored = two_dents(0, -1, 1);
    test_strip *twice = two_dents(0, 1, 2);
    compare(s, shifted, false, 5);
    compare(s, mirrored, true, 0);
    compare(s, twice, false, 0);
    compare(s, twice, false, 28);
    test_strip_free(s);
    test_strip_free(shifted);
    test_strip_free(mirrored);
    test_strip_free(twice);
}

/* Change of the film at X = 0 and all lines by waves that stand still. */
static void change_by(double along, double across, double second, double *to)
{
    test_strip *s = test_strip_make(20, 10, test_strip_shape(257, 56), NULL);
    const double A = 1e-5;
    for (int k = 0; k < 2; k++) {
        s->bump[s->bumps++] = (test_bump){
            .A = A / 2, .along = along, .across = k ? second : across};
    }
    test_strip_solve(s, 1e-10);
    for (size_t j = 0; j < 56; j++)
        to[j] = test_strip_at(s, test_strip_finest(s)->f.H, 187, j);
    test_strip_free(s);
}

/* Small waves are linear: crossed waves are half of each oblique one. */
TEST(crossed_waves_are_two_oblique_ones)
{
    double crossed[56], left[56], right[56];
    change_by(1, 1, -1, crossed);
    change_by(1, 1, 1, left);
    change_by(1, -1, -1, right);
    test_strip *flat = test_strip_make(20, 10, test_strip_shape(257, 56), NULL);
    test_strip_solve(flat, 1e-10);
    double changed = 0;
    for (size_t j = 0; j < 56; j++) {
        double H = test_strip_at(flat, test_strip_finest(flat)->f.H, 187, j);
        CHECK_NEAR(crossed[j] - H, 0.5 * (left[j] + right[j]) - H, 5e-9);
        changed = fmax(changed, fabs(crossed[j] - H));
    }
    assert_true(changed > 1e-6);
    test_strip_free(flat);
}
