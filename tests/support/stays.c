/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "stays.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "overroll/case.h"
#include "random_case.h"
#include "simulation/simulation.h"
#include "test.h"

typedef struct tally {
    int runs, startless, failed, marked, moved;
    long steps, cycles, retries;
    double most; /* that a run moved by */
} tally;

typedef struct text {
    char of[1200];
    size_t used;
    uint64_t state;
} text;

static double uniform(text *t, double from, double to)
{
    return test_random(&t->state, from, to);
}

static double logarithmic(text *t, double from, double to)
{
    return from * pow(to / from, uniform(t, 0, 1));
}

static bool one_in(text *t, double n)
{
    return uniform(t, 0, n) < 1;
}

static void line(text *t, const char *key, double value, const char *unit)
{
    t->used += (size_t)snprintf(t->of + t->used, sizeof t->of - t->used,
                                "%s = %.6g%s%s\n", key, value, *unit ? " " : "",
                                unit);
    assert_true(t->used < sizeof t->of);
}

static void words(text *t, const char *lines)
{
    t->used += (size_t)snprintf(t->of + t->used, sizeof t->of - t->used, "%s",
                                lines);
    assert_true(t->used < sizeof t->of);
}

static double slip(text *t)
{
    static const double from[] = {0, 0, 0.3, 1.5, 2},
                        to[] = {0, 0.3, 1.9, 2, 3};
    int k = (int)uniform(t, 0, 6) % 5;
    double S = uniform(t, from[k], to[k]);
    return one_in(t, 2) ? S : -S;
}

static void flow_law(text *t)
{
    int k = (int)uniform(t, 0, 4);
    if (k == 1 || k == 2) {
        words(t, "rheology = eyring\n");
        line(t, "eyring_stress", logarithmic(t, 2, 20), "MPa");
    } else if (k == 3) {
        words(t, "rheology = carreau\ncarreau_form = stress\n");
        line(t, "carreau_n", uniform(t, 0.3, 0.8), "");
        line(t, "carreau_stress", logarithmic(t, 0.5, 8), "MPa");
    }
    if (one_in(t, 4))
        line(t, "limiting_shear", uniform(t, 0.03, 0.1), "");
}

static void draw(text *t, uint64_t seed)
{
    *t = (text){.state = seed};
    words(t, "[contact]\nmodulus = 226 GPa\n");
    line(t, "hertz_pressure", uniform(t, 0.4, 2), "GPa");
    line(t, "radius", logarithmic(t, 3, 30), "mm");
    line(t, "mean_speed", logarithmic(t, 0.1, 20), "m/s");
    line(t, "slide_to_roll", slip(t), "");
    words(t, "[lubricant]\n");
    line(t, "viscosity", logarithmic(t, 3, 100), "mPa.s");
    line(t, "alpha", uniform(t, 12, 24), "1/GPa");
    flow_law(t);
    words(t, "[domain]\n");
    line(t, "level", one_in(t, 3) ? 6 : 7, "");
    words(t, "[time]\nend = 3\n");
    words(t,
          one_in(t, 3) ? "scheme = upstream2\n" : "scheme = characteristic\n");
    if (!one_in(t, 4)) {
        words(t, "[heat]\nmodel = lobatto\n");
        line(t, "temperature", uniform(t, 20, 120), "degC");
    }
    if (uniform(t, 0, 5) < 2) {
        words(t, "[cavitation]\nmodel = conserving\n");
        if (uniform(t, 0, 5) < 2) {
            words(t, "[supply]\nmodel = film\n");
            line(t, "thickness_1", logarithmic(t, 0.025, 1), "um");
            line(t, "thickness_2", logarithmic(t, 0.025, 1), "um");
        }
    }
}

typedef struct extreme {
    double low, high;
} extreme;

static double spread(extreme *e, double value)
{
    e->low = fmin(e->low, value);
    e->high = fmax(e->high, value);
    return (e->high - e->low) / fmax(fabs(e->high), 1e-300);
}

/* Marches; how far what is observed moved once what the start changed has left.
 */
static ovr_status march(ovr_simulation *sim, const ovr_march *march,
                        double *moved, ovr_error *err)
{
    const ovr_observation *o = ovr_simulation_observation(sim);
    const double left = 2.5;
    extreme all[4];
    for (int k = 0; k < 4; k++)
        all[k] = (extreme){INFINITY, -INFINITY};
    *moved = 0;
    for (bool more = true; more;) {
        if (ovr_simulation_advance(sim, march, &more, err))
            return err->status;
        if (o->T < left)
            continue;
        /* rises below 2 K say nothing; the spike, a mesh or two wide, and what
         * it heats are known to a per cent at the tolerance of a step */
        const double seen[4] = {o->H_min, o->H_cen, o->P_max,
                                fmax(o->T_max_rise, 2)};
        for (int k = 0; k < 4; k++)
            *moved = fmax(*moved, spread(&all[k], seen[k]) / (k < 2 ? 1 : 7));
    }
    return OVR_OK;
}

static void try(tally *t, uint64_t seed)
{
    const double much = 3e-3;
    static text drawn;
    double moved = 0;
    ovr_error err = {0};
    draw(&drawn, seed);
    ovr_case *c = ovr_case_read_text(drawn.of, "case", NULL, NULL, &err);
    ovr_setup *setup = c ? ovr_case_resolve(c, NULL, &err) : NULL;
    CHECK_OK(setup ? OVR_OK : err.status, &err);
    ovr_simulation *sim = ovr_setup_simulation(setup, NULL, &err);
    assert_non_null(sim);
    ovr_status start = ovr_simulation_steady(sim, &err);
    ovr_status status = start ? start : march(sim, setup->march, &moved, &err);
    const ovr_statistics *s = ovr_simulation_statistics(sim);
    t->runs++;
    t->startless += start != OVR_OK;
    t->failed += !start && status;
    t->moved += moved > much;
    t->most = fmax(t->most, moved);
    if (!start) {
        t->steps += s->steps;
        t->cycles += s->cycles;
        t->retries += s->retries;
        t->marked += s->marked > 0;
    }
    if (status || moved > much || s->marked)
        print_message("    seed %llu: moved %.1e, %ld marked%s%s\n%s",
                      (unsigned long long)seed, moved, s->marked,
                      status ? ": " : "", status ? err.message : "", drawn.of);
    ovr_simulation_free(sim);
    ovr_setup_free(setup);
    ovr_case_free(c);
}

void test_stays_survey(uint64_t seed, int runs)
{
    tally t = {0};
    for (int k = 0; k < runs; k++)
        try(&t, seed + (uint64_t)k);
    print_message("    seeds %llu on: %d runs, %d without a start, %d failed, "
                  "%d with marked steps, %d moved, %.1e the most; %ld steps, "
                  "%.2f cycles each, %ld retries\n",
                  (unsigned long long)seed, t.runs, t.startless, t.failed,
                  t.marked, t.moved, t.most, t.steps,
                  (double)t.cycles / (double)t.steps, t.retries);
    assert_int_equal(t.failed, 0);
    assert_int_equal(t.moved, 0);
    assert_true(50 * t.marked <= t.runs);
    assert_true(50 * t.startless <= t.runs);
}
