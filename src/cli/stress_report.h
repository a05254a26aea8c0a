/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Writes what JSON has of stresses beside the lines of reports. */
#ifndef OVR_CLI_STRESS_REPORT_H
#define OVR_CLI_STRESS_REPORT_H

#include "cli/cli.h"
#include "cli/json.h"

/* Equivalent lengths counted from each depth down, of the worse body (either
 * may be NULL). */
void cli_json_lengths(json_writer *json,
                      const ovr_stress_report *const report[2]);

#endif
