/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "sliding.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "overroll/case.h"
#include "overroll/simulation.h"
#include "test.h"

static ovr_statistics counts_of(const char *text)
{
    ovr_error err = {0};
    ovr_case *c = ovr_case_read_text(text, "case", NULL, NULL, &err);
    ovr_setup *setup = c ? ovr_case_resolve(c, NULL, &err) : NULL;
    CHECK_OK(setup ? OVR_OK : OVR_BAD_INPUT, &err);
    ovr_simulation *sim = ovr_setup_simulation(setup, NULL, &err);
    CHECK_OK(sim ? OVR_OK : OVR_BAD_INPUT, &err);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    long start = ovr_simulation_statistics(sim)->cycles;
    CHECK_OK(ovr_simulation_march(sim, setup->march, &err), &err);
    ovr_statistics s = *ovr_simulation_statistics(sim);
    s.cycles -= start;
    ovr_simulation_free(sim);
    ovr_setup_free(setup);
    ovr_case_free(c);
    return s;
}

/* Adds a run; returns true if it has the most cycles per step so far. */
static int count(test_slides *all, const ovr_statistics *s)
{
    double cycles = (double)s->cycles / (double)s->steps;
    int maximum = cycles > all->largest;
    all->runs++;
    all->mean += (cycles - all->mean) / all->runs;
    if (maximum)
        all->largest = cycles;
    all->steps += s->steps;
    all->retries += s->retries;
    return maximum;
}

void test_slides_add(test_slides *all, const test_slide *one)
{
    char text[500];
    double speed = 1 + one->slip / 2, D = 5.5 / (7 << one->level);
    double start = speed > 0 ? -1.3 - one->width : 0;
    double end = speed > 0 ? (1.3 + one->width - start) / speed : 1;
    snprintf(text, sizeof text,
             "[contact]\nM = 20\nL = 10\nslide_to_roll = %g\n"
             "[domain]\ninlet = -4\noutlet = 1.5\nlevel = %d\n"
             "[feature d]\nshape = dent\nsurface = 1\nwidth = %g\n"
             "depth = 0.05\nstart = %g\n"
             "[time]\nscheme = %s\nstep = %.17g\nend = %.6g\n",
             one->slip, one->level, one->width, start, one->scheme,
             one->meshes * D, end);
    ovr_statistics s = counts_of(text);
    if (count(all, &s))
        all->worst = *one;
}

test_slides test_slides_grid(const char *scheme, int level, double meshes,
                             int every)
{
    static const double widths[] = {0.02, 0.05, 0.2, 0.5};
    static const double slips[] = {-2, -1, -0.3, 0, 0.8, 2};
    test_slides all = {0};
    int k = 0;
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 6; j++) {
            const test_slide one = {scheme, level, widths[i], slips[j], meshes};
            if (k++ % every == 0)
                test_slides_add(&all, &one);
        }
    printf("%-14s level %2d, dT = %g D: %4.2f cycles per step, at most %5.2f "
           "(width %g, slip %g); %ld retries in %ld steps\n",
           scheme, level, meshes, all.mean, all.largest, all.worst.width,
           all.worst.slip, all.retries, all.steps);
    fflush(stdout);
    return all;
}

static void put_profile(char *text, size_t bytes, int surface,
                        const char *profile)
{
    size_t used = strlen(text);
    const char *how = strcmp(profile, "scratch")
                          ? "level = line\nlambda_c = 250 um\n"
                            "extend = periodic\ntaper = 60 um\n"
                          : "level = ends\nscale = 0.4\n";
    snprintf(text + used, bytes - used,
             "[feature p%d]\nsurface = %d\nshape = profile\n"
             "file = %s/profiles/%s.csv\nstart = -1.25\n%s",
             surface, surface, getenv("TOP"), profile, how);
}

/* Order 2 for both schemes excludes the cost of fourth-order corrections. */
void test_slides_rough(test_slides *all, const test_rough_slide *one)
{
    char text[2000];
    snprintf(text, sizeof text,
             "[contact]\nload = 3.07e5 N/m\nradius = 10 mm\n"
             "modulus = 226 GPa\nmean_speed = 1.3 m/s\n"
             "slide_to_roll = %g\n"
             "[lubricant]\nviscosity = 40 mPa.s\nalpha = 17 1/GPa\n"
             "z = 0.68\n"
             "[domain]\ninlet = -4\noutlet = 1.5\nlevel = %d\norder = 2\n"
             "[time]\nscheme = %s\nstep = %.17g\nend = %g\n",
             one->slip, one->level, one->scheme,
             one->meshes * 5.5 / (7 << one->level), one->end);
    for (int k = 0; k < 2; k++)
        if (one->profile[k])
            put_profile(text, sizeof text, k + 1, one->profile[k]);
    ovr_statistics s = counts_of(text);
    count(all, &s);
    printf("%s, %s: SRR %g, level %d, dT = %g D, %s: %.2f cycles per step, "
           "%ld retries in %ld steps\n",
           one->profile[0], one->profile[1] ? one->profile[1] : "smooth",
           one->slip, one->level, one->meshes, one->scheme,
           (double)s.cycles / (double)s.steps, s.retries, s.steps);
    fflush(stdout);
}
