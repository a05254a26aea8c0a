/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Accuracy of transient runs against CPU time, on each level: root mean square
 * error of H_cen(T) over the run, relative to the film thickness. Three
 * settings are compared: the defaults, steps of D, and the previous version.
 * The previous version is an older program if BEFORE=PATH names one (its files
 * and start-up are included). Otherwise it is this program with the settings of
 * version 0.1.0 (second order, upstream2, arithmetic means, steps of D), which
 * has the same errors but needs fewer cycles. The reference is the default on a
 * finer level, in steps of D. */
#define _DEFAULT_SOURCE /* wait4 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "bench.h"
#include "overroll/results.h"
#include "support/series.h"
#include "support/test.h"

enum { LEVELS = 4, WAYS = 3 };

typedef struct question {
    const char *name;
    const char *text; /* case without domain.level */
    int first, truth; /* coarsest level; level of the reference */
} question;

#define CONTACT(slip) "[contact]\nM = 20\nL = 10\nslide_to_roll = " slip "\n"
#define DENT(width, start, end)                                                \
    "[feature d]\nshape = dent\ndepth = 0.1\nwidth = " width                   \
    "\nstart = " start "\n[time]\nend = " end "\n"

#define HOT                                                                    \
    "[lubricant]\nviscosity = 40 mPa.s\nalpha = 17 1/GPa\np0 = 198 MPa\n"      \
    "z = 0.68\nrheology = eyring\neyring_stress = 5 MPa\n"
/* Contact of two gear teeth with increasing load. */
#define GEAR                                                                   \
    "[contact]\nload = 250 N/mm\nradius = 12 mm\nmodulus = 226 GPa\n"          \
    "mean_speed = 6 m/s\nslide_to_roll = 0.3\n[lubricant]\n"                   \
    "viscosity = 40 mPa.s\nalpha = 17 1/GPa\np0 = 198 MPa\nz = 0.68\n"         \
    "[load]\nhistory = ramp\nfrom = 0.5\nto = 1\nduration = 3\n"               \
    "[feature g]\nshape = roughness\nRq = 0.03 um\nlength = 4\n"               \
    "shortest = 0.25\nseed = 1\nstart = -12\n[time]\nend = 17\n"

/* M = 20, L = 10. The ground surface is in the contact of profiles/ground.ini,
 * M = 41, L = 12, with a slide-to-roll ratio of 0.15. */
static const question questions[] = {
    {"rolling dent, 0.5 b", CONTACT("0") DENT("0.5", "-4.6", "6"), 6, 11},
    {"rolling dent, 0.05 b", CONTACT("0") DENT("0.05", "-1.6", "3"), 7, 12},
    {"sliding dent, 0.05 b", CONTACT("-1") DENT("0.05", "-1.6", "6"), 7, 11},
    {"rolling waves, 0.25 b",
     CONTACT("0") "[feature w]\nshape = wave\namplitude = 0.02\n"
                  "wavelength = 0.25\norigin = 0\ngrow = 1\n"
                  "[time]\nend = 3\n",
     6, 10},
    {"ground surface",
     "[contact]\nload = 3.07e5 N/m\nradius = 10 mm\nmodulus = 226 GPa\n"
     "viscosity = 40 mPa.s\nspeed_1 = 1.4 m/s\nspeed_2 = 1.2 m/s\n"
     "[lubricant]\nalpha = 17 1/GPa\n"
     "[feature g]\nshape = profile\nfile = ground.csv\nlevel = line\n"
     "lambda_c = 250 um\nextend = periodic\ntaper = 60 um\nstart = -4.02\n"
     "[time]\nend = 4\n",
     7, 11},
    {"ramp of load, dent",
     CONTACT("0") "[load]\nhistory = ramp\nfrom = 1\nto = 1.5\nstart = 1\n"
                  "duration = 3\n" DENT("0.5", "-4.6", "7"),
     6, 10},
    {"starved dent, 0.5 b",
     CONTACT("0") "[cavitation]\nmodel = conserving\n[supply]\nmodel = film\n"
                  "thickness_1 = 0.0252\n"
                  "thickness_2 = 0.0252\n" DENT("0.5", "-4.6", "7"),
     6, 10},
    {"hot Eyring dent",
     "[contact]\nload = 300 kN/m\nradius = 8 mm\nmodulus = 226 GPa\n"
     "speed_1 = 3.3 m/s\nspeed_2 = 2.7 m/s\n" HOT
     "[heat]\nmodel = lobatto\ntemperature = 80 degC\n"
     "[feature d]\nshape = dent\ndepth = 0.4 um\nwidth = 0.5\n"
     "start = -4.6\n[time]\nend = 7\n",
     5, 9},
    {"ground gear tooth", GEAR, 5, 9}};

typedef enum way { BEFORE, DEFAULT, ONE_MESH } way;
static const char *const names[WAYS] = {"before", "default", "dT = D"};

typedef struct cost {
    double error, seconds;
} cost;

static const char *before(void)
{
    return getenv("BEFORE");
}

/* Writes a case with the settings of one of the three ways. */
static void write_case(const question *q, way w, int level, char *text,
                       size_t capacity)
{
    int n = snprintf(text, capacity,
                     "%s[domain]\ninlet = -4\noutlet = 1.5\nlevel = %d\n",
                     q->text, level);
    char *rest = text + n;
    capacity -= (size_t)n;
    if (w == ONE_MESH)
        snprintf(rest, capacity, "[time]\nstep = grid\n");
    else if (w == BEFORE && !before())
        snprintf(rest, capacity,
                 "order = 2\nfaces = arithmetic\n"
                 "[time]\nstep = grid\nscheme = upstream2\n");
}

static void write_text(const char *path, const char *text)
{
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fputs(text, file);
    assert_int_equal(fclose(file), 0);
}

/* Reads the central film thickness of a result file. */
static void read_series(const char *path, test_series *s)
{
    ovr_error err = {0};
    ovr_result *result = ovr_result_open(path, NULL, &err);
    CHECK_OK(result ? OVR_OK : OVR_BAD_INPUT, &err);
    s->n = ovr_result_get_info(result)->steps;
    assert_true(s->n <= TEST_SERIES);
    CHECK_OK(ovr_result_history(result, "time", OVR_HERTZIAN, s->T, &err),
             &err);
    CHECK_OK(ovr_result_history(result, "central_film_thickness", OVR_HERTZIAN,
                                s->H, &err),
             &err);
    ovr_result_close(result);
}

/* Links the profile that the case names into the folder. */
static void link_profile(const char *folder, char *path, size_t capacity)
{
    char here[400], target[450];
    assert_non_null(getcwd(here, sizeof here));
    snprintf(target, sizeof target, "%s/profiles/ground.csv", here);
    snprintf(path, capacity, "%s/ground.csv", folder);
    assert_int_equal(symlink(target, path), 0);
}

/* Runs a case with the older program. */
static void run_before(const char *text, test_series *s)
{
    char folder[] = "/tmp/overroll-bench-XXXXXX", input[64], output[64];
    char profile[64];
    struct rusage used;
    int status;
    assert_non_null(mkdtemp(folder));
    snprintf(input, sizeof input, "%s/case.ini", folder);
    snprintf(output, sizeof output, "%s/case.h5", folder);
    write_text(input, text);
    link_profile(folder, profile, sizeof profile);
    pid_t child = fork();
    assert_true(child >= 0);
    if (child == 0) {
        execl(before(), before(), "run", input, "-o", output, "-q",
              (char *)NULL);
        _exit(127);
    }
    assert_true(wait4(child, &status, 0, &used) == child && status == 0);
    s->seconds = (double)used.ru_utime.tv_sec + (double)used.ru_stime.tv_sec +
                 1e-6 * (double)(used.ru_utime.tv_usec + used.ru_stime.tv_usec);
    read_series(output, s);
    assert_true(!unlink(input) && !unlink(output) && !unlink(profile));
    strcat(output, ".restart");
    unlink(output);
    assert_int_equal(rmdir(folder), 0);
}

static void solve(const question *q, way w, int level, test_series *s)
{
    char text[1500];
    write_case(q, w, level, text, sizeof text);
    if (w == BEFORE && before())
        run_before(text, s);
    else
        test_series_run(text, "profiles", s);
}

/* Interpolates the time for an error, linearly in logarithms, or extrapolates
 * it from the last two levels. */
static double seconds_at(double error, const cost of[LEVELS])
{
    int k = 0;
    while (k + 2 < LEVELS && of[k + 1].error > error)
        k++;
    double slope = log(of[k + 1].seconds / of[k].seconds) /
                   log(of[k + 1].error / of[k].error);
    return of[k].seconds * pow(error / of[k].error, slope);
}

static void record(const question *q, way w, int level, cost c)
{
    bench_row();
    bench_text("case", q->name);
    bench_text("way", names[w]);
    bench_number("level", level);
    bench_number("rms_error", c.error);
    bench_number("seconds", c.seconds);
    bench_end();
}

/* Prints the time for an error of the previous version, then and now. */
static void compare(cost was, cost all[WAYS][LEVELS])
{
    double now = fmin(seconds_at(was.error, all[DEFAULT]),
                      seconds_at(was.error, all[ONE_MESH]));
    printf("  an error of %.1e: %.3g s instead of %.3g, %.3g times quicker\n",
           was.error, now, was.seconds, was.seconds / now);
}

static void compare_ways(const question *q)
{
    static test_series truth, s; /* large */
    cost all[WAYS][LEVELS];
    solve(q, ONE_MESH, q->truth, &truth);
    for (int w = 0; w < WAYS; w++) {
        printf("%-22s %-12s", q->name, names[w]);
        for (int l = 0; l < LEVELS; l++) {
            solve(q, (way)w, q->first + l, &s);
            cost c = {test_series_error(&s, &truth), s.seconds};
            all[w][l] = c;
            printf(" | %d: %7.1e %6.2f s", q->first + l, c.error, c.seconds);
            fflush(stdout);
            record(q, (way)w, q->first + l, c);
        }
        printf("\n");
    }
    for (int l = 1; l < LEVELS; l++)
        compare(all[BEFORE][l], all);
}

int main(int argc, char *argv[])
{
    bench_open(argc, argv);
    printf("\nruns in time: rms error of H_cen and CPU seconds on levels; "
           "before is %s\n",
           before() ? before() : "this program with the settings of 0.1.0");
    bench_list("accuracy");
    for (size_t k = 0; k < sizeof questions / sizeof *questions; k++)
        compare_ways(&questions[k]);
    bench_end();
    bench_close();
    return 0;
}
