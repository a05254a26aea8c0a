/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Survey to which the film thickness formulas were fitted, and the fit: 260
 * contacts (films.c) at level 10, the errors stated in film_formula.c, and a
 * new fit of the constants by Levenberg and Marquardt to the logarithms of the
 * film thicknesses, which must not be better by a tenth. */
#include "contact/film_formula.h"

#include <gsl/gsl_blas.h>
#include <gsl/gsl_multifit_nlinear.h>
#include <math.h>
#include <stdlib.h>

#include "support/films.h"
#include "support/test.h"

enum { COUNT = 260, CONSTANTS = 11 };

static test_film film[COUNT];
static size_t n;

static int survey(void **state)
{
    (void)state;
    n = test_films(COUNT, 10, film);
    return n < COUNT - 5;
}

typedef struct quantity {
    const char *name;
    const ovr_film_constants *constants;
    bool central;
} quantity;

static double solved(const quantity *q, size_t k)
{
    return q->central ? film[k].central * film[k].density : film[k].minimum;
}

static int residuals(const gsl_vector *x, void *data, gsl_vector *r)
{
    const quantity *q = data;
    ovr_film_constants c;
    for (size_t i = 0; i < CONSTANTS; i++)
        c.a[i] = gsl_vector_get(x, i);
    for (size_t k = 0; k < n; k++)
        gsl_vector_set(
            r, k, log(ovr_film_blend(&c, film[k].M, film[k].L) / solved(q, k)));
    return 0;
}

static int ascending(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Median and largest error in per cent. */
static void judge(const quantity *q, double *median, double *maximum)
{
    double error[COUNT] = {0};
    for (size_t k = 0; k < n; k++)
        error[k] = 100 *
                   fabs(ovr_film_blend(q->constants, film[k].M, film[k].L) /
                            solved(q, k) -
                        1);
    qsort(error, n, sizeof *error, ascending);
    *median = error[n / 2];
    *maximum = error[n - 1];
    print_message("# %s film, %zu contacts: median %.2f %%, largest %.2f %%\n",
                  q->name, n, *median, *maximum);
}

/* Returns the root mean square of the residuals of a new fit. */
static double refit(quantity *q)
{
    gsl_multifit_nlinear_parameters how =
        gsl_multifit_nlinear_default_parameters();
    gsl_multifit_nlinear_workspace *w = gsl_multifit_nlinear_alloc(
        gsl_multifit_nlinear_trust, &how, n, CONSTANTS);
    gsl_multifit_nlinear_fdf problem = {0};
    gsl_vector_const_view x = gsl_vector_const_view_array(q->constants->a,
                                                          CONSTANTS);
    int why;
    double rms;
    problem.f = residuals;
    problem.n = n;
    problem.p = CONSTANTS;
    problem.params = q;
    gsl_multifit_nlinear_init(&x.vector, &problem, w);
    gsl_multifit_nlinear_driver(200, 1e-10, 1e-10, 0, NULL, NULL, &why, w);
    print_message("# fitted anew:");
    for (size_t i = 0; i < CONSTANTS; i++)
        print_message(" %.4g",
                      gsl_vector_get(gsl_multifit_nlinear_position(w), i));
    print_message("\n");
    rms = gsl_blas_dnrm2(gsl_multifit_nlinear_residual(w));
    gsl_multifit_nlinear_free(w);
    return rms;
}

static double norm(quantity *q)
{
    gsl_vector_const_view x = gsl_vector_const_view_array(q->constants->a,
                                                          CONSTANTS);
    gsl_vector *r = gsl_vector_alloc(n);
    double value;
    residuals(&x.vector, q, r);
    value = gsl_blas_dnrm2(r);
    gsl_vector_free(r);
    return value;
}

TEST(central_film)
{
    quantity q = {"central", &ovr_central_film, true};
    double median, maximum;
    judge(&q, &median, &maximum);
    assert_true(median < 0.25 && maximum < 2.6);
    assert_true(norm(&q) < 1.1 * refit(&q));
}

TEST(minimum_film)
{
    quantity q = {"minimum", &ovr_minimum_film, false};
    double median, maximum;
    judge(&q, &median, &maximum);
    assert_true(median < 0.29 && maximum < 1.7);
    assert_true(norm(&q) < 1.1 * refit(&q));
}

TEST_GROUP(survey, NULL)
