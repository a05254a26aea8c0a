/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "mixed.h"

#include <stdlib.h>
#include <string.h>

#include "overroll/run.h"
#include "random_case.h"
#include "test.h"

typedef struct tally {
    int runs, failed, touching, refused;
    long steps, cycles, retries, marked, late;
    long varying; /* hot runs in which temperatures may lag */
} tally;

/* True for a thermal film with a varying load, speed or sliding: temperatures
 * may change strongly in one step at jumps and at a reversal of the sliding. */
static bool heat_varies(const char *text)
{
    return strstr(text, "[heat]") && strstr(text, "history = ");
}

static void count(tally *t, const ovr_run *run, const char *text)
{
    const ovr_statistics *s = ovr_simulation_statistics(
        ovr_run_get_info(run)->sim);
    t->steps += s->steps;
    t->cycles += s->cycles;
    t->retries += s->retries;
    bool varies = heat_varies(text);
    t->varying += varies;
    t->late += varies && s->lagging > 0;
    t->marked += s->marked > (varies ? s->lagging : 0);
}

static void try(tally *t, uint64_t seed, int level)
{
    static test_random_case d;
    ovr_run_options how = {0};
    ovr_error err = {0};
    test_mixed_case(&d, seed, level);
    ovr_case *c = ovr_case_read_text(d.text, "case", NULL, NULL, &err);
    ovr_run *run = c ? ovr_run_create(c, &how, NULL, &err) : NULL;
    t->runs++;
    t->refused += run == NULL;
    if (run) {
        ovr_run_execute(run, &err);
        count(t, run, d.text);
    }
    t->touching += run && err.status == OVR_IMPOSSIBLE;
    t->failed += run && err.status && err.status != OVR_IMPOSSIBLE;
    if (err.status || getenv("OVERROLL_RUNS"))
        print_message("    seed %llu: %s\n", (unsigned long long)seed,
                      err.message);
    if (err.status && err.status != OVR_IMPOSSIBLE)
        print_message("%s\n", d.text);
    ovr_run_free(run);
    ovr_case_free(c);
}

void test_mixed_survey(uint64_t seed, int runs, int level)
{
    tally t = {0};
    test_write_points("thinning.csv");
    for (int k = 0; k < runs; k++)
        try(&t, seed + (uint64_t)k, level + k % 2);
    print_message("    seeds %llu on: %d runs, %d failed, %d refused, %d where "
                  "surfaces touch; %ld flagged steps; %ld of %ld hot runs "
                  "with lagging temperatures; %ld steps, %.2f cycles each, %ld "
                  "retries\n",
                  (unsigned long long)seed, t.runs, t.failed, t.refused,
                  t.touching, t.marked, t.late, t.varying, t.steps,
                  (double)t.cycles / (double)t.steps, t.retries);
    assert_int_equal(t.failed, 0);
    assert_int_equal(t.refused, 0);
    assert_true(100 * t.marked <= 3 * runs);
    assert_true(10 * t.late <= t.varying);
}
