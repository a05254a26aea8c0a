/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Accuracy per second of runs in time: the error of H_cen(T), rms over the run
 * relative to the film, against CPU seconds on each level, by what is taken
 * where nothing is written and as version 0.1.0 did it (second order,
 * upstream2).  The truth is the former on a finer level.
 */
#include <math.h>
#include <stdio.h>

#include "bench.h"
#include "support/series.h"

enum { LEVELS = 4, WAYS = 2 };

typedef struct question {
    const char *name;
    const char *text; /* of the case, without domain.level */
    int first, truth; /* levels */
} question;

#define CONTACT(slip) "[contact]\nM = 20\nL = 10\nslide_to_roll = " slip "\n"
#define DENT(width, start, end)                                                \
    "[feature d]\nshape = dent\ndepth = 0.1\nwidth = " width                   \
    "\nstart = " start "\n[time]\nend = " end "\n"

/* M = 20, L = 10; the ground surface in the contact of profiles/ground.ini,
 * M = 41, L = 12, at a slide-to-roll ratio of 0.15. */
static const question questions[] = {
    {"rolling dent, 0.5 b", CONTACT("0") DENT("0.5", "-4.6", "6"), 6, 11},
    {"rolling dent, 0.05 b", CONTACT("0") DENT("0.05", "-1.6", "3"), 7, 12},
    {"sliding dent, 0.05 b", CONTACT("-1") DENT("0.05", "-1.6", "6"), 7, 11},
    {"rolling waves, 0.25 b",
     CONTACT("0") "[feature w]\nshape = wave\namplitude = 0.02\n"
                  "wavelength = 0.25\norigin = 0\ngrow = 1\n"
                  "[time]\nend = 3\n",
     6, 11},
    {"ground surface",
     "[contact]\nload = 3.07e5 N/m\nradius = 10 mm\nmodulus = 226 GPa\n"
     "viscosity = 40 mPa.s\nspeed_1 = 1.4 m/s\nspeed_2 = 1.2 m/s\n"
     "[lubricant]\nalpha = 17 1/GPa\n"
     "[feature g]\nshape = profile\nfile = ground.csv\nlevel = line\n"
     "lambda_c = 250 um\nextend = periodic\ntaper = 60 um\nstart = -4.02\n"
     "[time]\nend = 4\n",
     7, 11}};

static const struct way {
    const char *name, *text;
} ways[WAYS] = {{"0.1.0's way", "scheme = upstream2\n[domain]\norder = 2\n"},
                {"default", ""}};

typedef struct cost {
    double error, seconds;
} cost;

static void solve(const question *q, const struct way *w, int level,
                  test_series *s)
{
    char text[1500];
    snprintf(text, sizeof text,
             "%s%s[domain]\ninlet = -4\noutlet = 1.5\nlevel = %d\n", q->text,
             w->text, level);
    test_series_run(text, "profiles", s);
}

/* At an error, on the line in logarithms through the levels about it; beyond
 * them on that through the last two. */
static double seconds_at(double error, const cost of[LEVELS])
{
    int k = 0;
    while (k + 2 < LEVELS && of[k + 1].error > error)
        k++;
    double slope = log(of[k + 1].seconds / of[k].seconds) /
                   log(of[k + 1].error / of[k].error);
    return of[k].seconds * pow(error / of[k].error, slope);
}

static void record(const question *q, const struct way *w, int level, cost c)
{
    bench_row();
    bench_text("case", q->name);
    bench_text("way", w->name);
    bench_number("level", level);
    bench_number("rms_error", c.error);
    bench_number("seconds", c.seconds);
    bench_end();
}

static void answer(const question *q)
{
    static test_series truth, s; /* large */
    cost all[WAYS][LEVELS];
    solve(q, &ways[1], q->truth, &truth);
    for (int w = 0; w < WAYS; w++) {
        printf("%-22s %-12s", q->name, ways[w].name);
        for (int l = 0; l < LEVELS; l++) {
            solve(q, &ways[w], q->first + l, &s);
            cost c = {test_series_error(&s, &truth), s.seconds};
            all[w][l] = c;
            printf(" | %d: %7.1e %6.2f s", q->first + l, c.error, c.seconds);
            fflush(stdout);
            record(q, &ways[w], q->first + l, c);
        }
        printf("\n");
    }
    double error = all[0][LEVELS - 1].error, now = seconds_at(error, all[1]);
    printf("  an error of %.1e: %.3g s, %.3g times quicker\n", error, now,
           all[0][LEVELS - 1].seconds / now);
}

int main(int argc, char *argv[])
{
    bench_open(argc, argv);
    printf("\ndT = D: rms error of H_cen and CPU seconds on "
           "levels\n");
    bench_list("accuracy");
    for (size_t k = 0; k < sizeof questions / sizeof *questions; k++)
        answer(&questions[k]);
    bench_end();
    bench_close();
    return 0;
}
