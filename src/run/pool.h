/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A limited number of worker processes, each of which processes one task after
 * the other. */
#ifndef OVR_RUN_POOL_H
#define OVR_RUN_POOL_H

#include <stdbool.h>
#include <stddef.h>

#include "base/arena.h"

/* Memory that a worker shares with its parent. */
typedef struct ovr_shared {
    volatile double *done; /* completed fraction of the task, written by the
                            * worker */
    const volatile int *stop;
} ovr_shared;

typedef struct ovr_pool_job {
    size_t count;
    const size_t *task;
    int workers;
    /* Called in a worker: processes the task and returns its exit code. */
    int (*work)(void *data, size_t task, ovr_shared shared);
    /* Called in the parent after a task has ended, with its exit code or
     * signal. */
    void (*ended)(void *data, size_t task, int code, int signal);
    /* Called in the parent a few times per second: number of ended tasks, of
     * running workers, and tasks done, including fractions of running ones. */
    void (*tick)(void *data, size_t ended, int running, double done);
    /* Called in the parent as often, and by workers between two tasks. If true,
     * no new task is started. */
    bool (*stop)(void *data);
    void *data;
    const ovr_allocator *allocator;
} ovr_pool_job;

/* Processes the tasks and returns after all workers have ended. 1: stopped; 0:
 * all done; -1: no memory or no process, see errno. */
int ovr_pool_run(const ovr_pool_job *job);

#endif
