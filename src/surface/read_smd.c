/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * SMD, the softgauge text of ISO 5436-2: records ended by ETX.
 *
 *     record 1  a revision line, PRF (or SUR) ..., then the axes
 *               CX I N unit scale type increment
 *               CZ A N unit scale type
 *     record 2  free text     record 3  the numbers     record 4  a checksum,
 *                                                       not to be trusted
 *
 * value = number x scale in the axis' unit; NUL is white space.
 */
#include <math.h>
#include <string.h>

#include "base/error.h"
#include "base/quantity.h"
#include "surface/areal.h"

static const char ETX = 3;

typedef struct axis {
    bool given;
    char kind; /* I or A */
    double count, metres, scale, increment;
} axis;

static ovr_status read_axis(const char *file, ovr_line line, axis *a,
                            ovr_error *err)
{
    ovr_line rest = line, word[7];
    size_t words = 0;
    while (words < 7 && ovr_next_piece(&rest, &word[words]))
        words++;
    a->given = true;
    if (words < 6)
        return ovr_fail_at(err, OVR_BAD_INPUT, file, line.number,
                           "an axis must be 'CX I count unit scale type "
                           "[increment]'; this line has %zu words",
                           words);
    a->kind = word[1].text[0];
    a->metres = ovr_length_unit(word[3], true);
    if (!(a->metres > 0))
        return ovr_fail_at(err, OVR_BAD_INPUT, file, line.number,
                           "'%s' is not a unit of length",
                           ovr_quote(word[3]).text);
    if (!ovr_number(word[2], false, &a->count) ||
        !ovr_number(word[4], false, &a->scale) || a->scale == 0)
        return ovr_fail_at(err, OVR_BAD_INPUT, file, line.number,
                           "count and scale of the axis must be numbers");
    a->increment = 1;
    if (words == 7 && !ovr_number(word[6], false, &a->increment))
        return ovr_fail_at(err, OVR_BAD_INPUT, file, line.number,
                           "the increment of the axis must be a number");
    return OVR_OK;
}

typedef struct axes {
    axis x, y, z;
} axes;

static ovr_status read_header(const char *file, ovr_lines *lines, axes *to,
                              ovr_error *err)
{
    ovr_line line;
    ovr_status status = OVR_OK;
    while (!status && ovr_next_line(lines, &line)) {
        line = ovr_trim(line);
        if (ovr_line_starts(line, "CX"))
            status = read_axis(file, line, &to->x, err);
        else if (ovr_line_starts(line, "CY"))
            status = read_axis(file, line, &to->y, err);
        else if (ovr_line_starts(line, "CZ"))
            status = read_axis(file, line, &to->z, err);
    }
    return status;
}

static ovr_status check(const char *file, const axes *of, ovr_error *err)
{
    const axis *x = &of->x, *y = &of->y, *z = &of->z;
    double maximum = OVR_POINTS_MAX, lines = y->given ? y->count : 1;
    if (!x->given || !z->given)
        return ovr_fail_at(err, OVR_BAD_INPUT, file, 0,
                           "SMD header: the axes CX and CZ are needed");
    if (x->kind != 'I' || z->kind != 'A')
        return ovr_fail_at(err, OVR_BAD_INPUT, file, 0,
                           "SMD header: CX must be incremental (I) and CZ "
                           "absolute (A)");
    if (!(x->count >= 2 && x->count <= maximum) ||
        !(lines >= 1 && lines <= maximum))
        return ovr_fail_at(err, OVR_BAD_INPUT, file, 0,
                           "SMD header: %g x %g points must be from 2 to %g",
                           x->count, lines, maximum);
    if (!(x->increment * x->scale > 0))
        return ovr_fail_at(err, OVR_BAD_INPUT, file, 0,
                           "SMD header: the increment of CX must be positive");
    return OVR_OK;
}

/* Returns the k-th record from 0, without its ETX. */
static bool record(ovr_bytes content, int k, ovr_bytes *found, long *line)
{
    const char *p = content.data, *end = p + content.size;
    *line = 0;
    for (;; k--) {
        const char *etx = p < end ? memchr(p, ETX, (size_t)(end - p)) : NULL;
        const char *stop = etx ? etx : end;
        ovr_lines skipped;
        ovr_line each;
        *found = (ovr_bytes){p, (size_t)(stop - p)};
        if (k == 0)
            return p < end;
        if (!etx)
            return false;
        skipped = ovr_lines_of(*found);
        while (ovr_next_line(&skipped, &each))
            ;
        *line += skipped.number;
        p = etx + 1;
    }
}

static ovr_status read_numbers(ovr_profile *p, ovr_lines lines, ovr_error *err)
{
    size_t n = p->map.nx * p->map.ny, k = 0;
    ovr_line line, word;
    while (k < n && ovr_next_line(&lines, &line)) {
        while (k < n && ovr_next_piece(&line, &word)) {
            double value = NAN;
            if (!ovr_number(word, false, &value) && !ovr_is_missing(word))
                return ovr_fail_at(err, OVR_BAD_INPUT, p->file, line.number,
                                   "'%s' must be a height",
                                   ovr_quote(word).text);
            p->map.z[k++] = value;
        }
    }
    if (k == n)
        return OVR_OK;
    return ovr_fail_at(err, OVR_BAD_INPUT, p->file, lines.number,
                       "the heights end after %zu, before %zu", k, n);
}

ovr_status ovr_read_smd(ovr_profile *profile, const ovr_profile_source *source,
                        ovr_bytes content, ovr_error *err)
{
    axes of = {0};
    const axis *x = &of.x, *y = &of.y, *z = &of.z;
    ovr_bytes part;
    ovr_lines header, numbers;
    double dx, dy;
    long before;
    ovr_status status;
    profile->view.format = "SMD";
    record(content, 0, &part, &before);
    header = ovr_lines_of(part);
    status = read_header(profile->file, &header, &of, err);
    if (!status)
        status = check(profile->file, &of, err);
    if (status)
        return status;
    if (!record(content, 2, &part, &before))
        return ovr_fail_at(err, OVR_BAD_INPUT, profile->file, before,
                           "truncated: the third record, the heights, is "
                           "missing");
    numbers = ovr_lines_of(part);
    numbers.number = before;
    dx = x->increment * x->scale * x->metres;
    dy = y->increment * y->scale * y->metres;
    /* A height needs at least two bytes. */
    if (x->count * (y->given ? y->count : 1) > (double)part.size / 2 + 1)
        return ovr_fail_at(err, OVR_BAD_INPUT, profile->file, before,
                           "the file contains fewer than the announced %g x "
                           "%g heights",
                           x->count, y->given ? y->count : 1);
    status = ovr_areal_reserve(profile, (size_t)x->count,
                               y->given ? (size_t)y->count : 1, dx,
                               dy > 0 ? dy : dx, err);
    if (!status)
        status = read_numbers(profile, numbers, err);
    if (status)
        return status;
    ovr_profile_note(profile, "spacing %s, heights times %s",
                     ovr_metres(dx).text,
                     ovr_metres(z->scale * z->metres).text);
    return ovr_areal_finish(profile, source, z->scale * z->metres, err);
}
