/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Messages, progress and end of runs, for the commands that solve. */
#ifndef OVR_CLI_WATCH_H
#define OVR_CLI_WATCH_H

#include <stdbool.h>

#include "cli/cli.h"

/* Progress of a run on stderr: a line that is rewritten on a terminal,
 * otherwise a line every 10 %. Nothing is shown with -q. */

typedef struct cli_progress {
    bool shown, terminal;
    double begun; /* start time from cli_seconds, s */
    double last;  /* time of the last output */
    double from;  /* completed fraction at the start (of a resumed run) */
    int tenths;   /* lines written when not on a terminal */
    bool line;    /* an unfinished line is on the terminal */
} cli_progress;

/* Returns the wall-clock time in seconds since an arbitrary moment. */
double cli_seconds(void);

cli_progress cli_progress_begin(int verbosity, double fraction);

/* Shows that `fraction` of the run is completed; `what` describes the present
 * stage. */
void cli_progress_show(cli_progress *progress, double fraction,
                       const char *what);

/* Erases the line from the terminal. */
void cli_progress_end(cli_progress *progress);

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

/* Returns options with messages and progress on stderr; signals stop the
 * run. */
ovr_run_options cli_run_options(cli_watch *watch);

/* Solves, prints the summary, frees the run and returns the exit code. A signal
 * stops the run, except in `steady`. `run` NULL: prints the reason of the
 * failure. */
int cli_finish_run(cli_watch *watch, ovr_run *run, ovr_error *err);

/* Prints the final status of a run on stderr; returns the exit code. */
int cli_run_code(const cli_call *call, const ovr_run *run, ovr_status status,
                 const ovr_error *err);

/* True if a run with this status has results to report. */
bool cli_has_result(const ovr_run *run, ovr_status status);

/* Prevents messages of HDF5 on stderr at the end of the program after a failed
 * write. Not called in main: commands that write no result must not initialize
 * HDF5, which aborts if memory is insufficient. */
void cli_silence_the_end(void);

#endif
