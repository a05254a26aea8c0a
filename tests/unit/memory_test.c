/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Memory of a simulation: taken once, little of it, and as announced. */
#include "simulation/internal.h"
#include "support/contact.h"
#include "support/test.h"

static ovr_simulation *create(int level, ovr_scheme scheme,
                              const ovr_allocator *allocator)
{
    ovr_error err;
    ovr_options options = ovr_options_default();
    test_contact t = test_contact_make(20, 10);
    options.level = level;
    options.scheme = scheme;
    ovr_simulation *sim = ovr_simulation_create(&t.contact, &t.lubricant,
                                                &options, allocator, &err);
    assert_non_null(sim);
    return sim;
}

/* A rough steady solution and a run allocate nothing. */
static void nothing_is_allocated_after_set_up(void **state)
{
    const ovr_scheme schemes[] = {OVR_UPSTREAM1, OVR_UPSTREAM2,
                                  OVR_CHARACTERISTIC};
    (void)state;
    for (int k = 0; k < 3; k++) {
        ovr_error err;
        test_faults faults;
        test_feature dent = {'l', -0.1, 0.5, -1.5, 1, 0};
        test_faults_init(&faults);
        ovr_simulation *sim = create(6, schemes[k], &faults.hook);
        long calls = faults.calls;
        ovr_simulation_surface(sim, test_feature_heights, &dent);
        CHECK_OK(ovr_simulation_steady(sim, &err), &err);
        for (int step = 0; step < 30; step++)
            CHECK_OK(
                ovr_simulation_step(sim, ovr_simulation_state(sim)->D, &err),
                &err);
        assert_int_equal(faults.calls, calls);
        ovr_simulation_free(sim);
        assert_int_equal(faults.live, 0);
    }
}

/* All levels and the past of a run together; what small grids take besides is
 * the dense matrix and some pages. */
static void a_node_takes_less_than_a_kilobyte(void **state)
{
    (void)state;
    for (int level = 8; level <= 13; level++) {
        ovr_simulation *sim = create(level, OVR_UPSTREAM2, NULL);
        double n = (double)ovr_simulation_state(sim)->n;
        double bytes = (double)sim->arena.bytes;
        double announced = ovr_simulation_memory(&sim->options);
        print_message("level %d: %.0f bytes a node, %.0f announced\n", level,
                      bytes / n, announced / n);
        assert_true(bytes < 1000 * n);
        CHECK_CLOSE(announced, bytes, 0.15);
        ovr_simulation_free(sim);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nothing_is_allocated_after_set_up),
        cmocka_unit_test(a_node_takes_less_than_a_kilobyte),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
