/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Accuracy per second: the error in H_cen(T) of the reference dent, rms over
 * the run relative to the film, and the time of the run, for each scheme and
 * level.  The truth is the characteristic scheme two levels above the finest
 * of the table.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "bench.h"
#include "simulation/internal.h"
#include "support/test.h"

enum { FIRST = 5, LAST = 8, TRUTH = 10, TIMES = 300 };

typedef struct run {
    ovr_simulation *sim;
    int every; /* steps between the times of level FIRST */
    double H[TIMES];
    int count;
} run;

static ovr_status sample(void *data, const ovr_simulation *sim, ovr_error *err)
{
    run *r = data;
    (void)err;
    if (ovr_simulation_state(sim)->step % r->every == 0 && r->count < TIMES)
        r->H[r->count++] = ovr_simulation_observation(sim)->H_cen;
    return OVR_OK;
}

static void roll(void *data)
{
    run *r = data;
    ovr_error err;
    static bench_dent dent = {-4.6};
    ovr_observer look = {sample, NULL, r};
    ovr_march march = {
        .size = sizeof march, .end = 6, .count = 1, .observers = &look};
    r->count = 0;
    ovr_simulation_surface(r->sim, bench_dent_heights, &dent);
    CHECK_OK(ovr_simulation_steady(r->sim, &err), &err);
    CHECK_OK(ovr_simulation_march(r->sim, &march, &err), &err);
}

static double seconds_of(run *r, int level, ovr_scheme scheme, int rounds)
{
    bench_work work = {roll, r, 0};
    r->sim = bench_contact(level, scheme, OVR_STOP_NEGLIGIBLE);
    r->every = 1 << (level - FIRST);
    bench_measure(1, &work, 0, rounds);
    ovr_simulation_free(r->sim);
    return work.seconds;
}

static double rms(const run *r, const run *truth)
{
    double sum = 0;
    int count = r->count < truth->count ? r->count : truth->count;
    for (int k = 0; k < count; k++)
        sum += pow((r->H[k] - truth->H[k]) / truth->H[0], 2);
    return sqrt(sum / count);
}

enum { LEVELS = LAST - FIRST + 1, SCHEMES = 3 };
static const char *const names[SCHEMES] = {"upstream1", "upstream2",
                                           "characteristic"};

typedef struct cost {
    double error, seconds;
} cost;

static void print_all(cost all[SCHEMES][LEVELS])
{
    printf("\nreference dent to T = 6, dT = D: rms error of H_cen / H_c, and "
           "seconds\n%-15s",
           "scheme");
    for (int l = 0; l < LEVELS; l++)
        printf(" |     level %d     ", FIRST + l);
    printf("\n");
    bench_list("accuracy");
    for (int s = 0; s < SCHEMES; s++) {
        printf("%-15s", names[s]);
        for (int l = 0; l < LEVELS; l++) {
            printf(" | %8.1e %7.3f", all[s][l].error, all[s][l].seconds);
            bench_row();
            bench_text("scheme", names[s]);
            bench_number("level", FIRST + l);
            bench_number("rms_error", all[s][l].error);
            bench_number("seconds", all[s][l].seconds);
            bench_end();
        }
        printf("\n");
    }
    bench_end();
}

/* Which settings to use: the quickest that is good enough. */
static void recommend(cost all[SCHEMES][LEVELS])
{
    static const double wanted[] = {3e-2, 1e-2, 3e-3, 1e-3, 3e-4};
    printf("\nquickest for a wanted error\n");
    bench_list("quickest");
    for (size_t k = 0; k < sizeof wanted / sizeof *wanted; k++) {
        int best = -1, at = 0;
        for (int s = 0; s < SCHEMES; s++)
            for (int l = 0; l < LEVELS; l++)
                if (all[s][l].error <= wanted[k] &&
                    (best < 0 || all[s][l].seconds < all[best][at].seconds)) {
                    best = s;
                    at = l;
                }
        if (best < 0)
            continue;
        printf("%8.0e  %-15s level %d  %.3f s\n", wanted[k], names[best],
               FIRST + at, all[best][at].seconds);
        bench_row();
        bench_number("wanted", wanted[k]);
        bench_text("scheme", names[best]);
        bench_number("level", FIRST + at);
        bench_number("seconds", all[best][at].seconds);
        bench_end();
    }
    bench_end();
}

int main(int argc, char *argv[])
{
    static run truth, r;
    cost all[SCHEMES][LEVELS];
    bench_open(argc, argv);
    seconds_of(&truth, TRUTH, OVR_CHARACTERISTIC, 1);
    for (int s = 0; s < SCHEMES; s++)
        for (int l = 0; l < LEVELS; l++) {
            double seconds = seconds_of(&r, FIRST + l, (ovr_scheme)s, 3);
            all[s][l] = (cost){rms(&r, &truth), seconds};
        }
    print_all(all);
    recommend(all);
    bench_close();
    return 0;
}
