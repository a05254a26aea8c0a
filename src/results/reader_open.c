/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Opening a result file beside the program that writes it. */
#include "results/reader.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "base/given.h"
#include "results/commit_lock.h"
#include "results/journal.h"

static bool journal_name(const char *path, char *name, size_t size)
{
    int length = snprintf(name, size, "%s.journal", path);
    return length > 0 && (size_t)length < size;
}

int ovr_reader_lock(const ovr_result *r)
{
    char name[4096];
    int journal = -1;
    if (journal_name(r->path, name, sizeof name))
        journal = open(name, O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    if (journal >= 0)
        ovr_commit_lock(journal, false);
    return journal;
}

void ovr_reader_unlock(int lock)
{
    if (lock < 0)
        return;
    ovr_commit_unlock(lock);
    close(lock);
}

static ovr_status cut(const ovr_result *r, ovr_error *err)
{
    return ovr_fail(err, OVR_IO,
                    "%s: its last write was cut, as the program or the machine "
                    "was stopped in it; 'overroll resume' goes back to its "
                    "last checkpoint",
                    r->path);
}

/* A file cut in the middle of a commit is a mixture of two states, of which
 * the checksums inside it find only some. */
static bool is_torn(ovr_result *r, int lock)
{
    if (ovr_commit_is_settled(lock)) {
        r->looked_at = false;
        return false;
    }
    if (r->looked_at) /* nobody writes, or this could not be known */
        return false;
    r->looked_at = !ovr_journal_torn(lock, r->fd, &r->arena.allocator);
    return !r->looked_at;
}

ovr_status ovr_reader_file(ovr_result *r, int lock, ovr_error *err)
{
    r->fd = open(r->path, O_RDONLY | O_CLOEXEC);
    if (r->fd < 0)
        return ovr_fail(err, OVR_BAD_INPUT, "%s: %s", r->path, strerror(errno));
    if (lock >= 0 && is_torn(r, lock))
        return cut(r, err);
    switch (ovr_container_open(&r->container, r->fd, &r->work)) {
    case OVR_FOUND_CONTAINER: return OVR_OK;
    case OVR_FOUND_OTHER_HDF5: return ovr_reader_not_ours(r, err);
    case OVR_FOUND_TRUNCATED:
        return ovr_fail(err, OVR_IO, "%s: is a truncated or damaged HDF5 file",
                        r->path);
    case OVR_FOUND_NO_MEMORY:
        return ovr_fail(err, OVR_NO_MEMORY, "%s: out of memory", r->path);
    default:
        return ovr_fail(err, OVR_BAD_INPUT, "%s: is not an HDF5 file", r->path);
    }
}

void ovr_reader_close_file(ovr_result *r)
{
    if (r->fd >= 0)
        close(r->fd);
    r->fd = -1;
    r->sets_hold = false;
    ovr_arena_release(&r->work);
}

static ovr_status open_once(ovr_result *r, int lock, ovr_error *err)
{
    ovr_status status = ovr_reader_file(r, lock, err);
    if (status == OVR_OK)
        status = ovr_reader_content(r, err);
    if (r->starved || r->container.source.starved)
        status = ovr_fail(err, OVR_NO_MEMORY, "%s: out of memory", r->path);
    ovr_arena_release(&r->work);
    return status;
}

bool ovr_reader_again(const ovr_result *r, int attempt, bool locked)
{
    enum { MAX = 4 };
    struct timespec wait = {0, 1000000L << attempt};
    char journal[4096];
    bool written = locked || (journal_name(r->path, journal, sizeof journal) &&
                              access(journal, F_OK) == 0);
    if (!written || attempt >= MAX)
        return false;
    nanosleep(&wait, NULL);
    return true;
}

static ovr_status open_result(ovr_result *r, ovr_error *err)
{
    ovr_status status;
    int attempt = 0, lock;
    do {
        ovr_reader_close_file(r);
        lock = ovr_reader_lock(r);
        status = open_once(r, lock, err);
        ovr_reader_unlock(lock);
    } while (status == OVR_IO && ovr_reader_again(r, attempt++, lock >= 0));
    if (status == OVR_IO && err)
        err->status = OVR_BAD_INPUT;
    return status == OVR_IO ? OVR_BAD_INPUT : status;
}

ovr_result *ovr_result_open(const char *path, const ovr_allocator *allocator,
                            ovr_error *err)
{
    if (!path)
        return ovr_null(err, __func__);
    ovr_arena arena = ovr_arena_make(allocator);
    ovr_result *r = ovr_arena_take(&arena, 1, sizeof *r, err);
    if (!r)
        return NULL;
    r->arena = arena;
    r->work = ovr_arena_make(allocator);
    r->fd = -1;
    r->path = ovr_arena_text(&r->arena, path, err);
    if (!r->path || open_result(r, err) != OVR_OK) {
        ovr_result_close(r);
        r = NULL;
    }
    return r;
}

void ovr_result_close(ovr_result *r)
{
    ovr_arena arena;
    if (!r)
        return;
    ovr_reader_close_file(r);
    arena = r->arena;
    ovr_arena_release(&arena);
}
