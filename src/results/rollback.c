/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Going back to the last checkpoint, by the journal. */
#include <errno.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include "base/disk.h"
#include "results/journal.h"

/* The date stands among the headers, at the file's beginning. */
static bool stands_in(int file, const char *created, ovr_arena *arena)
{
    enum { MAX = 1 << 20 };
    size_t length = strnlen(created, OVR_STORE_NAME), bytes;
    struct stat about;
    char *data;
    if (length == 0)
        return true;
    if (fstat(file, &about) != 0)
        return false;
    bytes = about.st_size < MAX ? (size_t)about.st_size : MAX;
    data = ovr_arena_take(arena, bytes + 1, 1, NULL);
    if (!data || ovr_read_all(file, data, bytes, 0) != 0)
        return false;
    for (size_t k = 0; k + length <= bytes; k++)
        if (data[k] == created[0] && memcmp(data + k, created, length) == 0)
            return true;
    return false;
}

static bool is_meant(const ovr_store *s, const ovr_journal_header *h,
                     ovr_arena *arena)
{
    struct stat about;
    bool known = s->created[0] != '\0';
    if (known &&
        (strcmp(s->created, h->created) != 0 || s->kept.number != h->number))
        return false;
    return fstat(s->fd, &about) == 0 && (uint64_t)about.st_size >= h->length &&
           stands_in(s->fd, h->created, arena);
}

static int put_back(const ovr_store *s, ovr_journal_walk *w, ovr_arena *arena)
{
    const ovr_journal_record *r = &w->record;
    const unsigned char *content;
    int error = 0;
    while (error == 0 && (content = ovr_journal_next(w, arena)) != NULL) {
        uint64_t at = r->where * OVR_PAGE;
        if (r->kind == OVR_JOURNAL_PAGE && r->bytes <= OVR_PAGE &&
            r->where < w->header.length / OVR_PAGE + 1 &&
            at + r->bytes <= w->header.length)
            error = ovr_write_all(s->fd, content, (size_t)r->bytes, at);
    }
    if (error == 0 && ftruncate(s->fd, (off_t)w->header.length) != 0)
        error = errno;
    if (error == 0 && fsync(s->fd) != 0)
        error = errno;
    return error;
}

int ovr_journal_roll_back(ovr_store *s)
{
    ovr_arena arena = ovr_arena_make(&s->changed.arena->allocator);
    ovr_journal_walk walk;
    int error = 0;
    if (ovr_journal_first(&walk, s->journal) &&
        is_meant(s, &walk.header, &arena)) {
        s->repaired = ovr_journal_torn(s->journal, s->fd,
                                       &s->changed.arena->allocator);
        error = put_back(s, &walk, &arena);
        s->kept.needed = error != 0;
        s->kept.number = walk.header.number;
    }
    ovr_arena_release(&arena);
    return error;
}
