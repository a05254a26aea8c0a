/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "jumps.h"

#include "overroll/case.h"
#include "physics/supply/supply.h"
#include "random_case.h"
#include "simulation/simulation.h"
#include "test.h"

typedef struct tally {
    int runs, startless, failed, touching, retried, halved, marked, late;
    long steps, cycles, retries, lagging; /* the most of a run */
} tally;

static double arriving(void *data, double T)
{
    (void)T;
    return *(const double *)data;
}

/* The flooded start determines the flow rate of a supply ratio. */
static ovr_status go(ovr_simulation *sim, const ovr_march *march, double share,
                     bool *started, ovr_error *err)
{
    enum { WAITING = 0 };
    ovr_status status = ovr_simulation_steady(sim, err);
    double flow = share * ovr_simulation_observation(sim)->outflow;
    ovr_simulation_supply(sim, arriving, &flow, WAITING);
    if (!status)
        status = ovr_simulation_steady(sim, err);
    *started = !status;
    return status ? status : ovr_simulation_march(sim, march, err);
}

static void add(tally *t, const ovr_simulation *sim)
{
    const ovr_statistics *s = ovr_simulation_statistics(sim);
    t->steps += s->steps;
    t->cycles += s->cycles;
    t->retries += s->retries;
    t->retried += s->retries > 0;
    t->halved += s->substeps > 0;
    /* If the load jumps in one step, its heat lags, which is reported. */
    t->late += s->lagging > 0;
    t->lagging = s->lagging > t->lagging ? s->lagging : t->lagging;
    t->marked += s->marked > s->lagging;
}

static void try(tally *t, uint64_t seed)
{
    static test_random_case d;
    double share;
    ovr_error err = {0};
    test_jump_case(&d, seed, &share);
    ovr_case *c = ovr_case_read_text(d.text, "case", NULL, NULL, &err);
    ovr_setup *setup = c ? ovr_case_resolve(c, NULL, &err) : NULL;
    assert_non_null(setup);
    CHECK_OK(ovr_setup_prepare(setup, NULL, &err), &err);
    ovr_simulation *sim = ovr_setup_simulation(setup, NULL, &err);
    assert_non_null(sim);
    bool started;
    long marked = t->marked;
    ovr_status status = go(sim, setup->march, share, &started, &err);
    t->runs++;
    t->startless += !started;
    if (started)
        add(t, sim);
    t->touching += started && status == OVR_IMPOSSIBLE;
    t->failed += started && status && status != OVR_IMPOSSIBLE;
    if (status || t->marked > marked)
        print_message("    seed %llu, share %g: %s\n%s\n",
                      (unsigned long long)seed, share,
                      status ? err.message : "marked",
                      status == OVR_IMPOSSIBLE ? "" : d.text);
    ovr_simulation_free(sim);
    ovr_setup_free(setup);
    ovr_case_free(c);
}

void test_jumps_survey(uint64_t seed, int runs)
{
    tally t = {0};
    test_write_points("thinning.csv");
    for (int k = 0; k < runs; k++)
        try(&t, seed + (uint64_t)k);
    print_message("    seeds %llu on: %d runs, %d without a start, %d failed, "
                  "%d where surfaces touch, %d marked, %d whose heat came late "
                  "(in %ld steps at most); %d "
                  "tried steps again, "
                  "%d halved some; %ld "
                  "steps, %.2f cycles each, %ld retries\n",
                  (unsigned long long)seed, t.runs, t.startless, t.failed,
                  t.touching, t.marked, t.late, t.lagging, t.retried, t.halved,
                  t.steps, (double)t.cycles / (double)t.steps, t.retries);
    assert_true(50 * t.startless <= t.runs);
    assert_int_equal(t.failed, 0);
    assert_int_equal(t.marked, 0);
    /* The jump, and both steps whose difference in time reaches over it. */
    assert_true(t.lagging <= 3);
}
