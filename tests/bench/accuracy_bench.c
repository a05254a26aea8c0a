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

/* depth 0.1, width 0.5, from X = -4.6, rolling */
static void heights(void *data, double T, size_t n, const double *X, double *S)
{
    (void)data;
    for (size_t i = 0; i < n; i++) {
        double xi = (X[i] + 4.6 - T) / 0.5;
        S[i] = xi * xi > 3 ? 0
                           : -0.1 * exp(-10 * log(10) * xi * xi) *
                                 cos(2 * acos(-1) * xi);
    }
}

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
    ovr_march march = {.end = 6, .observe = sample, .data = r};
    r->count = 0;
    ovr_simulation_surface(r->sim, heights, NULL);
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

int main(int argc, char *argv[])
{
    static const char *const names[] = {"upstream1", "upstream2",
                                        "characteristic"};
    static run truth, r;
    bench_open(argc, argv);
    seconds_of(&truth, TRUTH, OVR_CHARACTERISTIC, 1);
    printf("\nreference dent to T = 6, dT = D: error of H_cen and time\n"
           "%-15s %5s %10s %10s\n",
           "scheme", "level", "rms error", "seconds");
    bench_list("accuracy");
    for (int s = 0; s < 3; s++)
        for (int level = FIRST; level <= LAST; level++) {
            double seconds = seconds_of(&r, level, (ovr_scheme)s, 3);
            double error = rms(&r, &truth);
            printf("%-15s %5d %10.1e %10.3f\n", names[s], level, error,
                   seconds);
            bench_row();
            bench_text("scheme", names[s]);
            bench_number("level", level);
            bench_number("rms_error", error);
            bench_number("seconds", seconds);
            bench_end();
        }
    bench_end();
    bench_close();
    return 0;
}
