/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The writer as the observer of a run. */
#include "results/writer.h"

static ovr_frame frame_of(ovr_writer *w)
{
    const ovr_simulation *sim = w->observed;
    ovr_frame frame = {ovr_simulation_state(sim),
                       ovr_simulation_observation(sim), w->rho, w->eta,
                       w->flow};
    unsigned derived = OVR_FIELD_DENSITY | OVR_FIELD_VISCOSITY |
                       OVR_FIELD_MASS_FLOW;
    if (w->options.fields & derived)
        ovr_simulation_fields(sim, w->rho, w->eta, w->flow);
    return frame;
}

ovr_status ovr_writer_observe(void *writer, const ovr_simulation *sim,
                              ovr_error *err)
{
    ovr_writer *w = writer;
    const ovr_state *state = ovr_simulation_state(sim);
    ovr_frame frame = {state, ovr_simulation_observation(sim), NULL, NULL,
                       NULL};
    w->observed = sim;
    w->frame_of = frame_of;
    if (ovr_writer_due(w, state->step, state->T))
        frame = frame_of(w);
    return ovr_writer_record(w, &frame, err);
}
