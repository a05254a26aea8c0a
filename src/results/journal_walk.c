/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Through the records of a journal, as far as they are whole. */
#include <string.h>
#include <sys/stat.h>
#include <zlib.h>

#include "base/disk.h"
#include "results/journal.h"

bool ovr_journal_first(ovr_journal_walk *w, int journal)
{
    const ovr_journal_header *h = &w->header;
    struct stat about;
    if (fstat(journal, &about) != 0 || about.st_size < (off_t)sizeof *h ||
        ovr_read_all(journal, &w->header, sizeof *h, 0) != 0)
        return false;
    w->fd = journal;
    w->at = sizeof *h;
    w->size = (uint64_t)about.st_size;
    return memcmp(h->magic, OVR_JOURNAL_MAGIC, sizeof h->magic) == 0 &&
           h->version == 2 && h->created[OVR_STORE_NAME - 1] == '\0' &&
           h->sum ==
               crc32(0, (const void *)h, offsetof(ovr_journal_header, sum));
}

const unsigned char *ovr_journal_next(ovr_journal_walk *w, ovr_arena *arena)
{
    ovr_journal_record *r = &w->record;
    unsigned char *content;
    uLong sum;
    ovr_arena_release(arena);
    if (w->size - w->at < sizeof *r ||
        ovr_read_all(w->fd, r, sizeof *r, w->at) != 0 ||
        r->salt != w->header.salt || r->bytes > w->size - w->at - sizeof *r)
        return NULL;
    content = ovr_arena_take(arena, (size_t)r->bytes + 1, 1, NULL);
    if (!content ||
        ovr_read_all(w->fd, content, (size_t)r->bytes, w->at + sizeof *r) != 0)
        return NULL;
    sum = crc32(0, (const void *)r, offsetof(ovr_journal_record, sum));
    if (crc32(sum, content, (uInt)r->bytes) != r->sum)
        return NULL;
    w->at += sizeof *r + r->bytes;
    return content;
}
