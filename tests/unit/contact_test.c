/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Conditions, lubricant, film formulas and histories against independent
 * formulas and limits. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_integration.h>

#include "contact/contact.h"
#include "contact/film_formula.h"
#include "support/test.h"

static const double PI = 3.14159265358979323846;

static void close_to(double a, double b, double relative)
{
    if (!(fabs(a - b) <= relative * fmax(fabs(a), fabs(b))))
        fail_msg("%.17g and %.17g differ by more than %g", a, b, relative);
}

static ovr_contact resolve(ovr_conditions c)
{
    ovr_contact to;
    ovr_error err = {0};
    if (ovr_contact_resolve(&c, &to, &err))
        fail_msg("%s", err.message);
    return to;
}

static ovr_conditions moes(double M, double L)
{
    ovr_conditions c = ovr_conditions_default();
    c.M = M;
    c.L = L;
    return c;
}

/* A steel roller: w, R, E', eta0, alpha, u1, u2. */
static ovr_conditions roller(void)
{
    ovr_conditions c = ovr_conditions_default();
    c.load = 3.1e5;
    c.radius = 13.7e-3;
    c.modulus = 226e9;
    c.viscosity = 0.043;
    c.alpha = 18.3e-9;
    c.speed_1 = 2.3;
    c.speed_2 = 1.1;
    c.width = 0.02;
    return c;
}

/* ----------------------------------------------------------- conditions */

TEST(numbers_by_definition)
{
    ovr_conditions c = roller();
    ovr_contact to = resolve(c);
    double us = c.speed_1 + c.speed_2;
    double b = sqrt(8 * c.load * c.radius / (PI * c.modulus));
    double ph = 2 * c.load / (PI * b);
    double W = c.load / (c.modulus * c.radius);
    double U2 = c.viscosity * us / (c.modulus * c.radius);
    close_to(to.b, b, 1e-14);
    close_to(to.ph, ph, 1e-14);
    close_to(to.M, W / sqrt(U2), 1e-14);
    close_to(to.L, c.alpha * c.modulus * pow(U2, 0.25), 1e-14);
    close_to(to.lambda,
             6 * c.viscosity * us * c.radius * c.radius / (b * b * b * ph),
             1e-13);
    close_to(to.alphabar, c.alpha * ph, 1e-14);
    close_to(to.height, b * b / c.radius, 1e-14);
    close_to(to.time, b / (us / 2), 1e-14);
    close_to(to.u1_ratio, 2.3 / 1.7, 1e-14);
    close_to(to.u2_ratio, 1.1 / 1.7, 1e-14);
}

TEST(numbers_agree_with_each_other)
{
    ovr_contact to = resolve(moes(20, 10));
    close_to(to.lambda, 3 * PI * PI / (8 * 400), 1e-14);
    close_to(to.alphabar, 10 * sqrt(20 / (2 * PI)), 1e-14);
    assert_true(isnan(to.ph) && isnan(to.b) && isnan(to.time));
    to = resolve(roller());
    close_to(to.lambda, 3 * PI * PI / (8 * to.M * to.M), 1e-14);
    close_to(to.alphabar, to.L * sqrt(to.M / (2 * PI)), 1e-14);
}

static void same_contact(ovr_contact a, ovr_contact b, double relative)
{
    const double *x = (const double *)&a, *y = (const double *)&b;
    for (size_t i = 0; i < sizeof a / sizeof *x; i++)
        close_to(x[i], y[i], relative);
}

TEST(round_trips)
{
    ovr_contact to = resolve(roller());
    ovr_conditions c = moes(to.M, to.L);
    c.radius = to.radius;
    c.modulus = to.modulus;
    c.viscosity = to.viscosity;
    c.alpha = to.alpha;
    c.slide_to_roll = to.u1_ratio - to.u2_ratio;
    c.width = to.width;
    same_contact(resolve(c), to, 1e-12);

    c.M = c.L = NAN;
    c.lambda = to.lambda;
    c.alphabar = to.alphabar;
    same_contact(resolve(c), to, 1e-12);

    c.lambda = c.alphabar = NAN;
    c.hertz_pressure = to.ph;
    c.mean_speed = to.um;
    same_contact(resolve(c), to, 1e-12);

    /* speed known, viscosity to be found */
    c = moes(to.M, to.L);
    c.radius = to.radius;
    c.modulus = to.modulus;
    c.hertz_pressure = to.ph;
    c.width = to.width;
    c.speed_1 = to.u1_ratio * to.um;
    c.speed_2 = to.u2_ratio * to.um;
    same_contact(resolve(c), to, 1e-12);
}

TEST(alpha_alone_sets_the_pressure)
{
    ovr_conditions c = moes(20, 10);
    ovr_contact to;
    c.alpha = 1.7e-8;
    to = resolve(c);
    close_to(to.ph, to.alphabar / 1.7e-8, 1e-15);
    assert_true(isnan(to.b));
    c.radius = 0.01;
    c.modulus = 2e11;
    to = resolve(c);
    close_to(to.b, 4 * 0.01 * to.ph / 2e11, 1e-14);
    assert_true(isnan(to.um));
}

TEST(isoviscous_has_no_pressure)
{
    ovr_conditions c = moes(5, 0);
    assert_true(isnan(resolve(c).ph));
    c.alpha = 2e-8;
    assert_true(isnan(resolve(c).ph));
    assert_true(resolve(c).alphabar == 0);
}

static void refused(ovr_conditions c, const char *begin)
{
    ovr_contact to;
    ovr_error err = {0};
    assert_int_equal(ovr_contact_resolve(&c, &to, &err), OVR_BAD_INPUT);
    if (strncmp(err.message, begin, strlen(begin)) != 0)
        fail_msg("'%s' does not begin with '%s'", err.message, begin);
}

TEST(contradictions_are_named)
{
    ovr_conditions c = ovr_conditions_default();
    refused(c, "load is missing");
    refused(moes(-3, 10), "M = -3");
    refused(moes(20, NAN), "L is missing");
    refused(moes(INFINITY, 1), "M = inf");
    refused(moes(1e-7, 1), "M = 1e-07");
    c = moes(20, 10);
    c.load = 1e5;
    refused(c, "load is already determined by");
    c = moes(20, 10);
    c.lambda = 1;
    refused(c, "lambda cannot be combined");
    c = roller();
    c.speed_2 = NAN;
    refused(c, "speed_2 is missing");
    c = roller();
    c.speed_2 = -2.3;
    refused(c, "speed_1 plus speed_2");
    c = roller();
    c.mean_speed = 1;
    refused(c, "mean_speed is already determined");
    c = roller();
    c.slide_to_roll = 1;
    refused(c, "slide_to_roll is already determined");
    c = roller();
    c.hertz_pressure = 1e9;
    refused(c, "load and hertz_pressure");
    c = roller();
    c.radius = NAN;
    refused(c, "radius is missing");
    c = moes(20, 10);
    c.alpha = 1e-8;
    c.hertz_pressure = 1e9;
    refused(c, "hertz_pressure = 1e+09");
    c = moes(20, 10);
    c.alpha = 1.7e-8;
    c.radius = 0.01;
    c.modulus = 2e11;
    c.viscosity = 0.04;
    c.mean_speed = 100;
    refused(c, "mean_speed = 100");
}

/* ------------------------------------------------------------ lubricant */

static ovr_lubricant oil(ovr_viscosity_law v, ovr_density_law d, double z)
{
    ovr_conditions c = moes(20, 10);
    ovr_contact to;
    ovr_lubricant made;
    ovr_error err = {0};
    c.alpha = 1.7e-8;
    to = resolve(c);
    if (ovr_lubricant_make(&to, v, d, NAN, z, &made, &err))
        fail_msg("%s", err.message);
    return made;
}

TEST(roelands_in_physical_form)
{
    ovr_lubricant l = oil(OVR_ROELANDS, OVR_DOWSON_HIGGINSON, NAN);
    double ph = 10 * sqrt(20 / (2 * PI)) / 1.7e-8;
    for (double P = 0; P < 3; P += 0.37) {
        double p = P * ph, p0 = 1.98e8, z = 0.68;
        close_to(ovr_viscosity(&l, P),
                 exp(1.7e-8 * p0 / z * (pow(1 + p / p0, z) - 1)), 1e-13);
        close_to(ovr_density(&l, P), (5.9e8 + 1.34 * p) / (5.9e8 + p), 1e-15);
    }
}

TEST(laws_and_their_limits)
{
    ovr_lubricant barus = oil(OVR_BARUS, OVR_INCOMPRESSIBLE, NAN);
    ovr_lubricant one = oil(OVR_ROELANDS, OVR_INCOMPRESSIBLE, 1);
    ovr_lubricant iso = oil(OVR_ISOVISCOUS, OVR_INCOMPRESSIBLE, NAN);
    double h = 1e-6;
    for (double P = 0; P < 2; P += 0.31) /* Roelands with z = 1 is Barus */
        close_to(ovr_viscosity(&one, P), ovr_viscosity(&barus, P), 1e-12);
    assert_true(ovr_viscosity(&iso, 1.3) == 1);
    assert_true(ovr_density(&iso, 1.3) == 1);
    /* at P = 0 every law has the slope alphabar */
    one = oil(OVR_ROELANDS, OVR_INCOMPRESSIBLE, 0.5);
    close_to((ovr_viscosity(&one, h) - 1) / h, one.alphabar, 1e-4);
}

TEST(index_by_roelands_relation)
{
    ovr_contact to = resolve(roller());
    ovr_lubricant l;
    ovr_error err = {0};
    assert_int_equal(ovr_lubricant_make(&to, OVR_ROELANDS, OVR_INCOMPRESSIBLE,
                                        1.96e8, NAN, &l, &err),
                     OVR_OK);
    close_to(l.z, 18.3e-9 * 1.96e8 / (log(0.043) + 9.67), 1e-14);
    close_to(l.P0, 1.96e8 / to.ph, 1e-14);
}

TEST(no_pressure_no_law)
{
    ovr_contact to = resolve(moes(20, 10));
    ovr_lubricant l;
    ovr_error err = {0};
    assert_int_equal(ovr_lubricant_make(&to, OVR_ROELANDS, OVR_INCOMPRESSIBLE,
                                        NAN, NAN, &l, &err),
                     OVR_BAD_INPUT);
    assert_non_null(strstr(err.message, "alpha is missing"));
    assert_int_equal(ovr_lubricant_make(&to, OVR_BARUS, OVR_INCOMPRESSIBLE, NAN,
                                        NAN, &l, &err),
                     OVR_OK);
    to = resolve(moes(20, 0));
    assert_int_equal(ovr_lubricant_make(&to, OVR_ROELANDS, OVR_DOWSON_HIGGINSON,
                                        NAN, NAN, &l, &err),
                     OVR_OK);
    assert_int_equal(l.viscosity_law, OVR_ISOVISCOUS);
    assert_int_equal(l.density_law, OVR_INCOMPRESSIBLE);
}

/* -------------------------------------------------------- film formulas */

TEST(film_formula_limits)
{
    /* far into each regime the formula is its asymptote */
    close_to(ovr_film_central_moes(0.01, 0),
             ovr_film_asymptotes_moes(0.01, 0).rigid_iso, 1e-2);
    close_to(ovr_film_central_moes(1e4, 0),
             ovr_film_asymptotes_moes(1e4, 0).elastic_iso, 1e-3);
    close_to(ovr_film_central_moes(1e5, 60),
             ovr_film_asymptotes_moes(1e5, 60).elastic_piezo, 0.1);
    close_to(ovr_film_asymptotes_moes(20, 10).elastic_piezo * 8 * 20 / PI,
             1.311 * pow(20, -0.125) * pow(10, 0.75), 1e-14);
}

/* ------------------------------------------------------------ histories */

static ovr_history *make(ovr_history_form form)
{
    ovr_error err = {0};
    ovr_history *made = ovr_history_create(&form, NULL, &err);
    if (!made)
        fail_msg("%s", err.message);
    return made;
}

static double value_at(double T, void *history)
{
    return ovr_history_value(history, T);
}

static void integral_by_quadrature(ovr_history_form form, double breaks[4])
{
    ovr_history *h = make(form);
    gsl_integration_workspace *w = gsl_integration_workspace_alloc(1000);
    gsl_function f = {value_at, h};
    for (double T = -3; T < 9; T += 0.73) {
        double sum = 0, error, from = T < 0 ? T : 0, to = T < 0 ? 0 : T;
        for (int k = 0; k <= 4; k++) { /* from break to break */
            double a = k ? breaks[k - 1] : -1e9, b = k < 4 ? breaks[k] : 1e9;
            double part;
            a = fmax(a, from);
            b = fmin(b, to);
            if (a >= b)
                continue;
            gsl_integration_qag(&f, a, b, 1e-13, 1e-13, 1000, 6, w, &part,
                                &error);
            sum += part;
        }
        if (T < 0)
            sum = -sum;
        if (fabs(ovr_history_integral(h, T) - sum) > 1e-11)
            fail_msg("integral to %g: %.15g, quadrature %.15g", T,
                     ovr_history_integral(h, T), sum);
    }
    gsl_integration_workspace_free(w);
    ovr_history_free(h);
}

TEST(integrals)
{
    static const double T[] = {-1, 0.4, 2.5, 4}, v[] = {1, 0.3, 0, 1.7};
    ovr_history_form form = ovr_history_form_default();
    integral_by_quadrature(form, (double[]){0, 0, 0, 0});
    form.kind = OVR_HISTORY_RAMP;
    form.to = 1.2;
    form.from = 0.3;
    form.start = 0.7;
    form.duration = 2.9;
    integral_by_quadrature(form, (double[]){0.7, 3.6, 4, 4});
    form.start = -2;
    integral_by_quadrature(form, (double[]){-2, 0.9, 4, 4});
    form.kind = OVR_HISTORY_STEP;
    form.duration = 0;
    form.start = 1.1;
    integral_by_quadrature(form, (double[]){1.1, 2, 3, 4});
    form.kind = OVR_HISTORY_SINE;
    form.amplitude = 0.4;
    form.period = 1.3;
    integral_by_quadrature(form, (double[]){1.1, 2, 3, 4});
    form.kind = OVR_HISTORY_TABLE;
    form.points = 4;
    form.T = T;
    form.value = v;
    integral_by_quadrature(form, (double[]){-1, 0.4, 2.5, 4});
}

TEST(ramps_are_smooth_and_steps_jump)
{
    ovr_history_form form = ovr_history_form_default();
    ovr_history *h;
    form.kind = OVR_HISTORY_RAMP;
    form.to = 3;
    form.duration = 2;
    h = make(form);
    close_to(ovr_history_value(h, 1), 2, 1e-15);
    assert_true(ovr_history_value(h, -5) == 1);
    assert_true(ovr_history_value(h, 5) == 3);
    /* s(y) = 10 y^3 + ..: flat at the start */
    close_to((ovr_history_value(h, 0.002) - 1) / 2, 10 * 1e-9, 1e-2);
    ovr_history_free(h);
    form.kind = OVR_HISTORY_STEP;
    form.duration = 0;
    h = make(form);
    assert_true(ovr_history_value(h, 0) == 1);
    assert_true(ovr_history_value(h, 1e-9) == 3);
    ovr_history_free(h);
    assert_true(ovr_history_value(NULL, 4) == 1);
    assert_true(ovr_history_integral(NULL, 4) == 4);
}

TEST(tables_keep_their_points_and_range)
{
    static const double T[] = {0, 1, 1.1, 5}, v[] = {1, 0, 0, 2};
    ovr_history_form form = ovr_history_form_default();
    ovr_history *h;
    form.kind = OVR_HISTORY_TABLE;
    form.points = 4;
    form.T = T;
    form.value = v;
    h = make(form);
    for (int i = 0; i < 4; i++)
        assert_true(fabs(ovr_history_value(h, T[i]) - v[i]) < 1e-15);
    for (double t = -1; t < 6; t += 0.003)
        assert_true(ovr_history_value(h, t) >= 0 &&
                    ovr_history_value(h, t) <= 2);
    ovr_history_free(h);
    form.points = 2; /* a straight line */
    h = make(form);
    close_to(ovr_history_value(h, 0.25), 0.75, 1e-15);
    ovr_history_free(h);
}

TEST(bad_histories_are_refused)
{
    static const double T[] = {0, 1, 1}, v[] = {1, 2, NAN};
    ovr_history_form form = ovr_history_form_default();
    ovr_error err = {0};
    form.kind = OVR_HISTORY_TABLE;
    form.T = T;
    form.value = v;
    for (form.points = 0; form.points < 2; form.points++)
        assert_null(ovr_history_create(&form, NULL, &err));
    form.points = 3;
    assert_null(ovr_history_create(&form, NULL, &err));
    form.kind = OVR_HISTORY_SINE;
    form.period = 0;
    assert_null(ovr_history_create(&form, NULL, &err));
    assert_non_null(strstr(err.message, "period"));
    form.kind = OVR_HISTORY_RAMP;
    form.duration = -1;
    assert_null(ovr_history_create(&form, NULL, &err));
    assert_non_null(strstr(err.message, "duration"));
}

/* ------------------------------------------------------- failing memory */

typedef struct budget {
    int left, held;
} budget;

static void *take(void *context, size_t bytes)
{
    budget *b = context;
    if (b->left-- <= 0)
        return NULL;
    b->held++;
    return malloc(bytes);
}

static void give(void *context, void *memory)
{
    ((budget *)context)->held--;
    free(memory);
}

TEST(histories_survive_every_failed_allocation)
{
    double T[9000], v[9000];
    ovr_history_form form = ovr_history_form_default();
    int failures = 0;
    for (int i = 0; i < 9000; i++)
        T[i] = v[i] = i;
    form.kind = OVR_HISTORY_TABLE;
    form.points = 9000;
    form.T = T;
    form.value = v;
    for (;; failures++) {
        budget b = {failures, 0};
        ovr_allocator a = {take, give, &b};
        ovr_error err = {0};
        ovr_history *h = ovr_history_create(&form, &a, &err);
        ovr_history_free(h);
        assert_int_equal(b.held, 0);
        if (h)
            break;
        assert_int_equal(err.status, OVR_NO_MEMORY);
    }
    assert_true(failures >= 3);
}
