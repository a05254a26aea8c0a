/* SPDX-License-Identifier: GPL-3.0-or-later */
#define _DEFAULT_SOURCE /* MAP_ANONYMOUS */
#include "run/trials.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

#include "base/given.h"
#include "case/case.h"
#include "run/pool.h"
#include "run/run.h"

struct ovr_trials {
    ovr_arena arena;
    ovr_trial_plan plan;
    size_t count, bytes;
    ovr_case **cases;
    ovr_trial *trial; /* in memory shared with the forked processes */
};

/* Data of the interrupt function of a run. */
typedef struct asking {
    const ovr_trials *t;
    const volatile int *stop; /* stop flag of forked processes, or NULL */
} asking;

/* ------------------------------------------------------------------ access */

size_t ovr_trials_count(const ovr_trials *trials)
{
    return trials ? trials->count : 0;
}

ovr_case *ovr_trials_case(const ovr_trials *trials, size_t k)
{
    if (!trials || k >= trials->count)
        return NULL;
    return trials->cases[k];
}

bool ovr_trials_steady(const ovr_trials *trials)
{
    return trials && trials->plan.steady;
}

bool ovr_trials_estimate(const ovr_trials *trials)
{
    return trials && trials->plan.estimate;
}

void ovr_trials_put(ovr_trials *trials, size_t k, const char *key,
                    double number)
{
    if (!trials || k >= trials->count || !key)
        return;
    ovr_trial *t = &trials->trial[k];
    if (t->lines == OVR_TRIAL_LINES)
        return;
    snprintf(t->key[t->lines], OVR_TRIAL_KEY, "%s", key);
    t->number[t->lines++] = number;
    t->done = true;
}

void ovr_trials_fail(ovr_trials *trials, size_t k, const char *message)
{
    if (!trials || k >= trials->count)
        return;
    ovr_trial *t = &trials->trial[k];
    t->done = t->failed = true;
    snprintf(t->message, sizeof t->message, "%.*s", (int)sizeof t->message - 1,
             message ? message : "failed");
}

const ovr_trial *ovr_trials_at(const ovr_trials *trials, size_t k)
{
    return &trials->trial[k];
}

double ovr_trial_number(const ovr_trial *trial, const char *key, bool *known)
{
    if (known)
        *known = false;
    for (size_t k = 0; k < trial->lines; k++)
        if (strcmp(trial->key[k], key) == 0) {
            if (known)
                *known = true;
            return trial->number[k];
        }
    return NAN;
}

/* ---------------------------------------------------------------- creation */

ovr_trials *ovr_trials_create(size_t count, ovr_case *const *cases,
                              const ovr_trial_plan *plan, ovr_error *err)
{
    ovr_arena arena = ovr_arena_make(NULL);
    ovr_trials *t = ovr_arena_take(&arena, 1, sizeof *t, err);
    size_t bytes = (count ? count : 1) * sizeof *t->trial;
    void *shared = MAP_FAILED;
    if (t && (t->cases = ovr_arena_take(&arena, count, sizeof *t->cases, err)))
        shared = mmap(NULL, bytes, PROT_READ | PROT_WRITE,
                      MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (shared == MAP_FAILED) {
        ovr_fail(err, OVR_NO_MEMORY, "out of memory: %zu runs", count);
        ovr_arena_release(&arena);
        return NULL;
    }
    memcpy(t->cases, cases, count * sizeof *cases);
    t->plan = *plan;
    t->count = count;
    t->bytes = bytes;
    t->trial = shared;
    t->arena = arena;
    return t;
}

void ovr_trials_free(ovr_trials *trials)
{
    ovr_arena arena;
    if (!trials)
        return;
    for (size_t k = 0; k < trials->count; k++)
        ovr_case_free(trials->cases[k]);
    munmap(trials->trial, trials->bytes);
    arena = trials->arena;
    ovr_arena_release(&arena);
}

bool ovr_case_entry_of(const ovr_case *c, const char *where, size_t length,
                       ovr_case_entry *e)
{
    for (size_t k = 0; k < ovr_case_entries(c); k++) {
        *e = ovr_case_entry_at(c, k);
        if (ovr_entry_is(e, where, length))
            return true;
    }
    return false;
}

ovr_case *ovr_case_apart(ovr_case *c, ovr_error *err)
{
    const char *text = ovr_case_text(c, err);
    const char *name = ovr_case_name(c);
    ovr_case *own = text ? ovr_case_read_text(text, name ? name : "case",
                                              ovr_case_directory(c), NULL, err)
                         : NULL;
    if (own)
        ovr_case_unset(own, "output.file");
    return own;
}

/* ----------------------------------------------------------------- running */

/* Receiver of a run's summary. */
typedef struct putting {
    ovr_trials *trials;
    size_t k;
} putting;

static void store_line(void *data, const ovr_summary_line *line)
{
    const putting *p = data;
    if (line->key && line->form <= OVR_SUMMARY_FLAG)
        ovr_trials_put(p->trials, p->k, line->key, line->number);
}

static bool stop(void *data)
{
    const asking *a = data;
    const ovr_trial_plan *plan = &a->t->plan;
    return (a->stop && *a->stop) || (plan->stop && plan->stop(plan->data));
}

/* Opens the run of a trial. An existing file is resumed. A complete file
 * without checkpoint has no extremes and is computed again. */
static ovr_run *open_run(const ovr_trials *t, size_t k, ovr_run_options *how,
                         ovr_error *err)
{
    ovr_run *run = NULL;
    if (t->plan.files) {
        how->output = t->plan.files[k];
        how->force = how->from_start = true;
        if (access(how->output, F_OK) == 0)
            run = ovr_run_resume(how->output, how, NULL, err);
        if (run || err->status == OVR_STOPPED)
            return run;
        *err = (ovr_error){0};
        how->from_start = false;
    }
    return ovr_run_create(t->cases[k], how, NULL, err);
}

/* A steady solution above its tolerance is rejected; a run with flagged steps
 * is accepted and flagged. */
static ovr_status run_one(ovr_trials *t, size_t k, asking *asked)
{
    putting to = {t, k};
    ovr_run_options how = {0};
    ovr_error err = {0};
    how.steady = t->plan.steady;
    how.estimate_error = t->plan.estimate;
    how.no_thread = true;
    how.data = asked;
    how.stop = how.interrupt = stop;
    ovr_run *run = open_run(t, k, &how, &err);
    if (run && ovr_run_execute(run, &err) == OVR_OK) {
        const ovr_run_info *about = ovr_run_get_info(run);
        ovr_run_summary(about, store_line, &to);
        ovr_setup_scales(about->setup, store_line, &to);
        if (!about->transient && !about->converged)
            ovr_trials_fail(t, k, "the solution did not converge");
    } else if (err.status != OVR_STOPPED) {
        ovr_trials_fail(t, k, err.message);
    }
    ovr_run_free(run);
    return err.status == OVR_STOPPED ? OVR_STOPPED : OVR_OK;
}

static void by_formulas(ovr_trials *t, size_t k)
{
    putting to = {t, k};
    ovr_error err = {0};
    ovr_setup *setup = ovr_case_resolve(t->cases[k], NULL, &err);
    if (setup)
        ovr_setup_scales(setup, store_line, &to);
    else
        ovr_trials_fail(t, k, err.message);
    ovr_setup_free(setup);
}

static int work(void *data, size_t k, ovr_shared shared)
{
    ovr_trials *t = data;
    asking asked = {t, shared.stop};
    return (int)run_one(t, k, &asked);
}

static void ended(void *data, size_t k, int code, int number)
{
    char message[80];
    if (!number && code != OVR_OK && code != OVR_STOPPED)
        snprintf(message, sizeof message, "ended with code %d", code);
    else if (number)
        snprintf(message, sizeof message, "killed by signal %d", number);
    else
        return;
    ovr_trials_fail(data, k, message);
}

static void tick(void *data, size_t done, int running, double part)
{
    (void)data, (void)done, (void)running, (void)part;
}

static bool stop_all(void *data)
{
    const ovr_trials *t = data;
    return t->plan.stop && t->plan.stop(t->plan.data);
}

static ovr_status by_processes(ovr_trials *t, ovr_error *err)
{
    size_t *task = ovr_arena_take(&t->arena, t->count, sizeof *task, err);
    int maximum = (size_t)t->plan.workers < t->count ? t->plan.workers
                                                     : (int)t->count;
    if (!task)
        return OVR_NO_MEMORY;
    for (size_t k = 0; k < t->count; k++)
        task[k] = k;
    ovr_pool_job job = {t->count, task,     maximum, work, ended,
                        tick,     stop_all, t,       NULL};
    int code = ovr_pool_run(&job);
    if (code < 0)
        return ovr_fail(err, OVR_IO, "no process could be started: %s",
                        strerror(errno));
    return code ? ovr_fail(err, OVR_STOPPED, "stopped") : OVR_OK;
}

ovr_status ovr_trials_execute(ovr_trials *t, ovr_error *err)
{
    asking asked = {t, NULL};
    ovr_status status = OVR_OK;
    if (t->plan.formulas) {
        for (size_t k = 0; k < t->count; k++)
            by_formulas(t, k);
        return OVR_OK;
    }
    if (t->plan.run)
        status = t->plan.run(t->plan.data, t, err);
    else if (t->plan.workers > 1 && t->count > 1)
        status = by_processes(t, err);
    else
        for (size_t k = 0; !status && k < t->count; k++)
            status = run_one(t, k, &asked);
    if (status == OVR_STOPPED)
        return ovr_fail(err, OVR_STOPPED, "stopped");
    for (size_t k = 0; !status && k < t->count; k++)
        if (!t->trial[k].done)
            ovr_trials_fail(t, k, "nobody ran it");
    return status;
}
