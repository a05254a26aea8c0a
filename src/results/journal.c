/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The journal of a result file (journal.h describes its form).  Records are
 * read, written at a commit and used to restore the last checkpoint.  The
 * checksums in them decide if a file is in a state that a commit left.
 */
#define _GNU_SOURCE /* F_OFD_SETLK */
#include "results/journal.h"

#include <errno.h>
#include <fcntl.h>
#include <libdeflate.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "base/disk.h"
#include "base/lock.h"

/* ----------------------------------------- lock between commits and readers */

enum { TRIES = 1000, PAUSE = 200000 }; /* ns; 0.2 s in total */

/* Bytes of the journal used as locks: contents (see above), queue before it,
 * and a byte held while a writer exists. */
enum { CONTENT, QUEUE, LIFE };

static int set_lock(int journal, int byte, short kind)
{
#ifdef F_OFD_SETLK
    struct flock lock;
    memset(&lock, 0, sizeof lock);
    lock.l_type = kind;
    lock.l_whence = SEEK_SET;
    lock.l_start = byte;
    lock.l_len = 1;
    return fcntl(journal, F_OFD_SETLK, &lock);
#else
    (void)journal;
    (void)byte;
    (void)kind;
    return 0;
#endif
}

/* True if another process holds the lock; false on systems without such
 * locks. */
static bool is_taken(int journal, int byte, short kind)
{
    return set_lock(journal, byte, kind) != 0 &&
           (errno == EAGAIN || errno == EACCES);
}

static void wait_for(int journal, int byte, short kind)
{
    const struct timespec pause = {0, PAUSE};
    int tries = 0;
    while (is_taken(journal, byte, kind) && ++tries < TRIES)
        nanosleep(&pause, NULL);
}

void ovr_commit_lock(int journal, bool write)
{
    short kind = write ? F_WRLCK : F_RDLCK;
    wait_for(journal, QUEUE, kind);
    wait_for(journal, CONTENT, kind);
    set_lock(journal, QUEUE, F_UNLCK);
}

void ovr_commit_unlock(int journal)
{
    set_lock(journal, CONTENT, F_UNLCK);
}

/* Marks that a writer exists, until the descriptor is closed. */
static void commit_alive(int journal)
{
    set_lock(journal, LIFE, F_WRLCK);
}

bool ovr_commit_is_settled(int journal)
{
#ifdef F_OFD_SETLK
    struct flock lock = {
        .l_type = F_WRLCK, .l_whence = SEEK_SET, .l_start = LIFE, .l_len = 1};
    return set_lock(journal, CONTENT, F_RDLCK) == 0 &&
           fcntl(journal, F_OFD_GETLK, &lock) == 0 && lock.l_type != F_UNLCK;
#else
    (void)journal;
    return false;
#endif
}

/* Computes crc32, several times as fast as zlib. */
static uint64_t checksum(uint64_t sum, const void *data, size_t bytes)
{
    return libdeflate_crc32((uint32_t)sum, data, bytes);
}

/* ------------------------------------------------------------------ Reading */

/* Reads the header; false if it is missing or incomplete. */
static bool journal_first(ovr_journal_walk *w, int journal)
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
           h->sum == checksum(0, h, offsetof(ovr_journal_header, sum));
}

/* Returns the content of the next record, in memory of the arena, which is
 * cleared first; NULL if there is none. */
static const unsigned char *journal_next(ovr_journal_walk *w, ovr_arena *arena)
{
    ovr_journal_record *r = &w->record;
    unsigned char *content;
    uint64_t sum;
    ovr_arena_release(arena);
    if (w->size - w->at < sizeof *r ||
        ovr_read_all(w->fd, r, sizeof *r, w->at) != 0 ||
        r->salt != w->header.salt || r->bytes > w->size - w->at - sizeof *r)
        return NULL;
    content = ovr_arena_take(arena, (size_t)r->bytes + 1, 1, NULL);
    if (!content ||
        ovr_read_all(w->fd, content, (size_t)r->bytes, w->at + sizeof *r) != 0)
        return NULL;
    sum = checksum(0, r, offsetof(ovr_journal_record, sum));
    if (checksum(sum, content, (size_t)r->bytes) != r->sum)
        return NULL;
    w->at += sizeof *r + r->bytes;
    return content;
}

/* ------------------------------------------------------------------ Writing */

/* -------------------------------------------------------------- Opening */

bool ovr_file_is_named(int fd, const char *path)
{
    struct stat open, named;
    return fstat(fd, &open) == 0 && stat(path, &named) == 0 &&
           open.st_ino == named.st_ino && open.st_dev == named.st_dev;
}

/* Opens and locks the journal. Repeats this if another process removed the file
 * between opening and locking. */
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
            commit_alive(fd);
            s->unlocked = error != 0;
            return 0;
        }
        close(fd);
        if (error == EWOULDBLOCK)
            return error;
    }
    return EWOULDBLOCK;
}

/* -------------------------------------------------------------- Writing */

/* Returns a number that differs between journals of a file. */
static uint64_t new_salt(void)
{
    struct timespec now;
    clock_gettime(CLOCK_REALTIME, &now);
    return (uint64_t)now.tv_sec * 1000000000u + (uint64_t)now.tv_nsec +
           ((uint64_t)getpid() << 40);
}

/* Begins a journal. The names of the file and its checkpoint are written first,
 * because the old contents may belong to another file of that name. */
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

/* True if a page is saved. There is one bit per page of the checkpoint,
 * extended when the file grows. */
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

/* Data that a commit appends to the journal in one write. */
typedef struct addition {
    ovr_arena arena;
    unsigned char *data;
    size_t bytes;
    size_t state; /* bytes of the state, after the pages */
    bool pages;   /* contains pages */
} addition;

static uint64_t pages_of(uint64_t length)
{
    return (length + OVR_PAGE - 1) / OVR_PAGE;
}

/* Returns an upper bound of the number of page checksums in a state: changed
 * pages plus pages appended since the last commit. */
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

/* Completes a record whose content has been written. */
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

/* Appends the old content of a page that was not saved since the checkpoint. */
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

/* Appends the checksum of a page with the content `now`, up to the end of the
 * file. */
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

/* Appends the checksums of pages after the committed length, many at a time. */
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

/* Appends the state. Pages that extend beyond the committed length are counted
 * as new. */
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
    if (error) { /* the file is unchanged, so the state is withdrawn */
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

/* ------------------------------------------------------------- Rolling back */

/* True if the date is in the headers, at the beginning of the file. */
static bool has_date(int file, const char *created, ovr_arena *arena)
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
           has_date(s->fd, h->created, arena);
}

static int restore_page(const ovr_store *s, ovr_journal_walk *w,
                        ovr_arena *arena)
{
    const ovr_journal_record *r = &w->record;
    const unsigned char *content;
    int error = 0;
    while (error == 0 && (content = journal_next(w, arena)) != NULL) {
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
    if (journal_first(&walk, s->journal) && is_meant(s, &walk.header, &arena)) {
        s->repaired = ovr_journal_torn(s->journal, s->fd,
                                       &s->changed.arena->allocator);
        error = restore_page(s, &walk, &arena);
        s->kept.needed = error != 0;
        s->kept.number = walk.header.number;
    }
    ovr_arena_release(&arena);
    return error;
}

/* ----------------------------------------------- detection of a torn file */

/* Detection of a torn file. The journal records the checksums of the pages
 * changed since the checkpoint, state by state. The expected checksum of a page
 * in a state is the last one recorded up to that state. */

/* Expected page content from a state on; state 0 is the checkpoint. */
typedef struct promise {
    ovr_journal_entry entry;
    uint64_t state;
} promise;

typedef struct promises {
    promise *list;
    size_t count, capacity;
    uint64_t states, length, length_before; /* length of the last state and of
                                             * the one before */
    ovr_arena *arena;
} promises;

static bool add(promises *p, ovr_journal_entry entry, uint64_t state)
{
    if (p->count == p->capacity) {
        size_t capacity = 2 * p->capacity + 256;
        promise *more = ovr_arena_take(p->arena, capacity, sizeof *more, NULL);
        if (!more)
            return false;
        if (p->count)
            memcpy(more, p->list, p->count * sizeof *more);
        p->list = more;
        p->capacity = capacity;
    }
    p->list[p->count++] = (promise){entry, state};
    return true;
}

static bool add_promised_state(promises *p, const ovr_journal_record *r,
                               const unsigned char *content)
{
    ovr_journal_entry entry;
    p->states++;
    p->length_before = p->length;
    p->length = r->where;
    for (uint64_t k = 0; k + sizeof entry <= r->bytes; k += sizeof entry) {
        memcpy(&entry, content + k, sizeof entry);
        if (entry.bytes > OVR_PAGE || !add(p, entry, p->states))
            return false;
    }
    return true;
}

static bool gather(promises *p, ovr_journal_walk *w, ovr_arena *scratch)
{
    const ovr_journal_record *r = &w->record;
    const unsigned char *content;
    bool ok = true;
    p->length = w->header.length;
    while (ok && (content = journal_next(w, scratch)) != NULL)
        if (r->kind == OVR_JOURNAL_STATE) {
            ok = add_promised_state(p, r, content);
        } else if (r->kind == OVR_JOURNAL_PAGE && r->bytes <= OVR_PAGE) {
            uint64_t sum = checksum(0, content, (size_t)r->bytes);
            ok = add(p,
                     (ovr_journal_entry){r->where, (uint32_t)r->bytes,
                                         (uint32_t)sum},
                     0);
        }
    return ok;
}

static int by_page(const void *a, const void *b)
{
    const promise *x = a, *y = b;
    if (x->entry.page != y->entry.page)
        return x->entry.page < y->entry.page ? -1 : 1;
    return (x->state > y->state) - (x->state < y->state);
}

/* True if the page has the expected checksum. Bytes beyond the end of the state
 * are ignored. */
static bool holds(int file, const promise *p, uint64_t length)
{
    unsigned char now[OVR_PAGE];
    uint64_t at = p->entry.page * OVR_PAGE;
    if (at + p->entry.bytes > length)
        return true;
    return ovr_read_all(file, now, p->entry.bytes, at) == 0 &&
           checksum(0, now, p->entry.bytes) == p->entry.sum;
}

static bool is_state(const promises *p, int file, uint64_t state,
                     uint64_t length)
{
    struct stat about;
    if (fstat(file, &about) != 0 || (uint64_t)about.st_size < length)
        return false;
    for (size_t k = 0; k < p->count; k++) {
        const promise *now = &p->list[k], *next = now + 1;
        bool last = k + 1 == p->count || next->entry.page != now->entry.page ||
                    next->state > state;
        if (now->state <= state && last && !holds(file, now, length))
            return false;
    }
    return true;
}

bool ovr_journal_torn(int journal, int file, const ovr_allocator *allocator)
{
    ovr_arena arena = ovr_arena_make(allocator);
    ovr_arena scratch = ovr_arena_make(allocator);
    promises p = {.arena = &arena};
    ovr_journal_walk walk;
    bool torn = false;
    if (journal_first(&walk, journal) && gather(&p, &walk, &scratch) &&
        p.states > 0 && p.count > 0) {
        qsort(p.list, p.count, sizeof *p.list, by_page);
        torn = !is_state(&p, file, p.states, p.length) &&
               !is_state(&p, file, p.states - 1, p.length_before);
    }
    ovr_arena_release(&scratch);
    ovr_arena_release(&arena);
    return torn;
}
