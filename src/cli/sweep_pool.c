/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The parent blocks the signals it lives by (SIGCHLD, SIGINT, SIGTERM) and
 * waits for them with sigtimedwait: no handlers, so no races.  What workers
 * have done is in memory shared with them.
 */
#define _DEFAULT_SOURCE /* MAP_ANONYMOUS */
#include "cli/sweep_pool.h"

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

typedef struct pool {
    const pool_job *job;
    sigset_t signals, before;
    pid_t child[POOL_MOST]; /* 0: free */
    size_t task[POOL_MOST];
    volatile double *done; /* of each worker */
    size_t next, ended;
    int running, stopped; /* by which signal */
} pool;

/* A worker: signals as they were before the pool. */
static void be_worker(const pool *p, size_t task, int slot)
{
    int code;
    sigprocmask(SIG_SETMASK, &p->before, NULL);
    code = p->job->work(p->job->data, task, &p->done[slot]);
    exit(code);
}

static int start_one(pool *p, int slot)
{
    size_t task = p->job->task[p->next];
    pid_t child;
    fflush(NULL);
    p->done[slot] = 0;
    child = fork();
    if (child < 0)
        return -1;
    if (child == 0)
        be_worker(p, task, slot);
    p->child[slot] = child;
    p->task[slot] = task;
    p->running++;
    p->next++;
    return 0;
}

static int fill(pool *p)
{
    for (int slot = 0; slot < p->job->workers; slot++)
        if (!p->stopped && !p->child[slot] && p->next < p->job->count &&
            start_one(p, slot) != 0)
            return -1;
    return 0;
}

static void reap(pool *p)
{
    for (int slot = 0; slot < p->job->workers; slot++) {
        int status;
        if (!p->child[slot] || waitpid(p->child[slot], &status, WNOHANG) <= 0)
            continue;
        p->child[slot] = 0;
        p->running--;
        p->ended++;
        p->job->ended(p->job->data, p->task[slot],
                      WIFEXITED(status) ? WEXITSTATUS(status) : 0,
                      WIFSIGNALED(status) ? WTERMSIG(status) : 0);
    }
}

/* A worker ends at its next step at the first signal of each kind, at once at
 * the second.  The terminal or batch system may have sent ours to all the
 * group already; so they get the other kind from us. */
static void pass_on(pool *p, int number)
{
    p->stopped = number;
    for (int slot = 0; slot < p->job->workers; slot++)
        if (p->child[slot])
            kill(p->child[slot], number == SIGINT ? SIGTERM : SIGINT);
}

static void tick(const pool *p)
{
    double done = (double)p->ended;
    for (int slot = 0; slot < p->job->workers; slot++)
        if (p->child[slot])
            done += p->done[slot];
    p->job->tick(p->job->data, p->ended, p->running, done);
}

static int run(pool *p)
{
    const struct timespec pause = {0, 200000000};
    int trouble = 0;
    while (!trouble) {
        int number;
        trouble = fill(p) != 0 && p->running == 0;
        if (p->running == 0)
            break;
        tick(p);
        number = sigtimedwait(&p->signals, NULL, &pause);
        if (number == SIGINT || number == SIGTERM)
            pass_on(p, number);
        reap(p);
    }
    tick(p);
    return trouble ? -1 : p->stopped;
}

int pool_run(const pool_job *job)
{
    pool *p = calloc(1, sizeof *p);
    size_t bytes = POOL_MOST * sizeof(double);
    void *shared = mmap(NULL, bytes, PROT_READ | PROT_WRITE,
                        MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    int code = -1;
    if (p && shared != MAP_FAILED) {
        p->job = job;
        p->done = shared;
        sigemptyset(&p->signals);
        sigaddset(&p->signals, SIGCHLD);
        sigaddset(&p->signals, SIGINT);
        sigaddset(&p->signals, SIGTERM);
        sigprocmask(SIG_BLOCK, &p->signals, &p->before);
        code = run(p);
        sigprocmask(SIG_SETMASK, &p->before, NULL);
    }
    if (shared != MAP_FAILED)
        munmap(shared, bytes);
    free(p);
    return code;
}
