/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Stresses and fatigue in words and in JSON: no number without the depth it is
 * counted from. */
#ifndef OVR_CLI_STRESS_REPORT_H
#define OVR_CLI_STRESS_REPORT_H

#include "cli/cli.h"
#include "cli/json.h"

void cli_put_stress(const ovr_stress_report *report, const ovr_setup *setup);

/* Equivalent lengths counted from each depth down, of the worse body (either
 * may be NULL). */
void cli_json_lengths(json_writer *json,
                      const ovr_stress_report *const report[2]);

#endif
