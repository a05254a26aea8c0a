/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "series.h"

#include <math.h>
#include <time.h>

#include "overroll/case.h"
#include "overroll/simulation.h"
#include "test.h"

static double cpu_seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static ovr_status look(void *data, const ovr_simulation *sim, ovr_error *err)
{
    const ovr_observation *o = ovr_simulation_observation(sim);
    test_series *s = data;
    (void)err;
    assert_true(s->n < TEST_SERIES);
    s->T[s->n] = o->T;
    s->H[s->n++] = o->H_cen;
    return OVR_OK;
}

void test_series_run(const char *text, const char *directory, test_series *s)
{
    ovr_error err = {0};
    ovr_case *c = ovr_case_read_text(text, "case", directory, NULL, &err);
    ovr_setup *setup = c ? ovr_case_resolve(c, NULL, &err) : NULL;
    CHECK_OK(setup ? OVR_OK : OVR_BAD_INPUT, &err);
    ovr_simulation *sim = ovr_setup_simulation(setup, NULL, &err);
    CHECK_OK(sim ? OVR_OK : OVR_BAD_INPUT, &err);
    ovr_observer observer = {look, NULL, s};
    ovr_march march = *setup->march;
    march.count = 1;
    march.observers = &observer;
    s->n = 0;
    double start = cpu_seconds();
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    CHECK_OK(ovr_simulation_march(sim, &march, &err), &err);
    s->seconds = cpu_seconds() - start;
    s->cycles = ovr_simulation_statistics(sim)->cycles;
    ovr_simulation_free(sim);
    ovr_setup_free(setup);
    ovr_case_free(c);
}

double test_series_error(const test_series *s, const test_series *better)
{
    double sum = 0, length = 0;
    size_t j = 0;
    for (size_t i = 1; i < s->n; i++) {
        while (j + 2 < better->n && better->T[j + 1] < s->T[i])
            j++;
        double part = (s->T[i] - better->T[j]) /
                      (better->T[j + 1] - better->T[j]);
        double H = better->H[j] + part * (better->H[j + 1] - better->H[j]);
        double e = s->H[i] / H - 1, dT = s->T[i] - s->T[i - 1];
        sum += dT * e * e;
        length += dT;
    }
    return sqrt(sum / length);
}
