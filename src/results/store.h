/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The bytes of a growing result file, changed only by complete commits.
 *
 * HDF5 may write anywhere in its file at any time, so that a killed program
 * would leave an inconsistent file. This store is the layer between HDF5 and
 * the disk (file.h). It follows these rules:
 *
 * 1. Bytes below the committed length, and below the length at the last
 * checkpoint, change only in a commit. Until then their pages are kept in
 * memory. Bytes beyond that length may be written at once, because no committed
 * data refer to them.
 *
 * 2. A commit first writes to OUT.h5.journal the pages that it will change, as
 * they were at the last checkpoint, unless the journal contains them already,
 * and the checksums of the new state. If it has written pages, it syncs the
 * journal. It then writes the changed pages to the file, page 0 (HDF5's
 * superblock) last. A writer that opens the file later can therefore always
 * restore the last checkpoint, even if only some of the new pages have reached
 * the disk. Readers can check whether the file is in a committed state
 * (journal.c).
 *
 * 3. A checkpoint syncs the file. It then writes, syncs and renames the state
 * of the run, which contains the number of the checkpoint. Then a new journal
 * with that number begins. A journal with another number
 * than the state belongs to the preceding checkpoint. It is not used, because
 * the file has not changed since the new checkpoint.
 *
 * 4. A journal is used only for the file whose date of creation it contains.
 *
 * 5. A failed write (a full disk) is recorded. Its bytes and those of all later
 * writes are kept in memory, because HDF5 does not survive failing writes. HDF5
 * is not informed of the failure. There are no further commits, and the file
 * keeps the state of the last commit.
 *
 * 6. A lock of the journal (flock) excludes a second writer. Another one
 * separates commits from this library's readers (journal.h). Readers of other
 * programs are not excluded. The journal is removed at the end, when the file
 * is synced.
 *
 * 7. A new file is written as OUT.h5.part and gets its name when its first
 * commit is synced.
 *
 * A commit that changes only pages in the journal does not sync. If the machine
 * fails, data written after the last checkpoint are lost.
 */
#ifndef OVR_RESULTS_STORE_H
#define OVR_RESULTS_STORE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <sys/types.h>

#include "base/arena.h"

/* Changed pages of a file that are not yet written: page number, new content
 * and the present content in the file, sorted by number. */

enum { OVR_PAGE = 4096 };

typedef struct ovr_page {
    uint64_t number;
    unsigned char *data, *was;
} ovr_page;

typedef struct ovr_pages {
    ovr_page *page; /* `count` in use; the others keep their memory */
    size_t count, capacity;
    ovr_arena *arena;
} ovr_pages;

/* Removes all pages and keeps their memory. */
void ovr_pages_clear(ovr_pages *pages);

/* Size of the date of creation. */
enum { OVR_STORE_NAME = 32 };

/* Pages saved in the journal since the last checkpoint. */
typedef struct ovr_kept {
    uint64_t number, length; /* number of the checkpoint, and length of the file
                              * then */
    bool begun;              /* the journal belongs to this checkpoint */
    bool needed;             /* pages were changed and not synced since */
    bool named;              /* the folder has been synced */
    uint64_t salt, end;      /* salt and end of the journal */
    uint64_t summed;         /* bytes whose checksums are in the journal's
                              * states */
    unsigned char *pages;    /* one bit per page: saved in the journal */
    size_t capacity;         /* bytes of `pages` */
} ovr_kept;

/* Unwritten bytes after the committed length, collected so that many small
 * writes of HDF5 become one. */
typedef struct ovr_tail {
    unsigned char *data;
    uint64_t at;
    size_t bytes;
} ovr_tail;

typedef struct ovr_store {
    char *path, *part, *journal_path;
    char created[OVR_STORE_NAME]; /* date in the file; "": unknown */
    int fd, journal;              /* -1: not open */
    bool published;               /* has its final name */
    bool halfway;                 /* a commit failed halfway */
    bool repaired;                /* was torn when opened */
    bool unlocked;                /* the file system has no locks */
    ovr_kept kept;
    int failed;     /* errno of the first failure; 0: none */
    int64_t driver; /* HDF5's identifier of the driver, or negative */
    uint64_t committed, length; /* committed bytes; present length (HDF5's end
                                 * of file) */
    uint64_t on_disk;           /* length of the file on disk */
    ovr_pages changed;
    ovr_tail tail;
} ovr_store;

/* Returns PATH with an ending, in the arena; NULL with *err filled. */
char *ovr_path_with(ovr_arena *arena, const char *path, const char *ending,
                    ovr_error *err);

/* Prepares file names; no disk access. */
ovr_status ovr_store_prepare(ovr_store *store, const char *path,
                             ovr_arena *arena, ovr_error *err);

/* Creates an empty, locked file under its temporary name. */
ovr_status ovr_store_create(ovr_store *store, bool force, ovr_error *err);

/* Opens and locks an existing file and restores its last checkpoint: that with
 * the store's date of creation and kept.number or, if the date is "", the one
 * in the journal. */
ovr_status ovr_store_open(ovr_store *store, ovr_error *err);

/* Read and write as seen by HDF5; failures are recorded. */
bool ovr_store_read(ovr_store *store, uint64_t at, size_t bytes, void *to);

/* Records the first error; true if there is none. */
bool ovr_store_note(ovr_store *store, int error);
void ovr_store_write(ovr_store *store, uint64_t at, size_t bytes,
                     const void *from);
void ovr_store_resize(ovr_store *store, uint64_t length);

/* Makes the present state visible to readers. */
ovr_status ovr_store_commit(ovr_store *store, ovr_error *err);

/* Renames the file to its final name; replaces an existing file only with
 * `force`. */
ovr_status ovr_store_publish(ovr_store *store, bool force, ovr_error *err);

/* Syncs the file to the disk. */
ovr_status ovr_store_sync(ovr_store *store, ovr_error *err);

/* Makes the committed and synced contents the state that a later restore
 * returns to, identified by `number`. */
void ovr_store_keep(ovr_store *store, uint64_t number);

/* Closes the store. Uncommitted data are lost; a file without its final name is
 * removed. */
void ovr_store_close(ovr_store *store);

/* Records that HDF5 failed; nothing is committed any more. */
void ovr_store_fail(ovr_store *store);

/* Returns the reason of a failed write, with the file's name, as OVR_IO. */
ovr_status ovr_store_failure(const ovr_store *store, ovr_error *err);

#endif
