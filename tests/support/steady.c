/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "support/steady.h"

#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "support/contact.h"
#include "support/test.h"

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

test_solution test_steady(double M, double L, const ovr_options *options)
{
    test_solution s = {0};
    ovr_error err = {0};
    ovr_simulation *sim = test_simulation(M, L, options);
    const ovr_refinement *r;
    int count;
    s.seconds = -now();
    s.status = ovr_simulation_steady(sim, &err);
    s.seconds += now();
    s.o = *ovr_simulation_observation(sim);
    s.options = *ovr_simulation_options(sim);
    r = ovr_simulation_refinements(sim, &count);
    if (count)
        s.finest = r[count - 1];
    memcpy(s.message, err.message, sizeof s.message);
    ovr_simulation_free(sim);
    return s;
}

int test_levels(int default_level)
{
    const char *levels = getenv("OVERROLL_LEVELS");
    return levels ? atoi(levels) : default_level;
}
