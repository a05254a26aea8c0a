/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Worker processes that process one task after the other, so that a process
 * serves many short tasks. Shared memory contains the position in the list,
 * each worker's current task and its progress, and the request to stop. Each
 * worker reports finished tasks through a pipe to the parent. The pipe closes
 * when the worker ends, so the parent needs no signal handler. If a worker
 * crashes, only its task is lost and a new worker is started.
 */
#define _DEFAULT_SOURCE /* MAP_ANONYMOUS */
#include "run/pool.h"

#include <poll.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif
#include <sys/mman.h>
#ifdef __linux__
#include <signal.h>
#include <sys/prctl.h>
#endif
#include <sys/wait.h>
#include <unistd.h>

/* Message of a worker about a finished task. */
typedef struct ending {
    size_t task;
    int code;
} ending;

/* Progress of one worker, in shared memory. */
typedef struct place {
    double done;          /* completed fraction of the task */
    volatile size_t task; /* number of the task in the list, from 1; 0: none */
} place;

/* Data shared by all workers. */
typedef struct board {
    atomic_size_t next; /* index of the next task in the list */
    volatile int stop;
    place at[];
} board;

typedef struct pool {
    const ovr_pool_job *job;
    pid_t *process; /* process of each worker; 0: unused */
    struct pollfd *end;
    board *board;
    size_t ended;
    int running;
} pool;

/* Keeps freed memory in the process for the next task. Otherwise requesting
 * pages from the system takes a fifth of a short task's time. */
static void keep_memory(void)
{
#ifdef __GLIBC__
    mallopt(M_MMAP_THRESHOLD, 1 << 25);
    mallopt(M_TRIM_THRESHOLD, 1 << 28);
#endif
}

/* A worker whose parent was killed would continue its task for hours.
 * SIGTERM lets it write a checkpoint. */
static void end_with(pid_t parent)
{
#ifdef __linux__
    prctl(PR_SET_PDEATHSIG, SIGTERM);
#endif
    if (getppid() != parent) /* the parent has already ended */
        _exit(1);
}

/* Processes tasks in the worker until there are none left. */
static void work_through(const pool *p, int slot, int to, pid_t parent)
{
    const ovr_pool_job *job = p->job;
    place *at = &p->board->at[slot];
    const ovr_shared shared = {&at->done, &p->board->stop};
    keep_memory();
    end_with(parent);
    /* The signal may reach only the worker, or reach it first. */
    while (!p->board->stop && !job->stop(job->data) && getppid() == parent) {
        size_t next = atomic_fetch_add(&p->board->next, 1);
        if (next >= job->count)
            break;
        at->done = 0;
        at->task = next + 1;
        ending message;
        memset(&message, 0, sizeof message); /* padding is written too */
        message.task = job->task[next];
        message.code = job->work(job->data, job->task[next], shared);
        fflush(NULL);
        at->task = 0;
        if (write(to, &message, sizeof message) != (ssize_t)sizeof message)
            _exit(1);
    }
    _exit(0);
}

static int start_one(pool *p, int slot)
{
    int ends[2];
    pid_t process, parent = getpid();
    if (pipe(ends) != 0)
        return -1;
    fflush(NULL);
    p->board->at[slot] = (place){0};
    process = fork();
    if (process == 0) {
        close(ends[0]);
        work_through(p, slot, ends[1], parent);
    }
    close(ends[1]);
    if (process < 0) {
        close(ends[0]);
        return -1;
    }
    p->end[slot] = (struct pollfd){ends[0], POLLIN, 0};
    p->process[slot] = process;
    p->running++;
    return 0;
}

static int fill(pool *p)
{
    for (int slot = 0; slot < p->job->workers; slot++)
        if (!p->board->stop && !p->process[slot] &&
            atomic_load(&p->board->next) < p->job->count &&
            start_one(p, slot) != 0)
            return -1;
    return 0;
}

/* Handles a worker that ended. Its current task, if any, has crashed. */
static void reap(pool *p, int slot)
{
    int status = 0;
    size_t task = p->board->at[slot].task;
    waitpid(p->process[slot], &status, 0);
    close(p->end[slot].fd);
    p->end[slot] = (struct pollfd){.fd = -1};
    p->process[slot] = 0;
    p->running--;
    if (!task)
        return;
    p->ended++;
    p->job->ended(p->job->data, p->job->task[task - 1],
                  WIFEXITED(status) ? WEXITSTATUS(status) : 0,
                  WIFSIGNALED(status) ? WTERMSIG(status) : 0);
}

/* Reads a worker's message, or detects its end. */
static void read_worker_message(pool *p, int slot)
{
    ending message;
    if (read(p->end[slot].fd, &message, sizeof message) !=
        (ssize_t)sizeof message) {
        reap(p, slot);
        return;
    }
    p->ended++;
    p->job->ended(p->job->data, message.task, message.code, 0);
}

static void tick(const pool *p)
{
    double done = (double)p->ended;
    for (int slot = 0; slot < p->job->workers; slot++)
        if (p->process[slot] && p->board->at[slot].task)
            done += p->board->at[slot].done;
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
                    read_worker_message(p, slot);
        if (p->job->stop(p->job->data))
            p->board->stop = 1;
    }
    tick(p);
    return trouble ? -1 : p->board->stop;
}

int ovr_pool_run(const ovr_pool_job *job)
{
    size_t n = (size_t)job->workers;
    size_t bytes = sizeof(board) + n * sizeof(place);
    void *shared = mmap(NULL, bytes, PROT_READ | PROT_WRITE,
                        MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    ovr_arena arena = ovr_arena_make(job->allocator);
    pool p = {.job = job,
              .process = ovr_arena_take(&arena, n, sizeof *p.process, NULL),
              .end = ovr_arena_take(&arena, n, sizeof *p.end, NULL)};
    int code = -1;
    if (p.process && p.end && shared != MAP_FAILED) {
        p.board = shared;
        code = run(&p);
    }
    if (shared != MAP_FAILED)
        munmap(shared, bytes);
    ovr_arena_release(&arena);
    return code;
}
