/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Locks that keep other processes out of a file. */
#ifndef OVR_BASE_LOCK_H
#define OVR_BASE_LOCK_H

#include <stdbool.h>

/* Locks a file that is open to read and write until it is closed, without
 * waiting: 0; EWOULDBLOCK when another has it; any other errno: this file
 * system has no locks (neither flock nor those of open file descriptions). */
int ovr_lock_file(int fd, bool shared);

#endif
