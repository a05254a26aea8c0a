/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "results/store.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/disk.h"
#include "results/journal.h"

/* -------------------------------------------------------------------- pages */

enum { FIRST_CAPACITY = 16 };

static void pages_init(ovr_pages *p, ovr_arena *arena)
{
    memset(p, 0, sizeof *p);
    p->arena = arena;
}

/* Returns the index of the first page whose number is at least `number`. */
static size_t place_of(const ovr_pages *p, uint64_t number)
{
    size_t low = 0, high = p->count;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (p->page[middle].number < number)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/* Returns the page with this number, or NULL. */
static ovr_page *pages_find(const ovr_pages *p, uint64_t number)
{
    size_t at = place_of(p, number);
    if (at < p->count && p->page[at].number == number)
        return &p->page[at];
    return NULL;
}

/* Doubles the list and allocates the new pages as one block. */
static bool reserve(ovr_pages *p)
{
    size_t more = p->capacity ? p->capacity : FIRST_CAPACITY;
    ovr_page *list = ovr_arena_take(p->arena, p->capacity + more, sizeof *list,
                                    NULL);
    bool blank = p->arena->blank;
    p->arena->blank = true; /* pages are filled from the file */
    unsigned char *data = ovr_arena_take(p->arena, 2 * more, OVR_PAGE, NULL);
    p->arena->blank = blank;
    if (!list || !data)
        return false;
    if (p->capacity)
        memcpy(list, p->page, p->capacity * sizeof *list);
    for (size_t k = 0; k < more; k++) {
        list[p->capacity + k].data = data + 2 * k * OVR_PAGE;
        list[p->capacity + k].was = data + (2 * k + 1) * OVR_PAGE;
    }
    p->page = list;
    p->capacity += more;
    return true;
}

/* Adds a page with undefined content; NULL without memory. */
static ovr_page *pages_add(ovr_pages *p, uint64_t number)
{
    size_t at = place_of(p, number);
    ovr_page added;
    if (p->count == p->capacity && !reserve(p))
        return NULL;
    added = p->page[p->count];
    added.number = number;
    memmove(&p->page[at + 1], &p->page[at], (p->count - at) * sizeof added);
    p->page[at] = added;
    p->count++;
    return &p->page[at];
}

void ovr_pages_clear(ovr_pages *p)
{
    p->count = 0;
}

/* --------------------------------------------------------------- Failures */

static ovr_status fail_with(const ovr_store *s, ovr_status status, int error,
                            const char *what, ovr_error *err)
{
    char text[128] = "";
    if (strerror_r(error, text, sizeof text) != 0)
        text[0] = '\0';
    return ovr_fail(err, status, "%s: %s: %s", s->path, what, text);
}

/* Writes the error message. ESTALE means that the name now belongs to another
 * file. */
ovr_status ovr_store_failure(const ovr_store *s, ovr_error *err)
{
    if (s->failed == ENOMEM)
        return ovr_fail(err, OVR_NO_MEMORY, "%s: out of memory", s->path);
    if (s->failed == ESTALE)
        return ovr_fail(err, OVR_IO,
                        "%s: was removed or replaced while the "
                        "run was writing it",
                        s->path);
    return fail_with(s, OVR_IO, s->failed ? s->failed : EIO,
                     "cannot be written", err);
}

void ovr_store_fail(ovr_store *s)
{
    if (!s->failed)
        s->failed = EIO;
}

/* ------------------------------------------------------- Reading, writing */

static uint64_t minimum(uint64_t a, uint64_t b)
{
    return a < b ? a : b;
}

static uint64_t maximum(uint64_t a, uint64_t b)
{
    return a > b ? a : b;
}

/* Returns a page to be changed; it is read from the file at its first
 * change. */
static ovr_page *changed_page(ovr_store *s, uint64_t number)
{
    ovr_page *page = pages_find(&s->changed, number);
    int error;
    if (page)
        return page;
    page = pages_add(&s->changed, number);
    if (!page) {
        ovr_store_note(s, ENOMEM);
        return NULL;
    }
    error = ovr_read_all(s->fd, page->was, OVR_PAGE, number * OVR_PAGE);
    memcpy(page->data, page->was, OVR_PAGE);
    return ovr_store_note(s, error) ? page : NULL;
}

/* Length of the part of [at, at + bytes) in one page. */
static size_t in_page(uint64_t at, uint64_t bytes)
{
    return (size_t)minimum(bytes, OVR_PAGE - at % OVR_PAGE);
}

static void change_pages(ovr_store *s, uint64_t at, uint64_t bytes,
                         const unsigned char *from)
{
    while (bytes > 0) {
        size_t n = in_page(at, bytes);
        ovr_page *page = changed_page(s, at / OVR_PAGE);
        if (page)
            memcpy(page->data + at % OVR_PAGE, from, n);
        at += n;
        from += n;
        bytes -= n;
    }
}

/* Writes to the disk. After a failure the bytes are kept in memory, so that
 * HDF5 sees a file in which every write succeeded. */
static void write_through(ovr_store *s, uint64_t at, size_t bytes,
                          const unsigned char *from)
{
    int error = s->failed ? s->failed : ovr_write_all(s->fd, from, bytes, at);
    if (!ovr_store_note(s, error))
        change_pages(s, at, bytes, from);
    if (at + bytes > s->on_disk) /* or a part of them */
        s->on_disk = at + bytes;
}

static void write_tail(ovr_store *s)
{
    size_t bytes = s->tail.bytes;
    s->tail.bytes = 0;
    if (bytes)
        write_through(s, s->tail.at, bytes, s->tail.data);
}

enum { TAIL = 1 << 16 };

/* Writes later; bytes that continue the tail are buffered with it. */
static void write_later(ovr_store *s, uint64_t at, size_t bytes,
                        const unsigned char *from)
{
    ovr_tail *tail = &s->tail;
    if (at != tail->at + tail->bytes || bytes > TAIL - tail->bytes)
        write_tail(s);
    if (bytes > TAIL || s->failed) {
        write_through(s, at, bytes, from);
        return;
    }
    if (!tail->bytes)
        tail->at = at;
    memcpy(tail->data + tail->bytes, from, bytes);
    tail->bytes += bytes;
}

/* Bytes below this offset are changed in memory only. */
static uint64_t guarded_end(const ovr_store *s)
{
    return s->failed ? UINT64_MAX : s->committed;
}

void ovr_store_write(ovr_store *s, uint64_t at, size_t bytes, const void *from)
{
    const unsigned char *next = from;
    uint64_t guard = guarded_end(s);
    size_t below = at < guard ? (size_t)minimum(bytes, guard - at) : 0;
    if (at + bytes > s->length)
        s->length = at + bytes;
    if (s->failed)
        write_tail(s);
    change_pages(s, at, below, next);
    if (bytes > below)
        write_later(s, at + below, bytes - below, next + below);
}

/* Changes the length. The file is extended at once, so that it contains all
 * committed bytes. It is shortened at most to the committed length; the commit
 * does the rest. */
void ovr_store_resize(ovr_store *s, uint64_t length)
{
    uint64_t to = length > s->committed ? length : s->committed;
    write_tail(s);
    s->length = length;
    if (s->failed || to == s->on_disk)
        return;
    if (ovr_store_note(s, ftruncate(s->fd, (off_t)to) != 0 ? errno : 0))
        s->on_disk = to;
}

/* ----------------------------------------------------------------- Commit */

/* Writes the changed pages; page 0, the first in the list, is written last. */
static int apply_pages(const ovr_store *s)
{
    int error = 0;
    for (size_t k = s->changed.count; error == 0 && k-- > 0;) {
        const ovr_page *page = &s->changed.page[k];
        uint64_t at = page->number * OVR_PAGE;
        if (at < s->committed)
            error = ovr_write_all(s->fd, page->data,
                                  (size_t)minimum(OVR_PAGE, s->committed - at),
                                  at);
    }
    return error;
}

/* Removes bytes after the end, except those of the checkpoint. */
static int cut_tail(ovr_store *s)
{
    uint64_t to = maximum(s->length, s->kept.length);
    if (to >= s->on_disk)
        return 0;
    if (ftruncate(s->fd, (off_t)to) != 0)
        return errno;
    s->on_disk = to;
    return 0;
}

/* Commits the changed pages. The journal is not needed before the file has its
 * final name. */
static int commit_pages(ovr_store *s)
{
    int error = s->published ? ovr_journal_write(s) : 0;
    if (error)
        return error;
    s->halfway = s->kept.needed = true;
    ovr_commit_lock(s->journal, true);
    error = apply_pages(s);
    if (error == 0)
        error = cut_tail(s);
    ovr_commit_unlock(s->journal);
    s->halfway = error != 0;
    return error;
}

/* Returns 0, or ESTALE if the name belongs to another file or to none. */
static int check_name(const ovr_store *s)
{
    return s->published && !ovr_file_is_named(s->fd, s->path) ? ESTALE : 0;
}

ovr_status ovr_store_commit(ovr_store *s, ovr_error *err)
{
    write_tail(s);
    int error = s->failed ? s->failed : check_name(s);
    if (error == 0 && s->changed.count > 0)
        error = commit_pages(s);
    if (!ovr_store_note(s, error))
        return ovr_store_failure(s, err);
    ovr_pages_clear(&s->changed);
    s->committed = maximum(s->length, s->kept.length);
    return OVR_OK;
}

ovr_status ovr_store_sync(ovr_store *s, ovr_error *err)
{
    write_tail(s);
    if (!ovr_store_note(s, fsync(s->fd) != 0 ? errno : 0))
        return ovr_store_failure(s, err);
    s->kept.needed = false;
    return OVR_OK;
}

void ovr_store_keep(ovr_store *s, uint64_t number)
{
    ovr_kept *k = &s->kept;
    k->number = number;
    k->length = k->summed = s->committed = s->length;
    k->begun = false;
    if (k->capacity)
        memset(k->pages, 0, k->capacity);
}

/* --------------------------------------------------------- Start and end */

char *ovr_path_with(ovr_arena *arena, const char *path, const char *ending,
                    ovr_error *err)
{
    size_t length = strlen(path), more = strlen(ending) + 1;
    char *joined = ovr_arena_take(arena, length + more, 1, err);
    if (!joined)
        return NULL;
    memcpy(joined, path, length);
    memcpy(joined + length, ending, more);
    return joined;
}

ovr_status ovr_store_prepare(ovr_store *s, const char *path, ovr_arena *arena,
                             ovr_error *err)
{
    memset(s, 0, sizeof *s);
    s->fd = s->journal = -1;
    s->path = ovr_path_with(arena, path, "", err);
    s->part = ovr_path_with(arena, path, ".part", err);
    s->journal_path = ovr_path_with(arena, path, ".journal", err);
    pages_init(&s->changed, arena);
    bool blank = arena->blank;
    arena->blank = true; /* written before it is read */
    s->tail.data = ovr_arena_take(arena, TAIL, 1, err);
    arena->blank = blank;
    return s->path && s->part && s->journal_path && s->tail.data
               ? OVR_OK
               : OVR_NO_MEMORY;
}

static ovr_status lock_journal(ovr_store *s, ovr_error *err)
{
    int error = ovr_journal_open(s);
    if (error == EWOULDBLOCK)
        return ovr_fail(err, OVR_BAD_INPUT, "%s: another process is writing it",
                        s->path);
    if (error)
        return fail_with(s, OVR_BAD_INPUT, error, "cannot be written", err);
    return OVR_OK;
}

static ovr_status fail_existing(const ovr_store *s, ovr_error *err)
{
    return ovr_fail(err, OVR_BAD_INPUT,
                    "%s: exists already; --force replaces it", s->path);
}

ovr_status ovr_store_create(ovr_store *s, bool force, ovr_error *err)
{
    struct stat about;
    bool there = stat(s->path, &about) == 0;
    ovr_status status;
    if (there && !S_ISREG(about.st_mode))
        return ovr_fail(err, OVR_BAD_INPUT, "%s: is not an ordinary file",
                        s->path);
    if (there && !force)
        return fail_existing(s, err);
    status = lock_journal(s, err);
    if (status != OVR_OK)
        return status;
    s->fd = open(s->part, O_RDWR | O_CREAT | O_TRUNC | O_NOFOLLOW | O_CLOEXEC,
                 0666);
    if (s->fd < 0)
        return fail_with(s, OVR_BAD_INPUT, errno, "cannot be created", err);
    return OVR_OK;
}

ovr_status ovr_store_publish(ovr_store *s, bool force, ovr_error *err)
{
    if (!force && access(s->path, F_OK) == 0)
        return fail_existing(s, err);
    if (rename(s->part, s->path) != 0)
        return fail_with(s, OVR_BAD_INPUT, errno, "cannot be created", err);
    s->published = true;
    ovr_store_keep(s, 0);
    return OVR_OK;
}

ovr_status ovr_store_open(ovr_store *s, ovr_error *err)
{
    struct stat about;
    ovr_status status;
    int error;
    s->fd = open(s->path, O_RDWR | O_CLOEXEC);
    if (s->fd < 0 || fstat(s->fd, &about) != 0)
        return fail_with(s, OVR_BAD_INPUT, errno, "cannot be opened", err);
    s->published = true;
    status = lock_journal(s, err);
    if (status != OVR_OK)
        return status;
    error = ovr_journal_roll_back(s);
    if (error)
        return fail_with(s, OVR_IO, error,
                         "the last checkpoint cannot be restored", err);
    if (fstat(s->fd, &about) != 0)
        return fail_with(s, OVR_IO, errno, "cannot be read", err);
    s->on_disk = s->length = (uint64_t)about.st_size;
    ovr_store_keep(s, s->kept.number);
    return OVR_OK;
}

/* True if the journal can be removed: the file is synced. */
static bool journal_is_done(ovr_store *s)
{
    struct stat about = {0};
    if (fstat(s->journal, &about) == 0 && about.st_size == 0)
        return true;
    if (s->fd < 0 || !s->published || s->halfway || s->failed == ECANCELED)
        return false;
    return !s->kept.needed || fsync(s->fd) == 0;
}

/* Closes the store. Bytes after the committed length are removed. */
void ovr_store_close(ovr_store *s)
{
    s->tail.bytes = 0;
    if (s->fd >= 0 && s->on_disk > s->committed && s->published && !s->halfway)
        (void)!ftruncate(s->fd, (off_t)s->committed);
    if (s->journal >= 0) {
        if (journal_is_done(s))
            unlink(s->journal_path);
        close(s->journal);
    }
    if (s->fd >= 0) {
        if (!s->published)
            unlink(s->part);
        close(s->fd);
    }
    s->fd = s->journal = -1;
}

/* ------------------------------------------------------------------ Reading */

bool ovr_store_note(ovr_store *s, int error)
{
    if (error && !s->failed)
        s->failed = error;
    return error == 0;
}

bool ovr_store_read(ovr_store *s, uint64_t at, size_t bytes, void *to)
{
    unsigned char *next = to;
    write_tail(s);
    if (!ovr_store_note(s, ovr_read_all(s->fd, to, bytes, at)))
        return false;
    while (bytes > 0) {
        size_t n = in_page(at, bytes);
        const ovr_page *page = pages_find(&s->changed, at / OVR_PAGE);
        uint64_t guard = guarded_end(s);
        if (page && at < guard)
            memcpy(next, page->data + at % OVR_PAGE,
                   (size_t)minimum(n, guard - at));
        at += n;
        next += n;
        bytes -= n;
    }
    return true;
}
