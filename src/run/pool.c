/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The parent holds the reading end of a pipe to each worker, which nobody
 * writes to: it ends when the worker does, and to wait for that takes no
 * signal of the caller's.  What workers have done, and that they are to stop,
 * is in memory shared with them.
 */
#define _DEFAULT_SOURCE /* MAP_ANONYMOUS */
#include "run/pool.h"

#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

typedef struct worker {
    pid_t process; /* 0: free */
    size_t task;
} worker;

typedef struct pool {
    const ovr_pool_job *job;
    worker *worker;
    struct pollfd *end; /* of each; fd -1: free */
    double *done;       /* of each, shared; behind them the stop */
    volatile int *stop;
    size_t next, ended;
    int running;
} pool;

static int start_one(pool *p, int slot)
{
    size_t task = p->job->task[p->next];
    ovr_shared shared = {&p->done[slot], p->stop};
    int ends[2];
    pid_t process;
    if (pipe(ends) != 0)
        return -1;
    fflush(NULL);
    p->done[slot] = 0;
    process = fork();
    if (process == 0) {
        close(ends[0]);
        _exit(p->job->work(p->job->data, task, shared));
    }
    close(ends[1]);
    if (process < 0) {
        close(ends[0]);
        return -1;
    }
    p->end[slot] = (struct pollfd){ends[0], POLLIN, 0};
    p->worker[slot] = (worker){process, task};
    p->running++;
    p->next++;
    return 0;
}

static int fill(pool *p)
{
    for (int slot = 0; slot < p->job->workers; slot++)
        if (!*p->stop && !p->worker[slot].process && p->next < p->job->count &&
            start_one(p, slot) != 0)
            return -1;
    return 0;
}

static void reap(pool *p, int slot)
{
    int status = 0;
    waitpid(p->worker[slot].process, &status, 0);
    close(p->end[slot].fd);
    p->end[slot] = (struct pollfd){.fd = -1};
    p->worker[slot].process = 0;
    p->running--;
    p->ended++;
    p->job->ended(p->job->data, p->worker[slot].task,
                  WIFEXITED(status) ? WEXITSTATUS(status) : 0,
                  WIFSIGNALED(status) ? WTERMSIG(status) : 0);
}

static void tick(const pool *p)
{
    double done = (double)p->ended;
    for (int slot = 0; slot < p->job->workers; slot++)
        if (p->worker[slot].process)
            done += p->done[slot];
    p->job->tick(p->job->data, p->ended, p->running, done);
}

static int run(pool *p)
{
    const int pause = 200; /* ms */
    int trouble = 0;
    for (int slot = 0; slot < p->job->workers; slot++)
        p->end[slot].fd = -1;
    while (!trouble) {
        trouble = fill(p) != 0 && p->running == 0;
        if (p->running == 0)
            break;
        tick(p);
        if (poll(p->end, (nfds_t)p->job->workers, pause) > 0)
            for (int slot = 0; slot < p->job->workers; slot++)
                if (p->end[slot].revents)
                    reap(p, slot);
        if (p->job->stop(p->job->data))
            *p->stop = 1;
    }
    tick(p);
    return trouble ? -1 : *p->stop;
}

int ovr_pool_run(const ovr_pool_job *job)
{
    size_t n = (size_t)job->workers, bytes = (n + 1) * sizeof(double);
    void *shared = mmap(NULL, bytes, PROT_READ | PROT_WRITE,
                        MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    ovr_arena arena = ovr_arena_make(job->allocator);
    pool p = {.job = job,
              .worker = ovr_arena_take(&arena, n, sizeof *p.worker, NULL),
              .end = ovr_arena_take(&arena, n, sizeof *p.end, NULL)};
    int code = -1;
    if (p.worker && p.end && shared != MAP_FAILED) {
        p.done = shared;
        p.stop = (int *)(void *)(p.done + n);
        code = run(&p);
    }
    if (shared != MAP_FAILED)
        munmap(shared, bytes);
    ovr_arena_release(&arena);
    return code;
}
