/* SPDX-License-Identifier: GPL-3.0-or-later */
#define _GNU_SOURCE /* F_OFD_SETLK */
#include "results/turns.h"

#include <fcntl.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

enum { TRIES = 1000, PAUSE = 200000 }; /* ns; a fifth of a second at most */

static int set_lock(int journal, short kind)
{
#ifdef F_OFD_SETLK
    struct flock lock;
    memset(&lock, 0, sizeof lock);
    lock.l_type = kind;
    lock.l_whence = SEEK_SET;
    lock.l_len = 1;
    return fcntl(journal, F_OFD_SETLK, &lock);
#else
    (void)journal;
    (void)kind;
    return 0;
#endif
}

void ovr_turn_take(int journal, bool write)
{
    const struct timespec pause = {0, PAUSE};
    int tries = 0;
    while (set_lock(journal, write ? F_WRLCK : F_RDLCK) != 0 && ++tries < TRIES)
        nanosleep(&pause, NULL);
}

void ovr_turn_give(int journal)
{
    set_lock(journal, F_UNLCK);
}
