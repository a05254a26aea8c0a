/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Complete reads and writes of files, and syncing of folders. Functions that
 * return an int return 0 or an errno. */
#ifndef OVR_BASE_DISK_H
#define OVR_BASE_DISK_H

#include <stddef.h>
#include <stdint.h>

#include "base/error.h"

/* Writes all bytes, also after interruptions. */
int ovr_write_all(int fd, const void *from, size_t bytes, uint64_t at);
/* Reads up to the end of the file; remaining bytes are zero. */
int ovr_read_all(int fd, void *to, size_t bytes, uint64_t at);

/* Syncs the folder of `path`, so that names created, changed or removed in it
 * are on disk, if the file system supports that. */
int ovr_sync_folder(const char *path);

/* Fails if `path` exists, is not empty and does not begin with `head`, the
 * beginning of this program's files of that kind. */
ovr_status ovr_file_ours(const char *path, const char *head, ovr_error *err);

#endif
