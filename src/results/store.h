/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The bytes of a growing result file, changed only in whole steps.
 *
 * HDF5 writes its file wherever it likes, whenever it likes; a program killed
 * in between leaves half a state.  This store stands between HDF5 and the
 * disk (file.h) and keeps these rules:
 *
 * 1. Bytes below the committed length, and below the length at the last
 *    checkpoint, change only in a commit.  Until then they are kept in memory,
 *    by pages.  Bytes above may be written at once: nothing that is committed
 *    refers to them.
 * 2. A commit first puts the pages that it will change, as they were at the
 *    last checkpoint, into OUT.h5.journal, unless they are there, with the
 *    checksums of what it will leave; if there were such pages it syncs the
 *    journal.  Then it writes the changed pages to the file, page 0 (HDF5's
 *    superblock) last.  So whoever opens the file to write can always go back
 *    to the last checkpoint, whatever of the pages written since has reached
 *    the disk; and readers see whether a file is in a state that a commit left
 *    (journal.c).
 * 3. A checkpoint syncs the file, writes and syncs the state of the run, which
 *    names the checkpoint's number, and its name; then the journal begins
 *    anew, with that number.  A journal of another number than the state has is
 *    not used: it is that of the checkpoint before, and nothing was changed
 *    since this one.
 * 4. A journal is used only for a file in which its date of creation stands;
 *    else it belongs to another.
 * 5. A failed write (a full disk) is noted and its bytes are kept in memory,
 *    and so are all after it: HDF5, which does not survive failing writes, is
 *    let believe that all is well until it is closed.  Nothing is committed
 *    any more; the file stays as the last commit left it.
 * 6. The journal carries the lock (flock) that keeps a second writer out, and
 *    the one between commits and our own readers (journal.h); it is
 *    removed at the end, when the file is synced.  Other readers are kept from
 *    nothing.
 * 7. A new file grows as OUT.h5.part and gets its name when its first commit
 *    is synced.
 *
 * A commit that changes only pages that are kept already does not sync: what
 * the death of the machine takes is what came after the last checkpoint.
 */
#ifndef OVR_RESULTS_STORE_H
#define OVR_RESULTS_STORE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <sys/types.h>

#include "base/arena.h"

/* Pages of a file that were changed but not yet written: page number, content
 * and what the file has there until then, sorted by number. */

enum { OVR_PAGE = 4096 };

typedef struct ovr_page {
    uint64_t number;
    unsigned char *data, *was;
} ovr_page;

typedef struct ovr_pages {
    ovr_page *page; /* `count` in use; those behind keep their memory */
    size_t count, capacity;
    ovr_arena *arena;
} ovr_pages;

/* Forgets all pages, keeping their memory for the next ones. */
void ovr_pages_clear(ovr_pages *pages);

/* Space for the date of creation. */
enum { OVR_STORE_NAME = 32 };

/* Kept since the last checkpoint. */
typedef struct ovr_kept {
    uint64_t number, length; /* the checkpoint's, and that of the file then */
    bool begun;              /* the journal is of this checkpoint */
    bool needed;             /* pages were changed and not synced since */
    bool named;              /* the folder was synced */
    uint64_t salt, end;      /* of the journal, and where it ends */
    uint64_t summed;         /* bytes whose checksums are in its states */
    unsigned char *pages;    /* a bit each: is in the journal */
    size_t capacity;         /* bytes of those */
} ovr_kept;

/* Bytes above the committed length that are not written yet, so that many small
 * pieces of HDF5 become one. */
typedef struct ovr_tail {
    unsigned char *data;
    uint64_t at;
    size_t bytes;
} ovr_tail;

typedef struct ovr_store {
    char *path, *part, *journal_path;
    char created[OVR_STORE_NAME]; /* stored in the file; "": unknown */
    int fd, journal;              /* -1: not open */
    bool published;               /* has its final name */
    bool halfway;                 /* a commit failed in the middle */
    bool repaired;                /* it was torn when it was opened */
    bool unlocked;                /* the file system has no locks */
    ovr_kept kept;
    int failed;     /* errno of the first failure; 0: none */
    int64_t driver; /* HDF5's identifier for what leads here, or negative */
    uint64_t committed, length; /* bytes: promised; now (HDF5's end of file) */
    uint64_t on_disk;           /* length of the file itself */
    ovr_pages changed;
    ovr_tail tail;
} ovr_store;

/* PATH and an ending, in the arena; NULL with *err filled. */
char *ovr_path_with(ovr_arena *arena, const char *path, const char *ending,
                    ovr_error *err);

/* Names, no disk touched. */
ovr_status ovr_store_prepare(ovr_store *store, const char *path,
                             ovr_arena *arena, ovr_error *err);

/* A new file, empty, locked, under its temporary name. */
ovr_status ovr_store_create(ovr_store *store, bool force, ovr_error *err);

/* An existing one, locked, as it was at its last checkpoint: the one of the
 * store's date of creation and kept.number, or where that date is "" whichever
 * the journal is of. */
ovr_status ovr_store_open(ovr_store *store, ovr_error *err);

/* Reading and writing as HDF5 sees the file; failures are noted. */
bool ovr_store_read(ovr_store *store, uint64_t at, size_t bytes, void *to);

/* Reading and writing share these: one keeps the first error, true without one;
 * bytes below this length are changed in memory only; how much of [at, at +
 * bytes) lies in one page. */
bool ovr_store_note(ovr_store *store, int error);
uint64_t ovr_store_guarded(const ovr_store *store);
size_t ovr_in_page(uint64_t at, uint64_t bytes);
void ovr_store_write(ovr_store *store, uint64_t at, size_t bytes,
                     const void *from);
void ovr_store_resize(ovr_store *store, uint64_t length);

/* Makes the state now the one that readers find. */
ovr_status ovr_store_commit(ovr_store *store, ovr_error *err);

/* Gives the file its name; an existing file is replaced only with `force`. */
ovr_status ovr_store_publish(ovr_store *store, bool force, ovr_error *err);

/* Writes on to the disk itself. */
ovr_status ovr_store_sync(ovr_store *store, ovr_error *err);

/* Makes the committed and synced contents the state that a later restore
 * returns to, identified by `number`. */
void ovr_store_keep(ovr_store *store, uint64_t number);

/* Ends it: what is not committed is lost, a file without a name is removed. */
void ovr_store_close(ovr_store *store);

/* HDF5 failed for a reason of its own: from now on nothing is committed. */
void ovr_store_fail(ovr_store *store);

/* Why writing failed, with the file's name, as an error of OVR_IO. */
ovr_status ovr_store_failure(const ovr_store *store, ovr_error *err);

#endif
