/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Results of a solution or run, as a table or as JSON. */
#ifndef OVR_CLI_REPORT_H
#define OVR_CLI_REPORT_H

#include "cli/cli.h"
#include "cli/json.h"

/* Writes one object, or a table unless -q. */
void cli_report(const cli_call *call, const ovr_run_info *run);
void cli_report_json(const ovr_run_info *s, FILE *to);

/* Prints the lines of a report. With a json_writer it prints lines with a key,
 * without one (NULL) lines with text, as a table. */
ovr_summary_taker cli_put_line;

/* Writes equivalent lengths as functions of the smallest depth considered, for
 * the more critical body (either may be NULL). */
void cli_json_lengths(json_writer *json,
                      const ovr_stress_report *const report[2]);

#endif
