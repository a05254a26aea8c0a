/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * One case of a study on disk.  All that is known of it lies in the folder of
 * the results, so that workers on any number of hosts need nothing else:
 *
 *     NAME.ini     the case, written and locked (flock) while it runs
 *     NAME.h5      its result file, unless the study has `results = no`
 *     NAME.log     what it said
 *     NAME.json    its summary, once it has finished
 *     NAME.failed  exit code and message of a failure
 */
#ifndef OVR_CLI_SWEEP_TASK_H
#define OVR_CLI_SWEEP_TASK_H

#include "cli/cli.h"
#include "cli/study.h"

typedef enum sweep_state {
    SWEEP_WAITING,  /* nothing there */
    SWEEP_STOPPED,  /* began; its result file can be gone on with */
    SWEEP_RUNNING,  /* another process has it */
    SWEEP_FINISHED, /* with its summary */
    SWEEP_FAILED,
    SWEEP_CHANGED, /* finished, stopped or failed as another case */
    SWEEP_STATES
} sweep_state;

const char *sweep_state_name(sweep_state state);

sweep_state sweep_state_of(const study *s, size_t task);

/* First line of the message of a failure, or "". */
void sweep_message(const study *s, size_t task, char *text, size_t room);

typedef struct sweep_how {
    const cli_call *call;
    bool retry; /* failed ones again */
    bool redo;  /* all again, from the beginning */
} sweep_how;

/* Whether this state is one to work on. */
bool sweep_wanted(const sweep_how *how, sweep_state state);

/* Runs or resumes a task in this process, whose standard output and error go
 * to its files; returns the exit code.  `done` is told the fraction done. */
int sweep_work(const study *s, size_t task, const sweep_how *how,
               volatile double *done);

/* For the parent of a worker that died of a signal without a word. */
void sweep_died(const study *s, size_t task, int number);

#endif
