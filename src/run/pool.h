/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Worker processes, so many at once, that take one task after the other. */
#ifndef OVR_RUN_POOL_H
#define OVR_RUN_POOL_H

#include <stdbool.h>
#include <stddef.h>

#include "base/arena.h"

/* Memory that a worker shares with its parent. */
typedef struct ovr_shared {
    volatile double *done; /* part of the task, told by the worker */
    const volatile int *stop;
} ovr_shared;

typedef struct ovr_pool_job {
    size_t count;
    const size_t *task;
    int workers;
    /* Called in a worker: does the task, returns the code that it ends with. */
    int (*work)(void *data, size_t task, ovr_shared shared);
    /* Called in the parent: a task ended, with a code or by a signal. */
    void (*ended)(void *data, size_t task, int code, int signal);
    /* Called in the parent a few times a second: how many ended, how many run,
     * and the tasks done, parts of running ones included. */
    void (*tick)(void *data, size_t ended, int running, double done);
    /* Asked as often, and by workers between two tasks; then nothing new is
     * begun. */
    bool (*stop)(void *data);
    void *data;
    const ovr_allocator *allocator;
} ovr_pool_job;

/* Runs until all started workers have ended. Returns 1: stopped; 0: all done;
 * -1: no memory or no process, see errno. */
int ovr_pool_run(const ovr_pool_job *job);

#endif
