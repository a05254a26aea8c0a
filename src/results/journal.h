/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The journal of a store: data to restore the last checkpoint, and checksums of
 * the file's states since then.
 *
 *   header   16 bytes "overroll journal"; then 64 bits each, in the machine's
 *            byte order: the version 2, number of the checkpoint, length of
 *            the file at that time, a salt; 32 bytes of the file's
 *            date_created; checksum of these
 *   records  each: the header's salt, kind, position, number of bytes (64 bits
 *            each), checksum (crc32) of these and of the content, content
 *       page     position: page number. Content: the page as it was at the
 *                checkpoint. The record is synced before the page is changed in
 *                the file.
 *       state    position: length of the file after the commit. Content:
 *                number, bytes and checksum of each page that it changes
 *
 * The log ends at the first record that is incomplete or has another salt. The
 * commit that wrote this record had not changed the file yet. A journal with an
 * incomplete header means that nothing was changed since the checkpoint.
 *
 * A file is complete if its pages match the last state or the preceding one (or
 * the checkpoint, if there is only one). Otherwise a commit was interrupted by
 * the end of the process or of the machine.
 */
#ifndef OVR_RESULTS_JOURNAL_H
#define OVR_RESULTS_JOURNAL_H

#include <stdbool.h>

#include "results/store.h"

/* Readers-writer lock between commits and this library's readers. A byte of the
 * journal is locked exclusively by the writer while it changes the file, and
 * shared by readers. A second byte is a queue: everyone locks it until they
 * hold the first, so that no new reader overtakes a waiting writer. Waiting is
 * bounded, because the other process may have been stopped. After the timeout a
 * process proceeds; a reader that finds a partial commit retries. Other
 * programs are not affected. (Open file description locks: Linux only; on other
 * systems nothing waits and readers retry.) A third byte is locked while a
 * writer exists. */

/* Acquires the lock on a descriptor of the journal, for writing or reading. */
void ovr_commit_lock(int journal, bool write);
void ovr_commit_unlock(int journal);

/* For a reader that holds the lock: true if a writer exists and is not changing
 * the file, which is then as a commit left it. False also on systems without
 * such locks; then the file must be checked (journal.c). */
bool ovr_commit_is_settled(int journal);

#define OVR_JOURNAL_MAGIC "overroll journal"

enum { OVR_JOURNAL_PAGE = 1, OVR_JOURNAL_STATE = 2 };

typedef struct ovr_journal_header {
    char magic[16];
    uint64_t version, number, length, salt;
    char created[OVR_STORE_NAME];
    uint64_t sum;
} ovr_journal_header;

typedef struct ovr_journal_record {
    uint64_t salt, kind, where, bytes, sum;
} ovr_journal_record;

/* A page recorded in a state. */
typedef struct ovr_journal_entry {
    uint64_t page;
    uint32_t bytes, sum;
} ovr_journal_entry;

/* The following functions return 0 or an errno. */

/* True if the path is a name of the open file. */
bool ovr_file_is_named(int fd, const char *path);

/* Opens or creates the journal and locks it; EWOULDBLOCK if another writer has
 * it. */
int ovr_journal_open(ovr_store *store);

/* Writes the records for a commit of the changed pages: the old content of
 * pages not saved since the checkpoint, and the new state. Synced if pages were
 * written. */
int ovr_journal_write(ovr_store *store);

/* ---- reading: a walk through its records */

typedef struct ovr_journal_walk {
    int fd;
    uint64_t at, size;
    ovr_journal_header header;
    ovr_journal_record record; /* current record */
} ovr_journal_walk;

/* ---- using */

/* True if the file is torn: the journal (of the file of that descriptor) has
 * states of the file, and its pages match none of them. False without
 * memory. */
bool ovr_journal_torn(int journal, int file, const ovr_allocator *allocator);

/* Restores the pages saved since the checkpoint, unless the journal belongs to
 * another file or to an old checkpoint. Returns an errno. */
int ovr_journal_roll_back(ovr_store *store);

#endif
