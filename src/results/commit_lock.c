/* SPDX-License-Identifier: GPL-3.0-or-later */
#define _GNU_SOURCE /* F_OFD_SETLK */
#include "results/commit_lock.h"

#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

enum { TRIES = 1000, PAUSE = 200000 }; /* ns; a fifth of a second at most */

/* Bytes that are locked: for the content, for the queue before it, and by a
 * writer for its life. */
enum { CONTENT, QUEUE, LIFE };

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

/* Nobody waits where there are no such locks. */
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

void ovr_commit_alive(int journal)
{
    set_lock(journal, LIFE, F_WRLCK);
}

bool ovr_commit_is_settled(int journal)
{
#ifdef F_OFD_SETLK
    struct flock lock = {
        .l_type = F_WRLCK, .l_whence = SEEK_SET, .l_start = LIFE, .l_len = 1};
    return set_lock(journal, CONTENT, F_RDLCK) == 0 &&
           fcntl(journal, F_OFD_GETLK, &lock) == 0 && lock.l_type != F_UNLCK;
#else
    (void)journal;
    return false;
#endif
}
