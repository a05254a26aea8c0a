/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "hot_starts.h"

#include <math.h>

#include "overroll/case.h"
#include "random_case.h"
#include "simulation/internal.h"
#include "test.h"

typedef struct tally {
    int runs, failed, max_failed_cycles, coarse;
    long cycles;          /* cycles of all converged starts */
    int level_cycles[10]; /* maximum of failed starts, by level */
    double max_defect, max_rise;
} tally;

static void count(tally *t, const ovr_simulation *sim, ovr_status status)
{
    const ovr_observation *o = ovr_simulation_observation(sim);
    int level = sim->finest->number;
    t->runs++;
    if (!status) {
        t->cycles += o->cycles;
        t->max_defect = fmax(t->max_defect, fabs(o->energy_defect));
    } else {
        t->failed++;
        if (o->cycles > t->level_cycles[level])
            t->level_cycles[level] = o->cycles;
        if (o->cycles > t->max_failed_cycles)
            t->max_failed_cycles = o->cycles;
    }
    t->max_rise = fmax(t->max_rise, o->T_max_rise);
}

static void solve(tally *t, uint64_t seed)
{
    static test_random_case drawn;
    ovr_error err = {0};
    test_hot_start_case(&drawn, seed);
    ovr_case *c = ovr_case_read_text(drawn.text, "case", NULL, NULL, &err);
    ovr_setup *setup = c ? ovr_case_resolve(c, NULL, &err) : NULL;
    CHECK_OK(setup ? OVR_OK : err.status, &err);
    ovr_simulation *sim = ovr_setup_simulation(setup, NULL, &err);
    assert_non_null(sim);
    ovr_status status = ovr_simulation_steady(sim, &err);
    if (status == OVR_IMPOSSIBLE) /* the film is too thin for the grid */
        t->coarse++;
    else
        count(t, sim, status);
    if (status)
        print_message("    seed %llu: %s\n%s", (unsigned long long)seed,
                      err.message, drawn.text);
    ovr_simulation_free(sim);
    ovr_setup_free(setup);
    ovr_case_free(c);
}

void test_hot_starts_survey(uint64_t seed, int runs)
{
    const double hottest = 5000;  /* temperature rise in K, failures included */
    const double program = 1.5e5; /* start of the program in node cycles */
    tally t = {0};
    test_write_points("thinning.csv");
    for (uint64_t k = 0; t.runs < runs; k++)
        solve(&t, seed + k);
    double mean = (double)t.cycles / fmax(t.runs - t.failed, 1);
    print_message(
        "    seeds %llu on: %d contacts, %d failed (at most %d cycles), mean "
        "%.0f cycles; energy balance error at most %.1e, temperature rise %.0f "
        "K; %d more too thin for the grid\n",
        (unsigned long long)seed, t.runs, t.failed, t.max_failed_cycles, mean,
        t.max_defect, t.max_rise, t.coarse);
    assert_true(100 * t.failed < 3 * runs + 100); /* 3 in 100, 1 in 10 */
    for (int l = 0; l < 10; l++) {
        double nodes = 7 * exp2(l), normal = program + mean * nodes;
        assert_true(t.level_cycles[l] * nodes < 22 * normal);
    }
    assert_true(t.max_defect < 0.02);
    assert_true(t.max_rise <= hottest);
    assert_true(t.coarse < runs / 4 + 2);
}
