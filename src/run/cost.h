/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a case will cost, before it is run. */
#ifndef OVR_RUN_COST_H
#define OVR_RUN_COST_H

#include "overroll/run.h"
#include "run/run.h"

typedef struct ovr_cost {
    double nodes, mesh, steps, passes;
    double seconds;     /* on one core */
    double bytes;       /* of memory */
    ovr_storage stored; /* of all passes */
} ovr_cost;

/* Memory of what writes its result file, bytes. */
double ovr_setup_output_memory(const ovr_setup *setup);

/* `live`: bytes that the set-up has taken, its surfaces included. */
ovr_cost ovr_setup_cost(const ovr_setup *setup, double live);

#endif
