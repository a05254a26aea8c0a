/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/disk.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "base/error.h"

int ovr_write_all(int fd, const void *from, size_t bytes, uint64_t at)
{
    const char *next = from;
    while (bytes > 0) {
        ssize_t n = pwrite(fd, next, bytes, (off_t)at);
        if (n < 0 && errno == EINTR)
            continue;
        if (n <= 0)
            return n < 0 ? errno : ENOSPC;
        next += n;
        at += (uint64_t)n;
        bytes -= (size_t)n;
    }
    return 0;
}

int ovr_read_all(int fd, void *to, size_t bytes, uint64_t at)
{
    char *next = to;
    while (bytes > 0) {
        ssize_t n = pread(fd, next, bytes, (off_t)at);
        if (n < 0 && errno == EINTR)
            continue;
        if (n < 0)
            return errno;
        if (n == 0)
            break;
        next += n;
        at += (uint64_t)n;
        bytes -= (size_t)n;
    }
    memset(next, 0, bytes);
    return 0;
}

/* A folder that one may write to but not read cannot be opened; some file
 * systems sync no folders. */
int ovr_sync_folder(const char *path)
{
    const char *slash = strrchr(path, '/');
    char folder[4096] = ".";
    int fd, error = 0;
    if (slash)
        snprintf(folder, sizeof folder, "%.*s", (int)(slash - path + 1), path);
    fd = open(folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (fd < 0)
        return 0;
    if (fsync(fd) != 0 && errno != EINVAL && errno != ENOTSUP)
        error = errno;
    close(fd);
    return error;
}

ovr_status ovr_file_ours(const char *path, const char *head, ovr_error *err)
{
    FILE *from = fopen(path, "r");
    size_t k = 0;
    int c = EOF;
    if (!from)
        return OVR_OK; /* no journal, or its writer has failed */
    while (head[k] && (c = getc(from)) == (unsigned char)head[k])
        k++;
    fclose(from);
    if (!head[k] || (k == 0 && c == EOF))
        return OVR_OK;
    return ovr_fail(err, OVR_BAD_INPUT,
                    "%s: exists and was not written by overroll; --force "
                    "replaces it",
                    path);
}
