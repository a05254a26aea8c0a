/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "support/steady.h"

#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "support/test.h"

void test_contact(double M, double L, ovr_contact *contact,
                  ovr_lubricant *lubricant)
{
    ovr_error err = {0};
    ovr_conditions given = ovr_conditions_unknown();
    given.M = M;
    given.L = L;
    if (L > 0)
        given.alpha = 1.7e-8;
    CHECK_OK(ovr_contact_resolve(&given, contact, &err), &err);
    CHECK_OK(ovr_lubricant_make(contact, OVR_ROELANDS, OVR_DOWSON_HIGGINSON,
                                1.98e8, 0.68, lubricant, &err),
             &err);
}

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

test_solution test_steady(double M, double L, const ovr_options *options)
{
    test_solution s = {0};
    ovr_contact contact;
    ovr_lubricant lubricant;
    ovr_error err = {0};
    ovr_simulation *sim;
    int count;
    test_contact(M, L, &contact, &lubricant);
    sim = ovr_simulation_create(&contact, &lubricant, options, NULL, &err);
    if (!sim) {
        fail_msg("M = %g, L = %g: %s", M, L, err.message);
        return s;
    }
    s.seconds = -now();
    s.status = ovr_simulation_steady(sim, &err);
    s.seconds += now();
    s.o = *ovr_simulation_observation(sim);
    s.options = *ovr_simulation_options(sim);
    const ovr_refinement *r = ovr_simulation_refinements(sim, &count);
    if (count)
        s.finest = r[count - 1];
    memcpy(s.message, err.message, sizeof s.message);
    ovr_simulation_free(sim);
    return s;
}

int test_levels(int unless_told)
{
    const char *told = getenv("OVERROLL_LEVELS");
    return told ? atoi(told) : unless_told;
}
