/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Each quantity has one name: reports, result files and extremes over a run use
 * the name in its row. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "overroll/overroll.h"
#include "run/comparison.h"
#include "support/test.h"

/* ------------------------------------------------------------- the table */

static bool begins(const char *text, const char *with)
{
    return !strncmp(text, with, strlen(with));
}

/* A label is the name itself; only " at a node" may be missing. */
TEST(labels_are_the_names_of_files)
{
    const ovr_observable *row;
    int labels = 0;
    for (size_t k = 0; (row = ovr_observable_at(k)); k++) {
        assert_non_null(row->long_name);
        if (!row->label)
            continue;
        labels++;
        if (!begins(row->long_name, row->label) ||
            (strcmp(row->long_name, row->label) != 0 &&
             strcmp(row->long_name + strlen(row->label), " at a node") != 0))
            fail_msg("'%s' is called '%s'", row->long_name, row->label);
        if (strlen(row->label) > OVR_LABEL_WIDTH)
            fail_msg("'%s' is wider than its column", row->label);
    }
    assert_true(labels > 20);
}

TEST(extremes_and_means_have_the_name_of_their_quantity)
{
    ovr_extreme e;
    size_t k = 0;
    for (; ovr_extreme_at(k, &e); k++) {
        const char *name = strstr(e.label, e.of->long_name);
        const ovr_quantity_name named = ovr_quantity_named(e.key);
        bool reported = e.part == OVR_KEPT_MEAN ? e.of->mean_reported
                                                : e.of->extreme_reported;
        if (!name || strlen(name) != strlen(e.of->long_name))
            fail_msg("%s: '%s' is called '%s'", e.key, e.of->long_name,
                     e.label);
        if (!strstr(e.long_name, e.label) || !strstr(e.long_name, "the run"))
            fail_msg("%s: '%s'", e.key, e.long_name);
        if (reported && strlen(e.label) > OVR_LABEL_WIDTH)
            fail_msg("'%s' is wider than its column", e.label);
        assert_string_equal(named.text, e.long_name);
    }
    assert_true(k > 40);
    assert_string_equal(ovr_quantity_named("H_min_overall_m").text,
                        "minimum film thickness over the run");
    assert_string_equal(ovr_quantity_named("H_min_overall_m").unit, "m");
    assert_string_equal(ovr_quantity_named("P_max").unit, "p_h");
    assert_string_equal(ovr_quantity_named("mu_slide_max").text,
                        "largest sliding friction coefficient over the run");
}

/* ----------------------------------------------------------- the reports */

enum { LINES = 200 };

typedef struct page {
    char label[LINES][80];
    size_t lines;
} page;

static void keep(void *data, const ovr_summary_line *line)
{
    page *p = data;
    if (line->form != OVR_SUMMARY_WORDS_BEHIND || p->lines == LINES)
        return;
    snprintf(p->label[p->lines++], 80, "%s", line->label);
}

static bool has(const page *p, const char *label)
{
    for (size_t k = 0; k < p->lines; k++)
        if (!strcmp(p->label[k], label))
            return true;
    return false;
}

/* Numbers of a report that are not quantities of a step. */
static bool is_of_the_run(const char *label)
{
    static const char *const keys[] = {"film_Rq_predicted", "H_min_predicted",
                                       "lambda_ratio", NULL};
    for (int k = 0; keys[k]; k++)
        if (!strcmp(ovr_quantity_named(keys[k]).text, label))
            return true;
    return !strcmp(label, "time steps") || !strcmp(label, "computing time");
}

static bool is_a_name(const char *label)
{
    const ovr_observable *row;
    ovr_extreme e;
    for (size_t k = 0; (row = ovr_observable_at(k)); k++)
        if (!strcmp(row->long_name, label) ||
            (row->label && !strcmp(row->label, label)))
            return true;
    for (size_t k = 0; ovr_extreme_at(k, &e); k++)
        if (!strcmp(e.label, label))
            return true;
    return is_of_the_run(label);
}

static void check_report(const char *text, bool transient)
{
    static page p;
    ovr_error err = {0};
    ovr_run_options how = {0};
    ovr_case *c = ovr_case_read_text(text, "a.ini", NULL, NULL, &err);
    assert_non_null(c);
    ovr_run *run = ovr_run_create(c, &how, NULL, &err);
    assert_non_null(run);
    CHECK_OK(ovr_run_execute(run, &err), &err);
    p.lines = 0;
    ovr_run_report(ovr_run_get_info(run), keep, &p);
    for (size_t k = 0; k < p.lines; k++) {
        if (!is_a_name(p.label[k]))
            fail_msg("'%s' is no quantity", p.label[k]);
        if (strlen(p.label[k]) > OVR_LABEL_WIDTH)
            fail_msg("'%s' is wider than its column", p.label[k]);
    }
    /* Quantities that these reports must contain. */
    assert_true(has(&p, "minimum film thickness"));
    assert_true(has(&p, "central film thickness"));
    assert_true(has(&p, "sliding friction coefficient"));
    assert_true(has(&p, "maximum film temperature"));
    if (transient) {
        assert_true(has(&p, "mean central film thickness"));
        assert_true(has(&p, "maximum film thickness roughness Rq"));
    } else {
        assert_true(has(&p, "mean film thickness"));
    }
    ovr_run_free(run);
    ovr_case_free(c);
}

static const char hot[] =
    "[contact]\nload = 300 kN/m\nradius = 8 mm\nmodulus = 226 GPa\n"
    "mean_speed = 1 m/s\nslide_to_roll = 0.2\nRq_1 = 0.1 um\n"
    "[lubricant]\nalpha = 20 1/GPa\nviscosity = 40 mPa.s\n"
    "rheology = eyring\neyring_stress = 5 MPa\n[heat]\nmodel = "
    "lobatto\ntemperature = 40 degC\n"
    "[domain]\nlevel = 4\n";

TEST(a_steady_report_has_names_of_the_table)
{
    check_report(hot, false);
}

TEST(a_report_of_a_run_has_names_of_the_table)
{
    char text[1000];
    snprintf(text, sizeof text,
             "%s[time]\nend = 0.2\n[feature w]\nshape = wave\n"
             "amplitude = 0.01\nwavelength = 1\n",
             hot);
    check_report(text, true);
}
