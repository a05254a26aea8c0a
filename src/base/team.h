/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Threads that share loops.
 *
 * A loop over `count` items is divided into contiguous parts, one for each
 * member of the team.  The calling thread is member 0.  The parts depend on
 * `count` and on the number of members alone.  A member therefore finds the
 * data of the loop before in its cache.
 *
 * A loop whose items are independent gives the same bits for any number of
 * members.  Sums over all items are to be stored item by item and added by the
 * caller.
 *
 * The child of a fork has no threads.  There the calling thread does all parts.
 *
 * Members that have no work wait actively for about 0.1 ms and then sleep.
 */
#ifndef OVR_BASE_TEAM_H
#define OVR_BASE_TEAM_H

#include <pthread.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stddef.h>
#include <sys/types.h>

enum { OVR_TEAM_MOST = 64 };

typedef struct ovr_team ovr_team;

/* Processes the items from .. to - 1 of a loop. */
typedef void ovr_team_work(void *data, int member, size_t from, size_t to);

typedef struct ovr_team_member {
    ovr_team *team;
    int number;
    pthread_t thread;
} ovr_team_member;

/* A struct of zeros is a team of only the calling thread. A started team must
 * not be moved. */
struct ovr_team {
    int members;   /* 0 or 1: no thread was started */
    pid_t process; /* process that started the threads */
    ovr_team_member member[OVR_TEAM_MOST];
    /* Current loop. Written by member 0 before it increments `loop`, while all
     * others wait. */
    ovr_team_work *work;
    void *data;
    size_t count;
    atomic_uint loop; /* number of the loop */
    atomic_uint busy; /* members other than 0 that are not finished */
    /* Protects the following. A member sleeps until `loop` changes, member 0
     * until `busy` is 0. */
    pthread_mutex_t mutex;
    pthread_cond_t changed;
    int asleep;
    bool closing;
};

/* Returns the number of processors that this process may use, within the limits
 * of taskset, a batch system or a container. */
int ovr_processors(void);

/* Starts members - 1 threads, or fewer if the system limits them. */
void ovr_team_start(ovr_team *team, int members);

/* Ends the threads; the team then consists of only the calling thread. */
void ovr_team_end(ovr_team *team);

/* Runs a loop and returns when all items are processed. */
void ovr_team_run(ovr_team *team, size_t count, ovr_team_work *work,
                  void *data);

#endif
