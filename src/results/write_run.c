/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Records a simulation: passes its steps to the writer of the result file, and
 * saves and restores its state in checkpoints. */
#include "base/given.h"
#include "results/results.h"
#include "results/writer.h"
#include "simulation/simulation.h"

static const double *field_of(const void *sim, const ovr_observable *which,
                              double *workspace)
{
    return which->field(sim, workspace);
}

static void show_line(void *sim, size_t line)
{
    ovr_simulation_show(sim, line);
}

static ovr_frame frame_of(ovr_writer *w)
{
    const ovr_simulation *sim = w->observed;
    return (ovr_frame){.state = ovr_simulation_state(sim),
                       .seen = ovr_simulation_observation(sim),
                       .field = field_of,
                       .source = sim,
                       .show = w->lines > 1 && w->saved ? show_line : NULL,
                       .shown = w->saved,
                       .total = ovr_simulation_statistics(sim)};
}

ovr_status ovr_writer_observe(void *writer, const ovr_simulation *sim,
                              ovr_error *err)
{
    if (!writer || !sim)
        return ovr_fail_null(err, __func__);
    ovr_writer *w = writer;
    ovr_frame frame;
    w->observed = sim;
    w->frame_of = frame_of;
    frame = frame_of(w);
    return ovr_writer_record(w, &frame, err);
}

ovr_observer ovr_writer_observer(ovr_writer *w)
{
    return (ovr_observer){ovr_writer_observe, ovr_writer_next_time, w};
}

static ovr_status visit_state(void *sim, ovr_visit *visit, void *context,
                              ovr_error *err)
{
    return ovr_simulation_visit(sim, visit, context, err);
}

/* Visits all saved state. It ends with the surface heights, which are compared
 * when the run is resumed. */
static ovr_status visit_all(void *writer, ovr_visit *visit, void *context,
                            ovr_error *err)
{
    ovr_writer *w = writer;
    ovr_simulation *sim = w->saved;
    ovr_status status = ovr_simulation_visit(sim, visit, context, err);
    if (status == OVR_OK)
        status = ovr_simulation_visit_heights(sim, visit, context, err);
    if (status == OVR_OK && w->more.visit_all)
        status = w->more.visit_all(w->more.object, visit, context, err);
    return status;
}

void ovr_writer_more(ovr_writer *w, ovr_visited *more, void *object)
{
    if (!w)
        return;
    w->more = (ovr_state_source){more, object};
}

ovr_status ovr_restart_more(ovr_restart *restart, ovr_visited *more,
                            void *object, ovr_error *err)
{
    if (!restart || !more)
        return ovr_fail_null(err, __func__);
    ovr_state_source source = {more, object};
    return ovr_restart_load_into(restart, &source, err);
}

void ovr_writer_checkpoints(ovr_writer *w, ovr_simulation *sim)
{
    if (!w)
        return;
    ovr_state_source source = {visit_all, w};
    w->saved = sim;
    ovr_writer_source(w, source);
    w->observed = sim;
    w->frame_of = frame_of;
}

ovr_status ovr_restart_load(ovr_restart *restart, ovr_simulation *sim,
                            ovr_error *err)
{
    if (!restart || !sim)
        return ovr_fail_null(err, __func__);
    ovr_state_source source = {visit_state, sim};
    const ovr_state *state = ovr_simulation_state(sim);
    ovr_status status = ovr_restart_load_into(restart, &source, err);
    if (status != OVR_OK)
        return status;
    ovr_simulation_restored(sim);
    if (ovr_restart_holds(restart, "S", state->S, state->n * sizeof *state->S))
        return OVR_OK;
    return ovr_fail(err, OVR_BAD_INPUT,
                    "the surface at T = %g differs from that of the run; "
                    "restore the original profile file",
                    state->T);
}
