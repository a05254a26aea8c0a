/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * SDF, ISO 25178-71: "aISO-1.0" text and "bISO-1.0" binary.
 *
 * Binary header, 81 bytes, packed, little-endian: magic 8, ManufacID 10,
 * CreateDate 12, ModDate 12, NumPoints u16, NumProfiles u16, Xscale, Yscale,
 * Zscale, Zresolution f64, Compression, DataType, CheckType i8; then values,
 * x fastest.  z = value Zscale [m]; missing: BAD, NaN, the smallest integer.
 */
#include <math.h>
#include <string.h>

#include "base/error.h"
#include "base/text.h"
#include "surface/binary.h"
#include "surface/profile.h"

enum { HEADER = 81 };

typedef struct sdf {
    double points, profiles, x_scale, z_scale, compression, type;
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
         h->z_scale != 0 && fabs(h->z_scale) < 1},
        {"Compression", "0: nothing else is read", h->compression,
         h->compression == 0},
        {"DataType", "0 to 7", h->type, h->type >= 0 && h->type <= 7}};
    for (size_t k = 0; k < sizeof checks / sizeof checks[0]; k++)
        if (!checks[k].good)
            return ovr_fail_at(err, OVR_BAD_INPUT, p->file, 0,
                               "SDF header: %s = %g must be %s", checks[k].name,
                               checks[k].value, checks[k].right);
    return OVR_OK;
}

static ovr_status start(ovr_profile *p, const ovr_profile_source *source,
                        const sdf *h, size_t *line, ovr_error *err)
{
    ovr_status status = check(p, h, err);
    if (!status)
        status = ovr_profile_choose_line(p, source, (size_t)h->profiles, line,
                                         err);
    if (!status)
        status = ovr_profile_reserve(p, (size_t)h->points, err);
    if (!status)
        ovr_profile_regular(p, (size_t)h->points, 0, h->x_scale);
    return status;
}

static ovr_status finish(ovr_profile *p, const sdf *h, ovr_error *err)
{
    size_t n = (size_t)h->points;
    for (size_t i = 0; i < n; i++)
        p->z[i] *= h->z_scale;
    ovr_profile_note(p, "SDF is in metres: spacing %s, heights times %s",
                     ovr_metres(h->x_scale).text, ovr_metres(h->z_scale).text);
    return ovr_profile_finish(p, n, err);
}

/* ---------------------------------------------------------------- binary */

static ovr_status read_binary(ovr_profile *p, const ovr_profile_source *source,
                              ovr_bytes c, ovr_error *err)
{
    static const ovr_binary types[] = {
        OVR_BINARY_U8, OVR_BINARY_U16, OVR_BINARY_U32, OVR_BINARY_F32,
        OVR_BINARY_I8, OVR_BINARY_I16, OVR_BINARY_I32, OVR_BINARY_F64};
    const char *d = c.data;
    sdf h;
    size_t line = 0, n, bytes;
    ovr_binary type;
    ovr_status status;
    p->view.format = "SDF (binary)";
    if (c.size < HEADER)
        return ovr_fail_at(err, OVR_BAD_INPUT, p->file, 0,
                           "offset %zu: cut off within the SDF header of %d "
                           "bytes",
                           c.size, HEADER);
    h = (sdf){ovr_binary_value(d + 42, OVR_BINARY_U16),
              ovr_binary_value(d + 44, OVR_BINARY_U16),
              ovr_binary_value(d + 46, OVR_BINARY_F64),
              ovr_binary_value(d + 62, OVR_BINARY_F64),
              ovr_binary_value(d + 78, OVR_BINARY_I8),
              ovr_binary_value(d + 79, OVR_BINARY_I8)};
    status = start(p, source, &h, &line, err);
    if (status)
        return status;
    n = (size_t)h.points;
    type = types[(int)h.type];
    bytes = ovr_binary_size(type);
    if ((c.size - HEADER) / bytes / n < (size_t)h.profiles)
        return ovr_fail_at(err, OVR_BAD_INPUT, p->file, 0,
                           "offset %zu: cut off: %zu x %zu values of %zu bytes "
                           "are announced",
                           c.size, n, (size_t)h.profiles, bytes);
    for (size_t i = 0; i < n; i++)
        p->z[i] = ovr_binary_height(d + HEADER + (line * n + i) * bytes, type);
    return finish(p, &h, err);
}

/* ------------------------------------------------------------------ text */

static ovr_status read_entry(ovr_line line, const char *file, sdf *h,
                             ovr_error *err)
{
    const struct {
        const char *name;
        double *value;
    } known[] = {
        {"NumPoints", &h->points},        {"NumProfiles", &h->profiles},
        {"Xscale", &h->x_scale},          {"Zscale", &h->z_scale},
        {"Compression", &h->compression}, {"DataType", &h->type}};
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
                       "cut off: the * behind the SDF header is missing");
}

/* Heights of the chosen line out of all values, in words of any layout. */
static ovr_status read_values(ovr_profile *p, const sdf *h, ovr_lines *lines,
                              size_t line, ovr_error *err)
{
    size_t n = (size_t)h->points, first = line * n, k = 0;
    ovr_line text, word;
    while (k < first + n && ovr_next_line(lines, &text)) {
        while (k < first + n && ovr_next_piece(&text, &word)) {
            double value = NAN;
            if (word.text[0] == '*')
                goto short_of_values;
            if (!ovr_number(word, false, &value) && !ovr_is_missing(word))
                return ovr_fail_at(err, OVR_BAD_INPUT, p->file, text.number,
                                   "'%s' where a height is needed",
                                   ovr_quote(word).text);
            if (k >= first)
                p->z[k - first] = ovr_missing_as_nan(value, (int)h->type);
            k++;
        }
    }
    if (k == first + n)
        return OVR_OK;
short_of_values:
    return ovr_fail_at(err, OVR_BAD_INPUT, p->file, lines->number,
                       "the values end after %zu; %zu x %g are announced", k, n,
                       h->profiles);
}

static ovr_status read_ascii(ovr_profile *p, const ovr_profile_source *source,
                             ovr_bytes content, ovr_error *err)
{
    ovr_lines lines = ovr_lines_of(content);
    ovr_line magic;
    sdf h = {NAN, 1, NAN, NAN, 0, 7};
    size_t line = 0;
    ovr_status status;
    p->view.format = "SDF (text)";
    ovr_next_line(&lines, &magic);
    status = read_entries(&lines, p->file, &h, err);
    if (!status)
        status = start(p, source, &h, &line, err);
    if (!status)
        status = read_values(p, &h, &lines, line, err);
    return status ? status : finish(p, &h, err);
}

ovr_status ovr_read_sdf(ovr_profile *profile, const ovr_profile_source *source,
                        ovr_bytes content, ovr_error *err)
{
    return content.data[0] == 'b' ? read_binary(profile, source, content, err)
                                  : read_ascii(profile, source, content, err);
}
