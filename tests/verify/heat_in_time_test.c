/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random thermal runs with the features, rheological models and oscillating
 * sliding of rheology_test.c, from 0.4 to 2 GPa. */
#include <math.h>
#include <stdlib.h>

#include "contact/contact.h"
#include "contact/film_formula.h"
#include "simulation/simulation.h"
#include "support/contact.h"
#include "support/hot.h"
#include "support/test.h"

typedef struct total {
    long runs, failed, marked, cycles, steps, retries;
    double min_rise, max_rise, max_defect;
} total;

/* Uniform in ln M, L and the slip, of those that are drawn the first with a
 * pressure between 0.4 and 2 GPa. */
static test_hot draw(uint64_t *seed, double *S)
{
    test_hot hot;
    do {
        double M = exp(test_random(seed, log(5), log(200)));
        double L = test_random(seed, 2.5, 14);
        double tau0 = exp(test_random(seed, log(2e6), log(15e6)));
        *S = test_random(seed, -2, 2);
        hot = test_hot_make(M, L, *S, tau0, NULL);
    } while (!(hot.contact.ph > 0.4e9 && hot.contact.ph < 2e9));
    return hot;
}

static void take(total *t, const ovr_simulation *sim, const ovr_error *err)
{
    const ovr_statistics *s = ovr_simulation_statistics(sim);
    t->runs++;
    t->failed += err->status != OVR_OK;
    t->marked += s->marked > 0;
    t->cycles += s->cycles;
    t->steps += s->steps;
    t->retries += s->retries;
    t->min_rise = fmin(t->min_rise, s->extreme.T_max_rise);
    t->max_rise = fmax(t->max_rise, s->extreme.T_max_rise);
    t->max_defect = fmax(t->max_defect, fabs(s->extreme.energy_defect));
}

/* One run of 400 steps of 2 D. */
static void run(uint64_t *seed, total *t)
{
    double S;
    test_hot hot = draw(seed, &S);
    const ovr_contact *c = &hot.contact;
    int level = test_random(seed, 0, 1) < 0.5 ? 7 : 8;
    double u = 1 + (test_random(seed, 0, 1) < 0.5 ? S : -S) / 2;
    test_feature f = {
        'l', test_random(seed, -0.3, 0.1), 0.5, u < 0 ? 2 : -4.5, u, 0};
    ovr_history_form form = ovr_history_form_default();
    ovr_error err = {0};
    ovr_simulation *sim = test_hot_simulation(&hot, level);
    f.A *= ovr_film_central_moes(c->M, c->L);
    f.width = test_random(seed, 0.2, 1);
    form.kind = OVR_HISTORY_SINE;
    form.amplitude = test_random(seed, 0, 2);
    form.period = test_random(seed, 1, 4);
    form.mean = S;
    ovr_history *V = ovr_history_create(&form, NULL, &err);
    bool swings = test_random(seed, 0, 1) < 0.5;
    if (swings)
        ovr_simulation_sliding(sim, V);
    ovr_simulation_surface(sim, test_feature_heights, &f);
    ovr_simulation_moving(sim, u);
    ovr_simulation_steady(sim, &err);
    double D = ovr_simulation_state(sim)->D;
    for (int k = 0; k < 400 && !err.status; k++)
        ovr_simulation_step(sim, 2 * D, &err);
    take(t, sim, &err);
    const ovr_statistics *s = ovr_simulation_statistics(sim);
    print_message("    M %.4g L %.4g, %.2f GPa, %.3g MPa, S %.3g%s: %.0f K, "
                  "Peclet %.2g %.2g, %ld marked%s%s\n",
                  c->M, c->L, c->ph * 1e-9,
                  hot.oil.Sigma0 * c->ph * c->kappa * 1e-6, S,
                  swings ? " swings" : "", s->extreme.T_max_rise,
                  hot.heat.peclet[0], hot.heat.peclet[1], s->marked,
                  err.status ? ": " : "", err.status ? err.message : "");
    ovr_simulation_free(sim);
    ovr_history_free(V);
}

TEST(random_runs_go_through)
{
    const char *told = getenv("OVERROLL_RUNS");
    long runs = told ? strtol(told, NULL, 10) : 100;
    total t = {.min_rise = INFINITY};
    uint64_t seed = 20261122;
    print_message("    seed %llu\n", (unsigned long long)seed);
    for (long k = 0; k < runs; k++)
        run(&seed, &t);
    print_message("    %ld runs, %ld failed, %ld with marked steps; rises of "
                  "%.3g to %.3g K, defect of energy up to %.2g; %.2f cycles a "
                  "step, %ld retries in %ld steps\n",
                  t.runs, t.failed, t.marked, t.min_rise, t.max_rise,
                  t.max_defect, (double)t.cycles / (double)t.steps, t.retries,
                  t.steps);
    assert_int_equal(t.failed, 0);
    assert_true(100 * t.marked <= 3 * t.runs);
}
