/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "newton.h"

#include <gsl/gsl_linalg.h>
#include <math.h>
#include <stdlib.h>

#include "contact/contact.h"
#include "contact/film_formula.h"
#include "test.h"

static double *allocate(size_t n)
{
    double *x = calloc(n, sizeof *x);
    assert_non_null(x);
    return x;
}

/* Integral of ln|x - y|/pi over the grid interval at distance d D. */
static double influence(double d, double D)
{
    double a = (d + 0.5) * D, b = (d - 0.5) * D;
    return (a * (log(fabs(a)) - 1) - b * (log(fabs(b)) - 1)) / acos(-1);
}

dense *dense_make(double M, double L, int level, ovr_scheme scheme)
{
    dense *d = calloc(1, sizeof *d);
    assert_non_null(d);
    size_t n = d->n = ((size_t)7 << level) + 1;
    bool second = scheme == OVR_UPSTREAM2;
    d->contact = test_contact_make(M, L);
    d->X_a = -4;
    d->w[0] = second ? 1.5 : 1;
    d->w[1] = second ? -2 : -1;
    d->w[2] = second ? 0.5 : 0;
    d->first[0] = 1;
    d->first[1] = -1;
    d->force = acos(0);
    double **all[] = {&d->X, &d->gap,    &d->F,   &d->P,  &d->H,
                      &d->q, &d->kernel, &d->rho, &d->eta};
    for (size_t k = 0; k < sizeof all / sizeof *all; k++)
        *all[k] = allocate(n);
    dense_outlet(d, 1.5);
    d->H0 = ovr_film_central_moes(M, L) - 0.6;
    return d;
}

void dense_outlet(dense *d, double X_b)
{
    d->D = (X_b - d->X_a) / (double)(d->n - 1);
    for (size_t i = 0; i < d->n; i++) {
        double X = d->X[i] = d->X_a + (double)i * d->D;
        d->gap[i] = 0.5 * X * X;
        d->P[i] = X * X < 1 ? sqrt(1 - X * X) : 0;
        d->kernel[i] = influence((double)i, d->D);
    }
}

void dense_free(dense *d)
{
    double *all[] = {d->X, d->gap,    d->F,   d->P,   d->H,
                     d->q, d->kernel, d->rho, d->eta, (double *)d};
    for (size_t k = 0; k < sizeof all / sizeof *all; k++)
        free(all[k]);
}

void dense_surface(dense *d, const double *S)
{
    for (size_t i = 0; i < d->n; i++)
        d->gap[i] = 0.5 * d->X[i] * d->X[i] - S[i];
}

static void properties(dense *d, size_t i)
{
    d->rho[i] = ovr_density(&d->contact.lubricant, d->P[i]);
    d->eta[i] = ovr_viscosity(&d->contact.lubricant, d->P[i]);
}

static void film(dense *d)
{
    for (size_t i = 0; i < d->n; i++) {
        double w = 0;
        for (size_t j = 0; j < d->n; j++)
            w += d->kernel[i > j ? i - j : j - i] * d->P[j];
        d->H[i] = d->H0 + d->gap[i] - w;
        properties(d, i);
        d->q[i] = d->rho[i] * d->H[i];
    }
}

static double eps(const dense *d, size_t i)
{
    const test_contact *c = &d->contact;
    double eta = d->eta[i];
    if (d->thickening)
        eta *= d->thickening(d->H[i]);
    return d->q[i] * d->H[i] * d->H[i] / (eta * c->contact.lambda);
}

/* Returns (y - x)/ln(y/x), by a series if both are nearly equal. */
static double log_mean(double x, double y)
{
    double d = log(y / x);
    return fabs(d) < 1e-4 ? 0.5 * (x + y) * (1 - d * d / 12) : (y - x) / d;
}

/* Returns the conductance between nodes i and i + 1. */
static double conductance(const dense *d, size_t i)
{
    double a = pow(d->H[i], 3), b = pow(d->H[i + 1], 3);
    double f = eps(d, i), g = eps(d, i + 1);
    if (d->logarithmic)
        return a * b / (a + b) * (d->rho[i] + d->rho[i + 1]) *
               log_mean(f / (a * d->rho[i]), g / (b * d->rho[i + 1]));
    return d->in_line ? (f / a + g / b) / (1 / a + 1 / b) : 0.5 * (f + g);
}

/* Returns the net outflow of cell i by the mean speed, divided by D. With
 * `backward` the flow is in the direction of -x. */
static double wedge_of(const dense *d, size_t i)
{
    const double *q = d->q;
    if (d->backward)
        return i + 2 == d->n
                   ? d->first[0] * q[i] + d->first[1] * q[i + 1]
                   : d->w[0] * q[i] + d->w[1] * q[i + 1] + d->w[2] * q[i + 2];
    return i == 1 ? d->first[0] * q[1] + d->first[1] * q[0]
                  : d->w[0] * q[i] + d->w[1] * q[i - 1] + d->w[2] * q[i - 2];
}

/* Returns the net inflow of cell i minus the rate of storage, N_i - F_i. */
static double equation(const dense *d, size_t i)
{
    double D = d->D;
    double in = conductance(d, i - 1) * (d->P[i - 1] - d->P[i]) / D;
    double out = conductance(d, i) * (d->P[i] - d->P[i + 1]) / D;
    return (in - out - wedge_of(d, i)) / D - d->cT * d->q[i] - d->F[i];
}

static double load_defect(const dense *d)
{
    double sum = 0;
    for (size_t i = 0; i < d->n; i++)
        sum += d->P[i];
    return d->force - d->D * sum;
}

static void equations(dense *d, double *r)
{
    for (size_t i = 1; i + 1 < d->n; i++)
        r[i - 1] = -equation(d, i);
    r[d->n - 2] = load_defect(d);
}

/* Computes the equations with unknown c increased by h and restores it. The
 * film thickness is linear in the unknowns. */
static void nudge(dense *d, size_t c, double h, double *r)
{
    bool pressure = c + 2 < d->n;
    double *unknown = pressure ? &d->P[c + 1] : &d->H0, kept = *unknown;
    for (int back = 0; back < 2; back++, h = -h) {
        *unknown = back ? kept : kept + h;
        if (pressure)
            properties(d, c + 1);
        for (size_t i = 0; i < d->n; i++) {
            size_t away = i > c + 1 ? i - c - 1 : c + 1 - i;
            d->H[i] += pressure ? -h * d->kernel[away] : h;
            d->q[i] = d->rho[i] * d->H[i];
        }
        if (!back)
            equations(d, r);
    }
}

/* Performs one Newton step of the complementarity problem; rows of cavitated
 * nodes whose pressure should not become positive are dP = 0. Returns the
 * largest change. */
static double newton_step(dense *d, gsl_matrix *J, gsl_vector *x,
                          gsl_permutation *p, double *r, double *moved)
{
    size_t m = d->n - 1;
    int sign;
    double biggest = 0, step = 1;
    film(d);
    equations(d, r);
    for (size_t c = 0; c < m; c++) {
        const double h = 1e-7;
        nudge(d, c, h, moved);
        for (size_t i = 0; i < m; i++)
            gsl_matrix_set(J, i, c, (moved[i] - r[i]) / h);
    }
    for (size_t i = 0; i < m; i++) {
        /* r = -N increases with P: a cavitated node with r > 0 remains
         * cavitated */
        bool dry = i + 1 < m && d->P[i + 1] <= 0 && r[i] >= 0;
        if (d->primal_dual && i + 1 < m)
            dry = d->P[i + 1] < r[i] / gsl_matrix_get(J, i, i);
        for (size_t c = 0; dry && c < m; c++)
            gsl_matrix_set(J, i, c, i == c);
        gsl_vector_set(x, i, !dry ? -r[i] : d->primal_dual ? -d->P[i + 1] : 0);
    }
    gsl_linalg_LU_decomp(J, p, &sign);
    gsl_linalg_LU_svx(J, p, x);
    for (size_t c = 0; c < m; c++)
        biggest = fmax(biggest, fabs(gsl_vector_get(x, c)));
    if (biggest > 0.1)
        step = 0.1 / biggest;
    for (size_t c = 0; c + 1 < m; c++) {
        double P = d->P[c + 1] + step * gsl_vector_get(x, c);
        d->P[c + 1] = d->primal_dual ? P : fmax(0, P);
    }
    d->H0 += step * gsl_vector_get(x, m - 1);
    return biggest;
}

/* Returns the change of the last step. */
static double solve(dense *d, int maximum)
{
    size_t m = d->n - 1;
    gsl_matrix *J = gsl_matrix_alloc(m, m);
    gsl_vector *x = gsl_vector_alloc(m);
    gsl_permutation *p = gsl_permutation_alloc(m);
    double *r = allocate(m), *moved = allocate(m), change = 1;
    int step = 0;
    while (change > 1e-9 && step++ < maximum)
        change = newton_step(d, J, x, p, r, moved);
    film(d);
    free(r);
    free(moved);
    gsl_permutation_free(p);
    gsl_vector_free(x);
    gsl_matrix_free(J);
    return change;
}

void dense_solve(dense *d)
{
    CHECK_NEAR(solve(d, 100), 0, 1e-9);
}

bool dense_converges(dense *d, int maximum)
{
    return solve(d, maximum) <= 1e-9;
}
