/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Whole pieces of files, and what makes their names last.  Those that
 * return an int: 0 or an errno. */
#ifndef OVR_BASE_DISK_H
#define OVR_BASE_DISK_H

#include <stddef.h>
#include <stdint.h>

#include "base/error.h"

/* All bytes, in spite of interruptions. */
int ovr_write_all(int fd, const void *from, size_t bytes, uint64_t at);
/* As far as the file goes; the rest is zero. */
int ovr_read_all(int fd, void *to, size_t bytes, uint64_t at);

/* Names made, changed or removed in the folder of `path` are on the disk
 * itself, as far as its file system can promise it. */
int ovr_sync_folder(const char *path);

/* Fails where `path` exists, is not empty and does not begin with `head`, as
 * files of that kind of this program do. */
ovr_status ovr_file_ours(const char *path, const char *head, ovr_error *err);

#endif
