/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Parts of the heat model: modes of the solids under a moving uniform source,
 * and temperatures across a film, compared with closed forms. */
#include <gsl/gsl_integration.h>
#include <gsl/gsl_sf_bessel.h>
#include <math.h>
#include <stdio.h>

#include "contact/heat_numbers.h"
#include "multigrid/cross_film.h"
#include "physics/heat/solids.h"
#include "support/memory.h"
#include "support/test.h"

/* ----------------------------------------------------------------- solids */

TEST(memory_is_one_over_sqrt)
{
    for (double range = 100; range < 1e5; range *= 3) {
        ovr_memory m;
        ovr_memory_rates(0.01, 0.01 * range, &m);
        ovr_memory_fit(0.01, 0.01 * range, &m);
        double error = test_memory_error(&m, 0.01 * range);
        assert_true(error < (range < 3e4 ? 1e-4 : 5e-4));
    }
}

/* Steps of other lengths than the rates were made for: a bit shorter, or
 * longer by any factor. */
TEST(memory_survives_other_steps)
{
    ovr_memory m;
    ovr_memory_rates(0.01, 30, &m);
    for (double dT = 0.01 / 2.4; dT < 2; dT *= 1.3) {
        ovr_memory_fit(dT, 30, &m);
        assert_true(test_memory_error(&m, 30) < 2e-4);
    }
}

/* q = 1 over -1 < X < 1, from X = -3 on in steps of D: T/N = 2 sqrt(X + 1), and
 * behind it 2 (sqrt(X + 1) - sqrt(X - 1)). */
TEST(under_a_uniform_source)
{
    const double D = 1.0 / 256;
    double psi[OVR_MODES] = {0}, before = 0, worst = 0;
    ovr_memory m;
    ovr_memory_rates(D, 6, &m);
    ovr_memory_fit(D, 6, &m);
    for (int i = -768; i <= 768; i++) {
        double X = i * D, q = X > -1 && X < 1 ? 1 : X == -1 || X == 1 ? .5 : 0;
        double T = ovr_memory_past(&m, psi, before) + 4. / 3 * sqrt(D) * q;
        double exact = 2 * (sqrt(fmax(X + 1, 0)) - sqrt(fmax(X - 1, 0)));
        ovr_memory_step(&m, before, q, psi);
        before = q;
        if (fabs(X + 1) > 0.1 && fabs(X - 1) > 0.1)
            worst = fmax(worst, fabs(T - exact));
    }
    print_message("uniform source: off by %.1e of the largest\n",
                  worst / (2 * sqrt(2)));
    assert_true(worst < 1e-3 * 2 * sqrt(2));
}

static double source(double x, void *unused)
{
    (void)unused;
    return x == 0 ? 0 : gsl_sf_bessel_K0(fabs(x)) * exp(x);
}

/* How far the limit of fast motion is from Carslaw and Jaeger's full solution,
 * in its largest temperature: told, and falling. */
TEST(distance_from_the_full_solution)
{
    gsl_integration_workspace *w = gsl_integration_workspace_alloc(2000);
    gsl_function f = {source, NULL};
    double before = 1;
    for (double Pe = 1; Pe < 200; Pe *= 10) {
        double L = Pe / 2, largest = 0;
        for (double X = -1; X <= 1; X += 0.02) {
            double pts[] = {-L * (1 + X), 0, L * (1 - X)}, value, error;
            gsl_integration_qagp(&f, pts, 3, 1e-12, 1e-8, 2000, w, &value,
                                 &error);
            /* T = value q b/(pi k L); in the limit 2 sqrt(2 (1 + X)...) */
            largest = fmax(largest, value / sqrt(3.14159265358979323846 * L));
        }
        double off = fabs(largest / 2 - 1);
        (void)off;
        print_message("Peclet %g: the full solution is %.4f of the limit\n", Pe,
                      largest / 2);
        assert_true(off < before);
        before = off;
    }
    gsl_integration_workspace_free(w);
}

/* ------------------------------------------------------------------- film */

static const ovr_heat oil = {
    .points = 5, .T0 = 350, .theta = 400, .conduction = 3, .C = 0, .beta = 0};

/* The coefficient of P_{n-1}: 1 of that polynomial, 0 of all below; moved to
 * other points a polynomial of degree 4 is the same. */
TEST(last_of_legendre)
{
    ovr_cross_film a, b;
    for (int points = 5; points <= 7; points += 2) {
        double of[7] = {0}, moved[7];
        ovr_cross_film_make(points, &a);
        ovr_cross_film_make(12 - points, &b);
        for (int j = 0; j < points; j++) {
            double s = a.s[j], s2 = s * s;
            double P4 = (35 * s2 * s2 - 30 * s2 + 3) / 8;
            double P6 = (231 * s2 * s2 * s2 - 315 * s2 * s2 + 105 * s2 - 5) /
                        16;
            double T = 2 - s + 3 * s2 + 0.5 * s2 * s;
            of[0] += a.last[j] * T;
            of[1] += a.last[j] * (points == 5 ? P4 : P6);
            of[2] += a.last[j] * P4;
        }
        assert_true(fabs(of[0]) < 1e-14);
        CHECK_CLOSE(of[1], 1, 1e-14);
        assert_true(fabs(of[2] - (points == 5)) < 1e-14);
        for (int j = 0; j < points; j++)
            of[j] = 1 + pow(a.s[j], 3) - 2 * pow(a.s[j], 4);
        ovr_cross_film_move(&a, of, &b, moved);
        for (int j = 0; j < b.n; j++)
            CHECK_CLOSE(moved[j], 1 + pow(b.s[j], 3) - 2 * pow(b.s[j], 4),
                        1e-13);
    }
}

/* A slab between walls held at two temperatures, with uniform heating: a
 * parabola, T = T1 + (T2 - T1) z + Theta Q H z (1 - z)/(2 Kf). */
TEST(slab_conduction)
{
    for (int points = 5; points <= 7; points += 2) {
        const ovr_sheet sheet = {.H = 0.3,
                                 .rho = 1.1,
                                 .lambda = 0.1,
                                 .Sigma0 = INFINITY,
                                 .limit = INFINITY,
                                 .V = 0.4,
                                 .u1 = 1.2,
                                 .wet = true};
        const ovr_wall wall[2] = {{2, 1e-12}, {5, 1e-12}};
        double T[7] = {0}, never[7];
        ovr_cross_film a;
        ovr_cross_film_flow flow = {0};
        ovr_cross_film_make(points, &a);
        ovr_cross_film_flow_of(&a, &oil, &sheet, T, &flow);
        for (int j = 0; j < points; j++)
            never[j] = 1e30;
        ovr_cross_film_solve(&a, &oil, &sheet, &flow, T, never, wall, T);
        for (int j = 0; j < points; j++) {
            double z = (1 + a.s[j]) / 2, Q = flow.heating[0];
            CHECK_CLOSE(T[j],
                        2 + 3 * z +
                            oil.theta * Q * sheet.H * z * (1 - z) /
                                (2 * oil.conduction),
                        1e-9);
            CHECK_CLOSE(flow.u[j], 1.2 - 0.4 * z, 1e-12);
            CHECK_CLOSE(Q, 0.4 * 0.4 * 0.1 / (12 * sheet.H), 1e-12);
        }
    }
}

/* Walls that take no heat: rho dT/dt = Theta tau u_z/H, all of it stays. */
TEST(adiabatic_couette_heating)
{
    const ovr_sheet sheet = {.H = 0.2,
                             .rho = 1.2,
                             .lambda = 0.1,
                             .Sigma0 = INFINITY,
                             .limit = INFINITY,
                             .V = 0.5,
                             .u1 = 1.25,
                             .wet = true};
    const ovr_wall wall[2] = {{0, 1e30}, {0, 1e30}};
    double T[7] = {0}, step[7];
    ovr_cross_film a;
    ovr_cross_film_flow flow = {0};
    ovr_cross_film_make(5, &a);
    for (int j = 0; j < 5; j++)
        step[j] = 0.01;
    for (int k = 1; k <= 50; k++) {
        double departure[7];
        for (int j = 0; j < 5; j++)
            departure[j] = T[j];
        ovr_cross_film_flow_of(&a, &oil, &sheet, T, &flow);
        ovr_cross_film_solve(&a, &oil, &sheet, &flow, departure, step, wall, T);
        for (int j = 0; j < 5; j++)
            CHECK_CLOSE(T[j],
                        k * 0.01 * oil.theta * 0.25 * 0.1 /
                            (12 * 0.2 * 0.2 * 1.2),
                        1e-11);
    }
}

/* Rows add up to the balance of energy, whatever the temperatures. */
TEST(what_is_made_flows_out)
{
    ovr_heat hot = oil;
    const ovr_sheet sheet = {.H = 0.25,
                             .rho = 1.1,
                             .P_X = -0.4,
                             .P_T = 0.3,
                             .log_eta = 2,
                             .lambda = 0.1,
                             .Sigma0 = INFINITY,
                             .limit = INFINITY,
                             .V = 0.5,
                             .u1 = 1.25,
                             .wet = true};
    const ovr_wall wall[2] = {{3, 0.2}, {1, 0.4}};
    double departure[7] = {1, 2, 4, 3, 2}, T[7], step[7], made = 0, gone = 0;
    ovr_cross_film a;
    ovr_cross_film_flow flow = {0};
    hot.C = 6, hot.S0 = 1.1, hot.expansion = 6e-4;
    ovr_cross_film_make(5, &a);
    ovr_cross_film_flow_of(&a, &hot, &sheet, departure, &flow);
    CHECK_CLOSE(flow.u[4], 0.75, 1e-12);
    for (int j = 0; j < 5; j++)
        step[j] = 0.1 / fmax(flow.u[j], 0.02);
    ovr_cross_film_solve(&a, &hot, &sheet, &flow, departure, step, wall, T);
    for (int j = 0; j < 5; j++) {
        made += a.w[j] * hot.theta *
                (flow.heating[j] + 6e-4 * (350 + T[j]) * sheet.H *
                                       (sheet.P_T + flow.u[j] * sheet.P_X));
        gone += a.w[j] * sheet.rho * sheet.H * (T[j] - departure[j]) / step[j];
    }
    gone += hot.conduction * ((T[0] - 3) / 0.2 + (T[4] - 1) / 0.4);
    CHECK_CLOSE(gone, made, 1e-12);
}

TEST(viscosity_falls_with_temperature)
{
    ovr_heat roelands = {.T0 = 353, .C = 6.4, .S0 = 1.1};
    ovr_heat barus = {.T0 = 353, .beta = 0.033};
    /* the slope at ambient pressure is beta = S0 C/(T0 - 138) */
    CHECK_CLOSE(-ovr_heat_log_viscosity(&roelands, 0, 1e-4) / 1e-4,
                1.1 * 6.4 / 215, 1e-5);
    CHECK_CLOSE(ovr_heat_log_viscosity(&barus, 7, 10), 6.67, 1e-14);
    CHECK_CLOSE(ovr_heat_log_viscosity(&roelands, 12, 50),
                18.4 * pow(265. / 215, -1.1) - 6.4, 1e-13);
}
