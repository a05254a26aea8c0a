/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * SDF, ISO 25178-71, as text ("aISO-1.0") and binary ("bISO-1.0"); dialects
 * ISO-1.0, ISO-2.0, BCR-1.0 (EUNA 15178) and NIST-1.0.
 *
 * Binary header, 81 bytes, packed, little-endian: magic 8, ManufacID 10,
 * CreateDate 12, ModDate 12, NumPoints u16, NumProfiles u16, Xscale, Yscale,
 * Zscale, Zresolution f64, Compression, DataType, CheckType i8; then values,
 * x fastest.  ISO-2.0 has both counts as u32, 85 bytes in all.
 * z = value Zscale [m]; missing: BAD, NaN, the smallest integer, the lowest
 * finite floating-point number.
 */
#include <math.h>
#include <string.h>

#include "base/error.h"
#include "base/text.h"
#include "surface/areal.h"
#include "surface/binary.h"
#include "surface/profile.h"

typedef struct sdf {
    double points, profiles, x_scale, y_scale, z_scale, compression, type;
} sdf;

static ovr_status check(const ovr_profile *p, const sdf *h, ovr_error *err)
{
    const struct {
        const char *name, *right;
        double value;
        bool good;
    } checks[] = {
        {"NumPoints", "2 or more", h->points,
         h->points >= 2 && h->points <= OVR_POINTS_MAX},
        {"NumProfiles", "1 or more", h->profiles,
         h->profiles >= 1 && h->profiles <= OVR_POINTS_MAX},
        {"Xscale", "a positive length in m", h->x_scale,
         h->x_scale > 0 && h->x_scale < 1},
        {"Zscale", "a length in m", h->z_scale,
         h->z_scale != 0 && fabs(h->z_scale) <= 1},
        {"Compression", "0 (no other value is supported)", h->compression,
         h->compression == 0},
        {"DataType", "0 to 7", h->type, h->type >= 0 && h->type <= 7}};
    for (size_t k = 0; k < sizeof checks / sizeof checks[0]; k++)
        if (!checks[k].good)
            return ovr_fail_at(err, OVR_BAD_INPUT, p->file, 0,
                               "SDF header: %s = %g must be %s", checks[k].name,
                               checks[k].value, checks[k].right);
    return OVR_OK;
}

/* Without a Yscale (files of a single profile have 0), rows have the spacing of
 * the points along x. */
static ovr_status start(ovr_profile *p, const sdf *h, ovr_error *err)
{
    ovr_status status = check(p, h, err);
    return status ? status
                  : ovr_areal_reserve(
                        p, (size_t)h->points, (size_t)h->profiles, h->x_scale,
                        h->y_scale > 0 ? h->y_scale : h->x_scale, err);
}

static ovr_status finish(ovr_profile *p, const ovr_profile_source *source,
                         const sdf *h, ovr_error *err)
{
    ovr_profile_note(p, "SDF is in metres: spacing %s, heights times %s",
                     ovr_metres(h->x_scale).text, ovr_metres(h->z_scale).text);
    return ovr_areal_finish(p, source, h->z_scale, err);
}

/* ---------------------------------------------------------------- binary */

/* Reads a binary file. `magic` is the length of the dialect's name: 8, for
 * NIST-1.0 9. */
static ovr_status read_binary(ovr_profile *p, const ovr_profile_source *source,
                              ovr_bytes c, size_t magic, ovr_error *err)
{
    static const ovr_binary types[] = {
        OVR_BINARY_U8, OVR_BINARY_U16, OVR_BINARY_U32, OVR_BINARY_F32,
        OVR_BINARY_I8, OVR_BINARY_I16, OVR_BINARY_I32, OVR_BINARY_F64};
    const char *d = c.data;
    const bool wide = memcmp(d, "bISO-2.0", 8) == 0; /* 32-bit counts */
    const size_t header = magic + (wide ? 77 : 73);
    const ovr_binary count = wide ? OVR_BINARY_U32 : OVR_BINARY_U16;
    const char *after = d + header - 35; /* position of the counts */
    sdf h;
    size_t n, bytes;
    ovr_binary type;
    ovr_status status;
    p->view.format = "SDF (binary)";
    if (c.size < header)
        return ovr_fail_at(err, OVR_BAD_INPUT, p->file, 0,
                           "offset %zu: truncated within the SDF header of "
                           "%zu bytes",
                           c.size, header);
    h = (sdf){.points = ovr_binary_value(d + magic + 34, count),
              .profiles = ovr_binary_value(d + magic + (wide ? 38 : 36), count),
              .x_scale = ovr_binary_value(after, OVR_BINARY_F64),
              .y_scale = ovr_binary_value(after + 8, OVR_BINARY_F64),
              .z_scale = ovr_binary_value(after + 16, OVR_BINARY_F64),
              .compression = ovr_binary_value(after + 32, OVR_BINARY_I8),
              .type = ovr_binary_value(after + 33, OVR_BINARY_I8)};
    status = check(p, &h, err);
    if (status)
        return status;
    n = (size_t)h.points;
    type = types[(int)h.type];
    bytes = ovr_binary_size(type);
    if ((c.size - header) / bytes / n < (size_t)h.profiles)
        return ovr_fail_at(err, OVR_BAD_INPUT, p->file, 0,
                           "offset %zu: truncated; the header announces %zu "
                           "x %zu values of %zu bytes",
                           c.size, n, (size_t)h.profiles, bytes);
    status = start(p, &h, err);
    if (status)
        return status;
    for (size_t i = 0; i < n * p->map.ny; i++)
        p->map.z[i] = ovr_binary_height(d + header + i * bytes, type);
    return finish(p, source, &h, err);
}

/* ------------------------------------------------------------------ text */

static ovr_status read_entry(ovr_line line, const char *file, sdf *h,
                             ovr_error *err)
{
    const struct {
        const char *name;
        double *value;
    } known[] = {{"NumPoints", &h->points}, {"NumProfiles", &h->profiles},
                 {"Xscale", &h->x_scale},   {"Yscale", &h->y_scale},
                 {"Zscale", &h->z_scale},   {"Compression", &h->compression},
                 {"DataType", &h->type}};
    const char *sign = line.size ? memchr(line.text, '=', line.size) : NULL;
    ovr_line name, value;
    if (!sign)
        return ovr_fail_at(err, OVR_BAD_INPUT, file, line.number,
                           "'%s' where 'Name = value' or * is needed",
                           ovr_quote(line).text);
    name = ovr_trim((ovr_line){line.text, (size_t)(sign - line.text), 0});
    value = (ovr_line){sign + 1, (size_t)(line.text + line.size - sign - 1), 0};
    value = ovr_trim(value);
    for (size_t k = 0; k < sizeof known / sizeof known[0]; k++)
        if (ovr_line_is(name, known[k].name) &&
            !ovr_number(value, false, known[k].value))
            return ovr_fail_at(err, OVR_BAD_INPUT, file, line.number,
                               "%s = '%s' is not a number", known[k].name,
                               ovr_quote(value).text);
    return OVR_OK;
}

static ovr_status read_entries(ovr_lines *lines, const char *file, sdf *h,
                               ovr_error *err)
{
    ovr_line line;
    while (ovr_next_line(lines, &line)) {
        ovr_line entry = ovr_trim(line);
        if (entry.size && entry.text[0] == '*')
            return OVR_OK;
        if (entry.size && read_entry(entry, file, h, err))
            return OVR_BAD_INPUT;
    }
    return ovr_fail_at(err, OVR_BAD_INPUT, file, lines->number,
                       "truncated: the * after the SDF header is missing");
}

/* Reads heights separated by blanks or line ends. */
static ovr_status read_values(ovr_profile *p, const sdf *h, ovr_lines *lines,
                              ovr_error *err)
{
    size_t n = p->map.nx * p->map.ny, k = 0;
    ovr_line text, word;
    while (k < n && ovr_next_line(lines, &text)) {
        while (k < n && ovr_next_piece(&text, &word)) {
            double value = NAN;
            if (word.text[0] == '*')
                goto short_of_values;
            if (!ovr_number(word, false, &value) && !ovr_is_missing(word))
                return ovr_fail_at(err, OVR_BAD_INPUT, p->file, text.number,
                                   "'%s' must be a height",
                                   ovr_quote(word).text);
            p->map.z[k++] = ovr_missing_as_nan(value, (int)h->type);
        }
    }
    if (k == n)
        return OVR_OK;
short_of_values:
    return ovr_fail_at(err, OVR_BAD_INPUT, p->file, lines->number,
                       "the values end after %zu, but the header announces "
                       "%zu x %zu",
                       k, p->map.nx, p->map.ny);
}

/* True if the text is long enough for the announced counts (two bytes per
 * value), checked before memory is allocated. */
static bool is_long_enough(const ovr_lines *lines, const sdf *h)
{
    return h->points * h->profiles <= (double)(lines->end - lines->at) / 2 + 1;
}

static ovr_status read_ascii(ovr_profile *p, const ovr_profile_source *source,
                             ovr_bytes content, ovr_error *err)
{
    ovr_lines lines = ovr_lines_of(content);
    ovr_line magic;
    sdf h = {NAN, 1, NAN, NAN, NAN, 0, 7};
    ovr_status status;
    p->view.format = "SDF (text)";
    ovr_next_line(&lines, &magic);
    status = read_entries(&lines, p->file, &h, err);
    if (!status)
        status = check(p, &h, err);
    if (!status && !is_long_enough(&lines, &h))
        status = ovr_fail_at(err, OVR_BAD_INPUT, p->file, lines.number,
                             "truncated; the header announces %g x %g values",
                             h.points, h.profiles);
    if (!status)
        status = start(p, &h, err);
    if (!status)
        status = read_values(p, &h, &lines, err);
    return status ? status : finish(p, source, &h, err);
}

ovr_status ovr_read_sdf(ovr_profile *profile, const ovr_profile_source *source,
                        ovr_bytes content, ovr_error *err)
{
    static const char *const dialects[] = {"ISO-1.0", "ISO-2.0", "BCR-1.0",
                                           "NIST-1.0"};
    ovr_line name = {content.data, 0, 0};
    while (name.size < content.size && name.size < 16 &&
           (unsigned char)name.text[name.size] > ' ')
        name.size++;
    for (size_t k = 0; k < sizeof dialects / sizeof *dialects; k++) {
        size_t length = strlen(dialects[k]);
        if (content.size <= length ||
            memcmp(content.data + 1, dialects[k], length) != 0)
            continue;
        /* "aISO-1.05" is another dialect. A binary header follows without a
         * separator. */
        if (content.data[0] == 'b')
            return read_binary(profile, source, content, length + 1, err);
        if (name.size == length + 1)
            return read_ascii(profile, source, content, err);
    }
    return ovr_fail_at(err, OVR_BAD_INPUT, profile->file, 0,
                       "the SDF dialect '%s' is not supported; must be "
                       "ISO-1.0, ISO-2.0, BCR-1.0 or NIST-1.0 (after a or b)",
                       ovr_quote(name).text);
}
