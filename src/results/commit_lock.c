/* SPDX-License-Identifier: GPL-3.0-or-later */
#define _GNU_SOURCE /* F_OFD_SETLK */
#include "results/commit_lock.h"

#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

enum { TRIES = 1000, PAUSE = 200000 }; /* ns; a fifth of a second at most */

/* Bytes that are locked: for the content, and for the queue before it. */
enum { CONTENT, QUEUE };

static int set_lock(int journal, int byte, short kind)
{
#ifdef F_OFD_SETLK
    struct flock lock;
    memset(&lock, 0, sizeof lock);
    lock.l_type = kind;
    lock.l_whence = SEEK_SET;
    lock.l_start = byte;
    lock.l_len = 1;
    return fcntl(journal, F_OFD_SETLK, &lock);
#else
    (void)journal;
    (void)byte;
    (void)kind;
    return 0;
#endif
}

/* Where there are no such locks nobody waits. */
static bool is_taken(int journal, int byte, short kind)
{
    return set_lock(journal, byte, kind) != 0 &&
           (errno == EAGAIN || errno == EACCES);
}

static void wait_for(int journal, int byte, short kind)
{
    const struct timespec pause = {0, PAUSE};
    int tries = 0;
    while (is_taken(journal, byte, kind) && ++tries < TRIES)
        nanosleep(&pause, NULL);
}

void ovr_commit_lock(int journal, bool write)
{
    short kind = write ? F_WRLCK : F_RDLCK;
    wait_for(journal, QUEUE, kind);
    wait_for(journal, CONTENT, kind);
    set_lock(journal, QUEUE, F_UNLCK);
}

void ovr_commit_unlock(int journal)
{
    set_lock(journal, CONTENT, F_UNLCK);
}
