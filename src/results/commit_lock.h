/* SPDX-License-Identifier: GPL-3.0-or-later */
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
#ifndef OVR_RESULTS_COMMIT_LOCK_H
#define OVR_RESULTS_COMMIT_LOCK_H

#include <stdbool.h>

/* Acquires the lock on a descriptor of the journal, for writing or reading. */
void ovr_commit_lock(int journal, bool write);
void ovr_commit_unlock(int journal);

/* From now on a writer lives, until the descriptor is closed. */
void ovr_commit_alive(int journal);

/* Returns to a reader with the lock whether a writer exists and is not changing
 * the file, so that this is as a commit left it.  False also where there are no
 * such locks: then the file must be looked at (journal.c). */
bool ovr_commit_is_settled(int journal);

#endif
