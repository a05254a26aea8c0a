/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Messages about a failed solution contain no infinite numbers or NaN, for
 * every kind of failure. */
#include "support/test.h"

#include <math.h>
#include <string.h>

#include "simulation/internal.h"
#include "support/contact.h"

static void has_no_such_word(const char *message)
{
    static const char *const words[] = {"nan", "inf"};
    assert_true(strlen(message) > 20);
    for (size_t k = 0; k < sizeof words / sizeof *words; k++)
        if (strstr(message, words[k]))
            fail_msg("%s", message);
}

TEST(messages_of_diverged_solutions)
{
    const double ends[] = {NAN, -NAN, INFINITY, 1e-3};
    ovr_error err = {0};
    ovr_options o = test_options();
    o.level = 6;
    ovr_simulation *sim = test_simulation(20, 10, &o);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    for (size_t k = 0; k < sizeof ends / sizeof *ends; k++)
        for (int load = 0; load < 2; load++) {
            ovr_outcome end = {.defect = {ends[k], 1e-3, 0.1}, .cycles = 50};
            if (load)
                end.defect = (ovr_defect){1e-3, ends[k], 0.1};
            ovr_failure_steady(sim, &end, 1e-5, &err);
            has_no_such_word(err.message);
            ovr_failure_step(sim, &end, 0.5, &err);
            has_no_such_word(err.message);
        }
    ovr_simulation_free(sim);
}

/* Strategies are counted if there were several. */
TEST(one_strategy_is_not_counted)
{
    ovr_error err = {0};
    ovr_options o = test_options();
    o.level = 6;
    ovr_simulation *sim = test_simulation(20, 10, &o);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    ovr_outcome end = {.defect = {1e-3, 1e-3, 0.1}, .cycles = 50};
    ovr_failure_steady(sim, &end, 1e-5, &err);
    CHECK_ERROR(&err, OVR_NOT_CONVERGED, "did not converge: relative mass");
    end.retries = 1;
    ovr_failure_steady(sim, &end, 1e-5, &err);
    CHECK_ERROR(&err, OVR_NOT_CONVERGED,
                "did not converge with any of 2 strategies: relative mass");
    ovr_simulation_free(sim);
}

static void flat(void *data, double T, size_t n, const double *X, double *S)
{
    (void)data, (void)T, (void)X;
    for (size_t i = 0; i < n; i++)
        S[i] = 0;
}

/* Lower features are suggested if there are features, shear thinning if the
 * lubricant is Newtonian. */
TEST(remedies_suit_the_contact)
{
    for (int features = 0; features < 2; features++)
        for (int thins = 0; thins < 2; thins++) {
            ovr_error err = {0};
            ovr_options o = test_options();
            o.level = 5;
            test_contact t = test_contact_make(20, 10);
            if (thins) {
                t.lubricant.rheology = OVR_EYRING;
                t.lubricant.Sigma0 = 0.5;
            }
            ovr_simulation *sim = ovr_simulation_create(
                &t.contact, &t.lubricant, &o, NULL, &err);
            assert_non_null(sim);
            if (features)
                ovr_simulation_surface(sim, flat, NULL);
            CHECK_OK(ovr_simulation_steady(sim, &err), &err);
            ovr_outcome end = {.defect = {1e-3, 1e-3, 0.1}, .cycles = 50};
            ovr_failure_step(sim, &end, 0.5, &err);
            assert_int_equal(strstr(err.message, "lower features") != NULL,
                             features);
            assert_int_equal(strstr(err.message, "shear thinning") != NULL,
                             !thins);
            const char *last = strrchr(err.message, ';');
            assert_non_null(last);
            assert_non_null(strstr(last, "a finer domain.level"));
            assert_non_null(strstr(last, " may help"));
            assert_int_equal(strstr(last, ", ") != NULL, features && !thins);
            assert_int_equal(strstr(last, " or ") != NULL, features || !thins);
            ovr_simulation_free(sim);
        }
}

/* A plateau a thousand times as high as the film appears after T = 0. */
static void plateau(void *data, double T, size_t n, const double *X, double *S)
{
    (void)data;
    for (size_t i = 0; i < n; i++)
        S[i] = T > 0 && X[i] > -0.5 && X[i] < 0.5 ? 100 : 0;
}

/* A step ends by its work, which is counted: the same message twice, as many
 * cycles as the limit allows, and the state of before. */
TEST(a_step_that_has_no_solution_ends_by_its_work)
{
    const double most = 60;
    char first[sizeof((ovr_error){0}.message)] = "";
    for (int k = 0; k < 2; k++) {
        ovr_error err = {0};
        ovr_options o = test_options();
        o.level = 6;
        ovr_simulation *sim = test_simulation(20, 10, &o);
        ovr_simulation_surface(sim, plateau, NULL);
        CHECK_OK(ovr_simulation_steady(sim, &err), &err);
        sim->limits.step_work = most * (double)sim->now.n;
        assert_int_equal(ovr_simulation_step(sim, 0.01, &err),
                         OVR_NOT_CONVERGED);
        print_message("    %s\n", err.message);
        assert_non_null(
            strstr(err.message, "within 20 times the predicted work"));
        if (k)
            assert_string_equal(err.message, first);
        strcpy(first, err.message);
        assert_true(ovr_simulation_state(sim)->T == 0);
        ovr_simulation_free(sim);
    }
}
