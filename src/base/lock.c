/* SPDX-License-Identifier: GPL-3.0-or-later */
#define _GNU_SOURCE /* flock, F_OFD_SETLK */
#include "base/lock.h"

#include <errno.h>
#include <fcntl.h>
#include <sys/file.h>

/* One byte, far behind those of the commit lock. */
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
