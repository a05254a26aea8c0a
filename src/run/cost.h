/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Predicts computing time, memory and disk space of a case before the run. */
#ifndef OVR_RUN_COST_H
#define OVR_RUN_COST_H

#include "overroll/run.h"
#include "run/run.h"

typedef struct ovr_cost {
    double nodes, mesh, steps, passes;
    double seconds;     /* computing time on one core */
    double bytes;       /* memory in bytes */
    ovr_storage stored; /* disk space of all passes */
} ovr_cost;

/* Returns the memory in bytes for writing the result file. */
double ovr_setup_output_memory(const ovr_setup *setup);

/* `live`: bytes already allocated by the setup, including its surfaces.
 * `peak`: maximum while the setup was prepared, for example while measured
 * surfaces were read and filtered. */
ovr_cost ovr_setup_cost(const ovr_setup *setup, double live, double peak);

#endif
