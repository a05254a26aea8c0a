/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Sample of the loads of the paper (all 64 are in tests/verify/loads_test.c),
 * the rigid limit, and the stopping criterion. */
#include "support/contact.h"
#include "support/test.h"

#include <math.h>
#include <stdio.h>

#include "support/reference.h"
#include "support/steady.h"

static ovr_options automatic(int level)
{
    ovr_options o = test_options();
    o.level = level;
    o.inlet = o.outlet = NAN;
    return o;
}

TEST(test_sample)
{
    const double ML[][2] = {{5, 0},   {5, 15},   {20, 10},  {50, 15},
                            {100, 0}, {200, 10}, {1000, 0}, {1000, 15}};
    for (size_t k = 0; k < sizeof ML / sizeof *ML; k++)
        for (int hybrid = 0; hybrid < 2; hybrid++) {
            ovr_options o = automatic(10);
            o.smoother = hybrid ? OVR_HYBRID : OVR_LINE;
            test_solution s = test_steady(ML[k][0], ML[k][1], &o);
            if (s.status)
                print_error("M = %g, L = %g: %s\n", ML[k][0], ML[k][1],
                            s.message);
            assert_int_equal(s.status, OVR_OK);
            assert_true(s.o.converged);
        }
}

TEST(test_film)
{
    for (size_t k = 0; k < sizeof truth_steady_rows / sizeof *truth_steady_rows;
         k += 4) {
        const truth_steady *e = &truth_steady_rows[k];
        ovr_options o = test_options();
        o.level = 11;
        test_solution s = test_steady(e->M, e->L, &o);
        CHECK_OK(s.status, NULL);
        CHECK_CLOSE(s.o.H_min, e->H_m, 5e-4);
        CHECK_CLOSE(s.o.H_cen, e->H_cen, 1e-4);
    }
}

/* The film thickness in Moes' scaling times M converges to 2.4476 (Martin,
 * Guembel); the automatic inlet reduces it by 1e-3. */
TEST(test_rigid_limit)
{
    const double limit = 2.4476, moes = 8 / acos(-1.0);
    double before = 1e9;
    print_message("\n|| rigid, isoviscous: H_min (Moes) M against 2.4476\n"
                  "| M | inlet | H_min M |\n|--:|--:|--:|\n");
    for (double M = 3; M > 5e-3; M *= 0.3162278) {
        ovr_options o = automatic(11);
        test_solution s = test_steady(M, 0, &o);
        double product = s.o.H_min * moes * M * M;
        print_message("| %.3g | %.4g | %.4f |\n", M, s.options.inlet, product);
        CHECK_OK(s.status, NULL);
        assert_true(product < before);
        before = product;
    }
    CHECK_CLOSE(before, limit, 2e-3);
}

/* The film does not depend on the automatic inlet. */
TEST(test_inlet)
{
    const double ML[][2] = {{0.1, 0}, {1, 0}, {1, 5}, {5, 0}, {5, 10}, {20, 5}};
    for (size_t k = 0; k < sizeof ML / sizeof *ML; k++) {
        ovr_options o = automatic(11);
        test_solution near = test_steady(ML[k][0], ML[k][1], &o);
        o.inlet = 2 * near.options.inlet;
        o.outlet = near.options.outlet;
        test_solution far = test_steady(ML[k][0], ML[k][1], &o);
        CHECK_OK(near.status, NULL);
        CHECK_OK(far.status, NULL);
        CHECK_CLOSE(near.o.H_cen, far.o.H_cen, 2e-3);
    }
}

/* stop = truncation: the algebraic error is a fraction of the discretization
 * error, in fewer cycles. */
TEST(test_truncation)
{
    const double ML[][2] = {{5, 10}, {20, 10}, {100, 5}};
    for (size_t k = 0; k < sizeof ML / sizeof *ML; k++)
        for (int order = 1; order <= 2; order++) {
            ovr_options o = test_options();
            test_solution s, exact;
            o.level = 9;
            o.scheme = order == 1 ? OVR_UPSTREAM1 : OVR_UPSTREAM2;
            exact = test_steady(ML[k][0], ML[k][1], &o);
            o.stop = OVR_STOP_TRUNCATION;
            s = test_steady(ML[k][0], ML[k][1], &o);
            CHECK_OK(s.status, NULL);
            assert_true(s.o.cycles < exact.o.cycles);
            assert_true(s.finest.algebraic < 0.1 * s.finest.difference);
            CHECK_CLOSE(s.o.H_cen, exact.o.H_cen, 1e-5);
        }
}
