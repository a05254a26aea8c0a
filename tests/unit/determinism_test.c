/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The same input gives the same bits, and on another instruction set the same
 * numbers to 1e-9. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "simulation/internal.h"
#include "support/contact.h"
#include "support/test.h"

enum { LEVEL = 6, NODES = 7 * 64 + 1, STEPS = 60 };

typedef struct ending {
    double P[NODES], H[NODES], H0;
    int cycles;
} ending;

/* A dent at a load that needs the continuation; false: not on this machine. */
static bool run_on(const char *kernels, double M, ending *end)
{
    ovr_error err = {OVR_OK, ""};
    ovr_options o = ovr_options_default();
    test_feature dent = {'l', -0.02, 0.5, -1.2, 1, 0};
    ovr_march march = {.end = STEPS * 5.5 / (NODES - 1)};
    o.level = LEVEL;
    ovr_simulation *sim = test_simulation(M, 10, &o);
    if (kernels)
        sim->grids.kernels = ovr_kernels_choose(kernels);
    bool here = sim->grids.kernels != NULL;
    if (here) {
        ovr_simulation_surface(sim, test_feature_heights, &dent);
        CHECK_OK(ovr_simulation_steady(sim, &err), &err);
        CHECK_OK(ovr_simulation_march(sim, &march, &err), &err);
        const ovr_state *s = ovr_simulation_state(sim);
        assert_int_equal(s->n, NODES);
        memset(end, 0, sizeof *end);
        memcpy(end->P, s->P, sizeof end->P);
        memcpy(end->H, s->H, sizeof end->H);
        end->H0 = s->H0;
        end->cycles = (int)ovr_simulation_statistics(sim)->cycles;
    }
    ovr_simulation_free(sim);
    return here;
}

static void same_bits_again(void **state)
{
    static ending first, again;
    (void)state;
    assert_true(run_on(NULL, 20, &first) && run_on(NULL, 20, &again));
    assert_memory_equal(&first, &again, sizeof first);
    assert_true(run_on(NULL, 100, &first) && run_on(NULL, 100, &again));
    assert_memory_equal(&first, &again, sizeof first);
}

static void same_numbers_on_every_instruction_set(void **state)
{
    static const char *const names[] = {"avx2", "avx512"};
    static ending base, other;
    (void)state;
    assert_true(run_on("base", 20, &base));
    for (int k = 0; k < 2; k++) {
        double worst = 0;
        if (!run_on(names[k], 20, &other))
            continue;
        for (int i = 0; i < NODES; i++)
            worst = fmax(worst, fmax(fabs(base.P[i] - other.P[i]),
                                     fabs(base.H[i] / other.H[i] - 1)));
        printf("base and %s differ by %.1e\n", names[k], worst);
        CHECK_NEAR(worst, 0, 1e-9);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(same_bits_again),
        cmocka_unit_test(same_numbers_on_every_instruction_set)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
