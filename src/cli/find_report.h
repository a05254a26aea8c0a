/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef OVR_CLI_FIND_REPORT_H
#define OVR_CLI_FIND_REPORT_H

#include "cli/cli.h"

/* Prints the answer, or why there is none; returns the exit code. */
int cli_report_find(const cli_call *call, const ovr_find *find,
                    ovr_status status, const ovr_error *err);

#endif
