/* SPDX-License-Identifier: GPL-3.0-or-later */
#define _GNU_SOURCE /* sched_getaffinity */
#include "base/team.h"

#include <sched.h>
#include <signal.h>
#include <unistd.h>

/* Checks between two yields of the processor, and number of yields before a
 * thread sleeps. */
enum { CHECKS = 100, TURNS = 50 };

static inline void pause_briefly(void)
{
#if defined __x86_64__ || defined __i386__
    __builtin_ia32_pause();
#endif
}

/* Waits a short time until `number` has the value `wanted`, or another value
 * than that, and yields the processor to other programs. Returns false if the
 * time has passed. */
static bool wait_awake(atomic_uint *number, unsigned wanted, bool another)
{
    for (int turn = 0; turn < TURNS; turn++) {
        for (int check = 0; check < CHECKS; check++) {
            unsigned now = atomic_load_explicit(number, memory_order_acquire);
            if ((now != wanted) == another)
                return true;
            pause_briefly();
        }
        sched_yield();
    }
    return false;
}

static void do_part(const ovr_team *team, int number)
{
    size_t m = (size_t)number, all = (size_t)team->members;
    size_t from = team->count * m / all, to = team->count * (m + 1) / all;
    if (to > from)
        team->work(team->data, number, from, to);
}

/* Waits for the loop after `last`; false if the team is closing. */
static bool wait_for_loop(ovr_team *team, unsigned last)
{
    if (wait_awake(&team->loop, last, true))
        return true;
    pthread_mutex_lock(&team->mutex);
    team->asleep++;
    while (atomic_load(&team->loop) == last && !team->closing)
        pthread_cond_wait(&team->changed, &team->mutex);
    team->asleep--;
    bool closing = atomic_load(&team->loop) == last;
    pthread_mutex_unlock(&team->mutex);
    return !closing;
}

static void wait_for_members(ovr_team *team)
{
    if (wait_awake(&team->busy, 0, false))
        return;
    pthread_mutex_lock(&team->mutex);
    team->asleep++;
    while (atomic_load(&team->busy))
        pthread_cond_wait(&team->changed, &team->mutex);
    team->asleep--;
    pthread_mutex_unlock(&team->mutex);
}

/* Wakes sleeping members after `loop`, `busy` or `closing` has changed. */
static void wake(ovr_team *team)
{
    pthread_mutex_lock(&team->mutex);
    if (team->asleep)
        pthread_cond_broadcast(&team->changed);
    pthread_mutex_unlock(&team->mutex);
}

static void *run_member(void *data)
{
    const ovr_team_member *m = data;
    ovr_team *team = m->team;
    for (unsigned last = 0; wait_for_loop(team, last); last++) {
        do_part(team, m->number);
        if (atomic_fetch_sub(&team->busy, 1) == 1)
            wake(team);
    }
    return NULL;
}

/* Starts threads with all signals blocked: signals are handled by the program's
 * own threads. */
static void start_threads(ovr_team *team, int members)
{
    sigset_t all, before;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    for (int k = 1; k < members; k++) {
        team->member[k] = (ovr_team_member){.team = team, .number = k};
        if (pthread_create(&team->member[k].thread, NULL, run_member,
                           &team->member[k]))
            break;
        team->members++;
    }
    pthread_sigmask(SIG_SETMASK, &before, NULL);
}

void ovr_team_start(ovr_team *team, int members)
{
    if (members > OVR_TEAM_MOST)
        members = OVR_TEAM_MOST;
    if (members < 2 || pthread_mutex_init(&team->mutex, NULL))
        return;
    if (pthread_cond_init(&team->changed, NULL)) {
        pthread_mutex_destroy(&team->mutex);
        return;
    }
    team->members = 1;
    team->process = getpid();
    team->closing = false;
    atomic_store(&team->loop, 0);
    start_threads(team, members);
}

void ovr_team_end(ovr_team *team)
{
    if (!team->members || team->process != getpid())
        return;
    pthread_mutex_lock(&team->mutex);
    team->closing = true;
    pthread_cond_broadcast(&team->changed);
    pthread_mutex_unlock(&team->mutex);
    for (int k = 1; k < team->members; k++)
        pthread_join(team->member[k].thread, NULL);
    pthread_cond_destroy(&team->changed);
    pthread_mutex_destroy(&team->mutex);
    team->members = 0;
}

void ovr_team_run(ovr_team *team, size_t count, ovr_team_work *work, void *data)
{
    if (team->members < 2 || team->process != getpid()) {
        if (count)
            work(data, 0, 0, count);
        return;
    }
    team->work = work;
    team->data = data;
    team->count = count;
    atomic_store(&team->busy, (unsigned)team->members - 1);
    atomic_fetch_add(&team->loop, 1);
    wake(team);
    do_part(team, 0);
    wait_for_members(team);
}

int ovr_processors(void)
{
    long all = sysconf(_SC_NPROCESSORS_ONLN);
    cpu_set_t allowed;
    CPU_ZERO(&allowed);
    if (sched_getaffinity(0, sizeof allowed, &allowed) == 0 &&
        CPU_COUNT(&allowed) > 0)
        return CPU_COUNT(&allowed);
    return all > 0 ? (int)all : 1; /* more than a set can hold */
}
