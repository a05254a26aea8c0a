/* SPDX-License-Identifier: GPL-3.0-or-later */
#define _GNU_SOURCE /* flock, F_OFD_SETLK */
#include "base/lock.h"

#include <errno.h>
#include <fcntl.h>
#include <sys/file.h>

/* Locks one byte, far after those of the commit lock. */
static int lock_byte(int fd, bool shared)
{
#ifdef F_OFD_SETLK
    struct flock lock = {.l_type = shared ? F_RDLCK : F_WRLCK,
                         .l_whence = SEEK_SET,
                         .l_start = 1 << 30,
                         .l_len = 1};
    if (fcntl(fd, F_OFD_SETLK, &lock) == 0)
        return 0;
    return errno == EAGAIN || errno == EACCES ? EWOULDBLOCK : errno;
#else
    (void)fd;
    (void)shared;
    return ENOLCK;
#endif
}

int ovr_lock_file(int fd, bool shared)
{
    int result;
    do
        result = flock(fd, (shared ? LOCK_SH : LOCK_EX) | LOCK_NB);
    while (result != 0 && errno == EINTR);
    if (result == 0)
        return 0;
    return errno == EWOULDBLOCK ? EWOULDBLOCK : lock_byte(fd, shared);
}

static int lock_range(int fd, int how, short kind, uint64_t at, uint64_t count,
                      struct flock *lock)
{
    int result;
    *lock = (struct flock){.l_type = kind,
                           .l_whence = SEEK_SET,
                           .l_start = (off_t)at,
                           .l_len = (off_t)count};
    do
        result = fcntl(fd, how, lock);
    while (result != 0 && errno == EINTR);
    if (result == 0)
        return 0;
    return errno == EAGAIN || errno == EACCES ? EWOULDBLOCK : errno;
}

#ifdef F_OFD_SETLK
int ovr_lock_bytes(int fd, uint64_t at, uint64_t count, bool wait)
{
    struct flock lock;
    return lock_range(fd, wait ? F_OFD_SETLKW : F_OFD_SETLK, F_WRLCK, at, count,
                      &lock);
}

void ovr_unlock_bytes(int fd, uint64_t at, uint64_t count)
{
    struct flock lock;
    lock_range(fd, F_OFD_SETLK, F_UNLCK, at, count, &lock);
}

bool ovr_bytes_locked(int fd, uint64_t at, uint64_t count)
{
    struct flock lock;
    return lock_range(fd, F_OFD_GETLK, F_WRLCK, at, count, &lock) == 0 &&
           lock.l_type != F_UNLCK;
}
#else /* process locks, which end when the process closes the file anywhere */
int ovr_lock_bytes(int fd, uint64_t at, uint64_t count, bool wait)
{
    struct flock lock;
    return lock_range(fd, wait ? F_SETLKW : F_SETLK, F_WRLCK, at, count, &lock);
}

void ovr_unlock_bytes(int fd, uint64_t at, uint64_t count)
{
    struct flock lock;
    lock_range(fd, F_SETLK, F_UNLCK, at, count, &lock);
}

bool ovr_bytes_locked(int fd, uint64_t at, uint64_t count)
{
    struct flock lock;
    return lock_range(fd, F_GETLK, F_WRLCK, at, count, &lock) == 0 &&
           lock.l_type != F_UNLCK;
}
#endif
