/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The commands that solve share this: how a run is listened to, and how it
 * ends. */
#ifndef OVR_CLI_WATCH_H
#define OVR_CLI_WATCH_H

#include <stdbool.h>

#include "cli/cli.h"

/* Shows on stderr how far a run is: one line rewritten on a terminal, else a
 * line each 10 %; nothing with -q. */

typedef struct cli_progress {
    bool shown, terminal;
    double begun; /* s, of cli_seconds */
    double last;  /* when the line was written last */
    double from;  /* fraction done when it began (a resumed run) */
    int tenths;   /* lines written when not on a terminal */
    bool line;    /* an unfinished line is on the terminal */
} cli_progress;

/* Wall-clock time, s, from some beginning. */
double cli_seconds(void);

cli_progress cli_progress_begin(int verbosity, double fraction);

/* `fraction` of the whole is done; `what` is a few words on where it is. */
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
