/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Digital Surf .sur and .pro: profiles (.pro) and surfaces (.sur), 16 or 32
 * bit.
 *
 * Header of 512 bytes, little-endian: magic 12 ("DIGITAL SURF", compressed
 * "DSCOMPRESSED"), at 12 u16 0 (PC byte order), 14 i16 number of objects, 18
 * i16 type (1 profile, 2 surface, 4 series of profiles), 86 i16 special points,
 * 98 i16 bits of a point, 100 and 104 i32 lowest and highest value, 108, 112
 * i32 points of a line and lines, 120, 124, 128 f32 spacings, 180, 196, 212
 * char 16 their units, 334 and 336 i16 sizes of the comment and of the private
 * zone, which follow the header, 474 f32 offset of z.  Then values, x fastest;
 * z = value spacing_z + offset_z.  With special points, lowest - 2 is missing.
 *
 * Compressed: u32 number of streams, a u32 pair of sizes (plain, packed) for
 * each, then the zlib streams, which hold the values one after the other.
 */
#include <limits.h>
#include <math.h>
#include <string.h>
#include <zlib.h>

#include "base/error.h"
#include "base/quantity.h"
#include "surface/areal.h"
#include "surface/binary.h"

enum { HEADER = 512 };

typedef struct sur {
    double objects, type, bits, lowest, nx, ny;
    double spacing[3]; /* spacing along x, y and height unit, metres */
    double offset;     /* offset of z, in metres */
    bool special;      /* lowest - 2 denotes a missing value */
    size_t start;      /* offset of the values */
} sur;

static double whole16(const char *at)
{
    return ovr_binary_value(at, OVR_BINARY_I16);
}

static double whole32(const char *at)
{
    return ovr_binary_value(at, OVR_BINARY_I32);
}

/* Returns the unit in a field of 16 characters in metres; 0 if unknown. */
static double unit_at(const char *at)
{
    ovr_line unit = {at, 0, 0};
    while (unit.size < 16 && at[unit.size])
        unit.size++;
    return ovr_length_unit(ovr_trim(unit), true);
}

static ovr_status read_units(const ovr_profile *p, const char *d, sur *h,
                             ovr_error *err)
{
    for (int k = 0; k < 3; k++) {
        const char *unit = d + 180 + 16 * k;
        double metres = unit_at(unit);
        ovr_line text = {unit, strnlen(unit, 16), 0};
        h->spacing[k] = ovr_binary_value(d + 120 + 4 * k, OVR_BINARY_F32);
        if (!(metres > 0) && k == 1 && h->ny < 2)
            metres = unit_at(d + 180); /* not used by profiles */
        if (!(metres > 0))
            return ovr_fail_at(err, OVR_BAD_INPUT, p->file, 0,
                               "header: the unit '%s' of %c is not a length",
                               ovr_quote(text).text, "xyz"[k]);
        h->spacing[k] *= metres;
        if (k == 2)
            h->offset = ovr_binary_value(d + 474, OVR_BINARY_F32) * metres;
    }
    if (!isfinite(h->offset))
        h->offset = 0;
    if (h->spacing[2] != 0 && isfinite(h->spacing[2]))
        return OVR_OK;
    return ovr_fail_at(err, OVR_BAD_INPUT, p->file, 0,
                       "header: the step of z, %g m, must not be 0",
                       h->spacing[2]);
}

static ovr_status read_header(const ovr_profile *p, ovr_bytes c, sur *h,
                              ovr_error *err)
{
    const char *d = c.data;
    double comment, private_zone;
    if (c.size < HEADER)
        return ovr_fail_at(err, OVR_BAD_INPUT, p->file, 0,
                           "offset %zu: truncated within the header of %d "
                           "bytes",
                           c.size, HEADER);
    *h = (sur){.objects = whole16(d + 14),
               .type = whole16(d + 18),
               .special = whole16(d + 86) != 0,
               .bits = whole16(d + 98),
               .lowest = whole32(d + 100),
               .nx = whole32(d + 108),
               .ny = whole32(d + 112)};
    comment = whole16(d + 334);
    private_zone = whole16(d + 336);
    if (whole16(d + 12) != 0)
        return ovr_fail_at(err, OVR_BAD_INPUT, p->file, 0,
                           "header: only files of PC byte order are supported");
    if (h->type != 1 && h->type != 2 && h->type != 4)
        return ovr_fail_at(err, OVR_BAD_INPUT, p->file, 0,
                           "header: objects of type %g are not supported; "
                           "must be a profile (1), surface (2) or series of "
                           "profiles (4)",
                           h->type);
    if (h->bits != 16 && h->bits != 32)
        return ovr_fail_at(err, OVR_BAD_INPUT, p->file, 0,
                           "header: %g bits of a point must be 16 or 32",
                           h->bits);
    if (comment < 0 || private_zone < 0)
        return ovr_fail_at(err, OVR_BAD_INPUT, p->file, 0,
                           "header: sizes of %g and %g bytes of comment and "
                           "private zone must not be negative",
                           comment, private_zone);
    if (!(h->nx >= 2 && h->ny >= 1 && h->nx * h->ny <= OVR_POINTS_MAX))
        return ovr_fail_at(err, OVR_BAD_INPUT, p->file, 0,
                           "header: %g x %g points: must be 2 to %d", h->nx,
                           h->ny, OVR_POINTS_MAX);
    h->start = HEADER + (size_t)comment + (size_t)private_zone;
    return read_units(p, d, h, err);
}

static double unsigned32(const char *at)
{
    return ovr_binary_value(at, OVR_BINARY_U32);
}

static ovr_status fail_cut(const ovr_profile *p, ovr_bytes c, ovr_error *err)
{
    return ovr_fail_at(err, OVR_BAD_INPUT, p->file, 0,
                       "offset %zu: truncated within the values", c.size);
}

/* Unpacks the streams into `values`, which has the size of all of them. */
static ovr_status unpack(const ovr_profile *p, ovr_bytes c, size_t start,
                         char *values, size_t size, ovr_error *err)
{
    size_t at = start + 4, used = 0, from;
    double streams;
    if (c.size < at)
        return fail_cut(p, c, err);
    streams = unsigned32(c.data + start);
    if (streams * 8 > (double)(c.size - at))
        return fail_cut(p, c, err);
    from = at + 8 * (size_t)streams;
    for (; at < start + 4 + 8 * (size_t)streams; at += 8) {
        size_t plain = (size_t)unsigned32(c.data + at);
        size_t packed = (size_t)unsigned32(c.data + at + 4);
        uLongf made = plain;
        if (packed > c.size - from)
            return fail_cut(p, c, err);
        if (plain > size - used)
            return ovr_fail_at(err, OVR_BAD_INPUT, p->file, 0,
                               "the streams contain more than the announced "
                               "%zu bytes",
                               size);
        if (uncompress((Bytef *)values + used, &made,
                       (const Bytef *)c.data + from, packed) != Z_OK ||
            made != plain)
            return ovr_fail_at(err, OVR_BAD_INPUT, p->file, 0,
                               "offset %zu: the compressed values are damaged",
                               from);
        used += plain;
        from += packed;
    }
    return used == size ? OVR_OK : fail_cut(p, c, err);
}

ovr_status ovr_read_sur(ovr_profile *p, const ovr_profile_source *source,
                        ovr_bytes c, ovr_error *err)
{
    ovr_arena arena = ovr_arena_make(&p->arena.allocator);
    ovr_status status;
    const char *values = NULL;
    ovr_binary type;
    size_t bytes, all;
    bool packed;
    sur h = {0};
    p->view.format = "SUR (Digital Surf)";
    status = read_header(p, c, &h, err);
    if (status)
        return status;
    packed = memcmp(c.data, "DSCOMPRESSED", 12) == 0;
    type = h.bits == 16 ? OVR_BINARY_I16 : OVR_BINARY_I32;
    bytes = ovr_binary_size(type);
    all = (size_t)h.nx * (size_t)h.ny;
    /* The compression ratio of deflate is at most 1032. */
    if (c.size < h.start || (double)(c.size - h.start) * (packed ? 1032 : 1) <
                                (double)(all * bytes))
        return fail_cut(p, c, err);
    if (packed) {
        char *plain = ovr_arena_take(&arena, all * bytes, 1, err);
        status = plain ? unpack(p, c, h.start, plain, all * bytes, err)
                       : OVR_NO_MEMORY;
        values = plain;
    } else {
        values = c.data + h.start;
    }
    if (!status)
        status = ovr_areal_reserve(p, (size_t)h.nx, (size_t)h.ny, h.spacing[0],
                                   h.ny > 1 ? h.spacing[1] : h.spacing[0], err);
    for (size_t i = 0; i < all && !status; i++) {
        double value = ovr_binary_value(values + i * bytes, type);
        p->map.z[i] = h.special && value == h.lowest - 2
                          ? NAN
                          : value * h.spacing[2] + h.offset;
    }
    ovr_arena_release(&arena);
    if (status)
        return status;
    if (h.objects > 1)
        ovr_profile_note(p, "the first of %g objects is read", h.objects);
    ovr_profile_note(p, "header: spacing %s, heights times %s",
                     ovr_metres(h.spacing[0]).text,
                     ovr_metres(h.spacing[2]).text);
    return ovr_areal_finish(p, source, 1, err);
}
