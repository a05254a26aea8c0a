/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "run/companion.h"

#include "case/resolve.h"
#include "results/results.h"
#include "run/internal.h"

/* NOLINTBEGIN(bugprone-macro-parentheses): names */
#define EACH(run, c, function)                                                 \
    for (ovr_accompanied *c = (run)->company; c->is; c++)                      \
        if (c->is->function)
/* NOLINTEND(bugprone-macro-parentheses) */

static ovr_accompanied_run seen(ovr_run *run)
{
    return (ovr_accompanied_run){.setup = run->setup,
                                 .sim = run->sim,
                                 .arena = &run->arena,
                                 .writer = run->writer,
                                 .output = run->info.output,
                                 .force = run->force,
                                 .resumed = run->restart != NULL,
                                 .stress = run->info.stress,
                                 .say = ovr_run_message,
                                 .listener = run};
}

static const ovr_companion *companion_of(const ovr_setup *setup, int k)
{
    static const ovr_companion none;
    const ovr_physics_in_output *of = ovr_physics_list[k]->in_output;
    bool has = of && of->companion && ovr_setup_has(setup, k);
    return has ? of->companion : &none;
}

void ovr_companions_predict(const ovr_setup *setup, ovr_listener *say,
                            void *data)
{
    for (int k = 0; say && ovr_physics_list[k]; k++) {
        const ovr_companion *c = companion_of(setup, k);
        if (c->review_before)
            c->review_before(setup, say, data);
    }
}

static void pass_on(void *run, bool warning, const char *text)
{
    ovr_run_message(run, warning ? OVR_MESSAGE_WARNING : OVR_MESSAGE_NOTE,
                    text);
}

void ovr_companions_review(ovr_run *run)
{
    const ovr_accompanied_run as = seen(run);
    ovr_physics_review(run->sim, pass_on, run);
    for (int k = 0; ovr_physics_list[k]; k++) {
        const ovr_companion *c = companion_of(run->setup, k);
        if (c->review)
            c->review(&as);
    }
}

ovr_status ovr_companions_make(ovr_run *run, ovr_error *err)
{
    const ovr_accompanied_run as = seen(run);
    ovr_accompanied *next = run->company;
    for (int k = 0; ovr_physics_list[k]; k++) {
        const ovr_companion *is = companion_of(run->setup, k);
        if (!is->make && !is->open && !is->finish)
            continue;
        if (is->make && is->make(&as, &next->own, err))
            return err ? err->status : OVR_BAD_INPUT;
        next++->is = is;
    }
    return OVR_OK;
}

void ovr_companions_release(ovr_run *run)
{
    EACH(run, c, release)
        c->is->release(c->own);
    run->company[0] = (ovr_accompanied){NULL, NULL};
}

static ovr_status visit_all(void *data, ovr_visit *visit, void *context,
                            ovr_error *err)
{
    ovr_run *run = data;
    ovr_status status = OVR_OK;
    EACH(run, c, visit)
        if (!status)
            status = c->is->visit(c->own, visit, context, err);
    return status;
}

ovr_status ovr_companions_open(ovr_run *run, ovr_error *err)
{
    const ovr_accompanied_run as = seen(run);
    if (run->company[0].is)
        ovr_writer_more(run->writer, visit_all, run);
    EACH(run, c, open)
        if (c->is->open(c->own, &as, err))
            return err ? err->status : OVR_IO;
    return OVR_OK;
}

void ovr_companions_set_path(ovr_run *run)
{
    const ovr_accompanied_run as = seen(run);
    EACH(run, c, set_path)
        c->is->set_path(c->own, &as);
}

ovr_status ovr_companions_restore(ovr_run *run, double T, ovr_error *err)
{
    ovr_status status = OVR_OK;
    if (run->company[0].is)
        status = ovr_restart_more(run->restart, visit_all, run, err);
    EACH(run, c, restored)
        if (!status)
            status = c->is->restored(c->own, T, err);
    return status;
}

ovr_status ovr_companions_observe(void *data, const ovr_simulation *sim,
                                  ovr_error *err)
{
    ovr_run *run = data;
    ovr_status status = OVR_OK;
    EACH(run, c, observe)
        if (!status)
            status = c->is->observe(c->own, sim, err);
    return status;
}

ovr_status ovr_companions_finish(ovr_run *run, ovr_error *err)
{
    const ovr_accompanied_run as = seen(run);
    ovr_status status = OVR_OK;
    EACH(run, c, finish)
        if (!status)
            status = c->is->finish(c->own, &as, err);
    return status;
}
