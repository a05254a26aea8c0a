/* SPDX-License-Identifier: GPL-3.0-or-later */
/* ZIP archives in memory (PKWARE APPNOTE 6.3), for X3P files.  Entries are
 * stored or deflated and may have 64-bit sizes, but are not encrypted. */
#ifndef OVR_SURFACE_ZIP_H
#define OVR_SURFACE_ZIP_H

#include <stdint.h>
#include <stdio.h>

#include "base/arena.h"
#include "base/text.h"

typedef struct ovr_zip_entry {
    char *name;
    unsigned method, flags, crc;
    uint64_t packed, size, at; /* in bytes; offset of the local header */
} ovr_zip_entry;

typedef struct ovr_zip {
    ovr_bytes content;
    ovr_zip_entry *entry;
    size_t entries;
} ovr_zip;

/* Reads the directory.  Fails with OVR_BAD_INPUT if the content of the file is
 * no readable archive. */
ovr_status ovr_zip_open(ovr_zip *zip, ovr_bytes content, const char *file,
                        ovr_arena *arena, ovr_error *err);

/* Returns the entry with this name, or NULL. */
const ovr_zip_entry *ovr_zip_find(const ovr_zip *zip, const char *name);

/* Unpacks an entry into `to`, which must have its size, and verifies the
 * checksum. Returns NULL or the reason of the failure. */
const char *ovr_zip_unpack(const ovr_zip *zip, const ovr_zip_entry *entry,
                           char *to);

/* A file to add to a new archive. */
typedef struct ovr_zip_file {
    const char *name;
    const void *data;
    size_t size;
} ovr_zip_file;

/* Writes an archive, compressed or stored; all files must be smaller than 4 GB.
 * Returns false after a write error or without memory. */
bool ovr_zip_write(FILE *to, const ovr_zip_file *file, size_t files,
                   bool stored, ovr_arena *arena);

#endif
