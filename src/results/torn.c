/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Tells if a file is in a state that a commit left.
 *
 * The journal says what every page changed since the checkpoint must be, state
 * by state.  A state's pages are those that it names last, and before those
 * what was kept of the checkpoint.
 */
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <zlib.h>

#include "base/disk.h"
#include "results/journal.h"

/* The page is this from a state on; state 0 is the checkpoint. */
typedef struct promise {
    ovr_journal_entry entry;
    uint64_t state;
} promise;

typedef struct promises {
    promise *list;
    size_t count, capacity;
    uint64_t states, length, length_before; /* of the last state, and before */
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

static bool add_state(promises *p, const ovr_journal_record *r,
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
    while (ok && (content = ovr_journal_next(w, scratch)) != NULL)
        if (r->kind == OVR_JOURNAL_STATE) {
            ok = add_state(p, r, content);
        } else if (r->kind == OVR_JOURNAL_PAGE && r->bytes <= OVR_PAGE) {
            uLong sum = crc32(0, content, (uInt)r->bytes);
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

/* What lies behind a state's end is not its own. */
static bool holds(int file, const promise *p, uint64_t length)
{
    unsigned char now[OVR_PAGE];
    uint64_t at = p->entry.page * OVR_PAGE;
    if (at + p->entry.bytes > length)
        return true;
    return ovr_read_all(file, now, p->entry.bytes, at) == 0 &&
           crc32(0, now, p->entry.bytes) == p->entry.sum;
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
    if (ovr_journal_first(&walk, journal) && gather(&p, &walk, &scratch) &&
        p.states > 0 && p.count > 0) {
        qsort(p.list, p.count, sizeof *p.list, by_page);
        torn = !is_state(&p, file, p.states, p.length) &&
               !is_state(&p, file, p.states - 1, p.length_before);
    }
    ovr_arena_release(&scratch);
    ovr_arena_release(&arena);
    return torn;
}
