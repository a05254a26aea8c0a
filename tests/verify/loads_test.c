/* SPDX-License-Identifier: GPL-3.0-or-later */
/* All 64 loads of the figures of the paper with automatic settings at level 10
 * and both smoothers, and the film thickness at level 12 compared with
 * independent grid-converged values. */
#include "support/contact.h"
#include "support/test.h"

#include <math.h>
#include <stdio.h>

#include "support/reference.h"
#include "support/steady.h"

static const double M_of[] = {5, 10, 20, 50, 100, 200, 500, 1000};
static const double L_of[] = {0, 1, 2.5, 5, 8, 10, 12, 15};

static void matrix(ovr_smoother smoother)
{
    int failed = 0;
    print_message("\n|| level 10, %s: cycles (attempts)\n| M \\ L |",
                  smoother == OVR_LINE ? "line" : "hybrid");
    for (size_t j = 0; j < 8; j++)
        print_message(" %g |", L_of[j]);
    print_message("\n|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n");
    for (size_t i = 0; i < 8; i++) {
        print_message("| %g |", M_of[i]);
        for (size_t j = 0; j < 8; j++) {
            ovr_options o = test_options();
            o.level = 10;
            o.smoother = smoother;
            o.inlet = o.outlet = NAN;
            test_solution s = test_steady(M_of[i], L_of[j], &o);
            failed += s.status != OVR_OK;
            print_message(" %d (%d)%s |", s.o.cycles, s.o.retries + 1,
                          s.status ? "!" : "");
        }
        print_message("\n");
    }
    print_message("# %d of 64 converged\n", 64 - failed);
    assert_int_equal(failed, 0);
}

TEST(test_line)
{
    matrix(OVR_LINE);
}

TEST(test_hybrid)
{
    matrix(OVR_HYBRID);
}

TEST(test_film)
{
    print_message("\n|| level 12, upstream2, [-4, 1.5]: relative errors\n"
                  "| M | L | H_min | error | H_cen | error |\n"
                  "|--:|--:|--:|--:|--:|--:|\n");
    for (size_t k = 0; k < sizeof truth_steady_rows / sizeof *truth_steady_rows;
         k++) {
        const truth_steady *e = &truth_steady_rows[k];
        ovr_options o = test_options();
        o.level = 12;
        test_solution s = test_steady(e->M, e->L, &o);
        print_message("| %g | %g | %.7f | %.1e | %.7f | %.1e |\n", e->M, e->L,
                      s.o.H_min, s.o.H_min / e->H_m - 1, s.o.H_cen,
                      s.o.H_cen / e->H_cen - 1);
        CHECK_OK(s.status, NULL);
        CHECK_CLOSE(s.o.H_min, e->H_m, 5e-4);
        CHECK_CLOSE(s.o.H_cen, e->H_cen, 1e-4);
    }
}
