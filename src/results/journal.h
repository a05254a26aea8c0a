/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The journal of a store: how to go back to the last checkpoint, and what the
 * file must be since.
 *
 *   header   16 bytes "overroll journal", then 64 bits each, as the machine
 *            lays them: 2, number of the checkpoint, length of the file then,
 *            a salt; 32 bytes of the file's date_created; checksum of these
 *   records  each: the header's salt, its kind, where, bytes of its content
 *            (64 bits each), checksum (crc32) of these and of the content
 *       page     where: number of a page; as it was at the checkpoint.  It
 *                stands here, synced, before it is changed in the file
 *       state    where: length of the file that a commit is about to leave;
 *                number, bytes and checksum of each page changed by it
 *
 * The log ends at the first record that is not whole or has another salt: the
 * commit that wrote it had not touched the file yet.  A journal with an
 * incomplete header means that nothing was changed since the checkpoint.
 *
 * A file is complete if its pages match the last state or the preceding one (or
 * the checkpoint, if there is only one).  Otherwise a commit was
 * interrupted by the end of the process or of the machine.
 */
#ifndef OVR_RESULTS_JOURNAL_H
#define OVR_RESULTS_JOURNAL_H

#include <stdbool.h>

#include "results/store.h"

/*
 * A readers-writer lock between commits and our own readers: a byte of the
 * journal is locked exclusively by the writer while it changes the file, shared
 * by readers while they read.  A second byte is the queue before it: all lock
 * it until they hold the first, so once the writer waits no further reader
 * passes it, however many there are.
 *
 * Neither waits for ever: the other one may have been stopped in the middle.
 * Whoever has waited too long goes ahead; a reader that then meets half a
 * commit notices and tries again.  Readers that know nothing of this are kept
 * from nothing.  (Locks of open file descriptions: Linux; elsewhere nobody
 * waits and readers try again.)
 *
 * A third byte is locked as long as a writer lives.
 */

/* Acquires the lock on a descriptor of the journal, for writing or reading. */
void ovr_commit_lock(int journal, bool write);
void ovr_commit_unlock(int journal);

/* Returns to a reader with the lock whether a writer exists and is not changing
 * the file, so that this is as a commit left it.  False also where there are no
 * such locks: then the file must be looked at (journal.c). */
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

/* A page that a state names. */
typedef struct ovr_journal_entry {
    uint64_t page;
    uint32_t bytes, sum;
} ovr_journal_entry;

/* Both return 0 or an errno. */

/* True if the path is a name of the open file. */
bool ovr_file_is_named(int fd, const char *path);

/* Opens (or makes) and locks it; EWOULDBLOCK: another writer has it. */
int ovr_journal_open(ovr_store *store);

/* Writes what the commit of the changed pages needs: pages that are not kept
 * yet since the checkpoint, and the state to come; synced if there are any of
 * the former. */
int ovr_journal_write(ovr_store *store);

/* ---- reading: a walk through its records */

typedef struct ovr_journal_walk {
    int fd;
    uint64_t at, size;
    ovr_journal_header header;
    ovr_journal_record record; /* the present one */
} ovr_journal_walk;

/* ---- using */

/* True if the journal (of the file of that descriptor) knows a state of it, and
 * it is in none of those: see above.  Without memory it is not. */
bool ovr_journal_torn(int journal, int file, const ovr_allocator *allocator);

/* Restores the pages saved since the checkpoint, unless the journal
 * is of another file, or of a checkpoint that is no longer the store's; an
 * errno. */
int ovr_journal_roll_back(ovr_store *store);

#endif
