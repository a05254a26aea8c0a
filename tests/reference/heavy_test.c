/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Heavily loaded steady contacts on the automatic level. */
#include <math.h>
#include <stdio.h>

#include "support/test.h"

#include "overroll/overroll.h"

typedef struct heavy {
    double H_cen, H_min, P_cen;
    bool converged;
    int level;
} heavy;

/* level = 0: as the program chooses. */
static heavy solve(double M, double L, int level)
{
    ovr_error err = {0};
    char text[200];
    int used = snprintf(text, sizeof text,
                        "[contact]\nM = %g\nL = %g\n[domain]\n", M, L);
    if (level)
        snprintf(text + used, sizeof text - (size_t)used, "level = %d\n",
                 level);
    ovr_case *c = ovr_case_read_text(text, "case", NULL, NULL, &err);
    ovr_run *run = c ? ovr_run_create(c, NULL, NULL, &err) : NULL;
    CHECK_OK(run ? OVR_OK : err.status, &err);
    ovr_run_execute(run, &err);
    const ovr_observation *o = ovr_simulation_observation(
        ovr_run_get_info(run)->sim);
    heavy h = {o->H_cen, o->H_min, o->P_cen, o->converged,
               ovr_run_get_info(run)->setup->options->level};
    print_message("M %g, L %g: level %d, H_cen %.6g, H_min %.6g, P_cen %.5f, "
                  "%d cycles\n",
                  M, L, h.level, h.H_cen, h.H_min, h.P_cen, o->cycles);
    ovr_run_free(run);
    ovr_case_free(c);
    return h;
}

/* The central film thicknesses of two levels agree; the pressure is nearly
 * Hertzian, and the difference decreases with the load. */
TEST(heavy_contacts_are_solved_by_default)
{
    static const double of[][2] = {{1400, 5},   {2000, 5},   {2000, 10},
                                   {3500, 1.3}, {4000, 1.3}, {5000, 0.5},
                                   {5000, 1.8}, {5000, 5}};
    double last = 1;
    for (size_t k = 0; k < sizeof of / sizeof *of; k++) {
        heavy h = solve(of[k][0], of[k][1], 0);
        assert_true(h.converged && h.level > 8 && h.H_min > 0);
        CHECK_NEAR(h.P_cen, 1, 2e-3);
        if (k == 0)
            last = h.H_cen;
        if (k == 1)
            assert_true(h.H_cen < last);
        if (of[k][0] < test_draws(1500, 3000)) {
            heavy finer = solve(of[k][0], of[k][1], h.level + 1);
            CHECK_NEAR(h.H_cen / finer.H_cen, 1, 1e-3);
        }
    }
}

/* Where a level is too coarse and the solve fails, no film is an answer that is
 * not above zero. */
TEST(failed_films_are_not_numbers)
{
    int failed = 0;
    for (double M = 1500; M < 6000; M *= 1.3) {
        heavy h = solve(M, 5, 7);
        failed += !h.converged;
        assert_true(h.converged ? h.H_min > 0 : !(h.H_min <= 0));
        assert_true(!(h.H_cen <= 0));
    }
    assert_true(failed > 0);
}
