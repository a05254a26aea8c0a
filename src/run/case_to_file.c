/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs a case and writes its result file. */
#include <math.h>
#include <string.h>
#include <time.h>

#include "base/given.h"
#include "case/resolve.h"
#include "contact/contact.h"
#include "results/results.h"
#include "run/internal.h"
#include "run/pass_series.h"
#include "run/run.h"
#include "simulation/internal.h"

ovr_run *ovr_run_make(const ovr_run_options *options,
                      const ovr_allocator *allocator, ovr_error *err)
{
    ovr_arena arena = ovr_arena_make(allocator);
    ovr_run *run = ovr_arena_take(&arena, 1, sizeof *run, err);
    if (!run)
        return NULL;
    run->arena = arena;
    run->info.error = &run->error;
    run->info.predicted = &run->predicted;
    if (options)
        run->how = *options;
    run->force = run->how.force;
    return run;
}

/* Removes the growth of features: a steady solution has fully grown features,
 * as at the end of a run in time. */
static void stop_growing(ovr_case *c)
{
    for (size_t k = 0; k < ovr_case_entries(c); k++) {
        ovr_case_entry entry = ovr_case_entry_at(c, k);
        char where[128];
        if (!entry.name || !entry.given || strncmp(entry.key, "grow", 4) != 0)
            continue;
        snprintf(where, sizeof where, "feature %s.%s", entry.name, entry.key);
        ovr_case_unset(c, where);
    }
}

/* Chooses the path of the result file and checks that it can be written, before
 * anything large is allocated. */
static ovr_status choose_output(ovr_run *run, ovr_error *err)
{
    const char *path = run->how.output;
    if (!path)
        path = run->setup->output->file;
    if (!path || run->how.steady)
        return OVR_OK;
    run->info.output = ovr_arena_text(&run->arena, path, err);
    return run->info.output
               ? ovr_output_check(path, run->c, run->how.force, err)
               : OVR_NO_MEMORY;
}

static ovr_status resolve(ovr_run *run, ovr_error *err)
{
    run->c->standing = !run->how.steady ? NULL : run->how.at ? run->how.at : "";
    if (run->how.steady)
        stop_growing(run->c);
    run->setup = ovr_case_resolve(run->c, &run->arena.allocator, err);
    return run->setup ? OVR_OK : OVR_BAD_INPUT;
}

static ovr_status prepare(ovr_run *run, ovr_error *err)
{
    if (resolve(run, err) || choose_output(run, err))
        return OVR_BAD_INPUT;
    if (run->setup->passes->number > 1 && !run->how.steady)
        return ovr_passes_begin(run, err);
    if (ovr_run_set_up(run, err))
        return OVR_BAD_INPUT;
    return run->info.output && !ovr_setup_makes_nodes(run->setup)
               ? ovr_output_open(run, err)
               : OVR_OK;
}

ovr_run *ovr_run_create(ovr_case *c, const ovr_run_options *options,
                        const ovr_allocator *allocator, ovr_error *err)
{
    if (!c)
        return ovr_null(err, __func__);
    ovr_run *run = ovr_run_make(options, allocator, err);
    if (!run)
        return NULL;
    run->c = c;
    if (prepare(run, err)) {
        ovr_run_free(run);
        return NULL;
    }
    return run;
}

ovr_run *ovr_run_unsolved(ovr_case *c, const ovr_run_options *options,
                          ovr_error *err)
{
    ovr_run *run = ovr_run_make(options, NULL, err);
    if (!run)
        return NULL;
    run->c = c;
    if (resolve(run, err) || ovr_run_set_up(run, err)) {
        ovr_run_free(run);
        return NULL;
    }
    return run;
}

void ovr_run_free(ovr_run *run)
{
    ovr_arena arena;
    if (!run)
        return;
    if (run->writer)
        ovr_writer_close(run->writer, OVR_RUN_STOPPED, NULL, NULL);
    ovr_companions_release(run);
    ovr_simulation_free(run->sim);
    ovr_setup_free(run->setup);
    ovr_passes_free(run->passes);
    if (run->resumed)
        ovr_case_free(run->c);
    ovr_restart_close(run->restart);
    arena = run->arena;
    ovr_arena_release(&arena);
}

const ovr_run_info *ovr_run_get_info(const ovr_run *run)
{
    return !run ? NULL : &run->info;
}

ovr_status ovr_run_execute(ovr_run *run, ovr_error *err)
{
    if (!run)
        return ovr_fail_null(err, __func__);
    double begun = ovr_run_clock();
    ovr_error unasked = {0};
    ovr_status status;
    err = err ? err : &unasked;
    if (run->gone)
        return ovr_fail(
            err, OVR_BAD_INPUT,
            run->going
                ? "the run has started; functions called by it must not "
                  "start it again"
                : "the run has already been executed; create another run");
    run->going = run->gone = true;
    status = run->passes ? ovr_passes_execute(run, err)
                         : ovr_run_once(run, err);
    run->going = false;
    if (run->passes)
        run->info.seconds = ovr_run_clock() - begun;
    return status;
}
