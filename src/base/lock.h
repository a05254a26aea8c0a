/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Locks that prevent other processes from using a file. */
#ifndef OVR_BASE_LOCK_H
#define OVR_BASE_LOCK_H

#include <stdbool.h>
#include <stdint.h>

/* Locks a file opened for reading and writing until it is closed, without
 * waiting. Returns 0; EWOULDBLOCK if another process has it; any other errno if
 * the file system has no locks (neither flock nor open file description
 * locks). */
int ovr_lock_file(int fd, bool shared);

/* Locks the bytes at..at+count-1 until they are unlocked or the file is closed.
 * With `wait` the call waits for other processes. Returns as above. */
int ovr_lock_bytes(int fd, uint64_t at, uint64_t count, bool wait);
void ovr_unlock_bytes(int fd, uint64_t at, uint64_t count);

/* True if another open file has locked one of these bytes. */
bool ovr_bytes_locked(int fd, uint64_t at, uint64_t count);

#endif
