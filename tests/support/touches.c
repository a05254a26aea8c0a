/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "touches.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "contact/film_formula.h"
#include "overroll/run.h"
#include "test.h"

typedef struct tally {
    int runs, failed, maximum;
    long cycles;
    double minimum, largest; /* asperity load shares */
} tally;

static double logarithmic(uint64_t *state, double low, double high)
{
    return exp(test_random(state, log(low), log(high)));
}

static void write_case(char *text, size_t size, uint64_t seed)
{
    static const double amplitude[] = {0.3, 1, 3};
    uint64_t state = seed;
    double M = logarithmic(&state, 5, 200), L = test_random(&state, 5, 14);
    double lambda = logarithmic(&state, 0.1, 6);
    double a1 = amplitude[(int)test_random(&state, 0, 2.999)];
    double decay = ovr_film_central_moes(M, L) / lambda / 2.15;
    snprintf(text, size,
             "[contact]\nM = %.6g\nL = %.6g\n[lubricant]\nalpha = 17 1/GPa\n"
             "[domain]\nlevel = %d\n"
             "[boundary]\nlaw = exponential\namplitude = %g\ndecay = %.6g\n",
             M, L, M < 60 ? 5 : 6, a1, decay);
}

/* True if a solution is withheld correctly: the asperity pressure at H = 0 is
 * below 0.9 p_h, and that at H_min exceeds half of it. */
static bool withheld(const ovr_case *c, const ovr_observation *o,
                     const ovr_error *err)
{
    ovr_case_entry e;
    double a1 = 0, decay = 0;
    for (size_t k = 0; k < ovr_case_entries(c); k++) {
        e = ovr_case_entry_at(c, k);
        if (!strcmp(e.key, "amplitude"))
            a1 = strtod(e.text, NULL);
        if (!strcmp(e.key, "decay"))
            decay = strtod(e.text, NULL);
    }
    return err->status == OVR_IMPOSSIBLE && a1 < 0.9 &&
           exp(-o->H_min / decay) > 0.5;
}

static void try(tally *t, uint64_t seed)
{
    enum { SHARE = 0 };
    char text[400];
    ovr_error err = {0};
    write_case(text, sizeof text, seed);
    ovr_case *c = ovr_case_read_text(text, "case", NULL, NULL, &err);
    ovr_run *run = c ? ovr_run_create(c, NULL, NULL, &err) : NULL;
    CHECK_OK(run ? OVR_OK : err.status, &err);
    ovr_run_execute(run, &err);
    const ovr_observation *o = ovr_simulation_observation(
        ovr_run_get_info(run)->sim);
    bool failed = (err.status || !o->converged) && !withheld(c, o, &err);
    t->runs++;
    t->failed += failed;
    t->cycles += o->cycles;
    t->maximum = o->cycles > t->maximum ? o->cycles : t->maximum;
    t->minimum = fmin(t->minimum, o->more[SHARE]);
    t->largest = fmax(t->largest, o->more[SHARE]);
    if (failed)
        print_message("    seed %llu: %s\n%s\n", (unsigned long long)seed,
                      err.message, text);
    else
        CHECK_NEAR(o->load, acos(-1.0) / 2, 1e-9);
    ovr_run_free(run);
    ovr_case_free(c);
}

void test_touches_survey(uint64_t seed, int runs)
{
    enum { ATTEMPT = 60 };
    tally t = {.minimum = 1};
    for (int k = 0; k < runs; k++)
        try(&t, seed + (uint64_t)k);
    print_message("    seeds %llu on: %d runs, %d failed; shares %.5f to %.5f; "
                  "%.1f Newton steps each, %d at most\n",
                  (unsigned long long)seed, t.runs, t.failed, t.minimum,
                  t.largest, (double)t.cycles / t.runs, t.maximum);
    assert_int_equal(t.failed, 0);
    assert_true(2 * t.cycles <= (long)ATTEMPT * t.runs);
}
