/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Commits and reads take turns: a byte of the journal is locked by the writer
 * while it changes the file, and by our own readers while they read.  Another
 * is a gate that all pass before: once the writer waits behind it no further
 * reader comes in, however many there are.
 *
 * Neither waits for ever: the other one may have been stopped in the middle.
 * Whoever has waited too long goes ahead; a reader that then meets half a
 * commit notices and tries again.  Readers that know nothing of this are kept
 * from nothing.  (Locks of open file descriptions: Linux; elsewhere nobody
 * waits and readers try again.)
 */
#ifndef OVR_RESULTS_TURNS_H
#define OVR_RESULTS_TURNS_H

#include <stdbool.h>

/* Takes the turn on a descriptor of the journal, to write or to read. */
void ovr_turn_take(int journal, bool write);
void ovr_turn_give(int journal);

#endif
