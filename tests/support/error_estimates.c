/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "error_estimates.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "overroll/run.h"
#include "random_case.h"
#include "test.h"

typedef struct tally {
    int cases, failed, low, numbers, estimated;
} tally;

/* Runs a case with error estimates or, if T is not NAN, on `level` until T. */
static ovr_run *run_case(const char *text, int level, double T, ovr_error *err)
{
    char set[64];
    ovr_run_options how = {0};
    ovr_case *c = ovr_case_read_text(text, "case", NULL, NULL, err);
    assert_non_null(c);
    how.estimate_error = isnan(T);
    if (!isnan(T)) {
        snprintf(set, sizeof set, "domain.level=%d", level);
        CHECK_OK(ovr_case_assign(c, set, "test", err), err);
        snprintf(set, sizeof set, "time.end=%.17g", T);
        CHECK_OK(ovr_case_assign(c, set, "test", err), err);
    }
    ovr_run *run = ovr_run_create(c, &how, NULL, err);
    if (run)
        ovr_run_execute(run, err);
    ovr_case_free(c);
    return run;
}

static double value_of(const ovr_run *run, const char *key)
{
    const ovr_simulation *sim = ovr_run_get_info(run)->sim;
    const ovr_observation *o = ovr_simulation_observation(sim);
    const ovr_statistics *s = ovr_simulation_statistics(sim);
    const struct {
        const char *key;
        double value;
    } rows[] = {{"H_min", o->H_min_located},
                {"H_cen", o->H_cen},
                {"P_max", o->P_max},
                {"H_min_overall", s->extreme.H_min_located},
                {"P_max_overall", s->extreme.P_max}};
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++)
        if (!strcmp(rows[k].key, key))
            return rows[k].value;
    return NAN;
}

static void compare(tally *t, uint64_t seed, const ovr_run *coarse,
                    const ovr_run *fine)
{
    const ovr_run_errors *e = ovr_run_get_info(coarse)->error;
    int low = 0;
    for (size_t k = 0; k < e->count; k++) {
        const ovr_run_error *of = &e->of[k];
        double actual = fabs(of->value[0] - value_of(fine, of->key));
        if (isnan(actual))
            continue;
        t->numbers++;
        t->estimated += isfinite(of->error);
        if (!(of->error < 0.5 * actual))
            continue;
        low++;
        print_message("    seed %llu: error of %s: estimate %.2g, actual "
                      "%.2g; values %.5g, %.5g, %.5g\n",
                      (unsigned long long)seed, of->key,
                      of->error / fabs(of->value[0]),
                      actual / fabs(of->value[0]), of->value[0], of->value[1],
                      of->value[2]);
    }
    t->low += low > 0;
}

static void run_both(tally *t, uint64_t seed, const char *text, int level,
                     int finer)
{
    ovr_error err = {0};
    ovr_run *coarse = run_case(text, level, NAN, &err), *fine = NULL;
    if (!err.status)
        fine = run_case(text, level + finer,
                        ovr_simulation_state(ovr_run_get_info(coarse)->sim)->T,
                        &err);
    t->cases += !err.status;
    t->failed += err.status != OVR_OK;
    if (!err.status)
        compare(t, seed, coarse, fine);
    ovr_run_free(fine);
    ovr_run_free(coarse);
}

void test_error_estimates_case(const char *text, int level, int finer)
{
    tally t = {0};
    run_both(&t, 0, text, level, finer);
    assert_int_equal(t.cases, 1);
    assert_int_equal(t.low, 0);
}

int test_error_estimates_survey(uint64_t seed, int cases, int level, int finer,
                                int maximum)
{
    static test_random_case d;
    tally t = {0};
    test_write_points("thinning.csv");
    for (uint64_t k = seed; t.cases < cases && t.failed < cases; k++) {
        test_mixed_case(&d, k, level);
        run_both(&t, k, d.text, level, finer);
    }
    print_message("    seeds %llu on: %d cases (%d more failed), %d with an "
                  "estimate below half of the actual error; %d of %d numbers "
                  "have estimates\n",
                  (unsigned long long)seed, t.cases, t.failed, t.low,
                  t.estimated, t.numbers);
    assert_int_equal(t.cases, cases);
    assert_true(t.low <= maximum);
    assert_true(3 * t.estimated >= t.numbers);
    return t.low;
}
