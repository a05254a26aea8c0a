/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Library for LD_PRELOAD that records the disk operations of a program:
 *
 *     RECORD=log       to this file (read by crash_states.py)
 *     RECORD_NAME=s    of files whose names begin with s, and of folders
 *     RECORD_KILL=k    and kills the program at its k-th operation
 *     RECORD_SPEED=k   the clock runs k times faster, so that periodic
 *                      operations of a run are more frequent
 *
 * A record contains the number of the operation, a descriptor, an offset and a
 * length (64 bits each), then as many bytes: data, or a name (two names for a
 * rename, each with its end). Operations are in the order in which they
 * happened. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

enum { CREATE = 1, OPEN, CLOSE, WRITE, CUT, SYNC, SYNC_NAMES, RENAME, UNLINK };
enum { MAX = 1024 };

static pthread_mutex_t one_at_a_time = PTHREAD_MUTEX_INITIALIZER;
static unsigned char watched[MAX]; /* 1: a file, 2: a folder */
static int out = -1;
static long operations, last; /* to be killed at; 0: never */

#define REAL(type, name, ...)                                                  \
    static type (*real)(__VA_ARGS__);                                          \
    if (!real)                                                                 \
    *(void **)&real = dlsym(RTLD_NEXT, name)

static ssize_t real_write(int fd, const void *data, size_t bytes)
{
    REAL(ssize_t, "write", int, const void *, size_t);
    return real(fd, data, bytes);
}

static int real_open(const char *path, int flags, int mode)
{
    REAL(int, "open", const char *, int, ...);
    return real(path, flags, mode);
}

__attribute__((constructor)) static void begin(void)
{
    const char *path = getenv("RECORD");
    const char *kill = getenv("RECORD_KILL");
    last = kill ? strtol(kill, NULL, 10) : 0;
    if (path)
        out = real_open(path, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
}

static void note(int what, int fd, int64_t at, const void *data, size_t bytes)
{
    int64_t head[4] = {what, fd, at, (int64_t)bytes};
    if (out < 0)
        return;
    if (real_write(out, head, sizeof head) != (ssize_t)sizeof head ||
        (bytes && real_write(out, data, bytes) != (ssize_t)bytes))
        abort();
    if (++operations == last)
        raise(SIGKILL);
}

static int is_ours(const char *path)
{
    const char *name = getenv("RECORD_NAME"), *slash = strrchr(path, '/');
    const char *file = slash ? slash + 1 : path;
    return name && strncmp(file, name, strlen(name)) == 0;
}

static int is_watched(int fd)
{
    return fd >= 0 && fd < MAX ? watched[fd] : 0;
}

static int open_any(const char *path, int flags, int mode)
{
    int there = access(path, F_OK) == 0, fd, ours = is_ours(path);
    struct stat about;
    pthread_mutex_lock(&one_at_a_time);
    fd = real_open(path, flags, mode);
    if (fd >= 0 && fd < MAX) {
        watched[fd] = (unsigned char)(ours && (flags & O_ACCMODE) != O_RDONLY);
        if (watched[fd])
            note(there ? OPEN : CREATE, fd, flags & O_TRUNC ? 1 : 0, path,
                 strlen(path) + 1);
        else if (fstat(fd, &about) == 0 && S_ISDIR(about.st_mode))
            watched[fd] = 2;
    }
    pthread_mutex_unlock(&one_at_a_time);
    return fd;
}

int open(const char *path, int flags, ...)
{
    va_list more;
    int mode;
    va_start(more, flags);
    mode = flags & O_CREAT ? va_arg(more, int) : 0;
    va_end(more);
    return open_any(path, flags, mode);
}

int open64(const char *path, int flags, ...)
{
    va_list more;
    int mode;
    va_start(more, flags);
    mode = flags & O_CREAT ? va_arg(more, int) : 0;
    va_end(more);
    return open_any(path, flags, mode);
}

int close(int fd)
{
    REAL(int, "close", int);
    int result;
    pthread_mutex_lock(&one_at_a_time);
    if (is_watched(fd) == 1)
        note(CLOSE, fd, 0, NULL, 0);
    if (fd >= 0 && fd < MAX)
        watched[fd] = 0;
    result = real(fd);
    pthread_mutex_unlock(&one_at_a_time);
    return result;
}

static ssize_t noted(int fd, ssize_t done, off_t at, const void *data)
{
    if (done > 0 && is_watched(fd) == 1)
        note(WRITE, fd, at, data, (size_t)done);
    return done;
}

ssize_t write(int fd, const void *data, size_t bytes)
{
    ssize_t done;
    if (is_watched(fd) != 1)
        return real_write(fd, data, bytes);
    pthread_mutex_lock(&one_at_a_time);
    off_t at = lseek(fd, 0, SEEK_CUR);
    done = noted(fd, real_write(fd, data, bytes), at, data);
    pthread_mutex_unlock(&one_at_a_time);
    return done;
}

ssize_t pwrite(int fd, const void *data, size_t bytes, off_t at)
{
    REAL(ssize_t, "pwrite", int, const void *, size_t, off_t);
    ssize_t done;
    pthread_mutex_lock(&one_at_a_time);
    done = noted(fd, real(fd, data, bytes, at), at, data);
    pthread_mutex_unlock(&one_at_a_time);
    return done;
}

ssize_t pwrite64(int fd, const void *data, size_t bytes, off_t at)
{
    return pwrite(fd, data, bytes, at);
}

int ftruncate(int fd, off_t length)
{
    REAL(int, "ftruncate", int, off_t);
    int result;
    pthread_mutex_lock(&one_at_a_time);
    result = real(fd, length);
    if (result == 0 && is_watched(fd) == 1)
        note(CUT, fd, length, NULL, 0);
    pthread_mutex_unlock(&one_at_a_time);
    return result;
}

int ftruncate64(int fd, off_t length)
{
    return ftruncate(fd, length);
}

int fsync(int fd)
{
    REAL(int, "fsync", int);
    int result, kind = is_watched(fd);
    pthread_mutex_lock(&one_at_a_time);
    result = real(fd);
    if (result == 0 && kind)
        note(kind == 1 ? SYNC : SYNC_NAMES, fd, 0, NULL, 0);
    pthread_mutex_unlock(&one_at_a_time);
    return result;
}

int fdatasync(int fd)
{
    return fsync(fd);
}

int rename(const char *from, const char *to)
{
    REAL(int, "rename", const char *, const char *);
    char names[8192];
    int result, length;
    pthread_mutex_lock(&one_at_a_time);
    result = real(from, to);
    length = snprintf(names, sizeof names, "%s%c%s", from, 0, to);
    if (result == 0 && is_ours(to))
        note(RENAME, -1, 0, names, (size_t)length + 1);
    pthread_mutex_unlock(&one_at_a_time);
    return result;
}

int unlink(const char *path)
{
    REAL(int, "unlink", const char *);
    int result;
    pthread_mutex_lock(&one_at_a_time);
    result = real(path);
    if (result == 0 && is_ours(path))
        note(UNLINK, -1, 0, path, strlen(path) + 1);
    pthread_mutex_unlock(&one_at_a_time);
    return result;
}

int clock_gettime(clockid_t clock, struct timespec *now)
{
    REAL(int, "clock_gettime", clockid_t, struct timespec *);
    const char *text = getenv("RECORD_SPEED");
    int result = real(clock, now);
    if (result == 0 && text && clock == CLOCK_MONOTONIC) {
        int64_t speed = strtol(text, NULL, 10);
        int64_t ns = speed * (now->tv_sec * INT64_C(1000000000) + now->tv_nsec);
        now->tv_sec = (time_t)(ns / 1000000000);
        now->tv_nsec = (long)(ns % 1000000000);
    }
    return result;
}
