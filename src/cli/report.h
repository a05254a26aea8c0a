/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The results of a solve or a run, as a table or as JSON. */
#ifndef OVR_CLI_REPORT_H
#define OVR_CLI_REPORT_H

#include "cli/cli.h"
#include "cli/estimate.h"
#include "cli/json.h"

/* What is known when a command ends. */
typedef struct cli_summary {
    const ovr_setup *setup;
    const ovr_simulation *sim;
    bool converged;
    double seconds;
    bool run;           /* marched in time: the keys below */
    const char *output; /* result file or NULL */
    size_t snapshots;
    cli_estimate error; /* on request */
    int warnings;
    char warning[4][240];
} cli_summary;

/* Keeps a warning for JSON and prints it on stderr unless -q. */
void cli_warn(const cli_call *call, cli_summary *summary, const char *format,
              ...) OVR_PRINTF(3, 4);

/* What can be said before the solve: a grid too coarse for its features, a
 * feature that starts inside; and after it: a starved inlet. */
void cli_warn_before(const cli_call *call, cli_summary *summary);

/* On stderr, what was understood of profiles and done to them. */
void cli_say_assumed(const cli_call *call, const cli_summary *summary);

void cli_warn_after(const cli_call *call, cli_summary *summary);

void cli_report(const cli_call *call, const cli_summary *summary);

/* The scales of a contact; for check and info too. */
void cli_json_contact(json_writer *json, const ovr_contact *contact);

const char *cli_scheme_name(ovr_scheme scheme);
const char *cli_smoother_name(ovr_smoother smoother);

#endif
