/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The results of a solve or a run, as a table or as JSON. */
#ifndef OVR_CLI_REPORT_H
#define OVR_CLI_REPORT_H

#include "cli/cli.h"
#include "cli/json.h"

/* One object, or a table unless -q. */
void cli_report(const cli_call *call, const ovr_run_info *run);
void cli_report_json(const ovr_run_info *s, FILE *to);

/* The scales of a contact; for check and info too. */
void cli_json_contact(json_writer *json, const ovr_contact *contact);

const char *cli_smoother_name(ovr_smoother smoother);

#endif
