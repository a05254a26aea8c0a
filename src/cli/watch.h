/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The commands that solve share this: how a run is listened to, and how it
 * ends. */
#ifndef OVR_CLI_WATCH_H
#define OVR_CLI_WATCH_H

#include "cli/cli.h"
#include "cli/progress.h"

#define CLI_ESTIMATE_OPTION                                                    \
    {                                                                          \
        "estimate-error", NULL,                                                \
            "also solve on the next coarser level to estimate the "            \
            "discretization error",                                            \
            false                                                              \
    }

/* The data of a run's callbacks. */
typedef struct cli_watch {
    const cli_call *call;
    cli_progress progress;
} cli_watch;

/* Messages and progress on stderr; signals stop. */
ovr_run_options cli_run_options(cli_watch *watch);

/* Solves, until a signal but in `steady`, prints the summary, frees the run;
 * returns the exit code.  `run` NULL: prints the reason of the failure. */
int cli_finish_run(cli_watch *watch, ovr_run *run, ovr_error *err);

/* Prints how a run ended on stderr; returns the exit code. */
int cli_run_code(const cli_call *call, const ovr_run *run, ovr_status status,
                 const ovr_error *err);

/* True if a run that ended so leaves something to report. */
bool cli_has_result(const ovr_run *run, ovr_status status);

/* HDF5 would complain on stderr when the program ends after a write that
 * failed.  Not in main: a command that writes no result does not wake HDF5,
 * which dies where its memory runs out. */
void cli_silence_the_end(void);

#endif
