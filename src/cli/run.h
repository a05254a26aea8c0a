/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef OVR_CLI_RUN_H
#define OVR_CLI_RUN_H

#include "cli/cli.h"

/* Runs the case of the call, as its options and its verb say, or asks for its
 * sensitivities; the exit code. */
int cli_run_case(cli_call *call);

#endif
