/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Lubricant relations compared with their formulas in extended precision and
 * with differences, tables with GSL, data sheets with the standards. */
#include <gsl/gsl_integration.h>
#include <gsl/gsl_spline.h>
#include <math.h>

#include "contact/contact.h"
#include "contact/oil.h"
#include "support/test.h"

/* An ester at 1 GPa of Hertzian pressure, made up. */
static ovr_oil an_oil(ovr_viscosity_law law, ovr_density_law density)
{
    ovr_oil oil = ovr_oil_default();
    oil.viscosity_law = law;
    oil.density_law = density;
    oil.temperature = 353.15;
    oil.viscosity = 0.01;
    oil.tait_K0 = 1.3e9;
    oil.tait_K0_slope = 11;
    oil.doolittle_B = 4.2;
    oil.doolittle_R0 = 0.66;
    oil.yasutomi = (ovr_yasutomi){.C1 = 16.04,
                                  .C2 = 26,
                                  .Tg0 = 200,
                                  .A1 = 190,
                                  .A2 = 0.6e-9,
                                  .b1 = 6e-9,
                                  .b2 = -0.5};
    return oil;
}

static ovr_contact a_contact(double alpha)
{
    ovr_contact c = {.M = 20,
                     .L = 10,
                     .ph = 1e9,
                     .alpha = alpha,
                     .alphabar = alpha * 1e9,
                     .viscosity = 0.01};
    return c;
}

static ovr_lubricant scaled(ovr_oil *oil)
{
    ovr_error err = {0};
    ovr_lubricant made = {0};
    ovr_contact contact;
    if (isnan(oil->alpha) && ovr_oil_complete(oil, &err))
        fail_msg("%s", err.message);
    contact = a_contact(oil->alpha);
    if (ovr_oil_scale(oil, &contact, &made, &err))
        fail_msg("%s", err.message);
    return made;
}

static long double tait(const ovr_oil *oil, long double p)
{
    long double n = 1 + (long double)oil->tait_K0_slope;
    return 1 - log1pl(p * n / oil->tait_K0) / n;
}

static long double doolittle(const ovr_oil *oil, long double p)
{
    long double R0 = oil->doolittle_R0;
    return oil->doolittle_B * R0 * (1 / (tait(oil, p) - R0) - 1 / (1 - R0));
}

static long double yasutomi_exponent(const ovr_yasutomi *y, long double p)
{
    long double F = powl(1 + y->b1 * p, y->b2);
    long double Tg = y->Tg0 + y->A1 * log1pl(y->A2 * p);
    long double u = (353.15L - Tg) * F;
    return -y->C1 * u / (y->C2 + u);
}

static long double yasutomi(const ovr_oil *oil, long double p)
{
    return logl(10) * (yasutomi_exponent(&oil->yasutomi, p) -
                       yasutomi_exponent(&oil->yasutomi, 0));
}

TEST(viscosities_by_their_formulas)
{
    ovr_oil d = an_oil(OVR_DOOLITTLE, OVR_TAIT);
    ovr_oil y = an_oil(OVR_YASUTOMI, OVR_INCOMPRESSIBLE);
    ovr_lubricant by_d = scaled(&d), by_y = scaled(&y);
    for (double P = 0.01; P < 1.6; P += 0.083) {
        CHECK_CLOSE(log(ovr_viscosity(&by_d, P)),
                    (double)doolittle(&d, P * 1e9L), 1e-13);
        CHECK_CLOSE(log(ovr_viscosity(&by_y, P)),
                    (double)yasutomi(&y, P * 1e9L), 1e-13);
        CHECK_CLOSE(ovr_density(&by_d, P), (double)(1 / tait(&d, P * 1e9L)),
                    1e-15);
    }
}

/* alpha is the slope of ln eta at p = 0. */
TEST(alpha_is_the_slope)
{
    ovr_oil d = an_oil(OVR_DOOLITTLE, OVR_TAIT);
    ovr_oil y = an_oil(OVR_YASUTOMI, OVR_INCOMPRESSIBLE);
    long double h = 1e3;
    scaled(&d);
    scaled(&y);
    CHECK_CLOSE(d.alpha,
                (double)((doolittle(&d, h) - doolittle(&d, -h)) / (2 * h)),
                1e-10);
    CHECK_CLOSE(y.alpha,
                (double)((yasutomi(&y, h) - yasutomi(&y, -h)) / (2 * h)),
                1e-10);
    assert_true(d.alpha > 5e-9 && d.alpha < 5e-8);
    assert_true(y.alpha > 5e-9 && y.alpha < 5e-8);
}

/* At its glass transition an oil has the viscosity of a glass. */
TEST(viscosity_from_the_glass)
{
    ovr_oil y = an_oil(OVR_YASUTOMI, OVR_INCOMPRESSIBLE);
    y.viscosity = NAN;
    y.glass_viscosity = 1e12;
    scaled(&y);
    CHECK_CLOSE(y.viscosity,
                1e12 * pow(10, (double)yasutomi_exponent(&y.yasutomi, 0)),
                1e-13);
}

/* ----------------------------------------------------------------- tables */

enum { POINTS = 9 };
static const double table_p[POINTS] = {1e5, 2e7, 6e7,   1e8,  2e8,
                                       4e8, 7e8, 1.1e9, 1.5e9};
static const double table_eta[POINTS] = {0.01, 0.0146, 0.029, 0.0545, 0.21,
                                         2.1,  44,     1500,  40000};
static const double table_rho[POINTS] = {850, 860, 876,  890, 915,
                                         952, 987, 1020, 1043};

static ovr_law_table *a_table(ovr_table_of what)
{
    ovr_error err = {0};
    const ovr_law_points points = {what, POINTS, table_p,
                                   what == OVR_TABLE_OF_VISCOSITY ? table_eta
                                                                  : table_rho};
    ovr_law_table *table = ovr_law_table_create(&points, NULL, &err);
    if (!table)
        fail_msg("%s", err.message);
    return table;
}

TEST(tables_are_monotone_splines)
{
    ovr_oil oil = an_oil(OVR_VISCOSITY_TABLE, OVR_DENSITY_TABLE);
    gsl_spline *spline = gsl_spline_alloc(gsl_interp_steffen, POINTS);
    double y[POINTS], end, before = 0;
    ovr_lubricant made;
    oil.viscosity_table = a_table(OVR_TABLE_OF_VISCOSITY);
    oil.density_table = a_table(OVR_TABLE_OF_DENSITY);
    made = scaled(&oil);
    for (int i = 0; i < POINTS; i++)
        y[i] = log(table_eta[i]);
    gsl_spline_init(spline, table_p, y, POINTS);
    end = log(ovr_viscosity(&made, 1.5)) - log(ovr_viscosity(&made, 1.4999));
    for (int i = 0; i < POINTS; i++) { /* through every point */
        CHECK_CLOSE(ovr_viscosity(&made, table_p[i] / 1e9) / table_eta[i],
                    ovr_viscosity(&made, 1e-4) / table_eta[0], 3e-4);
        CHECK_CLOSE(ovr_density(&made, table_p[i] / 1e9) / table_rho[i],
                    ovr_density(&made, 1e-4) / table_rho[0], 1e-5);
    }
    for (double P = 1e-4; P < 1.5; P += 1e-3) {
        double value = log(ovr_viscosity(&made, P));
        bool inner = P > 0.02 && P < 1.1; /* GSL's ends are straighter */
        CHECK_NEAR(value - log(ovr_viscosity(&made, 1e-4)),
                   gsl_spline_eval(spline, P * 1e9, NULL) - y[0],
                   inner ? 3e-4 : 0.1);
        assert_true(value >= before);
        before = value;
    }
    /* straight on beyond the end */
    CHECK_CLOSE(log(ovr_viscosity(&made, 2)),
                log(ovr_viscosity(&made, 1.5)) + 5e3 * end, 1e-5);
    gsl_spline_free(spline);
    ovr_law_table_free((ovr_law_table *)oil.viscosity_table);
    ovr_law_table_free((ovr_law_table *)oil.density_table);
}

/* A law that is tabulated finely comes back. */
TEST(a_table_of_a_law_is_the_law)
{
    enum { FINE = 400 };
    ovr_oil d = an_oil(OVR_DOOLITTLE, OVR_INCOMPRESSIBLE);
    ovr_oil t = an_oil(OVR_VISCOSITY_TABLE, OVR_INCOMPRESSIBLE);
    ovr_lubricant by_d = scaled(&d), by_t;
    double p[FINE], eta[FINE];
    ovr_law_table *table;
    for (int i = 0; i < FINE; i++) {
        p[i] = 1.2e9 * i / (FINE - 1);
        eta[i] = 0.01 * ovr_viscosity(&by_d, p[i] / 1e9);
    }
    table = ovr_law_table_create(
        &(ovr_law_points){OVR_TABLE_OF_VISCOSITY, FINE, p, eta}, NULL, NULL);
    assert_non_null(table);
    t.viscosity_table = table;
    by_t = scaled(&t);
    for (double P = 0; P < 1.2; P += 0.0137)
        CHECK_CLOSE(ovr_viscosity(&by_t, P), ovr_viscosity(&by_d, P), 1e-4);
    CHECK_CLOSE(t.alpha, d.alpha, 1e-3); /* of second order in the points */
    ovr_law_table_free(table);
}

static void bad_table(size_t n, double p0, double p1, double v1)
{
    const double p[] = {p0, p1, 1e9}, v[] = {1, v1, 3};
    ovr_error err = {0};
    assert_null(ovr_law_table_create(
        &(ovr_law_points){OVR_TABLE_OF_VISCOSITY, n, p, v}, NULL, &err));
    assert_int_equal(err.status, OVR_BAD_INPUT);
}

TEST(bad_tables_are_refused)
{
    bad_table(1, 0, 1e8, 2);
    bad_table(3, 2e6, 1e8, 2); /* not ambient */
    bad_table(3, 0, 2e9, 2);   /* pressures fall */
    bad_table(3, 0, 1e8, 0.5); /* viscosities fall */
    bad_table(3, 0, 1e8, 4);
    bad_table(3, 0, 1e8, NAN);
    bad_table(3, 0, INFINITY, 2);
}

/* ------------------------------------------------------------- alpha star */

static double fluidity(double P, void *lubricant)
{
    return 1 / ovr_viscosity(lubricant, P);
}

TEST(asymptotic_alpha_by_quadrature)
{
    static const ovr_viscosity_law laws[] = {OVR_BARUS, OVR_ROELANDS,
                                             OVR_DOOLITTLE, OVR_YASUTOMI};
    gsl_integration_workspace *w = gsl_integration_workspace_alloc(1000);
    for (int k = 0; k < 4; k++) {
        ovr_oil oil = an_oil(laws[k], OVR_INCOMPRESSIBLE);
        ovr_lubricant made;
        double value, error, alphabar;
        gsl_function f = {fluidity, &made};
        oil.alpha = k < 2 ? 2e-8 : NAN;
        made = scaled(&oil);
        alphabar = ovr_asymptotic_alphabar(&made);
        gsl_integration_qags(&f, 0, 3, 0, 1e-10, 1000, w, &value, &error);
        CHECK_CLOSE(alphabar, 1 / value, 1e-9);
        if (laws[k] == OVR_BARUS) /* alpha is alpha* */
            CHECK_CLOSE(alphabar, 20, 1e-12);
        else
            assert_true(alphabar < made.alphabar);
    }
    gsl_integration_workspace_free(w);
}

/* ------------------------------------------------------------ data sheets */

/* The worked examples of ASTM D2270, whose L and H are of its table. */
TEST(index_by_the_standard)
{
    CHECK_NEAR(ovr_viscosity_index(73.30e-6, 8.86e-6), 92.43, 0.3);
    CHECK_NEAR(ovr_viscosity_index(22.83e-6, 5.05e-6), 156.37, 0.5);
    for (double Y = 2.5; Y < 60; Y *= 1.13)
        for (double VI = 20; VI < 200; VI += 17) {
            double low = Y * 1e-6, high = 1e-2;
            for (int k = 0; k < 80; k++) { /* U of that index, by bisection */
                double U = (low + high) / 2;
                if (ovr_viscosity_index(U, Y * 1e-6) < VI)
                    high = U;
                else
                    low = U;
            }
            CHECK_CLOSE(ovr_viscosity_at_100(low, VI), Y * 1e-6, 2e-3);
        }
    assert_true(isnan(ovr_viscosity_index(5e-6, 1.5e-6)));
}

TEST(walther_by_its_points)
{
    double nu = ovr_walther(46e-6, 6.8e-6, 343.15), B;
    CHECK_CLOSE(ovr_walther(46e-6, 6.8e-6, 313.15), 46e-6, 1e-12);
    CHECK_CLOSE(ovr_walther(46e-6, 6.8e-6, 373.15), 6.8e-6, 1e-12);
    B = (log10(log10(46.7)) - log10(log10(7.5))) /
        (log10(373.15) - log10(313.15));
    CHECK_CLOSE(log10(log10(nu * 1e6 + 0.7)),
                log10(log10(46.7)) - B * (log10(343.15) - log10(313.15)),
                1e-12);
}

TEST(oils_report_missing_values)
{
    ovr_oil oil = an_oil(OVR_DOOLITTLE, OVR_INCOMPRESSIBLE);
    ovr_error err = {0};
    oil.tait_K0 = NAN;
    assert_int_equal(ovr_oil_complete(&oil, &err), OVR_BAD_INPUT);
    assert_string_equal(err.about, "tait_K0");
    oil = an_oil(OVR_DOOLITTLE, OVR_INCOMPRESSIBLE);
    oil.alpha = 2e-8;
    assert_int_equal(ovr_oil_complete(&oil, &err), OVR_BAD_INPUT);
    assert_string_equal(err.about, "alpha");
    oil = an_oil(OVR_YASUTOMI, OVR_INCOMPRESSIBLE);
    oil.temperature = 190;
    assert_int_equal(ovr_oil_complete(&oil, &err), OVR_BAD_INPUT);
    assert_string_equal(err.about, "temperature");
    oil = ovr_oil_default();
    oil.nu_40 = 46e-6;
    assert_int_equal(ovr_oil_complete(&oil, &err), OVR_BAD_INPUT);
    assert_string_equal(err.about, "temperature");
}
