/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Worker processes: each runs task after task, and if one is killed only its
 * task fails. */
#define _DEFAULT_SOURCE /* MAP_ANONYMOUS */
#include <signal.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <unistd.h>

#include "run/pool.h"
#include "support/test.h"

enum { TASKS = 40, WORKERS = 2 };

/* Shared with the workers. */
typedef struct seen {
    atomic_int times[TASKS]; /* done in a worker */
    pid_t by[TASKS];
    int reports[TASKS], code[TASKS], signal[TASKS];
    int killed;  /* the task whose worker dies; -1: none */
    int stop_at; /* number of reports after which the pool stops; 0: never */
    int ended;
} seen;

static int work(void *data, size_t task, ovr_shared shared)
{
    seen *s = data;
    s->by[task] = getpid();
    atomic_fetch_add(&s->times[task], 1);
    *shared.done = 0.5;
    if ((int)task == s->killed)
        raise(SIGKILL);
    return (int)(task % 3);
}

static void ended(void *data, size_t task, int code, int number)
{
    seen *s = data;
    s->reports[task]++;
    s->code[task] = code;
    s->signal[task] = number;
    s->ended++;
}

static void tick(void *data, size_t count, int running, double done)
{
    (void)data;
    assert_true(running <= WORKERS && done <= TASKS && count <= TASKS);
}

static bool stop(void *data)
{
    const seen *s = data;
    return s->stop_at && s->ended >= s->stop_at;
}

static int run(seen *s)
{
    size_t task[TASKS];
    ovr_pool_job job = {TASKS, task, WORKERS, work, ended, tick, stop, s, NULL};
    for (size_t k = 0; k < TASKS; k++)
        task[k] = TASKS - 1 - k; /* names, not places in the list */
    return ovr_pool_run(&job);
}

static seen *make(int killed)
{
    seen *s = mmap(NULL, sizeof *s, PROT_READ | PROT_WRITE,
                   MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    assert_true(s != MAP_FAILED);
    s->killed = killed;
    return s;
}

static int processes(const seen *s)
{
    int count = 0;
    for (int i = 0; i < TASKS; i++) {
        int before = 0;
        for (int k = 0; k < i; k++)
            before += s->by[k] == s->by[i];
        count += s->by[i] && !before;
    }
    return count;
}

/* Every task once, by as many processes as there are workers. */
TEST(many_by_few)
{
    seen *s = make(-1);
    assert_int_equal(run(s), 0);
    for (int k = 0; k < TASKS; k++) {
        assert_int_equal(s->times[k], 1);
        assert_int_equal(s->reports[k], 1);
        assert_int_equal(s->code[k], k % 3);
        assert_int_equal(s->signal[k], 0);
    }
    assert_true(processes(s) <= WORKERS);
    munmap(s, sizeof *s);
}

TEST(one_that_dies)
{
    seen *s = make(25);
    assert_int_equal(run(s), 0);
    for (int k = 0; k < TASKS; k++) {
        assert_int_equal(s->times[k], 1);
        assert_int_equal(s->reports[k], 1);
        assert_int_equal(s->signal[k], k == 25 ? SIGKILL : 0);
    }
    assert_true(processes(s) <= WORKERS + 1);
    munmap(s, sizeof *s);
}

/* Running tasks are completed and reported; the others are not started. */
TEST(stopped)
{
    seen *s = make(-1);
    int done = 0;
    s->stop_at = 1;
    assert_int_equal(run(s), 1);
    for (int k = 0; k < TASKS; k++) {
        assert_int_equal(s->times[k], s->reports[k]);
        done += s->reports[k];
    }
    assert_true(done >= 1);
    munmap(s, sizeof *s);
}
