/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Locks that keep other processes out of a file. */
#ifndef OVR_BASE_LOCK_H
#define OVR_BASE_LOCK_H

#include <stdbool.h>
#include <stdint.h>

/* Locks a file that is open to read and write until it is closed, without
 * waiting: 0; EWOULDBLOCK when another has it; any other errno: this file
 * system has no locks (neither flock nor those of open file descriptions). */
int ovr_lock_file(int fd, bool shared);

/* Locks bytes at..at+count-1 until they are unlocked or the file is closed.
 * With `wait` the call waits for other processes.  Returns as above. */
int ovr_lock_bytes(int fd, uint64_t at, uint64_t count, bool wait);
void ovr_unlock_bytes(int fd, uint64_t at, uint64_t count);

/* True if another open file has locked one of these bytes. */
bool ovr_bytes_locked(int fd, uint64_t at, uint64_t count);

#endif
