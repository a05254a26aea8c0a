/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Statements of the public headers that no other test contains. */
#include "support/test.h"

#include <locale.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "overroll/overroll.h"

/* A steel roller and a dent that has just entered. */
static const char text[] = "[contact]\nM = 20\nL = 10\nradius = 10 mm\n"
                           "modulus = 226 GPa\nviscosity = 40 mPa.s\n"
                           "[domain]\nlevel = 4\norder = 2\n"
                           "[time]\nend = 0.5\n"
                           "[feature dent]\nshape = dent\ndepth = 0.05\n"
                           "width = 0.8\nstart = -2\n";

static ovr_case *dent(const ovr_allocator *allocator)
{
    ovr_error err = {0};
    ovr_case *c = ovr_case_read_text(text, "dent.ini", NULL, allocator, &err);
    CHECK_OK(err.status, &err);
    return c;
}

static void set(ovr_case *c, const char *key, const char *value)
{
    ovr_error err = {0};
    CHECK_OK(ovr_case_set(c, key, value, "here", &err), &err);
}

/* ----------------------------------------------------------------- memory */

/* An object is used and freed after the allocator of its constructor was
 * overwritten. */
TEST_IN_FOLDER(allocators_are_copied)
{
    test_faults f;
    ovr_error err = {0};
    ovr_run_options how = {.output = test_path(*state, "a.h5")};
    ovr_allocator hook, none = {0};
    test_faults_init(&f);
    hook = f.hook;
    ovr_case *c = dent(&hook);
    hook = none;
    set(c, "time.end", "0.2");
    long made = f.calls;
    assert_true(made > 0);

    hook = f.hook;
    ovr_setup *setup = ovr_case_resolve(c, &hook, &err);
    CHECK_OK(ovr_setup_prepare(setup, &hook, &err), &err);
    hook = none;
    assert_true(f.calls > made);
    made = f.calls;

    hook = f.hook;
    ovr_simulation *sim = ovr_setup_simulation(setup, &hook, &err);
    hook = none;
    assert_true(f.calls > made);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    CHECK_OK(ovr_simulation_step(sim, 0.1, &err), &err);
    made = f.calls;

    hook = f.hook;
    ovr_run *run = ovr_run_create(c, &how, &hook, &err);
    hook = none;
    assert_true(f.calls > made);
    CHECK_OK(ovr_run_execute(run, &err), &err);
    made = f.calls;

    hook = f.hook;
    ovr_result *result = ovr_result_open(how.output, &hook, &err);
    hook = none;
    assert_true(f.calls > made);
    assert_true(ovr_result_get_info(result)->steps > 1);

    ovr_result_close(result), ovr_run_free(run), ovr_simulation_free(sim);
    ovr_setup_free(setup), ovr_case_free(c);
    assert_int_equal(f.live, 0);
}

/* Returns the bytes allocated to resolve and prepare the case on a level, and
 * those of its simulation. */
static double bytes_on(const char *level, double *simulation)
{
    test_faults f;
    ovr_error err = {0};
    ovr_case *c = dent(NULL);
    test_faults_init(&f);
    set(c, "domain.level", level);
    ovr_setup *setup = ovr_case_resolve(c, &f.hook, &err);
    CHECK_OK(ovr_setup_prepare(setup, &f.hook, &err), &err);
    double bytes = f.bytes;
    ovr_simulation *sim = ovr_setup_simulation(setup, &f.hook, &err);
    assert_non_null(sim);
    *simulation = f.bytes - bytes;
    ovr_simulation_free(sim), ovr_setup_free(setup), ovr_case_free(c);
    return bytes;
}

/* An array of the 28,673 nodes of level 12 has 229 kB. */
TEST(preparing_needs_no_memory_for_a_grid)
{
    double coarse, fine, of_5 = bytes_on("5", &coarse),
                         of_12 = bytes_on("12", &fine);
    print_message("prepared %.0f and %.0f bytes, simulation %.0f and %.0f\n",
                  of_5, of_12, coarse, fine);
    assert_true(of_12 < of_5 + 70e3);
    assert_true(fine > 20 * coarse);
}

/* ------------------------------------------------------------- simulation */

static ovr_simulation *simulation_of(ovr_case *c, ovr_setup **setup)
{
    ovr_error err = {0};
    *setup = ovr_case_resolve(c, NULL, &err);
    CHECK_OK(err.status, &err);
    ovr_simulation *sim = ovr_setup_simulation(*setup, NULL, &err);
    CHECK_OK(err.status, &err);
    return sim;
}

/* Integrals of 1, of X and of P by the weights. */
TEST(weights_integrate)
{
    ovr_error err = {0};
    ovr_case *c = dent(NULL);
    ovr_setup *setup;
    ovr_simulation *sim = simulation_of(c, &setup);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    const ovr_state *s = ovr_simulation_state(sim);
    double one = 0, X = 0, P = 0, a = s->X[0], b = s->X[s->n - 1];
    for (size_t i = 0; i < s->n; i++) {
        one += s->weights[i];
        X += s->weights[i] * s->X[i];
        P += s->weights[i] * s->P[i];
    }
    CHECK_CLOSE(one, b - a, 1e-13);
    CHECK_NEAR(X, (b * b - a * a) / 2, 1e-12);
    CHECK_NEAR(P, ovr_simulation_observation(sim)->load, 1e-13);
    CHECK_NEAR(P, 2 * atan(1), 1e-6);
    ovr_simulation_free(sim), ovr_setup_free(setup), ovr_case_free(c);
}

static ovr_status expect_time(void *steps, const ovr_simulation *sim,
                              ovr_error *err)
{
    const ovr_state *s = ovr_simulation_state(sim);
    (void)err;
    assert_int_equal(s->step, (*(long *)steps)++);
    assert_true(s->T == (double)s->step * 0.07);
    return OVR_OK;
}

/* 0.07 is not a binary fraction: a sum of steps has another last bit. */
TEST(time_of_step_k_is_k_steps)
{
    ovr_error err = {0};
    long steps = 0;
    ovr_case *c = dent(NULL);
    ovr_setup *setup;
    ovr_simulation *sim = simulation_of(c, &setup);
    ovr_observer watch = {expect_time, NULL, &steps};
    ovr_march march = {.end = 10 * 0.07, .dT = 0.07, .count = 1};
    march.observers = &watch;
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    CHECK_OK(ovr_simulation_march(sim, &march, &err), &err);
    assert_int_equal(steps, 11);
    ovr_simulation_free(sim), ovr_setup_free(setup), ovr_case_free(c);
}

/* H_cen and H_min of the steady start with this speed at T = 0. */
static void start_at(const char *speed, double film[2])
{
    ovr_error err = {0};
    ovr_case *c = dent(NULL);
    ovr_setup *setup;
    set(c, "domain.level", "8");
    set(c, "domain.inlet", "-4");
    set(c, "domain.outlet", "1.5");
    set(c, "speed.history", "ramp");
    set(c, "speed.from", speed);
    set(c, "speed.duration", "1");
    ovr_simulation *sim = simulation_of(c, &setup);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    film[0] = ovr_simulation_observation(sim)->H_cen;
    film[1] = ovr_simulation_observation(sim)->H_min;
    ovr_simulation_free(sim), ovr_setup_free(setup), ovr_case_free(c);
}

TEST(a_start_from_rest_has_a_hundredth_of_the_speed)
{
    double rest[2], slow[2], faster[2];
    start_at("0", rest), start_at("0.01", slow), start_at("0.02", faster);
    CHECK_CLOSE(rest[0], slow[0], 1e-9);
    CHECK_CLOSE(rest[1], slow[1], 1e-9);
    assert_true(faster[0] > 1.2 * slow[0]);
}

/* ------------------------------------------------------------------ texts */

TEST(similar_names_have_a_third_of_wrong_letters)
{
    static const char *const names[] = {"abcdefghi", "iso_vg"};
    assert_string_equal(ovr_suggest("abcdefxyz", names, 2), "abcdefghi");
    assert_null(ovr_suggest("abcdewxyz", names, 2));
    assert_string_equal(ovr_suggest("vg", names, 2), "iso_vg");
}

TEST(utf8_by_the_standard)
{
    static const struct {
        const char *text;
        int length;
    } of[] = {{"a", 1},
              {"", 1},
              {"\xc3\xa9", 2},         /* e with acute accent */
              {"\xe2\x82\xac", 3},     /* euro sign */
              {"\xf0\x90\x8d\x88", 4}, /* a letter beyond 16 bits */
              {"\xc0\x80", 0},         /* longer than necessary */
              {"\xe0\x80\xaf", 0},     /* the same */
              {"\xed\xa0\x80", 0},     /* half of a pair */
              {"\xf4\x90\x80\x80", 0}, /* beyond the last letter */
              {"\xe2\x82", 0},         /* cut */
              {"\x80", 0}};            /* without a beginning */
    for (size_t k = 0; k < sizeof of / sizeof *of; k++)
        assert_int_equal(ovr_utf8_sequence((const unsigned char *)of[k].text),
                         of[k].length);
}

TEST(bare_numbers_have_a_point_in_every_locale)
{
    for (int comma = 0; comma < 2; comma++) {
        double value = 0;
        if (comma && !test_decimal_comma())
            break;
        assert_true(ovr_bare_number("-1.25e1", &value) && value == -12.5);
        assert_false(ovr_bare_number("1,5", &value));
        assert_false(ovr_bare_number("1.5 mm", &value));
        assert_false(ovr_bare_number("one", &value));
        assert_false(ovr_bare_number("", &value));
    }
    setlocale(LC_ALL, "C");
}

TEST(lists_end)
{
    const char *si;
    ovr_extreme extreme;
    size_t k = 0;
    while (ovr_unit_name(k, &si))
        assert_true(++k < 1000 && si && *si);
    for (k = 0; ovr_section_name(k); k++)
        assert_true(k < 1000 && *ovr_section_help(k));
    for (k = 0; ovr_observable_at(k); k++)
        assert_true(k < 1000);
    for (k = 0; ovr_extreme_at(k, &extreme); k++)
        assert_true(k < 1000 && *extreme.key && extreme.of);
    assert_true(k > 20 && !ovr_extreme_at(0, NULL));
    assert_string_equal(ovr_shape_name(OVR_SHAPES - 1), "areal");
    assert_null(ovr_shape_name(OVR_SHAPES));
    assert_null(ovr_scheme_name((ovr_scheme)7));
}

TEST(an_unset_key_has_its_default)
{
    ovr_error err = {0};
    ovr_case *c = dent(NULL);
    ovr_case_unset(c, "domain.level");
    ovr_case_unset(c, "domain.nothing");
    for (size_t k = 0; k < ovr_case_entries(c); k++) {
        ovr_case_entry e = ovr_case_entry_at(c, k);
        if (strcmp(e.section, "domain") == 0 && strcmp(e.key, "level") == 0)
            assert_true(!e.given && strcmp(e.text, "usual") == 0);
    }
    assert_null(strstr(ovr_case_text(c, &err), "level = 4"));
    assert_non_null(strstr(ovr_case_text(c, &err), "order = 2"));
    ovr_case_free(c);
}

/* ------------------------------------------------------------------ units */

/* b = sqrt(8 w R/(pi E')), p_h = 2 w/(pi b), of the resolved load. */
TEST(scales_of_kinds)
{
    ovr_error err = {0};
    ovr_contact contact, bare;
    ovr_conditions given = ovr_conditions_default();
    given.M = 20, given.L = 10;
    CHECK_OK(ovr_contact_resolve(&given, &bare, &err), &err);
    given.alpha = 20e-9, given.radius = 0.01, given.modulus = 226e9;
    given.viscosity = 0.04;
    CHECK_OK(ovr_contact_resolve(&given, &contact, &err), &err);
    const double pi = 4 * atan(1), w = contact.load;
    double b = sqrt(8 * w * 0.01 / (pi * 226e9)), ph = 2 * w / (pi * b);
    double h = b * b / 0.01;
    const struct {
        ovr_unit_kind kind;
        double scale;
    } of[] = {{OVR_KIND_LENGTH, b},
              {OVR_KIND_HEIGHT, h},
              {OVR_KIND_PRESSURE, ph},
              {OVR_KIND_TIME, b / contact.um},
              {OVR_KIND_VISCOSITY, 0.04},
              {OVR_KIND_FLOW, contact.um * h},
              {OVR_KIND_SHEAR, ph * b / 0.01},
              {OVR_KIND_FORCE, ph * h},
              {OVR_KIND_HEAT, contact.um * ph * b / 0.01},
              {OVR_KIND_POWER, contact.um * ph * h},
              {OVR_KIND_AREA, b * h}};
    for (size_t k = 0; k < sizeof of / sizeof *of; k++) {
        CHECK_CLOSE(ovr_kind_scale(of[k].kind, &contact), of[k].scale, 1e-12);
        assert_true(isnan(ovr_kind_scale(of[k].kind, &bare)));
        assert_int_equal(ovr_kind_named(ovr_kind_about(of[k].kind)->name),
                         of[k].kind);
    }
    assert_true(ovr_kind_scale(OVR_KIND_COUNT, &bare) == 1 &&
                ovr_kind_scale(OVR_KIND_TEMPERATURE, &bare) == 1);
    assert_int_equal(ovr_kind_named("tomorrow's kind"), OVR_KINDS);
}

/* ------------------------------------------------------- machine elements */

static const char gear[] = "[gear]\nteeth_1 = 25\nteeth_2 = 57\n"
                           "module = 2.5 mm\nface = 20 mm\nspeed = 3000 rpm\n"
                           "torque = 80 N.m\n[contact]\nmodulus = 226 GPa\n"
                           "[lubricant]\nviscosity = 40 mPa.s\n"
                           "alpha = 17 1/GPa\n";

TEST(contact_positions_are_in_the_order_of_time)
{
    static ovr_station at[OVR_STATIONS_MAX];
    ovr_error err = {0};
    ovr_case *c = ovr_case_read_text(gear, "gear.ini", NULL, NULL, &err);
    ovr_setup *setup = ovr_case_resolve(c, NULL, &err);
    CHECK_OK(err.status, &err);
    size_t n = ovr_setup_stations(setup, at), named = 0;
    assert_true(n >= 5 && n <= OVR_STATIONS_MAX);
    for (size_t k = 0; k < n; k++) {
        assert_true(k == 0 || at[k].T >= at[k - 1].T);
        named += strlen(at[k].name) == 1 && strchr("ABCDE", at[k].name[0]);
    }
    assert_int_equal(named, 5);
    ovr_setup_free(setup), ovr_case_free(c);

    double depth = 0;
    c = dent(NULL);
    setup = ovr_case_resolve(c, NULL, &err);
    assert_int_equal(ovr_setup_stations(setup, at), 0);
    CHECK_OK(ovr_setup_prepare(setup, NULL, &err), &err);
    CHECK_OK(ovr_setup_stress_depth(setup, &depth, &err), &err);
    assert_true(isnan(depth)); /* without [stress] */
    ovr_setup_free(setup), ovr_case_free(c);
}

/* ------------------------------------------------------------------- runs */

/* A complete run is resumed without a change of its file, with its checkpoint
 * and without; lengths and times in the units of the result. */
TEST_IN_FOLDER(complete_runs_stay_as_they_are)
{
    const char *path = test_path(*state, "a.h5");
    ovr_error err = {0};
    ovr_run_options how = {.output = path};
    char restart[4200];
    size_t before, after;
    ovr_case *c = dent(NULL);
    ovr_run *run = ovr_run_create(c, &how, NULL, &err);
    CHECK_OK(ovr_run_execute(run, &err), &err);
    ovr_run_free(run), ovr_case_free(c);
    char *bytes = test_read(path, &before);

    run = ovr_run_resume(path, NULL, NULL, &err);
    assert_non_null(run);
    CHECK_OK(ovr_run_execute(run, &err), &err);
    CHECK_CLOSE(ovr_run_get_info(run)->fraction, 1, 0);
    ovr_run_free(run);
    snprintf(restart, sizeof restart, "%s.restart", path);
    assert_int_equal(remove(restart), 0);
    assert_null(ovr_run_resume(path, NULL, NULL, &err));
    assert_int_equal(err.status, OVR_OK);
    assert_non_null(strstr(err.message, "already complete"));
    char *again = test_read(path, &after);
    assert_int_equal(before, after);
    assert_memory_equal(bytes, again, before);
    free(bytes), free(again);

    ovr_result *r = ovr_result_open(path, NULL, &err);
    const ovr_result_info *info = ovr_result_get_info(r);
    double value;
    CHECK_OK(ovr_result_number(r, OVR_KIND_LENGTH, "-0.1mm", &value, &err),
             &err);
    CHECK_CLOSE(value, -1e-4 / info->b, 1e-14);
    CHECK_OK(ovr_result_number(r, OVR_KIND_TIME, "0.2 ms", &value, &err), &err);
    CHECK_CLOSE(value, 2e-4 / info->time, 1e-14);
    CHECK_OK(ovr_result_number(r, OVR_KIND_PRESSURE, "0.7", &value, &err),
             &err);
    assert_true(value == 0.7);
    ovr_result_close(r);
}
