/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Solves all cases of a study, alone or together with other hosts. */
#include <errno.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/disk.h"
#include "base/given.h"
#include "base/team.h"
#include "run/internal.h"
#include "run/study_table.h"
#include "run/task.h"

typedef struct sweeping {
    const ovr_study *s;
    ovr_sweep_options how;
    ovr_run_options run;
    ovr_arena arena;
    size_t *task; /* tasks to process */
    size_t tasks, failed;
    ovr_rows *rows; /* in a worker of a study with rows, otherwise NULL */
} sweeping;

/* ------------------------------------------------------------------- tasks */

static int work(void *data, size_t task, ovr_shared shared)
{
    sweeping *w = data;
    ovr_error err = {0};
    if (ovr_study_in_rows(w->s) && !w->rows)
        w->rows = ovr_rows_open(w->s, false, &err);
    return err.status
               ? (int)err.status
               : (int)ovr_task_work(w->s, task, &w->how, shared, w->rows);
}

static void ended(void *data, size_t task, int code, int number)
{
    sweeping *w = data;
    if (number)
        ovr_task_died(w->s, task, number);
    w->failed += number || (code != OVR_OK && code != OVR_STOPPED);
}

static void tick(void *data, size_t count, int running, double done)
{
    const sweeping *w = data;
    if (w->how.progress)
        w->how.progress(w->how.data, count, w->tasks, running, w->failed,
                        done / (double)w->tasks);
}

static bool stop(void *data)
{
    const sweeping *w = data;
    return w->how.stop && w->how.stop(w->how.data);
}

/* Returns the last requested task; `only` is the first. */
static size_t last_of(const sweeping *w)
{
    size_t last = w->s->tasks - 1;
    return w->how.one && w->how.more < last - w->how.only
               ? w->how.only + w->how.more
               : last;
}

static size_t first_of(const sweeping *w)
{
    return w->how.one ? w->how.only : 0;
}

static ovr_status list_tasks(sweeping *w, ovr_error *err)
{
    const size_t first = first_of(w), last = last_of(w);
    w->task = ovr_arena_take(&w->arena, last - first + 1, sizeof *w->task, err);
    if (!w->task)
        return OVR_NO_MEMORY;
    ovr_rows *rows = NULL;
    if (ovr_study_in_rows(w->s) &&
        !(rows = ovr_rows_open(w->s, !w->how.one, err)))
        return err->status;
    for (size_t i = first; i <= last; i++)
        if (ovr_sweep_is_due(&w->how, ovr_task_state(w->s, rows, i)))
            w->task[w->tasks++] = i;
    ovr_rows_close(rows);
    return OVR_OK;
}

/* --------------------------------------------------------------- the sweep */

static ovr_status make_folder(const char *path, ovr_error *err)
{
    struct stat found;
    bool made = mkdir(path, 0777) == 0 || errno == EEXIST;
    if (made && stat(path, &found) == 0 && !S_ISDIR(found.st_mode))
        return ovr_fail(err, OVR_BAD_INPUT,
                        "%s: is a file; the results of a study need a folder",
                        path);
    if (made && access(path, W_OK | X_OK) == 0)
        return OVR_OK;
    return ovr_fail(err, OVR_BAD_INPUT, "%s: cannot be written: %s", path,
                    strerror(errno));
}

static const char table_head[] = "task,name,";

static void manifest_of(const ovr_study *s, char *path, size_t capacity)
{
    snprintf(path, capacity, "%.4300s/manifest.csv", s->output);
}

static ovr_status check_manifest(const ovr_study *s, ovr_error *err)
{
    char path[4400];
    manifest_of(s, path, sizeof path);
    return ovr_file_ours(path, table_head, err);
}

/* Checks, before any run, that no foreign file has the name of a case to be
 * solved or of the manifest. */
static ovr_status check_files(const sweeping *w, ovr_error *err)
{
    ovr_status status = w->how.one ? OVR_OK : check_manifest(w->s, err);
    char path[4400];
    for (size_t i = 0; !status && i < w->tasks; i++)
        if (ovr_task_foreign(w->s, w->task[i])) {
            ovr_study_file(w->s, w->task[i], ".ini", path, sizeof path);
            status = ovr_fail(err, OVR_BAD_INPUT,
                              "%s: exists and is not a case of this study; "
                              "--force replaces it",
                              path);
        }
    return status;
}

/* Checks the cases before they are solved. Fails if all of them have the same
 * error, which would otherwise be repeated for each. */
static ovr_status check_cases(const sweeping *w, ovr_error *err)
{
    ovr_error first = {0};
    if (w->how.one || !ovr_study_random(w->s))
        return OVR_OK;
    for (size_t i = 0; i < w->tasks; i++) {
        ovr_error why = {0};
        ovr_case *c = ovr_study_case(w->s, w->task[i], &why);
        ovr_setup *setup = c ? ovr_case_resolve(c, NULL, &why) : NULL;
        bool good = setup || why.status == OVR_NO_MEMORY;
        ovr_setup_free(setup);
        ovr_case_free(c);
        if (good || (i > 0 && strcmp(why.message, first.message) != 0))
            return OVR_OK;
        first = why;
    }
    return w->tasks > 1 ? ovr_fail(err, first.status, "all %zu draws: %.900s",
                                   w->tasks, first.message)
                        : OVR_OK;
}

static void copy_options(sweeping *w, const ovr_sweep_options *options)
{
    w->how = (ovr_sweep_options){0};
    w->run = (ovr_run_options){0};
    if (options)
        w->how = *options;
    if (w->how.run)
        w->run = *w->how.run;
    w->how.run = &w->run;
}

static int workers_of(const sweeping *w)
{
    int n = w->how.workers > 0 ? w->how.workers : ovr_processors();
    n = n < 1 ? 1 : n > OVR_SWEEP_MAX_WORKERS ? OVR_SWEEP_MAX_WORKERS : n;
    return (int)((size_t)n < w->tasks ? (size_t)n : w->tasks);
}

static ovr_status run(sweeping *w, ovr_error *err)
{
    ovr_pool_job job = {w->tasks, w->task, workers_of(w),
                        work,     ended,   tick,
                        stop,     w,       &w->arena.allocator};
    int stopped = w->tasks ? ovr_pool_run(&job) : 0;
    if (stopped < 0)
        return ovr_fail(err, OVR_IO,
                        "overroll sweep: no worker could be started: %s",
                        strerror(errno));
    return stopped ? ovr_fail(err, OVR_STOPPED,
                              "the sweep was stopped before all cases were "
                              "run; the same command continues it")
                   : OVR_OK;
}

ovr_status ovr_sweep(const ovr_study *study, const ovr_sweep_options *options,
                     ovr_error *err)
{
    if (!study)
        return ovr_fail_null(err, __func__);
    sweeping w = {.s = study};
    copy_options(&w, options);
    if (w.how.one && w.how.only >= study->tasks)
        return OVR_OK;
    ovr_status status = ovr_study_try_draws(study, first_of(&w), last_of(&w),
                                            err);
    if (!status)
        status = make_folder(study->output, err);
    if (status)
        return status;
    w.arena = ovr_arena_make(&study->arena.allocator);
    status = list_tasks(&w, err);
    if (!status && !w.how.force)
        status = check_files(&w, err);
    if (!status)
        status = check_cases(&w, err);
    if (!status)
        status = run(&w, err);
    ovr_arena_release(&w.arena);
    return status;
}

/* --------------------------------------------------------------- the table */

static ovr_status write_table(const ovr_table *t, const char *path, bool force,
                              ovr_error *err)
{
    const char *end = strrchr(path, '.');
    if (end && !strcmp(end, ".csv")) {
        if (!force && ovr_file_ours(path, table_head, err))
            return OVR_BAD_INPUT;
        return ovr_sweep_write_csv(t, path, false, err);
    }
    if (end && (!strcmp(end, ".nc") || !strcmp(end, ".h5"))) {
        if (!force && (ovr_file_ours(path, "\x89HDF", err) ||
                       ovr_sweep_netcdf_ours(path, err)))
            return OVR_BAD_INPUT;
        return ovr_sweep_write_netcdf(t, path, err);
    }
    return ovr_fail(err, OVR_BAD_INPUT,
                    "%s: its name must end with .csv, .nc or .h5", path);
}

static void count(const ovr_table *t, ovr_sweep_totals *totals)
{
    const ovr_table_column *marked = ovr_table_summary(t, "steps_marked");
    *totals = (ovr_sweep_totals){0};
    memcpy(totals->count, t->count, sizeof t->count);
    for (size_t i = 0; marked && i < t->rows; i++)
        totals->marked += marked->number[i] > 0;
}

ovr_status ovr_sweep_collect(const ovr_study *study, const char *path,
                             bool force, ovr_sweep_totals *totals,
                             ovr_error *err)
{
    char manifest[4400];
    ovr_status status = study ? make_folder(study->output, err)
                              : ovr_fail_null(err, __func__);
    if (!status && !force)
        status = check_manifest(study, err);
    if (status)
        return status;
    ovr_table *t = ovr_study_table(study, err);
    if (!t)
        return OVR_NO_MEMORY;
    manifest_of(study, manifest, sizeof manifest);
    status = ovr_sweep_write_csv(t, manifest, true, err);
    if (!status && path)
        status = write_table(t, path, force, err);
    if (!status && totals)
        count(t, totals);
    ovr_table_free(t);
    return status;
}
