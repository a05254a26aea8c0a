/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A run goes on where it ended, from the checkpoint beside its file.  Without a
 * checkpoint (it was lost, or the run was killed before its first one) it
 * begins again, on the case in the file.
 */
#include <stdarg.h>
#include <stdio.h>
#include <unistd.h>

#include "run/internal.h"

static void say(ovr_run *run, const char *format, ...) OVR_PRINTF(2, 3);
static void say(ovr_run *run, const char *format, ...)
{
    char what[120], text[OVR_MESSAGE_SIZE];
    va_list args;
    va_start(args, format);
    vsnprintf(what, sizeof what, format, args);
    va_end(args);
    snprintf(text, sizeof text, "%.880s: %s", run->info.output, what);
    ovr_run_say(run, OVR_SAY_FILE, text);
}

static bool has_checkpoint(const char *path)
{
    char name[4096];
    int length = snprintf(name, sizeof name, "%s.restart", path);
    return length > 0 && length < (int)sizeof name && access(name, F_OK) == 0;
}

/* The case as the result file holds it, for want of a checkpoint. */
static ovr_case *case_of_result(const ovr_run *run, ovr_error *err)
{
    const char *path = run->info.output;
    ovr_result *result = ovr_result_open(path, &run->arena.allocator, err);
    ovr_case *c = NULL;
    if (result)
        c = ovr_case_read_text(ovr_result_about(result)->case_text, path, NULL,
                               &run->arena.allocator, err);
    ovr_result_close(result);
    return c;
}

static ovr_case *find_case(ovr_run *run, ovr_error *err)
{
    const char *path = run->info.output;
    const ovr_restart_info *about;
    if (access(path, F_OK) != 0 || !has_checkpoint(path))
        return case_of_result(run, err);
    run->restart = ovr_restart_open(path, &run->arena.allocator, err);
    if (!run->restart)
        return NULL;
    about = ovr_restart_about(run->restart);
    return ovr_case_read_text(about->case_text, path, about->case_path,
                              &run->arena.allocator, err);
}

static ovr_status go_back(ovr_run *run, ovr_error *err)
{
    const ovr_state *state = ovr_simulation_state(run->sim);
    if (ovr_output_reopen(run, err))
        return OVR_BAD_INPUT;
    run->restored = run->restart && ovr_restart_about(run->restart)->has_state;
    if (ovr_writer_repaired(run->writer))
        say(run, "its last write had been cut and is repaired");
    if (run->restored)
        say(run, "goes on from T = %g, step %ld", state->T, state->step);
    else
        say(run, "has no checkpoint: the run begins again");
    if (run->restored && run->info.transient)
        run->info.fraction = state->T / run->setup->march->end;
    return OVR_OK;
}

/* Before anything is changed in it. */
static ovr_status as_it_began(ovr_run *run, ovr_error *err)
{
    if (run->restart && ovr_began(run->c, ovr_restart_about(run->restart),
                                  run->info.output, err))
        return OVR_BAD_INPUT;
    run->began = ovr_run_values(run->c, &run->began_count);
    return run->began ? OVR_OK : ovr_fail(err, OVR_NO_MEMORY, "out of memory");
}

static ovr_status prepare(ovr_run *run, const char *path, ovr_error *err)
{
    const ovr_run_options *how = &run->how;
    run->info.output = ovr_arena_text(&run->arena, path, err);
    run->c = run->info.output ? find_case(run, err) : NULL;
    if (!run->c || as_it_began(run, err) ||
        (how->change && how->change(how->data, run->c, err)))
        return OVR_BAD_INPUT;
    return ovr_run_set_up(run, err) ? OVR_BAD_INPUT : go_back(run, err);
}

ovr_run *ovr_run_resume(const char *path, const ovr_run_options *options,
                        const ovr_allocator *allocator, ovr_error *err)
{
    ovr_run *run = ovr_run_make(options, allocator, err);
    if (!run)
        return NULL;
    run->resumed = true;
    if (prepare(run, path, err)) {
        ovr_run_free(run);
        return NULL;
    }
    return run;
}
