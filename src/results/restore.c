/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A simulation's state into checkpoints and back. */
#include "results/writer.h"

static ovr_status visit_all(void *sim, ovr_visit *visit, void *context,
                            ovr_error *err)
{
    return ovr_simulation_visit(sim, visit, context, err);
}

void ovr_writer_checkpoints(ovr_writer *w, ovr_simulation *sim)
{
    ovr_state_source source = {visit_all, sim};
    ovr_writer_source(w, source);
}

ovr_status ovr_restart_load(const ovr_restart *restart, ovr_simulation *sim,
                            ovr_error *err)
{
    ovr_state_source source = {visit_all, sim};
    ovr_status status = ovr_restart_load_into(restart, &source, err);
    if (status == OVR_OK)
        ovr_simulation_restored(sim);
    return status;
}
