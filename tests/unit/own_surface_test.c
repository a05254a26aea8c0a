/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A run with a user-defined surface has the same bits as a simulation with it,
 * and its features are not used. */
#include <math.h>
#include <string.h>

#include "support/test.h"

#include "overroll/overroll.h"

static const char *const wave = "[contact]\nM = 20\nL = 10\n"
                                "[domain]\nlevel = 4\n[time]\nend = 0.5\n"
                                "[feature w]\nshape = wave\namplitude = 0.05\n"
                                "wavelength = 1\n";

static void heights(void *calls, double T, size_t n, const double *X, double *S)
{
    ++*(int *)calls;
    for (size_t i = 0; i < n; i++)
        S[i] = 0.02 * cos(X[i] - T);
}

TEST(a_run_is_on_the_heights_given)
{
    int calls[2] = {0};
    ovr_error err = {0};
    ovr_case *c = ovr_case_read_text(wave, "wave.ini", NULL, NULL, &err);
    ovr_run_options how = {0};
    how.heights = heights;
    how.data = &calls[0];
    how.estimate_error = true;
    ovr_run *run = ovr_run_create(c, &how, NULL, &err);
    assert_non_null(run);
    ovr_setup *setup = ovr_case_resolve(c, NULL, &err);
    ovr_simulation *sim = ovr_setup_simulation(setup, NULL, &err);
    CHECK_OK(ovr_run_execute(run, &err), &err);
    ovr_simulation_surface(sim, heights, &calls[1]);
    ovr_simulation_moving(sim, NAN);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    CHECK_OK(ovr_simulation_march(sim, setup->march, &err), &err);
    const ovr_state *a = ovr_simulation_state(ovr_run_get_info(run)->sim);
    const ovr_state *b = ovr_simulation_state(sim);
    assert_int_equal(a->step, b->step);
    assert_memory_equal(a->P, b->P, a->n * sizeof *a->P);
    CHECK_NEAR(a->S[0], 0.02 * cos(a->X[0] - a->T), 1e-15);
    assert_true(calls[0] > calls[1]); /* the coarser one too */
    assert_true(ovr_run_get_info(run)->error->level == 3);
    ovr_simulation_free(sim), ovr_setup_free(setup);
    ovr_run_free(run), ovr_case_free(c);
}

TEST(sections_that_have_names)
{
    const char *name;
    size_t k = 0;
    for (; (name = ovr_section_name(k)); k++) {
        bool named = !strcmp(name, "feature") || !strcmp(name, "body") ||
                     !strcmp(name, "coating");
        assert_int_equal(ovr_section_named(k), named);
    }
    assert_false(ovr_section_named(k));
}
