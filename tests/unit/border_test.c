/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Structs that cross the library's border: one of an older caller, which ends
 * before the last fields, is taken with the defaults of these; one without a
 * size, or of a newer caller, is refused. */
#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "support/test.h"

#include "contact/contact.h"
#include "contact/heat.h"
#include "contact/oil.h"
#include "overroll/overroll.h"
#include "stress/stress.h"
#include "surface/profile.h"
#include "surface/surfaces.h"

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
    ovr_conditions given = ovr_conditions_default();
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

/* A function that takes options, and whether it refused them. */
typedef bool refuses(void *options, ovr_error *err);

static bool conditions(void *o, ovr_error *err)
{
    ovr_contact contact;
    return ovr_contact_resolve(o, &contact, err) != OVR_OK;
}

static bool history(void *o, ovr_error *err)
{
    ovr_history *made = ovr_history_create(o, NULL, err);
    ovr_history_free(made);
    return !made;
}

static bool source(void *o, ovr_error *err)
{
    static const char text[] = "x um z um\n0 0\n1 1\n2 0\n3 1\n4 0\n";
    ovr_profile *made = ovr_profile_parse(o, text, sizeof text - 1, NULL, err);
    ovr_profile_free(made);
    return !made;
}

static bool conditioning(void *o, ovr_error *err)
{
    const double x[] = {0, 1, 2, 3, 4}, z[] = {0, 1, 0, 1, 0};
    ovr_profile *p = ovr_profile_create(5, x, z, true, NULL, err);
    ovr_status status = ovr_profile_condition(p, o, err);
    ovr_profile_free(p);
    return status != OVR_OK;
}

static bool roughness(void *o, ovr_error *err)
{
    ovr_profile *made = ovr_profile_random(o, NULL, err);
    ovr_profile_free(made);
    return !made;
}

static bool feature(void *o, ovr_error *err)
{
    ovr_contact c = {
        .size = sizeof c, .M = 20, .L = 10, .u1_ratio = 1, .u2_ratio = 1};
    ovr_surfaces *s = ovr_surfaces_create(&c, NULL, 0.01, NULL, err);
    ovr_status status = ovr_surfaces_add(s, o, err);
    ovr_surfaces_free(s);
    return status != OVR_OK;
}

static bool oil(void *o, ovr_error *err)
{
    const ovr_contact c = {
        .size = sizeof c, .M = 20, .L = 10, .alphabar = 20, .ph = 1e9};
    ovr_lubricant made;
    return ovr_oil_complete(o, err) != OVR_OK ||
           ovr_oil_scale(o, &c, &made, err) != OVR_OK;
}

static bool heat(void *o, ovr_error *err)
{
    ovr_contact c = {.size = sizeof c,
                     .b = 1e-4,
                     .height = 1e-6,
                     .um = 1,
                     .L = 10,
                     .radius = 0.01};
    const ovr_lubricant oil = {
        .size = sizeof oil, .alphabar = 20, .P0 = 0.2, .z = 0.68};
    ovr_heat made;
    return ovr_heat_make(o, &c, &oil, &made, err) != OVR_OK;
}

static bool stress(void *o, ovr_error *err)
{
    ovr_stress *made = ovr_stress_create(o, NULL, err);
    assert_true(isnan(ovr_stress_memory(o)) == !made);
    ovr_stress_free(made);
    return !made;
}

static bool material(void *range, ovr_error *err)
{
    ovr_stress_options o = ovr_stress_options_default();
    o.mesh = 0.05, o.inlet = -3, o.nodes = 121;
    ovr_passage *made = ovr_passage_create(&o, range, NULL, err);
    ovr_passage_free(made);
    return !made;
}

static bool life(void *o, ovr_error *err)
{
    ovr_life_result result;
    double ratio = ovr_life_ratio(o, 1, 10, 1);
    if (isnan(ratio)) /* this function has no error to give */
        ovr_life(o, &(ovr_material){.depths = 1}, NULL, NULL, NULL, NULL,
                 &result, err);
    return isnan(ratio);
}

/* The pictures would need files: they are refused, or the path is. */
static bool picture(void *o, ovr_error *err)
{
    ovr_picture(NULL, 0, o, NULL, err);
    return strstr(err->message, "_default()") != NULL;
}

static bool figure(void *o, ovr_error *err)
{
    ovr_figure(NULL, o, NULL, err);
    return strstr(err->message, "_default()") != NULL;
}

/* Its `look` has no size, which is the next thing refused. */
static bool frames(void *o, ovr_error *err)
{
    assert_int_equal(ovr_frames(NULL, 0, o, NULL, NULL, err), OVR_BAD_INPUT);
    return !strstr(err->message, "ovr_picture_options_default()");
}

static bool view(void *o, ovr_error *err)
{
    ovr_view(NULL, 0, o, NULL, err);
    return strstr(err->message, "_default()") != NULL;
}

/* What the library makes ends where an older caller's struct ends, and what
 * such a one gives back has defaults behind. */
static void test_made(void **state)
{
    const size_t known = offsetof(ovr_contact, width);
    ovr_conditions given = ovr_conditions_default();
    ovr_contact whole = ovr_contact_default(), *old;
    ovr_lubricant oil;
    ovr_error err = {0};
    (void)state;
    given.M = 20, given.L = 10, given.alpha = 17e-9, given.width = 0.01;
    old = front(&whole, known);
    assert_int_equal(ovr_contact_resolve_into(&given, old, &err), OVR_OK);
    assert_true(old->M == 20 && old->size == known);
    assert_int_equal(((unsigned char *)old)[known], 0x5a);
    assert_int_equal(ovr_lubricant_make(old, OVR_ROELANDS, OVR_DOWSON_HIGGINSON,
                                        198e6, 0.68, &oil, &err),
                     OVR_OK);
    assert_true(oil.size == sizeof oil && oil.z == 0.68);
    assert_true(ovr_kind_scale(OVR_KIND_PRESSURE, old) == old->ph);
    oil.size = offsetof(ovr_lubricant, limiting_shear);
    assert_true(ovr_viscosity(&oil, 0.5) > 1);
    oil.size = 0;
    assert_true(isnan(ovr_viscosity(&oil, 0.5)));
    old->size = sizeof whole + 8; /* newer: what this one lacks is zero */
    memset((char *)old + sizeof whole, 1, 8);
    assert_int_equal(ovr_contact_resolve_into(&given, old, &err), OVR_OK);
    assert_true(old->size == sizeof whole && old->width == 0.01);
    assert_int_equal(((char *)old)[sizeof whole + 7], 0);
    old->size = 0;
    assert_int_equal(ovr_contact_resolve_into(&given, old, &err),
                     OVR_BAD_INPUT);
    assert_non_null(strstr(err.message, "ovr_contact has size 0"));
    assert_null(ovr_surfaces_create(old, NULL, 0.1, NULL, &err));
    free(old);
}

/* The same of what it tells of a table's row; and quantities that an older
 * struct does not hold. */
static void test_told(void **state)
{
    ovr_observation seen = {
        .size = offsetof(ovr_observation, P_cen), .H_cen = 0.5, .P_cen = 1};
    ovr_parameter_info whole = {.size = 0}, *old;
    const ovr_observable *o;
    int known = 0;
    (void)state;
    old = front(&whole, offsetof(ovr_parameter_info, initial));
    ovr_parameter_into(0, old);
    assert_string_equal(old->section, ovr_parameter_at(0).section);
    assert_int_equal(((unsigned char *)old)[old->size], 0x5a);
    free(old);
    for (size_t k = 0; (o = ovr_observable_at(k)); k++) {
        bool there = o->offset < seen.size;
        if (o->axes != OVR_AT_STEPS)
            continue;
        known += there;
        assert_true(isnan(ovr_observable_value(o, &seen)) == !there);
    }
    assert_true(known > 5);
}

/* What the library fills says how long it is too. */
static void test_totals(void **state)
{
    ovr_sweep_totals totals = {0};
    ovr_error err = {0};
    (void)state;
    assert_int_equal(ovr_sweep_collect(NULL, NULL, &totals, &err),
                     OVR_BAD_INPUT);
    assert_non_null(strstr(err.message, "ovr_sweep_totals_default()"));
    totals.size = offsetof(ovr_sweep_totals, marked);
    totals.count[1] = totals.marked = 7;
    ovr_sweep_totals_fill(&totals);
    assert_true(totals.count[1] == 0 && totals.marked == 7);
}

/* Every other struct of options, whole or of an older caller that ends before
 * `known`; not of a newer one nor without a size. */
#define OPTIONS(type, function, known, ...)                                    \
    do {                                                                       \
        type whole = type##_default(), *old;                                   \
        __VA_ARGS__;                                                           \
        old = front(&whole, offsetof(type, known));                            \
        check_sizes(&whole, sizeof whole, old, #type "_default()", function);  \
        free(old);                                                             \
    } while (0)

static void check_sizes(void *whole, size_t size, void *old, const char *says,
                        refuses *refuse)
{
    const size_t bad[] = {0, size + 8};
    ovr_error err = {0};
    assert_false(refuse(whole, &err));
    assert_false(refuse(old, &err));
    for (int k = 0; k < 2; k++) {
        memset(&err, 0, sizeof err);
        memcpy(whole, &bad[k], sizeof bad[k]);
        assert_true(refuse(whole, &err));
        assert_int_equal(err.status, OVR_BAD_INPUT);
        assert_non_null(strstr(err.message, says));
    }
}

static void test_all_sizes(void **state)
{
    (void)state;
    OPTIONS(ovr_conditions, conditions, width, whole.M = 20, whole.L = 10,
            whole.alpha = 17e-9);
    OPTIONS(ovr_history_form, history, points, whole.kind = OVR_HISTORY_SINE,
            whole.amplitude = 0.1);
    OPTIONS(ovr_profile_source, source, options, whole.file = "it");
    OPTIONS(ovr_conditioning, conditioning, extend, whole.taper = 0);
    OPTIONS(ovr_roughness, roughness, seed, whole.Rq = 0.1, whole.length = 8);
    OPTIONS(ovr_feature_form, feature, roughness, whole.depth = 0.1,
            whole.width = 1, whole.start = 0);
    OPTIONS(ovr_oil, oil, density_15, whole.z = 0.6);
    OPTIONS(ovr_heat_form, heat, beta, whole.temperature = 353, whole.S0 = 1.1);
    OPTIONS(ovr_stress_options, stress, traction, whole.mesh = 0.05,
            whole.inlet = -3, whole.nodes = 121);
    OPTIONS(ovr_material_range, material, least_depth, whole.poisson = 0.25);
    OPTIONS(ovr_life_options, life, least_depth, whole.limit = 0.1);
}

static void test_all_pictures(void **state)
{
    const ovr_picture_options look = {.size = 0};
    (void)state;
    OPTIONS(ovr_picture_options, picture, script, whole.path = "none.bmp");
    OPTIONS(ovr_figure_options, figure, script, whole.path = "none.bmp");
    OPTIONS(ovr_frames_options, frames, data, whole.look = &look);
    OPTIONS(ovr_view_options, view, names, whole.path = ".");
}

/* ----------------------------------------------------- calls within calls */

typedef struct within {
    ovr_run *run;
    ovr_simulation *sim;
    int refused;
} within;

static ovr_status run_again(void *data, const ovr_simulation *sim,
                            ovr_error *err)
{
    within *w = data;
    ovr_error own = {0};
    (void)sim;
    (void)err;
    assert_int_equal(ovr_run_go(w->run, &own), OVR_BAD_INPUT);
    CHECK_ERROR(&own, OVR_BAD_INPUT, "under way");
    w->refused++;
    return OVR_OK;
}

static void test_run_within_its_observer(void **state)
{
    within w = {0};
    ovr_error err = {0};
    ovr_run_options how = ovr_run_options_default();
    ovr_case *c = ovr_case_read_text(
        "[contact]\nM = 20\nL = 10\n[domain]\nlevel = 4\n"
        "[time]\nend = 0.1\n",
        "case", NULL, NULL, &err);
    (void)state;
    how.data = &w;
    how.observe = run_again;
    w.run = ovr_run_create(c, &how, NULL, &err);
    assert_non_null(w.run);
    CHECK_OK(ovr_run_go(w.run, &err), &err);
    assert_true(w.refused > 2);
    assert_int_equal(ovr_run_go(w.run, &err), OVR_BAD_INPUT);
    ovr_run_free(w.run);
    ovr_case_free(c);
}

static ovr_status step_again(void *data, const ovr_simulation *sim,
                             ovr_error *err)
{
    within *w = data;
    ovr_march march = ovr_march_default();
    bool more;
    (void)sim;
    (void)err;
    march.end = 1;
    assert_int_equal(ovr_simulation_steady(w->sim, NULL), OVR_BAD_INPUT);
    assert_int_equal(ovr_simulation_step(w->sim, 0.01, NULL), OVR_BAD_INPUT);
    assert_int_equal(ovr_simulation_march(w->sim, &march, NULL), OVR_BAD_INPUT);
    assert_int_equal(ovr_simulation_advance(w->sim, &march, &more, NULL),
                     OVR_BAD_INPUT);
    w->refused++;
    return OVR_OK;
}

static void test_simulation_within_its_observer(void **state)
{
    within w = {0};
    ovr_error err = {0};
    ovr_options options = ovr_options_default();
    ovr_observer look = {step_again, NULL, &w};
    ovr_march march = ovr_march_default();
    (void)state;
    options.level = 4;
    w.sim = simulation(&options, &err);
    assert_non_null(w.sim);
    CHECK_OK(ovr_simulation_steady(w.sim, &err), &err);
    march.end = 0.1;
    march.count = 1;
    march.observers = &look;
    CHECK_OK(ovr_simulation_march(w.sim, &march, &err), &err);
    assert_true(w.refused > 2);
    ovr_simulation_free(w.sim);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_run_within_its_observer),
        cmocka_unit_test(test_simulation_within_its_observer),
        cmocka_unit_test(test_options),
        cmocka_unit_test(test_march),
        cmocka_unit_test(test_filled),
        cmocka_unit_test(test_all_sizes),
        cmocka_unit_test(test_all_pictures),
        cmocka_unit_test(test_totals),
        cmocka_unit_test(test_made),
        cmocka_unit_test(test_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
