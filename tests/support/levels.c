/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "levels.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "contact/film_formula.h"
#include "overroll/case.h"
#include "overroll/run.h"
#include "test.h"

enum { MOST = 40000 };

typedef struct seen {
    size_t count;
    double T[MOST], H_cen[MOST], H_min;
    int level;
    double mesh;
    bool told; /* that the accuracy was not reached */
} seen;

static seen here, finer; /* large */
static seen *watched;

static ovr_status watch(void *data, const ovr_simulation *sim, ovr_error *err)
{
    const ovr_observation *o = ovr_simulation_observation(sim);
    (void)data;
    (void)err;
    if (watched->count < MOST) {
        watched->T[watched->count] = o->T;
        watched->H_cen[watched->count++] = o->H_cen;
    }
    return OVR_OK;
}

static void hear(void *data, ovr_say kind, const char *text)
{
    (void)data;
    if (kind == OVR_SAY_WARNING && strstr(text, "was chosen for an error"))
        watched->told = true;
}

static void solve(const char *text, const char *level, seen *into)
{
    ovr_error err = {0};
    ovr_case *c = ovr_case_read_text(text, "case", NULL, NULL, &err);
    ovr_run_options how = {0};
    CHECK_OK(c ? ovr_case_set(c, "domain.level", level, "test", &err)
               : OVR_BAD_INPUT,
             &err);
    if (strcmp(level, "auto") != 0) {
        /* On a level that is given nothing is asked for of it. */
        ovr_case_unset(c, "domain.accuracy");
        ovr_case_unset(c, "domain.accuracy_of");
    }
    into->count = 0;
    into->told = false;
    watched = into;
    how.observe = watch;
    how.say = hear;
    ovr_run *run = ovr_run_create(c, &how, NULL, &err);
    CHECK_OK(run ? ovr_run_go(run, &err) : err.status, &err);
    const ovr_run_info *about = ovr_run_about(run);
    into->level = about->setup->options->level;
    into->mesh = about->setup->mesh;
    into->H_min = ovr_simulation_statistics(about->sim)->extreme.H_min_located;
    ovr_run_free(run);
    ovr_case_free(c);
}

static void refine(const char *text)
{
    char level[20];
    solve(text, "auto", &here);
    snprintf(level, sizeof level, "%d", here.level + 2);
    solve(text, level, &finer);
}

/* rms in time: each of our times is among theirs. */
static double error_of_centre(void)
{
    double sum = 0;
    size_t j = 0;
    for (size_t i = 0; i < here.count; i++) {
        while (j + 1 < finer.count && finer.T[j] < here.T[i] - 1e-9)
            j++;
        double e = here.H_cen[i] / finer.H_cen[j] - 1;
        sum += e * e;
    }
    return sqrt(sum / (double)here.count);
}

/* The estimate after the run may be too large: told then is no miss. */
static void judge(uint64_t seed, int k, double target, double error,
                  int *missed)
{
    printf("  %2d: level %d, target %.1e, %.1e%s\n", k, here.level, target,
           error, here.told ? ", told" : "");
    *missed += error > target;
    if (error > target && !here.told)
        fail_msg("seed %llu, case %d: %.2g instead of %.2g",
                 (unsigned long long)seed, k, error, target);
}

void test_levels_steady(uint64_t seed, int cases)
{
    uint64_t state = seed;
    int missed = 0;
    char text[300];
    printf("seed %llu\n", (unsigned long long)seed);
    for (int k = 0; k < cases; k++) {
        double M = 5 * pow(200, test_random(&state, 0, 1));
        double L = test_random(&state, 1, 15);
        double target = pow(10, test_random(&state, -4, -2));
        bool least = test_random(&state, 0, 1) < 0.4;
        if (least)
            target *= 5;
        snprintf(text, sizeof text,
                 "[contact]\nM = %.6g\nL = %.6g\n[domain]\naccuracy = %.3g\n"
                 "accuracy_of = %s\n",
                 M, L, target, least ? "H_min" : "H_cen");
        refine(text);
        judge(seed, k, target,
              least ? fabs(here.H_min / finer.H_min - 1) : error_of_centre(),
              &missed);
    }
    assert_true(10 * missed <= cases);
}

void test_levels_in_time(uint64_t seed, int cases)
{
    uint64_t state = seed;
    int missed = 0;
    char text[400];
    printf("seed %llu\n", (unsigned long long)seed);
    for (int k = 0; k < cases; k++) {
        double M = test_random(&state, 12, 40), L = test_random(&state, 4, 11);
        double size = test_random(&state, 0.2, 0.6);
        double H = ovr_film_central_moes(M, L);
        bool wave = test_random(&state, 0, 1) < 0.4;
        double slip = test_random(&state, 0, 1) < 0.5 ? 0 : -0.8;
        snprintf(text, sizeof text,
                 "[contact]\nM = %.6g\nL = %.6g\nslide_to_roll = %.3g\n"
                 "[domain]\ninlet = -4\naccuracy = 3e-3\n[time]\nend = 4\n"
                 "[feature f]\nsurface = 1\nshape = %s\n%s = %.4g\n"
                 "%s = %.4g\n%s\n",
                 M, L, slip, wave ? "wave" : "dent",
                 wave ? "amplitude" : "depth", 0.3 * H,
                 wave ? "wavelength" : "width", size,
                 wave ? "grow = 1" : "start = -4.6");
        refine(text);
        judge(seed, k, 3e-3, error_of_centre(), &missed);
    }
    assert_true(10 * missed <= cases);
}
