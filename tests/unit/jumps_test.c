/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Load jumps with mass-conserving cavitation are solved by continuation
 * (simulation/continuation.c). */
#include "../support/jumps.h"

#include <stdio.h>

#include "../support/mixed.h"
#include "../support/random_case.h"
#include "../support/test.h"
#include "overroll/run.h"

/* 200 in make verify.  Without a continuation four of the first twenty fail. */
TEST(random_jumps_go_through)
{
    test_jumps_survey(25165, test_draws(20, 200));
}

static ovr_status run_with(const char *text, double M, ovr_error *err)
{
    char number[40];
    ovr_run_options how = {0};
    ovr_case *c = ovr_case_read_text(text, "case", NULL, NULL, err);
    assert_non_null(c);
    snprintf(number, sizeof number, "%.17g", M);
    CHECK_OK(ovr_case_set(c, "contact.M", number, "test", err), err);
    ovr_run *run = ovr_run_create(c, &how, NULL, err);
    assert_non_null(run);
    ovr_status status = ovr_run_execute(run, err);
    ovr_run_free(run);
    ovr_case_free(c);
    return status;
}

/* A jump of load by a quarter, then one of speed, in a rough, hot, shear
 * thinning film: what is found does not hang on the last digits of the case. */
TEST(little_changes_change_little)
{
    static test_random_case d;
    test_write_points("thinning.csv");
    test_mixed_case(&d, 22068, 6);
    for (int k = -3; k <= 3; k++) {
        ovr_error err = {0};
        CHECK_OK(run_with(d.text, 176.339 * (1 + 1e-6 * k), &err), &err);
    }
}
