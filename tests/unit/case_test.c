/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Case files: accepted and rejected text, and the resolved values. */
#include "support/contact.h"
#include "support/test.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "case/parameters.h"
#include "case/settings.h"
#include "case/setup.h"
#include "contact/contact.h"
#include "overroll/overroll.h"

static const char *const moes = "[contact]\nM = 20\nL = 10\n";
static const char *const roller = "[contact]\n"
                                  "load = 307 kN/m\n"
                                  "radius = 10 mm\n"
                                  "modulus = 226 GPa\n"
                                  "speed_1 = 1.4 m/s\n"
                                  "speed_2 = 1.2 m/s\n"
                                  "[lubricant]\n"
                                  "viscosity = 40 mPa.s\n"
                                  "alpha = 17 1/GPa\n"
                                  "z = 0.68\n";

static char text[65536];

/* The two together in a static buffer. */
static const char *join(const char *a, const char *b)
{
    snprintf(text, sizeof text, "%s%s", a, b);
    return text;
}

/* Reads and resolves; OVR_OK with *setup, or the error. */
static ovr_status try_case(const char *source, ovr_case **c, ovr_setup **setup,
                           ovr_error *err)
{
    *setup = NULL;
    *c = ovr_case_read_text(source, "t.ini", NULL, NULL, err);
    if (*c)
        *setup = ovr_case_resolve(*c, NULL, err);
    if (*setup && ovr_setup_prepare(*setup, NULL, err) == OVR_OK)
        return OVR_OK;
    ovr_setup_free(*setup);
    ovr_case_free(*c);
    return err->status;
}

static void refused(const char *source, const char *message)
{
    ovr_case *c;
    ovr_setup *setup;
    ovr_error err = {0};
    if (try_case(source, &c, &setup, &err) == OVR_OK)
        fail_msg("not refused: %s", source);
    CHECK_ERROR(&err, OVR_BAD_INPUT, message);
    if (strstr(err.message, "did you mean")) /* for programs */
        assert_non_null(strstr(strstr(err.message, "did you mean"), err.meant));
    else
        assert_null(err.meant);
}

static ovr_setup *resolved(const char *source, ovr_case **c)
{
    ovr_setup *setup;
    ovr_error err = {0};
    if (try_case(source, c, &setup, &err))
        fail_msg("%s", err.message);
    return setup;
}

static void done(ovr_case *c, ovr_setup *setup)
{
    ovr_setup_free(setup);
    ovr_case_free(c);
}

/* ---------------------------------------------------------------- reading */

TEST(values_and_defaults)
{
    ovr_case *c;
    ovr_setup *s = resolved(join(moes, "[domain]\nlevel = 9\n"
                                       "[time]\nend = 2.5\nstep = adaptive\n"
                                       "[output]\nat = 0.5, 1,2\n"),
                            &c);
    assert_true(s->contact->M == 20 && s->contact->L == 10);
    assert_int_equal(s->options->level, 9);
    assert_int_equal(s->options->scheme, OVR_UPSTREAM2);
    assert_true(s->transient && s->march->end == 2.5 && s->march->adaptive);
    assert_true(s->options->inlet == -4 && s->options->outlet == 1.5);
    assert_int_equal(s->output->at.count, 3);
    assert_true(s->output->at.values[2] == 2);
    assert_int_equal(s->output->fields, 7);
    CHECK_CLOSE(s->contact->ph, s->contact->alphabar / 1.7e-8, 1e-15);
    assert_int_equal(s->lubricant->viscosity_law, OVR_ROELANDS);
    done(c, s);
}

TEST(scheme_of_starved_steps)
{
    static const struct {
        const char *text;
        ovr_scheme scheme;
    } of[] = {
        {"[contact]\nM = 20\nL = 10\n[supply]\nmodel = film\n"
         "thickness_1 = 0.02\nthickness_2 = 0.02\n",
         OVR_CHARACTERISTIC},
        {"[contact]\nM = 100\nL = 10\n[supply]\nmodel = film\n"
         "thickness_1 = 0.005\nthickness_2 = 0.005\n",
         OVR_UPSTREAM2},
        {"[contact]\nM = 100\nL = 10\n", OVR_CHARACTERISTIC},
        {"[contact]\nM = 100\nL = 10\n[passes]\nnumber = 2\nloss = 0.1\n",
         OVR_UPSTREAM2},
    };
    for (size_t k = 0; k < sizeof of / sizeof *of; k++) {
        ovr_case *c;
        ovr_setup *s = resolved(join(of[k].text,
                                     "[cavitation]\nmodel = conserving\n"
                                     "[time]\nend = 1\nstep = 0.025\n"),
                                &c);
        assert_int_equal(s->options->scheme, of[k].scheme);
        done(c, s);
    }
}

TEST(words_of_schemes)
{
    for (int k = 0; ovr_scheme_name((ovr_scheme)k); k++) {
        ovr_case *c;
        char setting[64];
        snprintf(setting, sizeof setting, "[time]\nscheme = %s\n",
                 ovr_scheme_name((ovr_scheme)k));
        ovr_setup *s = resolved(join(moes, setting), &c);
        assert_int_equal(s->options->scheme, k);
        done(c, s);
    }
    assert_string_equal(ovr_scheme_name(OVR_CHARACTERISTIC), "characteristic");
}

TEST(oddities_of_text)
{
    ovr_case *c;
    ovr_setup *s = resolved("\357\273\277# with a byte order mark\r\n"
                            "  [ contact ] # the contact\r\n"
                            "\tM=20#comment\r\r\n"
                            "    L : 10\r\n"
                            "; also a comment\r\n"
                            "\r\n"
                            "[feature a b.c]\n"
                            "shape = dent\ndepth=0.1\nwidth = 1\n"
                            "start = -5",
                            &c);
    assert_true(s->contact->M == 20 && s->contact->L == 10);
    assert_int_equal(s->features, 1);
    assert_string_equal(s->feature[0]->name, "a b.c");
    done(c, s);
}

TEST(bad_text_is_refused)
{
    char line[400];
    refused("[lubricant]\n\nviscocity = 1 Pa.s\n",
            "t.ini:3: unknown key 'viscocity' in [lubricant]; did you mean "
            "'viscosity'?");
    refused("[contact]\nM = 1\n\nM = 2", "t.ini:4: 'M' is given twice in "
                                         "[contact] (first in line 2)");
    refused("[contcat]\n", "t.ini:1: unknown section [contcat]; did you mean "
                           "[contact]?");
    refused("[warp]\n", "unknown section [warp]; the sections are");
    refused("M = 3\n", "t.ini:1: a [section] must come before");
    refused("[contact]\nM\n", "t.ini:2: must be 'key = value'");
    refused("[contact]\n= 3\n", "t.ini:2: a key is missing");
    refused("[contact]\nM =\n", "t.ini:2: M: the value is missing");
    refused("[contact\n", "t.ini:1: a section must be [name]");
    refused("[contact] M = 3\n", "t.ini:1: a section must be [name]");
    refused("[feature]\n", "needs a name");
    refused("[contact two]\n", "unknown section");
    refused("[feature a]\nshape = dent\n[feature a]\n",
            "t.ini:3: [feature a] is given twice (first in line 1)");
    refused("\032HDF\n", "t.ini:1: is not text");
    refused("[contact]\nalpha = 1\n", "needs a unit; allowed: 1/Pa");
    refused("[domain]\nM = 3\n", "t.ini:2: unknown key 'M' in [domain]; it "
                                 "is a key of [contact]");
    memset(line, 'x', sizeof line - 1);
    line[sizeof line - 1] = '\0';
    refused(line, "t.ini:1: the line is too long");
    line[60] = '=';
    line[100] = '\0';
    refused(join("[contact]\n", line), "t.ini:2: the key is too long");
    line[0] = '[';
    line[99] = ']';
    refused(line, "is longer than 48");
}

/* ------------------------------------------------------------ consistency */

TEST(contradictions_name_their_line)
{
    refused("", "load is missing");
    refused("[contact]\nM = 20\nL = 10\nload = 3 N/m\n", "t.ini:4: load");
    refused("[contact]\nM = -20\nL = 1\n", "t.ini:2: M: -20 must be");
    refused(join(moes, "alpha = 1 1/GPa\n[lubricant]\nalpha = 2 1/GPa\n"),
            "t.ini:6: alpha: is also set in [contact]");
    refused(join(moes, "[lubricant]\nviscosity_law = oil\n"),
            "t.ini:5: viscosity_law: unknown 'oil'");
    refused(join(roller, "[contact]\nslide_to_roll = 1\n"),
            "t.ini:12: slide_to_roll is already determined");
    refused(join(moes, "[domain]\nlevel = 99\n"), "t.ini:5: level: 99 must");
    refused(join(moes, "[domain]\nnodes = 1800\n"),
            "t.ini:5: nodes: 1800 must be 7 2^k + 1; the nearest such number "
            "is 1793");
    refused(join(moes, "[domain]\nnodes = 1793\nlevel = 8\n"),
            "t.ini:5: nodes: domain.level is also set");
    refused(join(moes, "[domain]\noutlet = 0.5\n"), "t.ini:5: outlet");
    refused(join(moes, "[load]\nto = 2\n"),
            "t.ini:5: to: has no effect with history = constant");
    refused(join(moes, "[load]\nhistory = sine\namplitude = 1\n"),
            "t.ini:5: history: sine");
    refused(join(moes, "[load]\nhistory = table\nfile = nowhere\n"),
            "t.ini:6: file: nowhere: cannot be opened");
    refused(join(moes, "[paper]\nmlmi_order = 5\n"), "t.ini:5: mlmi_order");
    refused(join(moes, "[feature a]\nshape = dent\nwidth = 1\nstart=-5\n"),
            "t.ini:4: feature 'a': a dent needs its depth");
    refused(join(moes, "[feature a]\nwidth = 1\n"),
            "[feature a] needs a shape");
    refused(join(moes, "[domain]\nlevel = 1\n[feature a]\nstart = -5\n"
                       "shape = roughness\nRq = 0.01\nlength = 1e-6\n"),
            "t.ini:6: the profile is 1e-06 b long, shorter than "
            "the mesh size of 0.39");
    refused(join(moes, "[feature a]\nshape = dent\ndepth = 1\nwidth = 1\n"
                       "start = -5\nwavelength = 3\n"),
            "t.ini:9: feature 'a': a dent has no wavelength");
}

TEST(physical_numbers_need_a_physical_contact)
{
    const char *dent = "[feature a]\nshape = dent\ndepth = 0.2 um\n"
                       "width = 0.5\nstart = -5\n";
    ovr_case *c;
    ovr_setup *s;
    refused(join(moes, dent), "t.ini:6: depth: 0.2 um needs a contact with "
                              "dimensions; set radius and modulus");
    refused(join(moes, "[time]\nend = 1 ms\n"), "t.ini:5: end: 1 ms needs a");
    s = resolved(join(roller, dent), &c);
    CHECK_CLOSE(s->feature[0]->depth, 0.2e-6 / s->contact->height, 1e-15);
    assert_true(s->feature[0]->width == 0.5);
    done(c, s);
    /* radius and modulus are enough for lengths */
    s = resolved("[contact]\nM = 20\nL = 10\nradius = 10 mm\n"
                 "modulus = 226 GPa\n"
                 "[output]\nfrom = -100 um\n",
                 &c);
    CHECK_CLOSE(s->output->from, -1e-4 / s->contact->b, 1e-15);
    done(c, s);
}

TEST(same_contact_either_way)
{
    ovr_case *c, *d;
    ovr_setup *s = resolved(roller, &c), *t;
    const ovr_contact *a = s->contact, *b;
    snprintf(text, sizeof text,
             "[contact]\nM = %.17g\nL = %.17g\nradius = 10 mm\n"
             "modulus = 226 GPa\nviscosity = 40 mPa.s\n"
             "slide_to_roll = %.17g\n[lubricant]\nz = 0.68\n",
             a->M, a->L, a->u1_ratio - a->u2_ratio);
    t = resolved(text, &d);
    b = t->contact;
    for (size_t i = 0; i < offsetof(ovr_contact, width) / sizeof(double); i++)
        CHECK_CLOSE(((const double *)b)[i], ((const double *)a)[i], 1e-12);
    CHECK_CLOSE(t->lubricant->P0, s->lubricant->P0, 1e-12);
    CHECK_CLOSE(t->lubricant->A, s->lubricant->A, 1e-12);
    CHECK_CLOSE(t->lubricant->z, s->lubricant->z, 1e-12);
    done(c, s);
    done(d, t);
}

/* --------------------------------------------------------------- settings */

TEST(settings_override_the_file)
{
    ovr_error err = {0};
    ovr_case *c = ovr_case_read_text(moes, "t.ini", NULL, NULL, &err), *d;
    ovr_setup *s, *t;
    CHECK_OK(ovr_case_set(c, "contact.M", "50", "--M", &err), &err);
    CHECK_OK(ovr_case_assign(c, "feature.a.shape = bump", "--set", &err), &err);
    CHECK_OK(ovr_case_assign(c, "feature a.height=0.1", "--set", &err), &err);
    CHECK_OK(ovr_case_assign(c, "feature a.width=1", "--set", &err), &err);
    CHECK_OK(ovr_case_assign(c, "feature a.start=-5", "--set", &err), &err);
    CHECK_OK(ovr_case_assign(c, "contact.slide_to_roll=0.5", "-", &err), &err);
    s = ovr_case_resolve(c, NULL, &err);
    assert_non_null(s);
    assert_true(s->contact->M == 50);
    /* the text with the settings in it is the same case */
    d = ovr_case_read_text(ovr_case_text(c, &err), "u.ini", NULL, NULL, &err);
    if (!d)
        fail_msg("%s in\n%s", err.message, ovr_case_text(c, &err));
    t = ovr_case_resolve(d, NULL, &err);
    assert_non_null(t);
    assert_memory_equal(t->contact, s->contact, sizeof *s->contact);
    assert_int_equal(t->features, 1);
    assert_true(t->feature[0]->height == 0.1);
    done(c, s);
    done(d, t);
}

TEST(bad_settings_name_their_origin)
{
    ovr_error err = {0};
    ovr_case *c = ovr_case_create(NULL, &err);
    ovr_case_set(c, "contact.M", "x", "--M", &err);
    CHECK_ERROR(&err, OVR_BAD_INPUT, "--M: 'x' is not a number");
    ovr_case_assign(c, "contact.N=3", "--set", &err);
    CHECK_ERROR(&err, OVR_BAD_INPUT, "--set: unknown key 'N' in [contact]");
    ovr_case_assign(c, "contact", "--set", &err);
    CHECK_ERROR(&err, OVR_BAD_INPUT, "must be section.key=value");
    ovr_case_assign(c, "contact.M=1#2", "--set", &err);
    CHECK_ERROR(&err, OVR_BAD_INPUT, "must not contain #");
    ovr_case_free(c);
}

TEST(paths_start_at_the_case)
{
    const char *source = join(moes, "[output]\nfile = out.h5\n");
    ovr_error err = {0};
    ovr_case *c = ovr_case_read_text(source, "d/t.ini", "d", NULL, &err);
    ovr_setup *s = ovr_case_resolve(c, NULL, &err);
    assert_string_equal(s->output->file, "d/out.h5");
    ovr_setup_free(s);
    CHECK_OK(ovr_case_set(c, "output.file", "o.h5", "--set", &err), &err);
    s = ovr_case_resolve(c, NULL, &err);
    assert_string_equal(s->output->file, "o.h5");
    done(c, s);
}

TEST_IN_FOLDER(load_from_a_table)
{
    const char *table = test_path(*state, "load.csv");
    const char *path = test_path(*state, "t.ini");
    ovr_error err = {0};
    ovr_case *c;
    ovr_setup *s;
    test_write_text(table, "# T; load\r\n0; 1\r\n\r\n1.5; 2 # end\r\n4;0.5");
    test_write_text(path, join(moes, "[load]\nhistory = table\n"
                                     "file = load.csv\n"));
    c = ovr_case_read(path, NULL, &err);
    assert_non_null(c);
    s = ovr_case_resolve(c, NULL, &err);
    assert_non_null(s);
    CHECK_NEAR(ovr_history_value(s->load, 1.5), 2, 1e-14);
    CHECK_NEAR(ovr_history_value(s->load, 9), 0.5, 1e-14);
    ovr_setup_free(s);
    test_write_text(table, "0 1\n1 -2\n");
    assert_null(ovr_case_resolve(c, NULL, &err));
    CHECK_ERROR(&err, OVR_BAD_INPUT, "load.csv:2: value -2 must be");
    test_write_text(table, "0 1\n1\n");
    assert_null(ovr_case_resolve(c, NULL, &err));
    CHECK_ERROR(&err, OVR_BAD_INPUT, "load.csv:2: must be two numbers");
    test_write_text(table, "0 1\n0 2\n");
    assert_null(ovr_case_resolve(c, NULL, &err));
    CHECK_ERROR(&err, OVR_BAD_INPUT,
                "load.csv:2: the time must increase: 0 follows 0");
    ovr_case_free(c);
}

/* -------------------------------------------------- the table of parameters */

TEST(sweeps_given_on_one_side_leave_the_usual_on_the_other)
{
    static const struct {
        const char *text;
        int before, after;
    } with[] = {{"sweeps_after = 3\n", 1, 3},
                {"sweeps_before = 2\n", 2, 1},
                {"sweeps_before = 0\nsweeps_after = 2\n", 0, 2},
                {"sweeps_after = 3\n[paper]\nsmoother = hybrid\n", 2, 3}};
    for (size_t k = 0; k < sizeof with / sizeof *with; k++) {
        char section[100];
        ovr_case *c;
        snprintf(section, sizeof section, "[solver]\n%s", with[k].text);
        ovr_setup *s = resolved(join(moes, section), &c);
        assert_int_equal(s->options->sweeps_before, with[k].before);
        assert_int_equal(s->options->sweeps_after, with[k].after);
        done(c, s);
    }
}

TEST(defaults_are_the_librarys)
{
    ovr_case *c;
    ovr_setup *s = resolved(moes, &c);
    ovr_options o = test_options(), *t;
    assert_int_equal(s->options->level, o.level); /* a steady contact's */
    done(c, s);
    c = ovr_case_read_text(moes, "t.ini", NULL, NULL, NULL);
    s = ovr_case_resolve(c, NULL, NULL); /* automatic ones still automatic */
    t = s->options;
    assert_int_equal(t->level, OVR_GRID_USUAL);
    assert_int_equal(t->coarsest_level, o.coarsest_level);
    assert_int_equal(t->scheme, o.scheme);
    assert_int_equal(t->smoother, o.smoother);
    assert_int_equal(t->cycle_index, o.cycle_index);
    assert_int_equal(t->sweeps_before, o.sweeps_before);
    assert_int_equal(t->max_cycles, o.max_cycles);
    assert_int_equal(t->cycles, o.cycles);
    assert_int_equal(t->stop, o.stop);
    assert_true(t->inlet == ovr_options_default().inlet);
    assert_true(t->outlet == ovr_options_default().outlet);
    assert_true(t->tolerance == o.tolerance);
    assert_true(t->switch_value == o.switch_value);
    assert_true(t->relax_seidel == o.relax_seidel);
    assert_true(t->relax_dipole == o.relax_dipole);
    assert_int_equal(t->paper_balance, o.paper_balance);
    done(c, s);
}

/* Steps of two mesh sizes need corrections of fourth order.  A start of second
 * order takes steps of one; given steps stay. */
TEST(a_start_of_second_order_has_short_steps)
{
    static const struct {
        const char *step;
        int order;
        double meshes;
    } rows[] = {{"auto", 4, 2}, {"auto", 2, 1}, {"0.013", 2, 0}};
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        char source[200];
        ovr_case *c;
        ovr_setup *s;
        ovr_error err = {0};
        snprintf(source, sizeof source,
                 "%s[domain]\nlevel = 7\n[time]\nend = 1\nstep = %s\n", moes,
                 rows[k].step);
        assert_int_equal(try_case(source, &c, &s, &err), OVR_OK);
        CHECK_OK(ovr_setup_prepare(s, NULL, &err), &err);
        ovr_setup_step_reached(s, rows[k].order);
        CHECK_NEAR(ovr_setup_step(s),
                   rows[k].meshes > 0 ? rows[k].meshes * s->mesh : 0.013,
                   1e-12);
        done(c, s);
    }
}

/* The outlet leaves room for the film's end while high features pass. */
TEST(high_features_move_the_outlet)
{
    static const struct {
        const char *feature;
        double least, most;
    } rows[] = {
        {"shape = ridge\nheight = 0.01\n", 1.5, 1.5},
        {"shape = ridge\nheight = 0.5\n", 1.6, 1.9},
        {"shape = dent\ndepth = 0.5\n", 1.5, 1.5},
        {"shape = ridge\nheight = 30\n", 3, 3},
        {"shape = ridge\nheight = 0.5\n[domain]\noutlet = 1.6\n", 1.6, 1.6}};
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        char source[300];
        ovr_case *c;
        ovr_setup *s;
        ovr_error err = {0};
        snprintf(source, sizeof source,
                 "%s[time]\nend = 1\n[feature f]\nwidth = 0.5\nstart = -5\n%s",
                 moes, rows[k].feature);
        assert_int_equal(try_case(source, &c, &s, &err), OVR_OK);
        CHECK_OK(ovr_setup_prepare(s, NULL, &err), &err);
        assert_true(s->options->outlet >= rows[k].least - 1e-9 &&
                    s->options->outlet <= rows[k].most + 1e-9);
        done(c, s);
    }
}

static ovr_status attempt(void *source, const ovr_allocator *hook,
                          ovr_error *err)
{
    ovr_case *c = ovr_case_read_text(source, "t.ini", ".", hook, err);
    ovr_setup *s = c ? ovr_case_resolve(c, hook, err) : NULL;
    ovr_status status = s ? ovr_setup_prepare(s, hook, err) : err->status;
    done(c, s);
    return status;
}

TEST(every_allocation_may_fail)
{
    char source[2000];
    snprintf(source, sizeof source, "%s%s", roller,
             "[load]\nhistory = ramp\nto = 2\nduration = 1\n"
             "[feature a]\nshape = dent\ndepth = 1 um\nwidth = 1\nstart = -5\n"
             "[output]\nat = 1, 2\nfile = x.h5\n");
    assert_true(test_every_allocation(attempt, source) > 2);
}
