/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Library for LD_PRELOAD that makes system calls of a program fail:
 *
 *     FAULT_MALLOC=k   the k-th malloc, calloc or realloc returns NULL
 *     FAULT_WRITE=k    the k-th write to a file and all later ones fail ...
 *     FAULT_ERRNO=e    ... with this errno (28: no space; 5: I/O error)
 *     FAULT_KILL=k     the process is killed at the k-th write to a file
 *     FAULT_READ=k     the k-th read from a file fails
 *     FAULT_SYNC=1     every fsync fails
 *     FAULT_SHORT=1    writes and reads process half of the requested bytes
 *     FAULT_KEEP=s     files with names ...s cannot be unlinked, like those of
 *                      another user in a shared folder
 *     FAULT_LOCK=e     the file system has no locks: that errno
 *     FAULT_FLOCK=e    the file system has no flock, but locks of open file
 *                      descriptions
 *     FAULT_REPORT=f   appends the numbers of calls to f at the end
 *
 * Standard input, output and error are not affected. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static long mallocs, writes, reads;

static long setting(const char *name)
{
    const char *text = getenv(name);
    return text ? strtol(text, NULL, 10) : 0;
}

/* malloc is called before the constructor runs: settings are read there. */
static long fail_malloc, fail_write, fail_read, fail_sync, halves, code;
static long kill_write;

__attribute__((constructor)) static void begin(void)
{
    fail_malloc = setting("FAULT_MALLOC");
    fail_write = setting("FAULT_WRITE");
    fail_read = setting("FAULT_READ");
    kill_write = setting("FAULT_KILL");
    fail_sync = setting("FAULT_SYNC");
    halves = setting("FAULT_SHORT");
    code = setting("FAULT_ERRNO");
    mallocs = writes = reads = 0;
}

__attribute__((destructor)) static void report(void)
{
    const char *path = getenv("FAULT_REPORT");
    FILE *out = path ? fopen(path, "w") : NULL;
    if (!out)
        return;
    fprintf(out, "%ld %ld %ld\n", mallocs, writes, reads);
    fclose(out);
}

void *__libc_malloc(size_t bytes);
void *__libc_calloc(size_t count, size_t bytes);
void *__libc_realloc(void *old, size_t bytes);

static int out_of_memory(void)
{
    if (++mallocs != fail_malloc)
        return 0;
    errno = ENOMEM;
    return 1;
}

void *malloc(size_t bytes)
{
    return out_of_memory() ? NULL : __libc_malloc(bytes);
}

void *calloc(size_t count, size_t bytes)
{
    return out_of_memory() ? NULL : __libc_calloc(count, bytes);
}

void *realloc(void *old, size_t bytes)
{
    return out_of_memory() ? NULL : __libc_realloc(old, bytes);
}

/* How many bytes to write: as asked, half, or none with errno set. */
static ssize_t allowed(int fd, size_t bytes)
{
    if (fd <= 2)
        return (ssize_t)bytes;
    if (++writes == kill_write)
        raise(SIGKILL);
    if (writes >= fail_write && fail_write) {
        errno = code ? (int)code : ENOSPC;
        return -1;
    }
    return (ssize_t)(halves && bytes > 1 ? bytes / 2 : bytes);
}

static ssize_t readable(int fd, size_t bytes)
{
    if (fd <= 2)
        return (ssize_t)bytes;
    if (++reads == fail_read) {
        errno = code ? (int)code : EIO;
        return -1;
    }
    return (ssize_t)(halves && bytes > 1 ? bytes / 2 : bytes);
}

#define REAL(type, name, ...)                                                  \
    static type (*real)(__VA_ARGS__);                                          \
    if (!real)                                                                 \
    *(void **)&real = dlsym(RTLD_NEXT, name)

ssize_t write(int fd, const void *data, size_t bytes)
{
    REAL(ssize_t, "write", int, const void *, size_t);
    ssize_t size = allowed(fd, bytes);
    return size < 0 ? size : real(fd, data, (size_t)size);
}

ssize_t pwrite(int fd, const void *data, size_t bytes, off_t at)
{
    REAL(ssize_t, "pwrite", int, const void *, size_t, off_t);
    ssize_t size = allowed(fd, bytes);
    return size < 0 ? size : real(fd, data, (size_t)size, at);
}

ssize_t pwrite64(int fd, const void *data, size_t bytes, off_t at)
{
    return pwrite(fd, data, bytes, at);
}

ssize_t read(int fd, void *data, size_t bytes)
{
    REAL(ssize_t, "read", int, void *, size_t);
    ssize_t size = readable(fd, bytes);
    return size < 0 ? size : real(fd, data, (size_t)size);
}

ssize_t pread(int fd, void *data, size_t bytes, off_t at)
{
    REAL(ssize_t, "pread", int, void *, size_t, off_t);
    ssize_t size = readable(fd, bytes);
    return size < 0 ? size : real(fd, data, (size_t)size, at);
}

ssize_t pread64(int fd, void *data, size_t bytes, off_t at)
{
    return pread(fd, data, bytes, at);
}

int fsync(int fd)
{
    REAL(int, "fsync", int);
    if (fail_sync) {
        errno = EIO;
        return -1;
    }
    return real(fd);
}

int flock(int fd, int how)
{
    REAL(int, "flock", int, int);
    errno = (int)(setting("FAULT_LOCK") | setting("FAULT_FLOCK"));
    return errno ? -1 : real(fd, how);
}

int fcntl(int fd, int command, ...)
{
    REAL(int, "fcntl", int, int, ...);
    va_list arguments;
    void *what;
    va_start(arguments, command);
    what = va_arg(arguments, void *);
    va_end(arguments);
    errno = (int)setting("FAULT_LOCK");
    return errno && command == F_OFD_SETLK ? -1 : real(fd, command, what);
}

int unlink(const char *path)
{
    const char *kept = getenv("FAULT_KEEP");
    size_t length = strlen(path), end = kept ? strlen(kept) : 0;
    REAL(int, "unlink", const char *);
    if (!end || length < end || strcmp(path + length - end, kept) != 0)
        return real(path);
    errno = EPERM;
    return -1;
}
