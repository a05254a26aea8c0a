/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What `run` and `resume` do, for the sweep too. */
#ifndef OVR_CLI_RUN_H
#define OVR_CLI_RUN_H

#include "cli/cli.h"

/* Runs a case from its beginning; `output` NULL: where the case
 * says, if it does.  Prints the summary, returns the exit code. */
int cli_run_case(const cli_call *call, ovr_case *c, const char *output,
                 bool force);

/* Goes on with a result file. */
int cli_resume_file(const cli_call *call, const char *path);

#endif
