/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The bytes of a growing result file, changed only in whole steps.
 *
 * HDF5 writes its file wherever it likes, whenever it likes; a program killed
 * in between leaves half a state.  This store stands between HDF5 and the
 * disk (driver.h) and keeps these rules:
 *
 * 1. Bytes below the committed length change only in a commit.  Until then
 *    they are kept in memory, by pages.  Bytes above it may be written at
 *    once: nothing that is committed refers to them.
 * 2. A commit writes the changed pages to OUT.h5.journal, with their places
 *    and a checksum over everything; then to the file, page 0 (HDF5's
 *    superblock) last; then empties the journal.
 *    Killed before the journal is whole: the file is as the last commit left
 *    it.  Killed after: whoever opens the file to write finds a whole
 *    journal and repeats step 2 from it.  Only in the fraction of a
 *    millisecond between is the file itself in neither state.
 * 3. A journal is used only if page 0 of the file is the one that the commit
 *    found or the one that it left; else it belongs to another file.
 * 4. A failed write (a full disk) is noted and its bytes are kept in memory,
 *    and so are all after it: HDF5, which does not survive failing writes, is
 *    let believe that all is well until it is closed.  Nothing is committed
 *    any more; the file stays as the last commit left it.
 * 5. The journal carries the lock (flock) that keeps a second writer out, and
 *    the one between commits and our own readers (commit_lock.h); it is
 *    removed at the end.  Other readers are kept from nothing.
 * 6. A new file grows as OUT.h5.part and gets its name when its first commit
 *    is done.
 *
 * There is no fsync in a commit: the rules hold when the process dies, not
 * when the machine does.  A checkpoint syncs the file before it refers to it.
 */
#ifndef OVR_RESULTS_STORE_H
#define OVR_RESULTS_STORE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <sys/types.h>

#include "results/pages.h"

typedef struct ovr_store {
    char *path, *part, *journal_path;
    int fd, journal; /* -1: not open */
    bool published;  /* has its final name */
    bool halfway;    /* the journal holds a commit that is not finished */
    bool repaired;   /* a cut commit was finished when it was opened */
    bool unlocked;   /* the file system has no locks */
    int failed;      /* errno of the first failure; 0: none */
    int64_t driver;  /* HDF5's identifier for what leads here, or negative */
    uint64_t committed, length; /* bytes: promised; now (HDF5's end of file) */
    uint64_t on_disk;           /* length of the file itself */
    ovr_pages changed;
} ovr_store;

/* Names, no disk touched. */
ovr_status ovr_store_prepare(ovr_store *store, const char *path,
                             ovr_arena *arena, ovr_error *err);

/* A new file, empty, locked, under its temporary name. */
ovr_status ovr_store_create(ovr_store *store, bool force, ovr_error *err);

/* An existing one, locked, its last commit finished if it was cut. */
ovr_status ovr_store_open(ovr_store *store, ovr_error *err);

/* Reading and writing as HDF5 sees the file; failures are noted. */
bool ovr_store_read(ovr_store *store, uint64_t at, size_t bytes, void *to);
void ovr_store_write(ovr_store *store, uint64_t at, size_t bytes,
                     const void *from);
void ovr_store_resize(ovr_store *store, uint64_t length);

/* Makes the state now the one that readers find. */
ovr_status ovr_store_commit(ovr_store *store, ovr_error *err);

/* Gives the file its name; in the way may be a file only with `force`. */
ovr_status ovr_store_publish(ovr_store *store, bool force, ovr_error *err);

/* On to the disk itself. */
ovr_status ovr_store_sync(ovr_store *store, ovr_error *err);

/* Ends it: what is not committed is lost, a file without a name is removed. */
void ovr_store_close(ovr_store *store);

/* HDF5 failed for a reason of its own: from now on nothing is committed. */
void ovr_store_fail(ovr_store *store);

/* Why writing failed, with the file's name, as an error of OVR_IO. */
ovr_status ovr_store_failure(const ovr_store *store, ovr_error *err);

#endif
