/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Contacts that shear thin, in numbers: 144 steady ones after Eyring, and runs
 * with features, flow laws and sliding that swings, drawn at random. */
#include <math.h>
#include <stdlib.h>

#include "support/contact.h"
#include "support/test.h"

static ovr_simulation *eyring(double M, double L, double S, double tau0,
                              int level)
{
    ovr_conditions given = ovr_conditions_default();
    test_contact c = test_contact_make(M, L);
    ovr_flow_form form = ovr_flow_form_default();
    ovr_options o = test_options();
    ovr_error err = {0};
    given.M = M, given.L = L;
    given.alpha = 17e-9, given.modulus = 226e9;
    given.slide_to_roll = S;
    CHECK_OK(ovr_contact_resolve(&given, &c.contact, &err), &err);
    form.rheology = OVR_EYRING;
    form.stress = tau0;
    CHECK_OK(ovr_lubricant_flow(&c.contact, &form, &c.lubricant, &err), &err);
    o.level = level;
    ovr_simulation *sim = ovr_simulation_create(&c.contact, &c.lubricant, &o,
                                                NULL, &err);
    assert_non_null(sim);
    return sim;
}

static void steady_contacts_converge(void **state)
{
    static const double contact[][2] = {{5, 5},   {20, 10}, {20, 2.5},
                                        {50, 14}, {100, 5}, {200, 14}};
    static const double tau0[] = {2e6, 5e6, 15e6}, S[] = {0, 0.1, 0.5, 2};
    int ways = 0, cycles = 0;
    (void)state;
    for (int k = 0; k < 144; k++) {
        const double *c = contact[k / 24];
        ovr_simulation *sim = eyring(c[0], c[1], S[k % 4], tau0[k / 4 % 3],
                                     k / 12 % 2 ? 10 : 8);
        ovr_error err = {0};
        CHECK_OK(ovr_simulation_steady(sim, &err), &err);
        ways += *ovr_simulation_strategy(sim) != '\0';
        cycles += ovr_simulation_observation(sim)->cycles;
        ovr_simulation_free(sim);
    }
    print_message("    144 contacts, %d by another way, %.1f cycles each\n",
                  ways, cycles / 144.);
}

/* One run of 120 steps of two meshes; how many were marked. */
static long run(uint64_t *seed, long *cycles, long *steps)
{
    double M = exp(test_random(seed, log(5), log(200)));
    double L = test_random(seed, 2.5, 14), S = test_random(seed, -2, 2);
    int level = test_random(seed, 0, 1) < 0.5 ? 7 : 8;
    ovr_simulation *sim = eyring(
        M, L, S, exp(test_random(seed, log(2e6), log(15e6))), level);
    double u = 1 + (test_random(seed, 0, 1) < 0.5 ? S : -S) / 2;
    test_feature f = {
        'l', test_random(seed, -0.3, 0.1), 0.5, u < 0 ? 2 : -4.5, u, 0};
    ovr_history_form form = ovr_history_form_default();
    ovr_error err = {0};
    f.A *= ovr_film_central_moes(M, L);
    f.width = test_random(seed, 0.2, 1);
    form.kind = OVR_HISTORY_SINE;
    form.amplitude = test_random(seed, 0, 2);
    form.period = test_random(seed, 1, 4);
    form.mean = S;
    ovr_history *V = ovr_history_create(&form, NULL, &err);
    if (test_random(seed, 0, 1) < 0.5)
        ovr_simulation_sliding(sim, V);
    ovr_simulation_surface(sim, test_feature_heights, &f);
    ovr_simulation_moving(sim, u);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    double D = ovr_simulation_state(sim)->D;
    for (int k = 0; k < 400 && !err.status; k++)
        ovr_simulation_step(sim, 2 * D, &err);
    if (err.status)
        print_message("    M %.4g L %.4g S %.3g: %s\n", M, L, S, err.message);
    assert_int_equal(err.status, OVR_OK);
    const ovr_statistics *s = ovr_simulation_statistics(sim);
    long marked = s->marked > 0;
    *cycles += s->cycles;
    *steps += s->steps;
    ovr_simulation_free(sim);
    ovr_history_free(V);
    return marked;
}

static void random_runs_go_through(void **state)
{
    const char *told = getenv("OVERROLL_RUNS");
    long runs = told ? strtol(told, NULL, 10) : 200, marked = 0, cycles = 0,
         steps = 0;
    uint64_t seed = 20260622;
    (void)state;
    print_message("    seed %llu\n", (unsigned long long)seed);
    for (long k = 0; k < runs; k++)
        marked += run(&seed, &cycles, &steps);
    print_message("    %ld runs, %ld with marked steps, %.2f cycles a step\n",
                  runs, marked, (double)cycles / (double)steps);
    assert_true(50 * marked <= runs);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(steady_contacts_converge),
        cmocka_unit_test(random_runs_go_through)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
