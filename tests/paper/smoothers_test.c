/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Comparison of the smoothers: number of cycles on all levels, reduction of the
 * finest residual by the last cycle, and time, with upstream2 and a negligible
 * algebraic error. */
#include "support/test.h"

#include <math.h>
#include <stdio.h>

#include "support/contact.h"
#include "support/steady.h"

static test_solution solve(double M, double L, int level, ovr_smoother smoother)
{
    ovr_options o = test_options();
    o.level = level;
    o.smoother = smoother;
    o.inlet = o.outlet = NAN;
    return test_steady(M, L, &o);
}

static void print_solution(const test_solution *s)
{
    if (s->status)
        print_message("| - | - | - ");
    else
        print_message("| %d | %.2f | %.1f ", s->o.cycles, s->finest.factor,
                      1e3 * s->seconds);
}

TEST(test_table)
{
    const double ML[][2] = {{5, 2.5},  {5, 10},   {10, 10},  {20, 2.5},
                            {20, 10},  {50, 10},  {100, 5},  {200, 8},
                            {500, 10}, {1000, 5}, {1000, 15}};
    const size_t cases = sizeof ML / sizeof *ML;
    int last = test_levels(8) < 12 ? test_levels(8) : 12;
    print_message("\n|| line V(1,1) and hybrid V(2,2)\n"
                  "| M | L | level | line: cycles | factor | ms | hybrid: "
                  "cycles | factor | ms |\n"
                  "|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n");
    for (size_t k = 0; k < cases; k++)
        for (int level = 8; level <= last; level += 2) {
            double M = ML[k][0], L = ML[k][1];
            test_solution line = solve(M, L, level, OVR_LINE);
            test_solution hybrid = solve(M, L, level, OVR_HYBRID);
            print_message("| %g | %g | %d ", M, L, level);
            print_solution(&line);
            print_solution(&hybrid);
            print_message("|\n");
            assert_int_equal(line.status, OVR_OK);
            /* the one case known to be beyond the hybrid */
            if (M >= 1000 && L >= 15 && level >= 12)
                continue;
            assert_int_equal(hybrid.status, OVR_OK);
            CHECK_CLOSE(hybrid.o.H_min, line.o.H_min, 1e-6);
            CHECK_CLOSE(hybrid.o.H_cen, line.o.H_cen, 1e-6);
        }
}

/* The paper's parts alone: Gauss-Seidel where eps/D^2 is large everywhere (low
 * load, fine grid), the dipole with its under-relaxation converges anywhere,
 * slowly; neither ends without saying so. */
TEST(test_parts_alone)
{
    test_solution seidel = solve(5, 0, 8, OVR_GAUSS_SEIDEL);
    test_solution dipole = solve(20, 10, 7, OVR_DIPOLE);
    print_message("# Gauss-Seidel alone, M = 5, L = 0, level 8: %s, R %.1e, "
                  "%d cycles\n",
                  ovr_status_name(seidel.status), seidel.o.residual,
                  seidel.o.cycles);
    print_message("# dipole alone, M = 20, L = 10, level 7: %s, R %.1e, "
                  "%d cycles\n",
                  ovr_status_name(dipole.status), dipole.o.residual,
                  dipole.o.cycles);
    assert_int_equal(seidel.status, OVR_OK);
    assert_true(dipole.status == OVR_OK || dipole.status == OVR_NOT_CONVERGED);
}

TEST(test_ranges)
{
    const double wrong[][2] = {{0.4, 0.5}, {1.1, 0.5}, {0.8, 0.2}, {0.8, 0.7}};
    test_contact c = test_contact_make(20, 10);
    for (size_t k = 0; k < sizeof wrong / sizeof *wrong; k++) {
        ovr_options o = test_options();
        ovr_error err = {0};
        o.relax_seidel = wrong[k][0];
        o.relax_dipole = wrong[k][1];
        assert_null(
            ovr_simulation_create(&c.contact, &c.lubricant, &o, NULL, &err));
        CHECK_ERROR(&err, OVR_BAD_INPUT, "under-relaxation");
    }
}
