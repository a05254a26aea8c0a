/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Chooses the reader of a file. The content is read into memory (gzip is
 * decompressed, the size is limited) and its format is recognized by the
 * content, not by the file name.
 */
#include "surface/profile.h"

#include <errno.h>
#include <math.h>
#include <stdbool.h>
#include <string.h>
#include <strings.h>
#include <zlib.h>

#include "base/error.h"
#include "base/given.h"
#include "base/text.h"

/* ---------------------------------------------------------------- content */

/* Enlarges the buffer to at most one byte more than the allowed size, which
 * suffices to detect files that are too large. */
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

/* Reads the whole file; gzread also reads uncompressed files. */
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
                               "is larger than %d MiB, which is the maximum",
                               OVR_CONTENT_MAX >> 20);
    }
    gzerror(in, &code);
    if (code == Z_MEM_ERROR)
        return ovr_fail(err, OVR_NO_MEMORY, "%s: out of memory", file);
    if (got < 0 || code < 0)
        return ovr_fail_at(err, OVR_BAD_INPUT, file, 0, "cannot be read: %s",
                           code == Z_ERRNO ? strerror(errno)
                           : code == Z_BUF_ERROR
                               ? "the gzip stream is truncated"
                               : "the gzip stream is damaged");
    *content = (ovr_bytes){data, size};
    return OVR_OK;
}

ovr_status ovr_file_bytes(const char *file, ovr_arena *arena,
                          ovr_bytes *content, ovr_error *err)
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

/* ------------------------------------------------------- format detection */

static bool starts(ovr_bytes content, const char *magic)
{
    size_t n = strlen(magic);
    return content.size >= n && memcmp(content.data, magic, n) == 0;
}

/* True for a softgauge file: before its first ETX it has lines that begin with
 * PRF (or SUR), CX and CZ. */
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

/* Fails for known formats that are not supported, with advice. */
static ovr_status check_foreign(ovr_bytes content, const char *file,
                                ovr_error *err)
{
    static const char csv[] = "save the sheet as CSV";
    static const char x3p[] = "export it as X3P, SDF, SUR or text";
    static const struct {
        const char *magic, *ending, *name, *remedy;
        size_t size;
    } formats[] = {
        {"\xD0\xCF\x11\xE0", ".xls", "an Excel workbook", csv, 4},
        {"PK", ".xlsx", "an Excel workbook", csv, 2},
        {"PK", ".xlsm", "an Excel workbook", csv, 2},
        {"PK", ".ods", "an OpenDocument spreadsheet", csv, 2},
        {"", ".mnt", "a document of MountainsMap (MNT)", x3p, 0},
        {"\x01\x00"
         "Directory",
         "", "a file of Wyko (OPD)", x3p, 11},
        {"AliconaImaging", "", "a file of Alicona (AL3D)", x3p, 14},
        {"PK", ".plux", "a file of Sensofar (PLUX)", x3p, 2},
        {"", ".plu", "a file of Sensofar (PLU)", x3p, 0},
        {"\x88\x1B\x03", "", "a file of Zygo (DAT)", x3p, 3},
        {"VK4_", "", "a file of Keyence (VK4)", x3p, 4},
        {"VK6", "", "a file of Keyence (VK6)", x3p, 3},
        {"GWYP", "", "a file of Gwyddion (GWY)", x3p, 4},
        {"\x89HDF", "", "an HDF5 file", x3p, 4},
        {"MATLAB 5.0", "", "a MAT file of MATLAB",
         "write it with writematrix as CSV", 10},
        {"%PDF", "", "a PDF document", csv, 4},
        {"\x89PNG", "", "a picture (PNG)", x3p, 4},
        {"\xFF\xD8\xFF", "", "a picture (JPEG)", x3p, 3},
        {"II*\0", "", "a picture (TIFF)", x3p, 4},
        {"MM\0*", "", "a picture (TIFF)", x3p, 4},
    };
    size_t length = strlen(file);
    for (size_t k = 0; k < sizeof formats / sizeof *formats; k++) {
        size_t end = strlen(formats[k].ending);
        bool named = end && length >= end &&
                     !strcasecmp(file + length - end, formats[k].ending);
        bool begins = content.size >= formats[k].size &&
                      !memcmp(content.data, formats[k].magic, formats[k].size);
        /* Text formats must not contain NUL bytes. */
        if (!formats[k].size)
            begins = named && memchr(content.data, 0, content.size);
        if (begins && (named || !end))
            return ovr_fail_at(err, OVR_BAD_INPUT, file, 0,
                               "is %s, which is not supported: %s",
                               formats[k].name, formats[k].remedy);
    }
    return OVR_OK;
}

static bool is_sdf(ovr_bytes content)
{
    static const char *const families[] = {"ISO-", "BCR-", "NIST-"};
    if (!starts(content, "a") && !starts(content, "b"))
        return false;
    content.data++, content.size--;
    for (size_t k = 0; k < sizeof families / sizeof *families; k++)
        if (starts(content, families[k]))
            return true;
    return false;
}

static ovr_reader *reader_of(ovr_bytes content)
{
    if (starts(content, "PK"))
        return ovr_read_x3p;
    if (is_sdf(content))
        return ovr_read_sdf;
    if (starts(content, "DIGITAL SURF") || starts(content, "DSCOMPRESSED"))
        return ovr_read_sur;
    if (starts(content, "\x93NUMPY"))
        return ovr_read_npy;
    return is_smd(content) ? ovr_read_smd : ovr_read_text;
}

/* ----------------------------------------------------------- entry points */

/* Rejects the choice of columns for other formats than text. */
static ovr_status check_idle(const ovr_profile *profile,
                             const ovr_profile_source *source, bool text,
                             ovr_error *err)
{
    const char *key = source->column_x ? "column_x" : "column_z";
    if (text || (!source->column_x && !source->column_z))
        return OVR_OK;
    return ovr_about(err, key,
                     ovr_fail_at(err, OVR_BAD_INPUT, profile->file, 0,
                                 "%s: has no effect, because only text files "
                                 "have columns",
                                 ovr_named(profile, key).text));
}

/* Rejects the choice of a line for a file that contains a single one. */
static ovr_status check_single(const ovr_profile *p,
                               const ovr_profile_source *s, ovr_error *err)
{
    const char *key = s->row > 1             ? "row"
                      : s->column            ? "column"
                      : !isnan(s->y)         ? "y"
                      : !isnan(s->direction) ? "direction"
                      : !isnan(s->band)      ? "band"
                                             : NULL;
    if (p->view.rows || p->view.columns || p->map_only || !key)
        return OVR_OK;
    return ovr_about(err, key,
                     ovr_fail_at(err, OVR_BAD_INPUT, p->file, 0,
                                 "%s: the file contains line 1 only",
                                 ovr_named(p, key).text));
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
    else
        status = check_foreign(content, profile->file, err);
    if (!status) {
        ovr_reader *reader = reader_of(content);
        status = check_idle(profile, source, reader == ovr_read_text, err);
        if (!status)
            status = reader(profile, source, content, err);
    }
    if (!status)
        status = check_single(profile, source, err);
    if (!status)
        return profile;
    ovr_profile_free(profile);
    return NULL;
}

/* Multiplications in the time in which a byte of a text is read. */
static const double WORK_A_BYTE = 10;

static ovr_profile *parse(const ovr_profile_source *source, bool map_only,
                          ovr_bytes content, const ovr_allocator *allocator,
                          ovr_error *err)
{
    ovr_profile *profile = ovr_profile_new(source->file, allocator, err);
    if (!profile)
        return NULL;
    profile->map_only = map_only;
    profile->work = WORK_A_BYTE * (double)content.size;
    return understand(profile, source, content, err);
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
    return parse(&own, false, content, allocator, err);
}

ovr_profile *ovr_profile_read_file(const ovr_profile_source *source,
                                   bool map_only,
                                   const ovr_allocator *allocator,
                                   ovr_error *err)
{
    ovr_arena arena = ovr_arena_make(allocator);
    ovr_profile *profile = NULL;
    ovr_bytes content = {NULL, 0};
    if (!source->file || !*source->file)
        ovr_fail(err, OVR_BAD_INPUT, "a profile needs a file; set file");
    else if (!ovr_file_bytes(source->file, &arena, &content, err))
        profile = parse(source, map_only, content, allocator, err);
    ovr_arena_release(&arena);
    return profile;
}

ovr_profile *ovr_profile_read(const ovr_profile_source *source,
                              const ovr_allocator *allocator, ovr_error *err)
{
    ovr_profile_source own;
    if (OVR_TAKE(ovr_profile_source, &own, source, err))
        return NULL;
    return ovr_profile_read_file(&own, false, allocator, err);
}
