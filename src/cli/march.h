/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Marching a case through time: what `run` and `resume` share. */
#ifndef OVR_CLI_MARCH_H
#define OVR_CLI_MARCH_H

#include "cli/cli.h"

typedef struct cli_job {
    const ovr_case *c; /* NULL: no error estimate */
    ovr_setup *setup;
    ovr_simulation *sim;
    ovr_writer *writer; /* NULL: nothing is stored */
    const char *output; /* its file */
    bool restored;      /* the state is a checkpoint's: no steady start */
} cli_job;

/* From the steady start or the state now to the end; closes the writer, prints
 * the summary, returns the exit code. */
int cli_march(const cli_call *call, const cli_job *job);

#endif
