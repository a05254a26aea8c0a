/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The journal of a store: the changed pages of one commit.
 *
 *   header  16 bytes "overroll journal", then as 64-bit integers in the
 *           machine's order: 1, committed length, new length, pages,
 *           checksums of page 0 before and after
 *   pages   each: its number (64 bit), 4096 bytes
 *   end     checksum (crc32) of all before it (64 bit)
 *
 * Anything shorter, or with another checksum, is no journal: the commit that
 * wrote it had not touched the file yet.
 */
#ifndef OVR_RESULTS_JOURNAL_H
#define OVR_RESULTS_JOURNAL_H

#include "results/store.h"

/* Both return 0 or an errno. */
int ovr_journal_write(ovr_store *store);

/* Whether the commit of this journal was cut: it is whole, belongs to the
 * file, and may have been carried out in part. */
bool ovr_journal_pending(int journal, int file);

/* Finishes the commit of a whole journal that belongs to the file; sets
 * store->repaired.  Anything else is emptied. */
int ovr_journal_replay(ovr_store *store);

/* Opens (or makes) and locks it; EWOULDBLOCK: another writer has it. */
int ovr_journal_open(ovr_store *store);

/* All bytes, in spite of interruptions. */
int ovr_write_all(int fd, const void *from, size_t bytes, uint64_t at);
/* As far as the file goes; the rest is zero. */
int ovr_read_all(int fd, void *to, size_t bytes, uint64_t at);

#endif
