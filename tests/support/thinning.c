/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "thinning.h"

#include "overroll/case.h"
#include "overroll/simulation.h"
#include "random_case.h"
#include "test.h"

static ovr_status run(const test_random_case *d, test_thinned *found,
                      ovr_error *err)
{
    ovr_case *c = ovr_case_read_text(d->text, "case", NULL, NULL, err);
    ovr_setup *setup = c ? ovr_case_resolve(c, NULL, err) : NULL;
    ovr_status status = setup ? ovr_setup_prepare(setup, NULL, err)
                              : OVR_BAD_INPUT;
    ovr_simulation *sim = status ? NULL
                                 : ovr_setup_simulation(setup, NULL, err);
    if (sim) {
        status = ovr_simulation_steady(sim, err);
        if (!status)
            status = ovr_simulation_march(sim, setup->march, err);
        const ovr_statistics *s = ovr_simulation_statistics(sim);
        *found = (test_thinned){s->steps, s->cycles, s->retries, s->substeps,
                                s->marked};
    }
    ovr_simulation_free(sim);
    ovr_setup_free(setup);
    ovr_case_free(c);
    return status;
}

test_thinned test_thinning(uint64_t seed, int level)
{
    static test_random_case d;
    ovr_error err = {0};
    test_thinned found = {0};
    test_write_points("thinning.csv");
    test_thinning_case(&d, seed, level);
    if (run(&d, &found, &err) || found.marked)
        print_message("    seed %llu: %ld flagged steps; %s\n%s\n",
                      (unsigned long long)seed, found.marked, err.message,
                      d.text);
    assert_int_equal(err.status, OVR_OK);
    return found;
}

void test_thinning_survey(uint64_t seed, int runs, int level)
{
    test_thinned all = {0};
    long marked = 0, retried = 0;
    for (int k = 0; k < runs; k++) {
        test_thinned one = test_thinning(seed + (uint64_t)k, level + k % 2);
        all.steps += one.steps;
        all.cycles += one.cycles;
        all.substeps += one.substeps;
        retried += one.retries > 0;
        marked += one.marked > 0;
    }
    print_message("    seeds %llu on: %d runs, %ld steps, %.2f cycles each; "
                  "%ld runs with retries, %ld halved steps, %ld runs with "
                  "flagged steps\n",
                  (unsigned long long)seed, runs, all.steps,
                  (double)all.cycles / (double)all.steps, retried, all.substeps,
                  marked);
    assert_true(50 * marked <= runs);
}
