/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Finds the reader of a file: the content is taken into memory (gzip undone on
 * the way, size bounded) and told apart by what it holds, not by its name.
 */
#include "surface/profile.h"

#include <errno.h>
#include <stdbool.h>
#include <string.h>
#include <zlib.h>

#include "base/error.h"
#include "base/given.h"
#include "base/text.h"

/* ----------------------------------------------------------- the content */

/* Up to one byte more than may be: that it is there is enough to know. */
static ovr_status grow(ovr_arena *arena, char **data, size_t *capacity,
                       ovr_error *err)
{
    const size_t maximum = (size_t)OVR_CONTENT_MAX + 1;
    size_t wider = 4 * *capacity < OVR_CONTENT_MAX ? 4 * *capacity : maximum;
    char *moved = ovr_arena_take(arena, wider, 1, err);
    if (!moved)
        return OVR_NO_MEMORY;
    memcpy(moved, *data, *capacity);
    *data = moved;
    *capacity = wider;
    return OVR_OK;
}

/* gzread gives plain files as they are. */
static ovr_status read_all(gzFile in, const char *file, ovr_arena *arena,
                           ovr_bytes *content, ovr_error *err)
{
    size_t capacity = 1 << 16, size = 0;
    char *data = ovr_arena_take(arena, capacity, 1, err);
    int got = 1, code;
    if (!data)
        return OVR_NO_MEMORY;
    while (got > 0) {
        if (size == capacity && grow(arena, &data, &capacity, err))
            return OVR_NO_MEMORY;
        got = gzread(in, data + size, (unsigned)(capacity - size));
        size += got > 0 ? (size_t)got : 0;
        if (size > OVR_CONTENT_MAX)
            return ovr_fail_at(err, OVR_BAD_INPUT, file, 0,
                               "holds more than %d MiB, too much for a profile",
                               OVR_CONTENT_MAX >> 20);
    }
    gzerror(in, &code);
    if (got < 0 || code < 0)
        return ovr_fail_at(err, OVR_BAD_INPUT, file, 0, "cannot be read: %s",
                           code == Z_ERRNO ? strerror(errno)
                           : code == Z_BUF_ERROR
                               ? "the gzip stream is cut off"
                               : "the gzip stream is damaged");
    *content = (ovr_bytes){data, size};
    return OVR_OK;
}

static ovr_status load(const char *file, ovr_arena *arena, ovr_bytes *content,
                       ovr_error *err)
{
    ovr_status status;
    gzFile in;
    errno = 0;
    in = gzopen(file, "rb");
    if (!in)
        return ovr_fail_at(err, OVR_BAD_INPUT, file, 0, "cannot be opened: %s",
                           errno ? strerror(errno) : "out of memory");
    status = read_all(in, file, arena, content, err);
    gzclose(in);
    return status;
}

/* -------------------------------------------------------------- sniffing */

static bool starts(ovr_bytes content, const char *magic)
{
    size_t n = strlen(magic);
    return content.size >= n && memcmp(content.data, magic, n) == 0;
}

/* A softgauge has, before its first ETX, lines that begin with PRF (or SUR),
 * CX and CZ. */
static bool is_smd(ovr_bytes content)
{
    ovr_lines lines = ovr_lines_of(content);
    ovr_line line;
    bool kind = false, cx = false, cz = false;
    while (lines.number < 64 && ovr_next_line(&lines, &line)) {
        kind |= ovr_line_starts(line, "PRF") || ovr_line_starts(line, "SUR");
        cx |= kind && ovr_line_starts(line, "CX");
        cz |= kind && ovr_line_starts(line, "CZ");
        if (memchr(line.text, 3, line.size))
            break;
    }
    return cx && cz;
}

static ovr_reader *reader_of(ovr_bytes content)
{
    if (starts(content, "PK"))
        return ovr_read_x3p;
    if (starts(content, "bISO-1.0") || starts(content, "aISO-1.0"))
        return ovr_read_sdf;
    return is_smd(content) ? ovr_read_smd : ovr_read_text;
}

/* ------------------------------------------------------------ both doors */

/* Columns are those of text, which holds one line; others have lines. */
static ovr_status check_idle(ovr_profile *profile,
                             const ovr_profile_source *source, bool text,
                             ovr_error *err)
{
    size_t line;
    const char *key = source->column_x ? "column_x" : "column_z";
    if (text)
        return ovr_profile_choose_line(profile, source, 1, &line, err);
    if (!source->column_x && !source->column_z)
        return OVR_OK;
    return ovr_about(err, key,
                     ovr_fail_at(err, OVR_BAD_INPUT, profile->file, 0,
                                 "%s: has no effect, columns are those of text",
                                 ovr_named(profile, key).text));
}

static ovr_profile *understand(ovr_profile *profile,
                               const ovr_profile_source *source,
                               ovr_bytes content, ovr_error *err)
{
    ovr_status status;
    profile->options = source->options;
    if (content.size == 0)
        status = ovr_fail_at(err, OVR_BAD_INPUT, profile->file, 0,
                             "the file is empty");
    else {
        ovr_reader *reader = reader_of(content);
        status = check_idle(profile, source, reader == ovr_read_text, err);
        if (!status)
            status = reader(profile, source, content, err);
    }
    if (!status)
        return profile;
    ovr_profile_free(profile);
    return NULL;
}

static ovr_profile *parse(const ovr_profile_source *source, ovr_bytes content,
                          const ovr_allocator *allocator, ovr_error *err)
{
    ovr_profile *profile = ovr_profile_new(source->file, allocator, err);
    return profile ? understand(profile, source, content, err) : NULL;
}

ovr_profile *ovr_profile_parse(const ovr_profile_source *source,
                               const void *data, size_t size,
                               const ovr_allocator *allocator, ovr_error *err)
{
    if (!data)
        return ovr_null(err, __func__);
    ovr_profile_source own;
    ovr_bytes content = {data, size};
    if (OVR_TAKE(ovr_profile_source, &own, source, err))
        return NULL;
    return parse(&own, content, allocator, err);
}

ovr_profile *ovr_profile_read(const ovr_profile_source *source,
                              const ovr_allocator *allocator, ovr_error *err)
{
    ovr_arena arena = ovr_arena_make(allocator);
    ovr_profile *profile = NULL;
    ovr_bytes content = {NULL, 0};
    ovr_profile_source own;
    if (OVR_TAKE(ovr_profile_source, &own, source, err))
        return NULL;
    if (!own.file || !*own.file)
        ovr_fail(err, OVR_BAD_INPUT, "a profile needs its file: give file");
    else if (!load(own.file, &arena, &content, err))
        profile = parse(&own, content, allocator, err);
    ovr_arena_release(&arena);
    return profile;
}
