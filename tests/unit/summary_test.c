/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The summary of a run is stored in its file, to the bit. Tables of studies
 * are made from these summaries or, without files, from the rows written by
 * the processes. */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "overroll/overroll.h"
#include "results/results.h"
#include "run/run.h"
#include "support/test.h"

static const char text[] = "[contact]\nM = 20\nL = 10\nalpha = 20 1/GPa\n"
                           "[domain]\nlevel = 3\n[time]\nend = 0.3\n";

/* ------------------------------------------------------------------- a run */

typedef struct held {
    const ovr_group_attribute *line;
    size_t count, matched, numbers;
} held;

/* Every number that is known but two is there, and is the same. */
static void compare(void *data, const ovr_summary_line *line)
{
    held *h = data;
    bool elsewhere = !strcmp(line->key, "snapshots") ||
                     !strcmp(line->key, "seconds");
    if (line->form == OVR_SUMMARY_TEXT || elsewhere || !isfinite(line->number))
        return;
    h->numbers++;
    for (size_t k = 0; k < h->count; k++)
        if (!strcmp(h->line[k].name, line->key) &&
            !memcmp(&h->line[k].number, &line->number, sizeof(double)))
            h->matched++;
}

TEST_IN_FOLDER(a_file_holds_its_summary)
{
    const char *path = test_path(*state, "a.h5");
    ovr_error err = {0};
    ovr_run_options how = {0};
    ovr_case *c = ovr_case_read_text(text, "a.ini", NULL, NULL, &err);
    held h = {0};
    how.output = path;
    how.estimate_error = true;
    assert_non_null(c);
    ovr_run *run = ovr_run_create(c, &how, NULL, &err);
    assert_non_null(run);
    CHECK_OK(ovr_run_execute(run, &err), &err);
    ovr_result *result = ovr_result_open(path, NULL, &err);
    assert_non_null(result);
    h.line = ovr_result_attributes(result, "summary", &h.count);
    ovr_run_summary(ovr_run_get_info(run), compare, &h);
    assert_true(h.numbers > 60 && h.matched == h.numbers &&
                h.count == h.numbers);
    assert_string_equal(h.line[0].name, "converged");
    assert_null(ovr_result_attributes(result, "sumary", &h.count));
    assert_int_equal(h.count, 0);
    ovr_result_close(result);
    ovr_run_free(run);
    ovr_case_free(c);
}

/* ----------------------------------------------------------------- studies */

static double largest_pressure(const ovr_study *study, size_t row)
{
    ovr_error err = {0};
    ovr_table *table = ovr_study_table(study, &err);
    const ovr_table_column *c;
    double P = NAN;
    assert_non_null(table);
    for (size_t k = 0; (c = ovr_table_at(table, k)); k++)
        if (!strcmp(c->name, "P_max_overall"))
            P = c->number[row];
    ovr_table_free(table);
    return P;
}

static void check_study(const char *folder, const char *name, bool results)
{
    const char *path = test_path(folder, name);
    char of_study[256], file[80];
    ovr_error err = {0};
    ovr_sweep_options how = {0};
    test_write_text(test_path(folder, "base.ini"), text);
    snprintf(of_study, sizeof of_study,
             "[study]\ncase = base.ini\nresults = %s\n[product]\n"
             "contact.M = 10, 20\n",
             results ? "yes" : "no");
    test_write_text(path, of_study);
    ovr_study *study = ovr_study_read(path, NULL, &err);
    assert_non_null(study);
    how.workers = 1;
    CHECK_OK(ovr_sweep(study, &how, &err), &err);
    snprintf(file, sizeof file, "%.*s/M=20.h5", (int)strcspn(name, "."), name);
    assert_int_equal(access(test_path(folder, file), F_OK) == 0, results);
    assert_true(largest_pressure(study, 0) > 0.8);
    assert_true(largest_pressure(study, 1) > largest_pressure(study, 0));
    ovr_study_free(study);
}

TEST_IN_FOLDER(studies_need_no_report)
{
    check_study(*state, "with.ini", true);
    check_study(*state, "without.ini", false);
}
