/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "levels.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "contact/film_formula.h"
#include "overroll/case.h"
#include "overroll/run.h"
#include "test.h"

enum { MAX = 40000 };

typedef struct seen {
    size_t count;
    double T[MAX], H_cen[MAX], minimum[MAX], mu[MAX], H_min;
    int level;
    double mesh;
    bool warned; /* of an accuracy that was not reached */
} seen;

static seen here, finer; /* large */
static seen *watched;

static ovr_status watch(void *data, const ovr_simulation *sim, ovr_error *err)
{
    const ovr_observation *o = ovr_simulation_observation(sim);
    (void)data;
    (void)err;
    if (watched->count < MAX) {
        watched->T[watched->count] = o->T;
        watched->H_cen[watched->count] = o->H_cen;
        watched->minimum[watched->count] = o->H_min_located;
        watched->mu[watched->count++] = o->mu_slide;
    }
    return OVR_OK;
}

static void listen(void *data, ovr_message_kind kind, const char *text)
{
    (void)data;
    if (kind == OVR_MESSAGE_WARNING && strstr(text, "was chosen for an error"))
        watched->warned = true;
}

static void solve(const char *text, const char *level, seen *into)
{
    ovr_error err = {0};
    ovr_case *c = ovr_case_read_text(text, "case", NULL, NULL, &err);
    ovr_run_options how = {0};
    CHECK_OK(c ? ovr_case_set(c, "domain.level", level, "test", &err)
               : OVR_BAD_INPUT,
             &err);
    if (strcmp(level, "auto") != 0 && strcmp(level, "usual") != 0) {
        /* With a given level no accuracy may be requested. */
        ovr_case_unset(c, "domain.accuracy");
        ovr_case_unset(c, "domain.accuracy_of");
    }
    into->count = 0;
    into->warned = false;
    watched = into;
    how.observe = watch;
    how.say = listen;
    ovr_run *run = ovr_run_create(c, &how, NULL, &err);
    CHECK_OK(run ? ovr_run_execute(run, &err) : err.status, &err);
    const ovr_run_info *about = ovr_run_get_info(run);
    into->level = about->setup->options->level;
    into->mesh = about->setup->mesh;
    into->H_min = ovr_simulation_statistics(about->sim)->extreme.H_min_located;
    ovr_run_free(run);
    ovr_case_free(c);
}

static void refine(const char *text, const char *chosen)
{
    char level[20];
    solve(text, chosen, &here);
    snprintf(level, sizeof level, "%d", here.level + 2);
    solve(text, level, &finer);
}

/* Returns the rms difference over time relative to the mean. The finer run is
 * interpolated linearly in time. */
static double error_of(const double *ours, const double *theirs)
{
    double sum = 0, mean = 0;
    size_t j = 1;
    for (size_t i = 0; i < here.count; i++) {
        double T = here.T[i], value = theirs[0];
        while (j + 1 < finer.count && finer.T[j] < T)
            j++;
        if (finer.count > 1) {
            double share = (T - finer.T[j - 1]) / (finer.T[j] - finer.T[j - 1]);
            share = fmin(share, 1); /* the last step may be shorter */
            value = theirs[j - 1] + share * (theirs[j] - theirs[j - 1]);
        }
        sum += (ours[i] - value) * (ours[i] - value);
        mean += fabs(value);
    }
    return sqrt(sum * (double)here.count) / mean;
}

static double error_of_centre(void)
{
    return error_of(here.H_cen, finer.H_cen);
}

/* Counts errors above the target. Fails the test if there was no warning; a
 * warning may be unnecessary. */
static void judge(uint64_t seed, int k, double target, double error,
                  int *missed)
{
    printf("  %2d: level %d, target %.1e, %.1e%s\n", k, here.level, target,
           error, here.warned ? ", warning" : "");
    *missed += error > target;
    if (error > target && !here.warned)
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
        bool minimum = test_random(&state, 0, 1) < 0.4;
        if (minimum)
            target *= 5;
        snprintf(text, sizeof text,
                 "[contact]\nM = %.6g\nL = %.6g\n[domain]\naccuracy = %.3g\n"
                 "accuracy_of = %s\n",
                 M, L, target, minimum ? "H_min" : "H_cen");
        refine(text, "auto");
        judge(seed, k, target,
              minimum ? fabs(here.H_min / finer.H_min - 1) : error_of_centre(),
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
                 "[domain]\ninlet = -4\naccuracy = 3e-3\naccuracy_of = H_cen\n"
                 "[time]\nend = 4\n"
                 "[feature f]\nsurface = 1\nshape = %s\n%s = %.4g\n"
                 "%s = %.4g\n%s\n",
                 M, L, slip, wave ? "wave" : "dent",
                 wave ? "amplitude" : "depth", 0.3 * H,
                 wave ? "wavelength" : "width", size,
                 wave ? "grow = 1" : "start = -4.6");
        refine(text, "auto");
        judge(seed, k, 3e-3, error_of_centre(), &missed);
    }
    assert_true(10 * missed <= cases);
}

#define STARVED                                                                \
    "[cavitation]\nmodel = conserving\n[supply]\nmodel = film\n"               \
    "thickness_1 = 0.15 um\nthickness_2 = 0.15 um\n"

void test_levels_usual(uint64_t seed, int cases)
{
    static const char *const kinds[] = {
        "", "[load]\nhistory = ramp\nto = 1.4\nstart = 1\nduration = 2\n",
        STARVED, "[heat]\nmodel = lobatto\ntemperature = 60 degC\n", ""};
    enum { KINDS = sizeof kinds / sizeof *kinds, GROUND = KINDS - 1 };
    uint64_t state = seed;
    int beyond = 0;
    char text[900];
    printf("seed %llu: p_h .6 to 1.3 GPa, um 1 to 5 m/s, slip .05 to .6, dents "
           ".1 to .5 um deep, .4 to .8 b wide, Rq .02 to .06 um\n",
           (unsigned long long)seed);
    for (int k = 0; k < cases; k++) {
        double p_h = test_random(&state, 0.6, 1.3);
        double um = test_random(&state, 1, 5);
        double slip = test_random(&state, 0.05, 0.6);
        double height = test_random(&state, 0, 1);
        double width = test_random(&state, 0.4, 0.8);
        int n = snprintf(
            text, sizeof text,
            "[contact]\nhertz_pressure = %.4g GPa\nradius = 12 mm\n"
            "modulus = 226 GPa\nmean_speed = %.4g m/s\nslide_to_roll = %.3g\n"
            "[lubricant]\nviscosity = 30 mPa.s\nalpha = 18 1/GPa\n"
            "rheology = eyring\neyring_stress = 5 MPa\nlimiting_shear = 0.08\n"
            "[time]\nend = 4\n%s",
            p_h, um, slip, kinds[k % KINDS]);
        if (k % KINDS == GROUND)
            snprintf(text + n, sizeof text - (size_t)n,
                     "[feature g]\nsurface = 1\nshape = roughness\n"
                     "Rq = %.3g um\nlength = 10\nshortest = 0.25\nseed = %d\n"
                     "start = 2\ngrow = 1\n",
                     0.02 + 0.04 * height, k + 1);
        else
            snprintf(text + n, sizeof text - (size_t)n,
                     "[feature d]\nshape = dent\ndepth = %.3g um\n"
                     "width = %.3g\nstart = -3\n",
                     0.1 + 0.4 * height, width);
        refine(text, "usual");
        double H_cen = error_of_centre();
        double H_min = error_of(here.minimum, finer.minimum);
        double mu = error_of(here.mu, finer.mu);
        double maximum = fmax(fmax(H_cen, H_min), mu);
        printf("  %2d: level %d, H_cen %.1e, H_min %.1e, mu %.1e\n", k,
               here.level, H_cen, H_min, mu);
        beyond += maximum > 1e-3;
        if (maximum > 4e-3)
            fail_msg("seed %llu, case %d: %.2g", (unsigned long long)seed, k,
                     maximum);
    }
    assert_true(5 * beyond <= cases);
}

void test_levels_touching(uint64_t seed, int cases)
{
    uint64_t state = seed;
    int beyond = 0;
    char text[700];
    printf("seed %llu: p_h .5 to 1.4 GPa, um .1 to 2 m/s, Rq .05 to .3 um\n",
           (unsigned long long)seed);
    for (int k = 0; k < cases; k++) {
        double p_h = test_random(&state, 0.5, 1.4);
        double um = 0.1 * pow(20, test_random(&state, 0, 1));
        double slip = test_random(&state, 0.05, 0.6);
        double Rq = 0.05 * pow(6, test_random(&state, 0, 1));
        double slope = test_random(&state, 0.02, 0.1);
        snprintf(text, sizeof text,
                 "[contact]\nhertz_pressure = %.4g GPa\nradius = 12 mm\n"
                 "modulus = 226 GPa\nmean_speed = %.4g m/s\n"
                 "slide_to_roll = %.3g\n"
                 "[lubricant]\nviscosity = 30 mPa.s\nalpha = 18 1/GPa\n"
                 "rheology = eyring\neyring_stress = 5 MPa\n"
                 "limiting_shear = 0.08\n"
                 "[boundary]\nlaw = exponential\nRq = %.3g um\n"
                 "slope = %.3g\nfriction = 0.12\n",
                 p_h, um, slip, Rq, slope);
        refine(text, "usual");
        double maximum = fmax(error_of(here.minimum, finer.minimum),
                              error_of(here.mu, finer.mu));
        maximum = fmax(maximum, error_of_centre());
        printf("  %2d: level %d, %.1e\n", k, here.level, maximum);
        beyond += maximum > 1e-3;
        if (maximum > 2e-3)
            fail_msg("seed %llu, case %d: %.2g", (unsigned long long)seed, k,
                     maximum);
    }
    assert_true(5 * beyond <= cases);
}
