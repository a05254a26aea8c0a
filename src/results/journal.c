/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Writing a journal: its form is described in journal.h. */
#include "results/journal.h"

#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>
#include <zlib.h>

#include "base/disk.h"
#include "base/lock.h"
#include "results/commit_lock.h"

static uint64_t checksum(uint64_t sum, const void *data, size_t bytes)
{
    return crc32((uLong)sum, data, (uInt)bytes);
}

/* -------------------------------------------------------------- opening */

bool ovr_file_is_named(int fd, const char *path)
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
        if (error != EWOULDBLOCK && ovr_file_is_named(fd, s->journal_path)) {
            s->journal = fd;
            ovr_commit_alive(fd);
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

/* No two journals of a file have the same. */
static uint64_t new_salt(void)
{
    struct timespec now;
    clock_gettime(CLOCK_REALTIME, &now);
    return (uint64_t)now.tv_sec * 1000000000u + (uint64_t)now.tv_nsec +
           ((uint64_t)getpid() << 40);
}

/* The names of the file and its checkpoint first: what the journal held until
 * now may belong to the file that had this name before. */
static int begin(ovr_store *s)
{
    ovr_kept *k = &s->kept;
    ovr_journal_header h = {"", 2, k->number, k->length, 0, "", 0};
    int error = k->named ? 0 : ovr_sync_folder(s->path);
    k->salt = h.salt = new_salt();
    memcpy(h.magic, OVR_JOURNAL_MAGIC, sizeof h.magic);
    memcpy(h.created, s->created, sizeof h.created);
    h.sum = checksum(0, &h, offsetof(ovr_journal_header, sum));
    if (error == 0 && ftruncate(s->journal, 0) != 0)
        error = errno;
    if (error == 0)
        error = ovr_write_all(s->journal, &h, sizeof h, 0);
    k->named = k->named || error == 0;
    k->begun = error == 0;
    k->end = sizeof h;
    return error;
}

static size_t minimum(uint64_t a, uint64_t b)
{
    return (size_t)(a < b ? a : b);
}

/* A bit for each page of the checkpoint; more of them than before where the
 * file has grown since. */
static bool is_kept(const ovr_kept *k, uint64_t number)
{
    return number / 8 < k->capacity && k->pages[number / 8] >> number % 8 & 1;
}

static int note_kept(ovr_store *s, uint64_t number)
{
    ovr_kept *k = &s->kept;
    if (number / 8 >= k->capacity) {
        size_t capacity = 2 * (size_t)(number / 8) + 64;
        unsigned char *more = ovr_arena_take(s->changed.arena, capacity, 1,
                                             NULL);
        if (!more)
            return ENOMEM;
        memset(more, 0, capacity);
        if (k->capacity)
            memcpy(more, k->pages, k->capacity);
        k->pages = more;
        k->capacity = capacity;
    }
    k->pages[number / 8] |= (unsigned char)(1u << number % 8);
    return 0;
}

/* A commit appends this, written at once. */
typedef struct addition {
    ovr_arena arena;
    unsigned char *data;
    size_t bytes;
    size_t state; /* bytes of the state, behind these */
    bool pages;   /* some of it are pages */
} addition;

static uint64_t pages_of(uint64_t length)
{
    return (length + OVR_PAGE - 1) / OVR_PAGE;
}

/* Pages whose checksums the state needs, at most: those changed, then those
 * written behind what was committed before. */
static size_t entries(const ovr_store *s)
{
    uint64_t first = s->kept.summed / OVR_PAGE, end = pages_of(s->length);
    return s->changed.count + (size_t)(end > first ? end - first : 0);
}

static int reserve(const ovr_store *s, addition *a)
{
    size_t record = sizeof(ovr_journal_record);
    size_t pages = s->changed.count * (record + OVR_PAGE);
    a->arena = ovr_arena_make(&s->changed.arena->allocator);
    a->data = ovr_arena_take(
        &a->arena, pages + record + entries(s) * sizeof(ovr_journal_entry), 1,
        NULL);
    return a->data ? 0 : ENOMEM;
}

/* The content is there already. */
static void end_record(const ovr_store *s, addition *a, uint64_t kind,
                       uint64_t where, size_t bytes)
{
    ovr_journal_record r = {s->kept.salt, kind, where, bytes, 0};
    unsigned char *content = a->data + a->bytes + sizeof r;
    r.sum = checksum(0, &r, offsetof(ovr_journal_record, sum));
    r.sum = checksum(r.sum, content, bytes);
    memcpy(a->data + a->bytes, &r, sizeof r);
    a->bytes += sizeof r + bytes;
}

/* What was not kept yet is in the file as the checkpoint had it. */
static int keep_page(ovr_store *s, addition *a, const ovr_page *page)
{
    size_t bytes = minimum(OVR_PAGE, s->kept.length - page->number * OVR_PAGE);
    int error = note_kept(s, page->number);
    memcpy(a->data + a->bytes + sizeof(ovr_journal_record), page->was, bytes);
    if (error == 0)
        end_record(s, a, OVR_JOURNAL_PAGE, page->number, bytes);
    a->pages = true;
    return error;
}

static int keep_pages(ovr_store *s, addition *a)
{
    int error = 0;
    for (size_t k = 0; error == 0 && k < s->changed.count; k++) {
        const ovr_page *page = &s->changed.page[k];
        if (page->number * OVR_PAGE < s->kept.length &&
            !is_kept(&s->kept, page->number))
            error = keep_page(s, a, page);
    }
    return error;
}

/* Notes a page, `now` being its content, as far as the file goes. */
static void name_page(const ovr_store *s, addition *a, uint64_t page,
                      const unsigned char *now)
{
    size_t bytes = minimum(OVR_PAGE, s->length - page * OVR_PAGE);
    ovr_journal_entry e = {page, (uint32_t)bytes,
                           (uint32_t)checksum(0, now, bytes)};
    memcpy(a->data + a->bytes + sizeof(ovr_journal_record) + a->state, &e,
           sizeof e);
    a->state += sizeof e;
}

/* Those that lie behind what was committed before, many at a time. */
static int name_new_pages(ovr_store *s, addition *a)
{
    enum { MANY = 16 };
    unsigned char now[MANY * OVR_PAGE];
    uint64_t page = s->kept.summed / OVR_PAGE, end = pages_of(s->length);
    while (page < end) {
        uint64_t at = page * OVR_PAGE, left = end - page;
        if (!ovr_store_read(s, at, minimum(sizeof now, s->length - at), now))
            return s->failed;
        for (size_t k = 0; k < minimum(MANY, left); k++)
            name_page(s, a, page + k, now + k * OVR_PAGE);
        page += minimum(MANY, left);
    }
    return 0;
}

/* A page that ends behind what is committed is one of the new ones. */
static int add_state(ovr_store *s, addition *a)
{
    uint64_t first = s->kept.summed / OVR_PAGE;
    int error = 0;
    for (size_t k = 0; k < s->changed.count; k++) {
        const ovr_page *p = &s->changed.page[k];
        if (p->number < first && p->number * OVR_PAGE < s->length)
            name_page(s, a, p->number, p->data);
    }
    error = name_new_pages(s, a);
    if (error == 0)
        end_record(s, a, OVR_JOURNAL_STATE, s->length, a->state);
    return error;
}

static int append(ovr_store *s, const addition *a)
{
    int error = ovr_write_all(s->journal, a->data, a->bytes, s->kept.end);
    if (error == 0 && a->pages && fsync(s->journal) != 0)
        error = errno;
    if (error) { /* the file is untouched: no state must say otherwise */
        (void)!ftruncate(s->journal, (off_t)s->kept.end);
        return error;
    }
    s->kept.end += a->bytes;
    s->kept.summed = s->length;
    return 0;
}

int ovr_journal_write(ovr_store *s)
{
    addition a = {.arena = ovr_arena_make(NULL)};
    int error = s->kept.begun ? 0 : begin(s);
    if (error == 0)
        error = reserve(s, &a);
    if (error == 0)
        error = keep_pages(s, &a);
    if (error == 0)
        error = add_state(s, &a);
    if (error == 0)
        error = append(s, &a);
    ovr_arena_release(&a.arena);
    return error;
}
