/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "run/pass_series.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "base/error.h"
#include "results/results.h"
#include "run/forms.h"

static ovr_status make(ovr_run *run, const char *path, ovr_error *err)
{
    ovr_passes *p = ovr_arena_take(&run->arena, 1, sizeof *p, err);
    run->passes = p;
    if (!p)
        return OVR_NO_MEMORY;
    p->now = 1;
    p->oil_flooded = NAN;
    p->converged = true;
    p->path = ovr_arena_text(&run->arena, path, err);
    return p->path ? OVR_OK : OVR_NO_MEMORY;
}

/* ---------------------------------------------------------------- a new run */

/* Files of passes from before, which would be resumed. */
static ovr_status clear(ovr_run *run, ovr_error *err)
{
    static const char *const endings[] = {"", ".restart", ".journal"};
    const ovr_passes *p = run->passes;
    for (int k = 0; k < p->rows; k++) {
        ovr_status status = ovr_output_check(p->file[k], run->c, run->how.force,
                                             err);
        if (status)
            return status;
    }
    for (int k = 0; k < p->rows; k++)
        for (size_t e = 0; e < sizeof endings / sizeof *endings; e++) {
            char path[4500];
            snprintf(path, sizeof path, "%.4400s%s", p->file[k], endings[e]);
            unlink(path);
        }
    run->how.force = true;
    return OVR_OK;
}

ovr_status ovr_passes_begin(ovr_run *run, ovr_error *err)
{
    ovr_status status;
    if (!run->info.output)
        return ovr_fail_about(err, "number",
                              "several passes need a result file: -o OUT.h5, "
                              "or file in [output]; of find: --results FOLDER; "
                              "of a study: results = yes; --sensitivity has "
                              "none, a study of the key's values does");
    status = make(run, run->info.output, err);
    if (!status)
        status = ovr_passes_make_rows(run, run->setup->passes->number, err);
    if (!status)
        status = clear(run, err);
    if (!status)
        status = ovr_run_set_up(run, err);
    if (!status)
        status = ovr_passes_write(run, "running", err);
    return status ? status : ovr_output_open(run, err);
}

/* ------------------------------------------------------------- going through
 */

/* All of the pass that was. */
static void forget(ovr_run *run)
{
    ovr_companions_release(run);
    ovr_simulation_free(run->sim);
    ovr_setup_free(run->setup);
    ovr_restart_close(run->restart);
    run->sim = NULL;
    run->setup = NULL;
    run->restart = NULL;
    run->restored = false;
    run->info.sim = NULL;
    run->info.setup = NULL;
    run->info.stress[0] = run->info.stress[1] = NULL;
}

static ovr_status next(ovr_run *run, ovr_error *err)
{
    ovr_status status;
    forget(run);
    run->passes->now++;
    status = ovr_run_set_up(run, err);
    return status ? status : ovr_output_open(run, err);
}

/* The row of a pass that ended. */
static ovr_status end_pass(ovr_run *run, ovr_error *err)
{
    ovr_pass_end end;
    ovr_status status = ovr_passes_learn(run, run->passes->now, &end, err);
    if (!status)
        ovr_pass_end_free(&end);
    return status;
}

static ovr_status write_rows(ovr_run *run, const char *how, ovr_error *err)
{
    return run->passes->whole ? OVR_OK : ovr_passes_write(run, how, err);
}

ovr_status ovr_passes_go(ovr_run *run, ovr_error *err)
{
    static const char *const names[] = {"complete", "stopped", "failed"};
    ovr_passes *p = run->passes;
    ovr_status status = OVR_OK;
    for (bool more = true; !status && more;) {
        status = write_rows(run, "running", err);
        if (!status)
            status = ovr_run_once(run, err);
        p->converged = p->converged && (status || run->info.converged);
        if (!status)
            status = end_pass(run, err);
        run->info.shaken_down = !status && ovr_passes_at_rest(run, p->now);
        if (run->info.shaken_down)
            run->info.passes = p->rows = p->now; /* no more are asked for */
        more = p->now < p->rows;
        if (!status && more)
            status = next(run, err);
    }
    const char *how = names[!status ? 0 : status == OVR_STOPPED ? 1 : 2];
    ovr_error late = {0};
    if (status)
        p->row[p->now - 1].status = how;
    if (run->setup && write_rows(run, how, &late) && !status) {
        *err = late;
        status = late.status;
    }
    run->info.converged = run->info.converged && p->converged;
    return status;
}

/* ---------------------------------------------------------------- resuming */

static void recall(ovr_run *run, ovr_result *result)
{
    size_t count = 0;
    const ovr_group_attribute *line = ovr_result_attributes(result, "summary",
                                                            &count);
    for (size_t k = 0; k < count; k++) {
        if (strcmp(line[k].name, "converged") == 0 && line[k].number == 0)
            run->passes->converged = false;
        if (strcmp(line[k].name, "steps_marked") == 0)
            run->info.marked += (long)line[k].number;
    }
    ovr_run_recall(run, ovr_result_about(result)->warnings);
}

void ovr_passes_recall(ovr_run *run)
{
    if (run->passes->before)
        recall(run, run->passes->before);
    ovr_passes_close(run->passes);
}

/* NULL: there is none, or it is not complete. */
static ovr_result *open_complete(const char *path)
{
    ovr_result *result = access(path, F_OK) == 0
                             ? ovr_result_open(path, NULL, NULL)
                             : NULL;
    if (result && strcmp(ovr_result_about(result)->status, "complete") == 0)
        return result;
    ovr_result_close(result);
    return NULL;
}

ovr_status ovr_passes_reopen(ovr_run *run, const char *path, ovr_error *err)
{
    ovr_status status = make(run, path, err);
    const char *file = NULL;
    if (status)
        return status;
    for (run->passes->now = 1;; run->passes->now++) {
        file = ovr_passes_file_of(run, run->passes->now, err);
        if (!file)
            return OVR_NO_MEMORY;
        ovr_result *complete = open_complete(file);
        if (!complete)
            break;
        ovr_passes_recall(run);
        run->passes->before = complete;
    }
    run->info.output = file;
    run->how.force = true;
    return OVR_OK;
}

ovr_status ovr_passes_finish(ovr_run *run, int last, ovr_error *err)
{
    run->passes->now = last;
    ovr_status status = ovr_passes_feed(run, err);
    if (!status)
        status = end_pass(run, err);
    run->passes->rows = last;
    return status ? status : ovr_passes_write(run, "complete", err);
}

ovr_status ovr_passes_go_back(ovr_run *run, int last, ovr_error *err)
{
    forget(run);
    run->passes->now = last;
    run->passes->whole = true;
    ovr_passes_close(run->passes);
    run->info.output = ovr_passes_file_of(run, last, err);
    return run->info.output ? OVR_OK : OVR_NO_MEMORY;
}
