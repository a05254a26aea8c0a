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

static heavy solve_text(const char *text)
{
    ovr_error err = {0};
    ovr_case *c = ovr_case_read_text(text, "case", NULL, NULL, &err);
    ovr_run *run = c ? ovr_run_create(c, NULL, NULL, &err) : NULL;
    CHECK_OK(run ? OVR_OK : err.status, &err);
    ovr_run_execute(run, &err);
    const ovr_observation *o = ovr_simulation_observation(
        ovr_run_get_info(run)->sim);
    heavy h = {o->H_cen, o->H_min, o->P_cen, o->converged,
               ovr_run_get_info(run)->setup->options->level};
    print_message("level %d, H_cen %.6g, H_min %.6g, P_cen %.5f, %d cycles\n",
                  h.level, h.H_cen, h.H_min, h.P_cen, o->cycles);
    ovr_run_free(run);
    ovr_case_free(c);
    return h;
}

/* level = 0: as the program chooses. */
static heavy solve(double M, double L, int level)
{
    char text[200];
    int used = snprintf(text, sizeof text,
                        "[contact]\nM = %g\nL = %g\n[domain]\n", M, L);
    if (level)
        snprintf(text + used, sizeof text - (size_t)used, "level = %d\n",
                 level);
    print_message("M %g, L %g: ", M, L);
    return solve_text(text);
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

/* A shear-thinning contact on a level that hardly resolves its inlet, with a
 * feature that the steady solution leaves out, and without. */
static heavy solve_unresolved(int level, bool dent)
{
    char text[700];
    snprintf(text, sizeof text,
             "[contact]\nM = 1648.84\nL = 3.65876\nmodulus = 226 GPa\n"
             "slide_to_roll = 0\n[lubricant]\ndensity_law = tait\n"
             "tait_K0 = 2.24 GPa\ntait_K0_slope = 11.99\n"
             "rheology = carreau\ncarreau_stress = 0.3357 MPa\n"
             "carreau_n = 0.185\ncarreau_a = 2.06\ncarreau_form = rate\n"
             "[domain]\nlevel = %d\ninlet = -8.25\n"
             "[time]\nscheme = upstream1\n[cavitation]\nmodel = conserving\n"
             "%s",
             level,
             dent ? "[feature d]\nshape = dent\ndepth = 1e-9\nwidth = 1\n"
                  : "");
    return solve_text(text);
}

/* Only steps in time find it, with Newton's method in most of them: by cycles
 * alone the start was not found in the work that it may take. */
TEST(features_left_out_do_not_decide_the_start)
{
    heavy with = solve_unresolved(10, true), finer = solve_unresolved(11, true);
    assert_true(with.converged && finer.converged);
    assert_true(with.H_min > 0);
    CHECK_NEAR(with.P_cen, finer.P_cen, 1e-3);
    CHECK_NEAR(with.H_cen / finer.H_cen, 1, 0.06);
    if (test_draws(0, 1) > 0) {
        heavy without = solve_unresolved(10, false);
        assert_true(without.H_cen == with.H_cen);
        assert_true(without.H_min == with.H_min);
    }
}
