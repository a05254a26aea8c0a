/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The writer as the observer of a run. */
#include "results/writer.h"

ovr_status ovr_writer_observe(void *writer, const ovr_simulation *sim,
                              ovr_error *err)
{
    ovr_writer *w = writer;
    ovr_frame frame = {ovr_simulation_state(sim),
                       ovr_simulation_observation(sim), w->rho, w->eta,
                       w->flow};
    unsigned derived = OVR_FIELD_DENSITY | OVR_FIELD_VISCOSITY |
                       OVR_FIELD_MASS_FLOW;
    if ((w->options.fields & derived) &&
        ovr_writer_due(w, frame.state->step, frame.state->T))
        ovr_simulation_fields(sim, w->rho, w->eta, w->flow);
    return ovr_writer_record(w, &frame, err);
}
