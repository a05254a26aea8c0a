/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Shows on stderr how far a run is: one line rewritten on a terminal, else a
 * line each 10 %; nothing with -q. */
#ifndef OVR_CLI_PROGRESS_H
#define OVR_CLI_PROGRESS_H

#include <stdbool.h>

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

#endif
