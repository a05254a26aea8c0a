/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Calls of the library with missing structs, and calls from within callbacks.
 */
#include "overroll/overroll.h"
#include "support/test.h"

static ovr_simulation *simulation(const ovr_options *options, ovr_error *err)
{
    ovr_conditions given = ovr_conditions_default();
    ovr_contact contact;
    ovr_lubricant oil;
    given.M = 20, given.L = 10, given.alpha = 17e-9;
    assert_int_equal(ovr_contact_resolve(&given, &contact, err), OVR_OK);
    assert_int_equal(ovr_lubricant_make(&contact, OVR_ROELANDS,
                                        OVR_DOWSON_HIGGINSON, 198e6, 0.68, &oil,
                                        err),
                     OVR_OK);
    return ovr_simulation_create(&contact, &oil, options, NULL, err);
}

TEST(test_structs_that_are_not_given)
{
    ovr_conditions given = ovr_conditions_default();
    ovr_contact contact;
    ovr_error err = {0};
    assert_null(simulation(NULL, &err));
    CHECK_ERROR(&err, OVR_BAD_INPUT, "no ovr_options is given");
    ovr_contact_resolve(NULL, &contact, &err);
    CHECK_ERROR(&err, OVR_BAD_INPUT, "no ovr_conditions is given");
    ovr_contact_resolve(&given, NULL, &err);
    CHECK_ERROR(&err, OVR_BAD_INPUT, "no ovr_contact to fill is given");
}

/* ----------------------------------------------------- calls within calls */

typedef struct within {
    ovr_run *run;
    ovr_simulation *sim;
    int refused;
} within;

static ovr_status run_again(void *data, const ovr_simulation *sim,
                            ovr_error *err)
{
    within *w = data;
    ovr_error own = {0};
    (void)sim;
    (void)err;
    assert_int_equal(ovr_run_execute(w->run, &own), OVR_BAD_INPUT);
    CHECK_ERROR(&own, OVR_BAD_INPUT, "has started");
    w->refused++;
    return OVR_OK;
}

TEST(test_run_within_its_observer)
{
    within w = {0};
    ovr_error err = {0};
    ovr_run_options how = {0};
    ovr_case *c = ovr_case_read_text(
        "[contact]\nM = 20\nL = 10\n[domain]\nlevel = 4\n"
        "[time]\nend = 0.1\n",
        "case", NULL, NULL, &err);
    how.data = &w;
    how.observe = run_again;
    w.run = ovr_run_create(c, &how, NULL, &err);
    assert_non_null(w.run);
    CHECK_OK(ovr_run_execute(w.run, &err), &err);
    assert_true(w.refused > 2);
    assert_int_equal(ovr_run_execute(w.run, &err), OVR_BAD_INPUT);
    ovr_run_free(w.run);
    ovr_case_free(c);
}

static ovr_status step_again(void *data, const ovr_simulation *sim,
                             ovr_error *err)
{
    within *w = data;
    ovr_march march = {0};
    bool more;
    (void)sim;
    (void)err;
    march.end = 1;
    assert_int_equal(ovr_simulation_steady(w->sim, NULL), OVR_BAD_INPUT);
    assert_int_equal(ovr_simulation_step(w->sim, 0.01, NULL), OVR_BAD_INPUT);
    assert_int_equal(ovr_simulation_march(w->sim, &march, NULL), OVR_BAD_INPUT);
    assert_int_equal(ovr_simulation_advance(w->sim, &march, &more, NULL),
                     OVR_BAD_INPUT);
    w->refused++;
    return OVR_OK;
}

TEST(test_simulation_within_its_observer)
{
    within w = {0};
    ovr_error err = {0};
    ovr_options options = ovr_options_default();
    ovr_observer look = {step_again, NULL, &w};
    ovr_march march = {0};
    options.level = 4;
    w.sim = simulation(&options, &err);
    assert_non_null(w.sim);
    CHECK_OK(ovr_simulation_steady(w.sim, &err), &err);
    march.end = 0.1;
    march.count = 1;
    march.observers = &look;
    CHECK_OK(ovr_simulation_march(w.sim, &march, &err), &err);
    assert_true(w.refused > 2);
    ovr_simulation_free(w.sim);
}
