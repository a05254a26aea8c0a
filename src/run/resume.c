/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Resumes a run from the checkpoint of its file. A run killed before its first
 * checkpoint starts again with the case in the file. If the checkpoint is lost,
 * the run starts again only on request, because computed results are replaced.
 * A complete file is not changed.
 */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "base/given.h"
#include "case/case.h"
#include "case/resolve.h"
#include "results/checkpoint.h"
#include "results/results.h"
#include "run/internal.h"
#include "run/pass_series.h"

static void note(ovr_run *run, const char *format, ...) OVR_PRINTF(2, 3);
static void note(ovr_run *run, const char *format, ...)
{
    char what[120], text[OVR_MESSAGE_SIZE];
    va_list args;
    va_start(args, format);
    vsnprintf(what, sizeof what, format, args);
    va_end(args);
    snprintf(text, sizeof text, "%.880s: %s", run->info.output, what);
    ovr_run_message(run, OVR_MESSAGE_FILE, text);
}

static bool has_checkpoint(const char *path)
{
    char name[4096];
    int length = snprintf(name, sizeof name, "%s.restart", path);
    return length > 0 && length < (int)sizeof name && access(name, F_OK) == 0;
}

/* Reads the case from the result file, and in *complete the end time of a
 * complete file, otherwise -INFINITY. A checkpoint of another run is rejected
 * later by the writer. */
static ovr_case *read_result(ovr_run *run, double *complete, ovr_error *err)
{
    const char *path = run->info.output;
    ovr_result *result = ovr_result_open(path, &run->arena.allocator, err);
    const ovr_result_info *about = result ? ovr_result_get_info(result) : NULL;
    ovr_case *c = NULL;
    *complete = -INFINITY;
    if (about && !run->restart)
        c = ovr_case_read_stored(about->case_text, path, NULL,
                                 &run->arena.allocator, err);
    if (about && strcmp(about->status, "complete") == 0 &&
        (!run->restart ||
         strcmp(ovr_restart_created(run->restart), about->created) == 0))
        *complete = isnan(about->end) ? INFINITY : about->end;
    if (about) {
        run->info.snapshots = about->snapshots;
        run->title = ovr_arena_text(&run->arena, about->title, NULL);
    }
    ovr_result_close(result);
    return c;
}

static ovr_case *find_case(ovr_run *run, double *complete, ovr_error *err)
{
    const char *path = run->info.output;
    const ovr_restart_info *about;
    if (access(path, F_OK) != 0 || !has_checkpoint(path))
        return read_result(run, complete, err);
    run->restart = ovr_restart_open(path, &run->arena.allocator, err);
    if (!run->restart)
        return NULL;
    read_result(run, complete, NULL);
    about = ovr_restart_get_info(run->restart);
    return ovr_case_read_stored(about->case_text, path, about->case_path,
                                &run->arena.allocator, err);
}

/* Fails unless the run may be repeated from the start, since there is no
 * checkpoint and the results in the file would be lost. */
static ovr_status begin_again(ovr_run *run, bool done, ovr_error *err)
{
    if (run->how.from_start && run->how.force)
        return OVR_OK;
    if (!done)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "%s: has no checkpoint to continue from; "
                        "--from-start --force repeats the run from the start",
                        run->info.output);
    ovr_fail(err, OVR_OK, "%s: run is already complete", run->info.output);
    return OVR_BAD_INPUT;
}

static void report_state(ovr_run *run, bool done)
{
    const ovr_state *state = ovr_simulation_state(run->sim);
    if (run->writer && ovr_writer_repaired(run->writer))
        note(
            run,
            "last write was interrupted; file restored to the last checkpoint");
    if (done && run->passes) /* already reported for all passes */
        return;
    if (done)
        note(run, "run is already complete");
    else if (run->restored)
        note(run, "continuing from T = %g, step %ld", state->T, state->step);
    else
        note(run, "has no checkpoint; the run starts again");
    if (run->restored && run->info.transient)
        run->info.fraction = fmin(state->T / run->setup->march->end, 1);
}

static ovr_status restore_state(ovr_run *run, double complete, ovr_error *err)
{
    bool done = !run->info.transient || run->setup->march->end <= complete;
    done = done && complete > -INFINITY;
    if (!run->restart && begin_again(run, done, err))
        return OVR_BAD_INPUT;
    done = done && run->restart;
    if (done)
        ovr_companions_set_path(run);
    if (ovr_output_reopen(run, !done, err))
        return OVR_BAD_INPUT;
    run->restored = run->restart &&
                    ovr_restart_get_info(run->restart)->has_state;
    report_state(run, done);
    return OVR_OK;
}

/* Stores the parameters recorded in the file, before the case is changed. */
static ovr_status store_recorded(ovr_run *run, ovr_error *err)
{
    ovr_case_mark_stored(run->c);
    run->recorded = ovr_run_values(run->c, &run->arena, &run->recorded_count);
    return run->recorded ? OVR_OK
                         : ovr_fail(err, OVR_NO_MEMORY, "out of memory");
}

static ovr_status prepare(ovr_run *run, const char *path, ovr_error *err)
{
    const ovr_run_options *how = &run->how;
    double complete = -INFINITY;
    run->info.output = ovr_arena_text(&run->arena, path, err);
    run->c = run->info.output ? find_case(run, &complete, err) : NULL;
    if (!run->c || store_recorded(run, err) ||
        (how->change && how->change(how->data, run->c, err)))
        return OVR_BAD_INPUT;
    if (ovr_run_set_up(run, err))
        return OVR_BAD_INPUT;
    const ovr_physics *maker = ovr_setup_makes_nodes(run->setup);
    if (maker)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "%s: a solution with %s is not computed in steps and "
                        "cannot be resumed",
                        path, maker->name);
    return restore_state(run, complete, err);
}

/* Completes a series whose passes all have files. The row of the last pass is
 * added if the program was killed before writing it. The report is that of the
 * last pass, if its checkpoint exists. */
static ovr_status complete_series(ovr_run *run, int last, ovr_error *err)
{
    const char *path = run->passes->path;
    bool whole = ovr_passes_file_complete(path);
    if (!whole && ovr_passes_finish(run, last, err))
        return OVR_BAD_INPUT;
    ovr_case_free(run->c);
    run->c = NULL;
    if (ovr_passes_go_back(run, last, err))
        return OVR_BAD_INPUT;
    ovr_fail(err, OVR_OK,
             whole ? "%s: run is already complete"
                   : "%s: all passes are complete; the last row was written",
             path);
    if (!has_checkpoint(run->info.output))
        return OVR_BAD_INPUT;
    ovr_run_message(run, OVR_MESSAGE_FILE, err->message);
    return prepare(run, run->info.output, err);
}

/* Begins a pass that has no file yet. */
static ovr_status begin_pass(ovr_run *run, ovr_error *err)
{
    const ovr_run_options *how = &run->how;
    ovr_passes *p = run->passes;
    run->c = ovr_passes_case(p->path, &run->arena.allocator, err);
    if (!run->c || (how->change && how->change(how->data, run->c, err)))
        return OVR_BAD_INPUT;
    run->setup = ovr_case_resolve(run->c, &run->arena.allocator, err);
    if (!run->setup)
        return OVR_BAD_INPUT;
    if (p->now > run->setup->passes->number)
        return complete_series(run, run->setup->passes->number, err);
    if (ovr_run_set_up(run, err))
        return OVR_BAD_INPUT;
    if (ovr_passes_at_rest(run, p->now - 1))
        return complete_series(run, p->now - 1, err);
    ovr_passes_recall(run);
    return ovr_output_open(run, err);
}

/* Continues the first incomplete pass. A pass that was killed between its first
 * checkpoint and the renaming of its file is begun again. */
static ovr_status prepare_passes(ovr_run *run, const char *path, ovr_error *err)
{
    if (ovr_passes_reopen(run, path, err))
        return OVR_BAD_INPUT;
    if (access(run->info.output, F_OK) != 0 ||
        !has_checkpoint(run->info.output))
        return begin_pass(run, err);
    ovr_passes_recall(run);
    return prepare(run, run->info.output, err);
}

ovr_run *ovr_run_resume(const char *path, const ovr_run_options *options,
                        const ovr_allocator *allocator, ovr_error *err)
{
    if (!path)
        return ovr_null(err, __func__);
    ovr_run *run = ovr_run_make(options, allocator, err);
    if (!run)
        return NULL;
    run->resumed = true;
    if (ovr_passes_file_is(path) ? prepare_passes(run, path, err)
                                 : prepare(run, path, err)) {
        ovr_run_free(run);
        return NULL;
    }
    return run;
}
