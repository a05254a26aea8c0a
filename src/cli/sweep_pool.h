/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Worker processes, one for each task, so many at once. */
#ifndef OVR_CLI_SWEEP_POOL_H
#define OVR_CLI_SWEEP_POOL_H

#include <stdbool.h>
#include <stddef.h>

enum { POOL_MOST = 1024 };

typedef struct pool_job {
    size_t count;
    const size_t *task;
    int workers;
    /* In the worker: does the task, returns its exit code; may tell the
     * fraction done. */
    int (*work)(void *data, size_t task, volatile double *done);
    /* In the parent: a task ended, with an exit code or by a signal. */
    void (*ended)(void *data, size_t task, int code, int signal);
    /* In the parent, a few times a second: how many ended, how many run, and
     * the tasks done, parts of running ones included. */
    void (*tick)(void *data, size_t ended, int running, double done);
    void *data;
} pool_job;

/* Until all have ended; SIGINT and SIGTERM are passed on, nothing new is
 * begun, and the signal's number is returned.  0: all done; -1: no memory or
 * no process, errno says which. */
int pool_run(const pool_job *job);

#endif
