/* SPDX-License-Identifier: GPL-3.0-or-later */
/* find and --sensitivity with artificial runs: closed forms, solutions of
 * different order, failures, interruption. */
#include "support/test.h"

#include <math.h>
#include <string.h>

#include "overroll/overroll.h"

typedef struct made_up {
    double (*of)(double M, double L);
    double odd; /* the M whose automatic order is 2 */
    long runs, stop_after;
    char said[400];
} made_up;

static double number_of(const ovr_case *c, const char *key, const char **text)
{
    for (size_t k = 0; k < ovr_case_entries(c); k++) {
        ovr_case_entry e = ovr_case_entry_at(c, k);
        if (strcmp(e.key, key) != 0 || strcmp(e.section, "feature") == 0)
            continue;
        if (text)
            *text = e.text;
        return e.number;
    }
    fail();
    return NAN;
}

/* By order 4 a tenth more than by order 2. */
static ovr_status run(void *data, ovr_trials *trials, ovr_error *err)
{
    made_up *u = data;
    for (size_t k = 0; ovr_trials_case(trials, k); k++) {
        const ovr_case *c = ovr_trials_case(trials, k);
        const char *asked = NULL;
        double M = number_of(c, "M", NULL), L = number_of(c, "L", NULL), q;
        bool second;
        number_of(c, "order", &asked);
        second = (asked && strcmp(asked, "2") == 0) || fabs(M - u->odd) < 0.3;
        if (u->stop_after && u->runs == u->stop_after)
            return ovr_fail(err, OVR_STOPPED, "enough");
        u->runs++;
        q = u->of(M, L) * (second ? 1 : 1.1);
        if (isnan(q)) {
            ovr_trials_fail(trials, k, "no film at all");
            continue;
        }
        ovr_trials_put(trials, k, "converged", 1);
        ovr_trials_put(trials, k, "order", second ? 2 : 4);
        ovr_trials_put(trials, k, "H_cen", q);
        ovr_trials_put(trials, k, "H_cen_error_relative", 0.02);
    }
    return OVR_OK;
}

static void say(void *data, ovr_message_kind kind, const char *text)
{
    made_up *u = data;
    (void)kind;
    strncat(u->said, text, sizeof u->said - strlen(u->said) - 1);
}

static ovr_case *some_case(void)
{
    ovr_error err = {0};
    ovr_case *c = ovr_case_read_text("[contact]\nM = 20\nL = 10\n", "case",
                                     NULL, NULL, &err);
    assert_non_null(c);
    return c;
}

static ovr_find *ask(made_up *u, const char *condition, const char *which)
{
    ovr_case *c = some_case();
    ovr_find_options how = {0};
    ovr_error err = {0};
    how.key = "contact.M";
    how.low = "4", how.high = "100";
    how.condition = condition;
    how.which = which;
    how.data = u;
    how.run = run;
    how.say = say;
    ovr_find *find = ovr_find_create(c, &how, &err);
    CHECK_OK(err.status, &err);
    assert_non_null(find);
    ovr_case_free(c);
    return find;
}

static double power(double M, double L)
{
    return pow(M, -1.5) * pow(L, 0.5);
}

/* One solution of order 2 among those of order 4: all again with order 2, so
 * that the answer is of one function. */
TEST(orders_are_not_mixed)
{
    made_up u = {.of = power, .odd = 20};
    ovr_find *find = ask(&u, "H_cen is 0.03", NULL);
    const ovr_find_info *i = ovr_find_get_info(find);
    ovr_error err = {0};
    double exact = pow(0.03 / sqrt(10), -1 / 1.5);
    CHECK_OK(ovr_find_execute(find, &err), &err);
    assert_true(i->pinned);
    assert_non_null(strstr(u.said, "order = 2"));
    CHECK_CLOSE(i->value, exact, 1e-3);
    CHECK_CLOSE(i->at_value, power(i->value, 10), 1e-14);
    CHECK_CLOSE(i->slope, -1.5 * i->at_value / i->value, 1e-2);
    for (size_t k = 0; k < i->evaluations; k++)
        assert_int_equal(ovr_find_evaluation_at(find, k).order, 2);
    /* 2 % of the quantity are 2/1.5 % of the key */
    CHECK_CLOSE(i->error, 0.02 / 1.5 * i->value, 2e-2);
    ovr_find_free(find);

    u = (made_up){.of = power, .odd = -1};
    find = ask(&u, "H_cen is 0.03", NULL);
    i = ovr_find_get_info(find);
    CHECK_OK(ovr_find_execute(find, &err), &err);
    assert_false(i->pinned);
    CHECK_CLOSE(i->value, exact * pow(1.1, 1 / 1.5), 1e-3);
    ovr_find_free(find);
}

static double thin(double M, double L)
{
    return M > 50 ? NAN : power(M, L);
}

static double nothing(double M, double L)
{
    return NAN * M * L;
}

TEST(failures)
{
    made_up u = {.of = thin, .odd = -1};
    ovr_find *find = ask(&u, "H_cen at least 0.03", "largest");
    ovr_error err = {0};
    CHECK_OK(ovr_find_execute(find, &err), &err);
    assert_non_null(strstr(ovr_find_get_info(find)->message, "no film at all"));
    assert_true(ovr_find_get_info(find)->at_value >= 0.03);
    ovr_find_free(find);

    u.of = nothing;
    find = ask(&u, "H_cen is 0.03", NULL);
    CHECK_STATUS(ovr_find_execute(find, &err), OVR_NOT_CONVERGED, &err);
    CHECK_ERROR(&err, OVR_NOT_CONVERGED, "all runs failed: no film at all");
    assert_int_equal(ovr_find_get_info(find)->end, OVR_FIND_FAILED);
    ovr_find_free(find);
}

TEST(stopped)
{
    made_up u = {.of = power, .odd = -1, .stop_after = 7};
    ovr_find *find = ask(&u, "H_cen is 0.03", NULL);
    ovr_error err = {0};
    CHECK_STATUS(ovr_find_execute(find, &err), OVR_STOPPED, &err);
    assert_int_equal(ovr_find_get_info(find)->evaluations, 7);
    ovr_find_free(find);
}

/* Powers are found to rounding; orders are not mixed here either. */
TEST(elasticities)
{
    made_up u = {.of = power, .odd = 20};
    ovr_case *c = some_case();
    ovr_sensitivity_options how = {0};
    ovr_error err = {0};
    how.data = &u;
    how.run = run;
    how.say = say;
    for (int mixed = 0; mixed < 2; mixed++) {
        u.odd = mixed ? 20.4 : -1; /* within 0.3 of the steps upwards alone */
        ovr_sensitivity *found = ovr_sensitivity_create(c, &how, &err);
        CHECK_OK(err.status, &err);
        const ovr_sensitivity_row *M = ovr_sensitivity_at(found, 0);
        const ovr_sensitivity_row *L = ovr_sensitivity_at(found, 1);
        assert_string_equal(M->key, "contact.M");
        CHECK_CLOSE(M->slope, -1.5, 1e-9);
        CHECK_CLOSE(L->slope, 0.5, 1e-9);
        assert_true(M->doubt >= 0 && M->doubt < 1e-9 && !M->why_none);
        assert_null(ovr_sensitivity_at(found, 2));
        ovr_sensitivity_free(found);
    }
    assert_non_null(strstr(u.said, "order = 2"));
    ovr_case_free(c);
}
