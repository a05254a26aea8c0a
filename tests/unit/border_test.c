/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Structs that cross the library's border: one of an older caller, which ends
 * before the last fields, is taken with the defaults of these; one without a
 * size, or of a newer caller, is refused. */
#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "support/test.h"

#include "overroll/overroll.h"

/* The front of a struct, so many bytes; nonsense behind. */
static void *front(const void *whole, size_t size)
{
    void *copy = malloc(1024);
    assert_non_null(copy);
    memset(copy, 0x5a, 1024);
    memcpy(copy, whole, size);
    memcpy(copy, &size, sizeof size);
    return copy;
}

static ovr_simulation *simulation(const ovr_options *options, ovr_error *err)
{
    ovr_conditions given = ovr_conditions_unknown();
    ovr_contact contact;
    ovr_lubricant oil;
    given.M = 20, given.L = 10, given.alpha = 17e-9;
    assert_int_equal(ovr_contact_resolve(&given, &contact, err), OVR_OK);
    assert_int_equal(ovr_lubricant_make(&contact, OVR_ROELANDS,
                                        OVR_DOWSON_HIGGINSON, 198e6, 0.68, &oil,
                                        err),
                     OVR_OK);
    return ovr_simulation_create(&contact, &oil, options, NULL, err);
}

static void test_options(void **state)
{
    ovr_options options = ovr_options_default();
    ovr_error err = {0};
    ovr_options *old;
    ovr_simulation *sim;
    (void)state;
    options.level = 4;
    options.relax_seidel = 0.6; /* the older caller knows nothing of it */
    old = front(&options, offsetof(ovr_options, relax_seidel));
    sim = simulation(old, &err);
    assert_non_null(sim);
    assert_int_equal(ovr_simulation_options(sim)->level, 4);
    assert_true(ovr_simulation_options(sim)->relax_seidel == 0.8);
    ovr_simulation_free(sim);
    free(old);
    options.size = 0;
    assert_null(simulation(&options, &err));
    assert_int_equal(err.status, OVR_BAD_INPUT);
    assert_non_null(strstr(err.message, "ovr_options_default()"));
    options.size = sizeof options + 8;
    assert_null(simulation(&options, &err));
}

static void test_march(void **state)
{
    ovr_options options = ovr_options_default();
    ovr_march march = {.end = 0.1};
    ovr_error err = {0};
    ovr_march *old;
    ovr_simulation *sim;
    (void)state;
    options.level = 4;
    sim = simulation(&options, &err);
    assert_non_null(sim);
    assert_int_equal(ovr_simulation_steady(sim, &err), OVR_OK);
    assert_int_equal(ovr_simulation_march(sim, &march, &err), OVR_BAD_INPUT);
    old = front(&march, offsetof(ovr_march, count));
    assert_int_equal(ovr_simulation_march(sim, old, &err), OVR_OK);
    free(old);
    ovr_simulation_free(sim);
}

static void test_filled(void **state)
{
    size_t known = offsetof(ovr_write_options, deflate);
    ovr_write_options whole = ovr_write_options_default(), *old;
    ovr_run_options *run;
    (void)state;
    whole.stride = 7;
    old = front(&whole, known);
    ovr_write_options_fill(old);
    assert_int_equal(old->size, known);
    assert_int_equal(old->stride, 1);
    assert_true(isnan(old->x_from));
    free(old);
    run = calloc(1, sizeof *run + 16);
    assert_non_null(run);
    run->size = sizeof *run + 16; /* a newer caller: the rest is zero */
    memset(run + 1, 1, 16);
    ovr_run_options_fill(run);
    assert_int_equal(((char *)(run + 1))[15], 0);
    assert_null(ovr_run_resume("none.h5", run, NULL, NULL));
    free(run);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_options),
        cmocka_unit_test(test_march),
        cmocka_unit_test(test_filled),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
