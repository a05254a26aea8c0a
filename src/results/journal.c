/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "results/journal.h"

#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include "base/lock.h"

static const char magic[16] = "overroll journal";

typedef struct header {
    char magic[16];
    uint64_t one, committed, length, pages, before, after;
} header;

typedef struct record {
    uint64_t number;
    unsigned char data[OVR_PAGE];
} record;

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

static uint64_t checksum(uint64_t sum, const void *data, size_t bytes)
{
    return crc32((uLong)sum, data, (uInt)bytes);
}

/* -------------------------------------------------------------- opening */

static bool same_file(int fd, const char *path)
{
    struct stat open, named;
    return fstat(fd, &open) == 0 && stat(path, &named) == 0 &&
           open.st_ino == named.st_ino && open.st_dev == named.st_dev;
}

/* The one who locked it before may have removed it meanwhile: then again. */
int ovr_journal_open(ovr_store *s)
{
    for (int attempt = 0; attempt < 100; attempt++) {
        int error;
        int fd = open(s->journal_path,
                      O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666);
        if (fd < 0)
            return errno;
        error = ovr_lock_file(fd, false);
        if (error != EWOULDBLOCK && same_file(fd, s->journal_path)) {
            s->journal = fd;
            s->unlocked = error != 0;
            return 0;
        }
        close(fd);
        if (error == EWOULDBLOCK)
            return error;
    }
    return EWOULDBLOCK;
}

/* -------------------------------------------------------------- writing */

/* Bytes of a page that lie below the committed length. */
static size_t page_bytes(const ovr_store *s, uint64_t number)
{
    uint64_t left = s->committed - number * OVR_PAGE;
    return left < OVR_PAGE ? (size_t)left : OVR_PAGE;
}

static int page_zero_sums(const ovr_store *s, header *h)
{
    const ovr_page *page = ovr_pages_find(&s->changed, 0);
    unsigned char now[OVR_PAGE];
    size_t bytes = page_bytes(s, 0);
    int error = ovr_read_all(s->fd, now, bytes, 0);
    h->before = h->after = checksum(0, now, bytes);
    if (page)
        h->after = checksum(0, page->data, bytes);
    return error;
}

int ovr_journal_write(ovr_store *s)
{
    header h = {"", 1, s->committed, s->length, s->changed.count, 0, 0};
    record r;
    uint64_t at = sizeof h, sum;
    int error = page_zero_sums(s, &h);
    memcpy(h.magic, magic, sizeof magic);
    sum = checksum(0, &h, sizeof h);
    if (error == 0)
        error = ovr_write_all(s->journal, &h, sizeof h, 0);
    for (size_t k = 0; error == 0 && k < s->changed.count; k++) {
        r.number = s->changed.page[k].number;
        memcpy(r.data, s->changed.page[k].data, OVR_PAGE);
        sum = checksum(sum, &r, sizeof r);
        error = ovr_write_all(s->journal, &r, sizeof r, at);
        at += sizeof r;
    }
    return error ? error : ovr_write_all(s->journal, &sum, sizeof sum, at);
}

/* -------------------------------------------------------------- replaying */

static bool whole(int journal, header *h)
{
    struct stat about;
    record r;
    uint64_t at = sizeof *h, sum, found;
    if (fstat(journal, &about) != 0 || about.st_size < (off_t)sizeof *h ||
        ovr_read_all(journal, h, sizeof *h, 0) != 0 ||
        memcmp(h->magic, magic, sizeof magic) != 0 || h->one != 1 ||
        h->pages > (uint64_t)about.st_size / sizeof r ||
        (uint64_t)about.st_size <
            sizeof *h + h->pages * sizeof r + sizeof found)
        return false;
    sum = checksum(0, h, sizeof *h);
    for (uint64_t k = 0; k < h->pages; k++, at += sizeof r) {
        if (ovr_read_all(journal, &r, sizeof r, at) != 0)
            return false;
        sum = checksum(sum, &r, sizeof r);
    }
    return ovr_read_all(journal, &found, sizeof found, at) == 0 && found == sum;
}

static bool belongs(int file, const header *h)
{
    struct stat about;
    unsigned char page[OVR_PAGE];
    size_t bytes = h->committed < OVR_PAGE ? (size_t)h->committed : OVR_PAGE;
    uint64_t sum;
    if (fstat(file, &about) != 0 || (uint64_t)about.st_size < h->committed ||
        ovr_read_all(file, page, bytes, 0) != 0)
        return false;
    sum = checksum(0, page, bytes);
    return sum == h->before || sum == h->after;
}

bool ovr_journal_pending(int journal, int file)
{
    header h;
    return whole(journal, &h) && belongs(file, &h);
}

static int apply(ovr_store *s, const header *h)
{
    record r;
    uint64_t at = sizeof *h;
    int error = 0;
    s->committed = h->committed;
    for (uint64_t k = 0; error == 0 && k < h->pages; k++, at += sizeof r) {
        error = ovr_read_all(s->journal, &r, sizeof r, at);
        if (error == 0 && r.number < (h->committed + OVR_PAGE - 1) / OVR_PAGE)
            error = ovr_write_all(s->fd, r.data, page_bytes(s, r.number),
                                  r.number * OVR_PAGE);
    }
    if (error == 0 && ftruncate(s->fd, (off_t)h->length) != 0)
        error = errno;
    return error;
}

int ovr_journal_replay(ovr_store *s)
{
    header h;
    int error = 0;
    if (whole(s->journal, &h) && belongs(s->fd, &h)) {
        error = apply(s, &h);
        s->repaired = error == 0;
    }
    if (error == 0 && ftruncate(s->journal, 0) != 0)
        error = errno;
    return error;
}
