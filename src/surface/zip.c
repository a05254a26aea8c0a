/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "surface/zip.h"

#define ZLIB_CONST /* for const input pointers */
#include <limits.h>
#include <string.h>
#include <zlib.h>

#include "base/error.h"

enum {
    END = 22, /* sizes of records in bytes; END: the one at the end */
    END_64 = 56,
    LOCATOR_64 = 20,
    CENTRAL = 46,
    LOCAL = 30,
    STORED = 0,
    DEFLATED = 8,
    ENCRYPTED = 1 /* flag bit */
};

static const char end_mark[] = "PK\5\6", end_64_mark[] = "PK\6\6",
                  locator_64_mark[] = "PK\6\7", central_mark[] = "PK\1\2",
                  local_mark[] = "PK\3\4";

static const char cut_off[] = "its directory is cut off or damaged";

/* --------------------------------------------------------------- directory */

/* Reads a little-endian number. */
static uint64_t number(const char *at, int bytes)
{
    uint64_t value = 0;
    for (int k = bytes; k-- > 0;)
        value = value << 8 | (unsigned char)at[k];
    return value;
}

static bool has_mark(ovr_bytes content, uint64_t at, size_t bytes,
                     const char *mark)
{
    return at <= content.size && content.size - at >= bytes &&
           !memcmp(content.data + at, mark, 4);
}

/* Finds the end record. It is followed by a comment of up to 64 kB, which may
 * contain its signature; a record whose comment ends with the file is
 * preferred. */
static bool find_end(ovr_bytes content, size_t *end)
{
    bool found = false;
    for (size_t n = 0; n <= 65535 && n + END <= content.size; n++) {
        size_t at = content.size - END - n;
        if (!has_mark(content, at, END, end_mark))
            continue;
        bool whole = number(content.data + at + 20, 2) == n;
        if (whole || !found)
            *end = at;
        found = true;
        if (whole)
            break;
    }
    return found;
}

typedef struct directory {
    uint64_t entries, at;
} directory;

/* Reads counts and offsets. If they do not fit into the end record, they are in
 * another record before it. */
static const char *find_directory(ovr_bytes content, directory *d)
{
    size_t end;
    uint64_t at;
    if (!find_end(content, &end))
        return "it has no directory";
    const char *record = content.data + end;
    d->entries = number(record + 10, 2);
    d->at = number(record + 16, 4);
    if (d->entries != 0xffff && d->at != 0xffffffff)
        return NULL;
    if (end < LOCATOR_64 ||
        !has_mark(content, end - LOCATOR_64, LOCATOR_64, locator_64_mark))
        return cut_off;
    at = number(content.data + end - LOCATOR_64 + 8, 8);
    if (!has_mark(content, at, END_64, end_64_mark))
        return cut_off;
    d->entries = number(content.data + at + 32, 8);
    d->at = number(content.data + at + 48, 8);
    return NULL;
}

/* Reads 64-bit sizes from the extra field if all bits of the 32-bit ones are
 * set. */
static void read_extra(ovr_zip_entry *e, const char *at, size_t bytes)
{
    uint64_t *const value[] = {&e->size, &e->packed, &e->at};
    while (bytes >= 4) {
        size_t kind = (size_t)number(at, 2), length = (size_t)number(at + 2, 2);
        at += 4;
        bytes -= 4;
        if (length > bytes)
            return;
        for (size_t k = 0, used = 0; kind == 1 && k < 3; k++)
            if (*value[k] == 0xffffffff && used + 8 <= length) {
                *value[k] = number(at + used, 8);
                used += 8;
            }
        at += length;
        bytes -= length;
    }
}

/* Reads an entry of the directory; returns its length, or 0 if it is damaged or
 * memory is insufficient. */
static size_t read_entry(const ovr_zip *zip, uint64_t at, ovr_zip_entry *e,
                         ovr_arena *arena, ovr_error *err)
{
    if (!has_mark(zip->content, at, CENTRAL, central_mark))
        return 0;
    const char *record = zip->content.data + at;
    size_t name = (size_t)number(record + 28, 2);
    size_t extra = (size_t)number(record + 30, 2);
    size_t length = CENTRAL + name + extra + (size_t)number(record + 32, 2);
    if (length > zip->content.size - at)
        return 0;
    *e = (ovr_zip_entry){.flags = (unsigned)number(record + 8, 2),
                         .method = (unsigned)number(record + 10, 2),
                         .crc = (unsigned)number(record + 16, 4),
                         .packed = number(record + 20, 4),
                         .size = number(record + 24, 4),
                         .at = number(record + 42, 4)};
    read_extra(e, record + CENTRAL + name, extra);
    e->name = ovr_arena_take(arena, name + 1, 1, err);
    if (e->name)
        memcpy(e->name, record + CENTRAL, name);
    return e->name ? length : 0;
}

static ovr_status unreadable(const char *file, const char *why, ovr_error *err)
{
    return ovr_fail_at(err, OVR_BAD_INPUT, file, 0,
                       "not a readable ZIP (X3P): %s", why);
}

ovr_status ovr_zip_open(ovr_zip *zip, ovr_bytes content, const char *file,
                        ovr_arena *arena, ovr_error *err)
{
    directory d;
    const char *wrong = find_directory(content, &d);
    *zip = (ovr_zip){.content = content};
    if (!wrong && d.entries > content.size / CENTRAL)
        wrong = cut_off;
    if (wrong)
        return unreadable(file, wrong, err);
    zip->entry = ovr_arena_take(arena, (size_t)d.entries, sizeof *zip->entry,
                                err);
    if (!zip->entry)
        return OVR_NO_MEMORY;
    for (size_t k = 0; k < d.entries; k++) {
        size_t length = read_entry(zip, d.at, &zip->entry[k], arena, err);
        if (!length)
            return arena->starved ? OVR_NO_MEMORY
                                  : unreadable(file, cut_off, err);
        d.at += length;
        zip->entries++;
    }
    return OVR_OK;
}

const ovr_zip_entry *ovr_zip_find(const ovr_zip *zip, const char *name)
{
    for (size_t k = 0; k < zip->entries; k++)
        if (!strcmp(zip->entry[k].name, name))
            return &zip->entry[k];
    return NULL;
}

/* --------------------------------------------------------------- unpacking */

static bool inflate_all(ovr_bytes packed, char *to, size_t size)
{
    z_stream z = {.next_in = (const Bytef *)packed.data,
                  .avail_in = (uInt)packed.size,
                  .next_out = (Bytef *)to,
                  .avail_out = (uInt)size};
    char none;
    if (!size) /* zlib needs a valid pointer */
        z.next_out = (Bytef *)&none;
    if (inflateInit2(&z, -MAX_WBITS) != Z_OK)
        return false;
    bool whole = inflate(&z, Z_FINISH) == Z_STREAM_END && !z.avail_out;
    inflateEnd(&z);
    return whole;
}

/* Finds the compressed data after the local header, which repeats the name and
 * has its own extra field. */
static bool find_packed(const ovr_zip *zip, const ovr_zip_entry *e,
                        ovr_bytes *packed)
{
    if (!has_mark(zip->content, e->at, LOCAL, local_mark))
        return false;
    const char *record = zip->content.data + e->at;
    uint64_t from = e->at + LOCAL + number(record + 26, 2) +
                    number(record + 28, 2);
    if (from > zip->content.size || e->packed > zip->content.size - from)
        return false;
    *packed = (ovr_bytes){zip->content.data + from, (size_t)e->packed};
    return true;
}

const char *ovr_zip_unpack(const ovr_zip *zip, const ovr_zip_entry *e, char *to)
{
    ovr_bytes packed;
    bool whole;
    if (e->flags & ENCRYPTED)
        return "encrypted";
    if (e->method != STORED && e->method != DEFLATED)
        return "neither stored nor deflated";
    if (e->size > UINT_MAX || e->packed > UINT_MAX ||
        !find_packed(zip, e, &packed))
        return "damaged or cut off";
    if (e->method == STORED) {
        whole = packed.size == e->size;
        if (whole)
            memcpy(to, packed.data, packed.size);
    } else {
        whole = inflate_all(packed, to, (size_t)e->size);
    }
    return whole && crc32(0, (const Bytef *)to, (uInt)e->size) == e->crc
               ? NULL
               : "damaged or cut off";
}

/* ----------------------------------------------------------------- writing */

static char *write_integer(char *at, uint64_t value, int bytes)
{
    for (int k = 0; k < bytes; k++)
        *at++ = (char)(value >> (8 * k) & 0xff);
    return at;
}

/* Writes the fields from the required version to the length of the extra field,
 * which local headers and the directory have in common. */
static char *write_common(char *at, const ovr_zip_entry *e)
{
    at = write_integer(at, 20, 2);
    at = write_integer(at, e->flags, 2);
    at = write_integer(at, e->method, 2);
    at = write_integer(at, 0x21 << 16,
                       4); /* 1980-01-01: same input, same bytes */
    at = write_integer(at, e->crc, 4);
    at = write_integer(at, e->packed, 4);
    at = write_integer(at, e->size, 4);
    at = write_integer(at, strlen(e->name), 2);
    return write_integer(at, 0, 2);
}

static bool write_record(FILE *to, const char *record, size_t bytes,
                         const char *name)
{
    return fwrite(record, 1, bytes, to) == bytes && fputs(name, to) >= 0;
}

static bool write_local(FILE *to, const ovr_zip_entry *e)
{
    char record[LOCAL];
    memcpy(record, local_mark, 4);
    write_common(record + 4, e);
    return write_record(to, record, LOCAL, e->name);
}

static bool write_central(FILE *to, const ovr_zip_entry *e)
{
    char record[CENTRAL] = {0};
    memcpy(record, central_mark, 4);
    write_common(write_integer(record + 4, 20, 2), e);
    write_integer(record + 42, e->at, 4);
    return write_record(to, record, CENTRAL, e->name);
}

static bool write_end(FILE *to, uint64_t entries, uint64_t from, uint64_t end)
{
    char record[END] = {0};
    memcpy(record, end_mark, 4);
    write_integer(record + 8, entries, 2);
    write_integer(record + 10, entries, 2);
    write_integer(record + 12, end - from, 4);
    write_integer(record + 16, from, 4);
    return write_record(to, record, END, "");
}

/* Compresses the data if that makes them smaller. */
static bool pack(const ovr_zip_file *file, bool stored, ovr_arena *arena,
                 ovr_zip_entry *e, const void **packed)
{
    z_stream z = {.next_in = file->data, .avail_in = (uInt)file->size};
    *packed = file->data;
    e->packed = file->size;
    if (stored)
        return true;
    void *out = ovr_arena_take(arena, file->size + 1, 1, NULL);
    if (!out || deflateInit2(&z, Z_DEFAULT_COMPRESSION, Z_DEFLATED, -MAX_WBITS,
                             8, Z_DEFAULT_STRATEGY) != Z_OK)
        return false;
    z.next_out = out;
    z.avail_out = (uInt)file->size;
    if (deflate(&z, Z_FINISH) == Z_STREAM_END) {
        e->method = DEFLATED;
        e->packed = z.total_out;
        *packed = out;
    }
    deflateEnd(&z);
    return true;
}

bool ovr_zip_write(FILE *to, const ovr_zip_file *file, size_t files,
                   bool stored, ovr_arena *arena)
{
    ovr_zip_entry *e = ovr_arena_take(arena, files, sizeof *e, NULL);
    uint64_t at = 0, from;
    bool good = e != NULL;
    for (size_t k = 0; good && k < files; k++) {
        const void *packed;
        e[k] = (ovr_zip_entry){
            .name = ovr_arena_text(arena, file[k].name, NULL),
            .size = file[k].size,
            .at = at,
            .crc = (unsigned)crc32(0, file[k].data, (uInt)file[k].size)};
        good = e[k].name && pack(&file[k], stored, arena, &e[k], &packed) &&
               write_local(to, &e[k]) &&
               fwrite(packed, 1, (size_t)e[k].packed, to) == e[k].packed;
        if (good)
            at += LOCAL + strlen(e[k].name) + e[k].packed;
    }
    from = at;
    for (size_t k = 0; good && k < files; k++) {
        good = write_central(to, &e[k]);
        at += CENTRAL + strlen(e[k].name);
    }
    return good && write_end(to, files, from, at);
}
