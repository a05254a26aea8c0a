/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Automatic level for a requested accuracy; more cases in make verify. */
#include <stdio.h>

#include "../support/levels.h"
#include "../support/test.h"
#include "overroll/case.h"

TEST(errors_on_request)
{
    test_levels_steady(1, test_draws(10, 100));
    test_levels_in_time(2, test_draws(1, 12));
}

TEST(usual_levels_do)
{
    test_levels_usual(3, test_draws(5, 60));
    test_levels_touching(5, test_draws(6, 40));
}

static double expected(const char *text, int *level)
{
    ovr_error err = {0};
    ovr_case *c = ovr_case_read_text(text, "test.ini", NULL, NULL, &err);
    ovr_setup *s = c ? ovr_case_resolve(c, NULL, &err) : NULL;
    double error;
    assert_non_null(s);
    CHECK_OK(ovr_setup_prepare(s, NULL, &err), &err);
    *level = s->options->level;
    error = s->expected;
    assert_true(s->nodes == (size_t)(7 << *level) + 1);
    ovr_setup_free(s);
    ovr_case_free(c);
    return error;
}

TEST(narrow_features_need_finer_levels)
{
    const char *dent = "[contact]\nM = 20\nL = 10\n[domain]\nlevel = auto\n"
                       "%s[time]\nend = 1\nscheme = %s\n[feature d]\n"
                       "shape = dent\ndepth = 0.01\nwidth = %s\nstart = -6\n";
    char text[400];
    int wide, narrow, smeared, of_features;
    snprintf(text, sizeof text, dent, "", "characteristic", "0.5");
    assert_true(expected(text, &wide) <= 1e-3);
    snprintf(text, sizeof text, dent, "", "characteristic", "0.02");
    assert_true(expected(text, &narrow) <= 1e-3);
    snprintf(text, sizeof text, dent, "", "upstream2", "0.02");
    assert_true(expected(text, &smeared) <= 1e-3);
    snprintf(text, sizeof text, dent, "accuracy_of = features\n",
             "characteristic", "0.02");
    assert_true(expected(text, &of_features) <= 1e-3);
    assert_true(wide < narrow && narrow < smeared && narrow < of_features);
    snprintf(text, sizeof text, dent, "", "upstream2", "0.0005");
    assert_true(expected(text, &smeared) > 1e-3); /* 14 at most */
    assert_int_equal(smeared, 14);
}

TEST(given_levels_stay)
{
    int level;
    assert_true(expected("[contact]\nM = 800\nL = 14\n[domain]\nlevel = 5\n",
                         &level) > 1e-2);
    assert_int_equal(level, 5);
}
