/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random steady thermal contacts: Eyring films from 0.4 to 2 GPa and Newtonian
 * films up to 1 GPa, whose friction is not realistic without heat. */
#include <math.h>
#include <stdlib.h>

#include "support/hot.h"
#include "support/test.h"

typedef struct total {
    int runs, failed, max_cycles;
    long cycles;
    double max_rise, max_defect;
} total;

/* Uniform in ln M, L and the slip, of those that are drawn the first within
 * these pressures. */
static test_hot draw(uint64_t *seed, double high, bool newtonian)
{
    test_hot hot;
    do {
        double M = exp(test_random(seed, log(5), log(200)));
        double L = test_random(seed, 2.5, 15);
        double tau0 = exp(test_random(seed, log(2e6), log(15e6)));
        double S = test_random(seed, -2, 2);
        hot = test_hot_make(M, L, S, newtonian ? 0 : tau0, NULL);
    } while (!(hot.contact.ph > 0.4e9 && hot.contact.ph < high));
    return hot;
}

static void solve(const test_hot *hot, int level, total *t)
{
    ovr_error err = {0};
    ovr_simulation *sim = test_hot_simulation(hot, level);
    ovr_status status = ovr_simulation_steady(sim, &err);
    const ovr_observation *o = ovr_simulation_observation(sim);
    t->runs++;
    t->cycles += o->cycles;
    t->max_cycles = o->cycles > t->max_cycles ? o->cycles : t->max_cycles;
    if (status) {
        const ovr_contact *c = &hot->contact;
        t->failed++;
        print_message("    M %.3g L %.3g %.3g GPa, SRR %.3g, Sigma0 %.3g: %s\n",
                      c->M, c->L, 1e-9 * c->ph, c->u1_ratio - c->u2_ratio,
                      hot->oil.Sigma0, err.message);
    } else {
        t->max_rise = fmax(t->max_rise, o->T_max_rise);
        t->max_defect = fmax(t->max_defect, fabs(o->energy_defect));
    }
    ovr_simulation_free(sim);
}

static void survey(const char *what, double high, bool newtonian, int runs)
{
    uint64_t seed = 20261123, first = seed;
    total t = {0};
    for (int k = 0; k < runs; k++) {
        test_hot hot = draw(&seed, high, newtonian);
        solve(&hot, k % 2 ? 8 : 6, &t);
    }
    print_message("    %s, seed %llu: %d contacts, %d fail; %.1f cycles, %d at "
                  "most; %.0f K, defect %.1e at most\n",
                  what, (unsigned long long)first, t.runs, t.failed,
                  (double)t.cycles / t.runs, t.max_cycles, t.max_rise,
                  t.max_defect);
    assert_int_equal(t.failed, 0);
}

static int runs(void)
{
    const char *told = getenv("OVERROLL_RUNS");
    return told ? atoi(told) : 100;
}

TEST(eyring_films)
{
    survey("Eyring, 0.4 to 2 GPa", 2e9, false, runs());
}

TEST(newtonian_films)
{
    survey("Newtonian, 0.4 to 1 GPa", 1e9, true, runs());
}
