/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Writes profiles as text, SDF (bISO-1.0, heights as f64) and X3P
 * (ISO 25178-72: main.xml, bindata/data.bin and their MD5 sums).
 */
#include <errno.h>
#include <float.h>
#include <math.h>
#include <nettle/md5.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "base/error.h"
#include "base/given.h"
#include "base/text.h"
#include "surface/profile.h"
#include "surface/zip.h"

static ovr_status fail_written(ovr_error *err, const char *path)
{
    return ovr_fail_at(err, OVR_IO, path, 0, "writing failed: %s",
                       strerror(errno));
}

static ovr_status fail_opened(ovr_error *err, const char *path)
{
    return ovr_fail_at(err, OVR_BAD_INPUT, path, 0, "cannot be written: %s",
                       strerror(errno));
}

/* -------------------------------------------------------------------- text */

static int write_points(const ovr_profile_view *view, FILE *out)
{
    int bad = fprintf(out, "# x in %s, z in %s\n", view->scaled_x ? "b" : "m",
                      view->scaled_z ? "b^2/R" : "m") < 0;
    for (size_t i = 0; i < view->n && !bad; i++)
        bad = isnan(view->z[i])
                  ? fprintf(out, "%.17g, NaN\n", view->x[i]) < 0
                  : fprintf(out, "%.17g, %.17g\n", view->x[i], view->z[i]) < 0;
    return bad;
}

static ovr_status save_text(const ovr_profile *profile, const char *path,
                            ovr_error *err)
{
    FILE *out = fopen(path, "w");
    locale_t before;
    int bad;
    if (!out)
        return fail_opened(err, path);
    before = ovr_plain_begin();
    bad = write_points(&profile->view, out);
    ovr_plain_end(before);
    return fclose(out) || bad ? fail_written(err, path) : OVR_OK;
}

/* ---------------------------------------------------------- little-endian */

static char *write_integer(char *at, uint64_t value, size_t bytes)
{
    for (size_t k = 0; k < bytes; k++)
        *at++ = (char)(value >> 8 * k & 255);
    return at;
}

static char *write_number(char *at, double value)
{
    uint64_t pattern;
    memcpy(&pattern, &value, sizeof pattern);
    return write_integer(at, pattern, sizeof pattern);
}

/* Returns the mean distance between points. */
static double spacing_of(const ovr_profile_view *v)
{
    return (v->x[v->n - 1] - v->x[0]) / (double)(v->n - 1);
}

/* --------------------------------------------------------------------- SDF */

static ovr_status save_sdf(const ovr_profile *profile, const char *path,
                           ovr_arena *arena, ovr_error *err)
{
    enum { HEADER = 81 };
    const ovr_profile_view *v = &profile->view;
    size_t size = HEADER + 8 * v->n;
    char *data, *at;
    FILE *out;
    bool written;
    if (!v->uniform)
        return ovr_fail_at(err, OVR_BAD_INPUT, path, 0,
                           "SDF supports only equidistant points; write X3P "
                           "or CSV");
    if (v->n > UINT16_MAX)
        return ovr_fail_at(err, OVR_BAD_INPUT, path, 0,
                           "SDF supports at most %d points, but there are "
                           "%zu; write X3P or CSV",
                           UINT16_MAX, v->n);
    data = ovr_arena_take(arena, size, 1, err);
    if (!data)
        return OVR_NO_MEMORY;
    /* Unknown dates are written as zeros. */
    memcpy(data, "bISO-1.0overroll  000000000000000000000000", 42);
    at = write_integer(data + 42, v->n, 2);
    at = write_integer(at, 1, 2);
    at = write_number(at, spacing_of(v));
    at = write_number(at, spacing_of(v));
    at = write_number(at, 1);  /* Zscale */
    at = write_number(at, -1); /* Zresolution: unknown */
    at = write_integer(at, 0, 1);
    at = write_integer(at, 7, 1); /* f64 */
    at = write_integer(at, 0, 1);
    for (size_t i = 0; i < v->n; i++)
        at = write_number(at, isnan(v->z[i]) ? -DBL_MAX : v->z[i]);
    out = fopen(path, "wb");
    if (!out)
        return fail_opened(err, path);
    written = fwrite(data, 1, size, out) == size;
    return fclose(out) || !written ? fail_written(err, path) : OVR_OK;
}

/* --------------------------------------------------------------------- X3P */

typedef struct digest {
    char text[2 * MD5_DIGEST_SIZE + 1];
} digest;

static digest md5(const void *data, size_t size)
{
    struct md5_ctx context;
    uint8_t sum[MD5_DIGEST_SIZE];
    digest d = {{0}};
    md5_init(&context);
    md5_update(&context, size, data);
    md5_digest(&context, sizeof sum, sum);
    for (size_t k = 0; k < sizeof sum; k++)
        snprintf(d.text + 2 * k, 3, "%02X", sum[k]);
    return d;
}

static int make_xml(const ovr_profile_view *v, const char *sum, char *xml,
                    size_t size)
{
    char increment[120] = "";
    locale_t before = ovr_plain_begin();
    int length;
    if (v->uniform)
        snprintf(increment, sizeof increment,
                 "<Increment>%.17g</Increment><Offset>%.17g</Offset>",
                 spacing_of(v), v->x[0]);
    length = snprintf(
        xml, size,
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<p:ISO5436_2 xmlns:p=\"http://www.opengps.eu/2008/ISO5436_2\">\n"
        "<Record1><Revision>ISO5436 - 2000</Revision>"
        "<FeatureType>PRF</FeatureType>\n<Axes>"
        "<CX><AxisType>%c</AxisType><DataType>D</DataType>%s</CX>\n"
        "<CY><AxisType>I</AxisType><DataType>D</DataType>"
        "<Increment>1</Increment><Offset>0</Offset></CY>\n"
        "<CZ><AxisType>A</AxisType><DataType>D</DataType></CZ>"
        "</Axes></Record1>\n"
        "<Record3><MatrixDimension><SizeX>%zu</SizeX><SizeY>1</SizeY>"
        "<SizeZ>1</SizeZ></MatrixDimension>\n"
        "<DataLink><PointDataLink>bindata/data.bin</PointDataLink>"
        "<MD5ChecksumPointData>%s</MD5ChecksumPointData></DataLink></Record3>\n"
        "<Record4><ChecksumFile>md5checksum.hex</ChecksumFile></Record4>\n"
        "</p:ISO5436_2>\n",
        v->uniform ? 'I' : 'A', increment, v->n, sum);
    ovr_plain_end(before);
    return length;
}

static ovr_status save_x3p(const ovr_profile *profile, const char *path,
                           ovr_arena *arena, ovr_error *err)
{
    const ovr_profile_view *v = &profile->view;
    size_t size = (v->uniform ? 8 : 16) * v->n;
    char *data = ovr_arena_take(arena, size, 1, err), *at = data;
    char xml[2000], sums[100];
    bool written;
    int length;
    FILE *out;
    if (!data)
        return OVR_NO_MEMORY;
    for (size_t i = 0; i < v->n; i++) {
        if (!v->uniform)
            at = write_number(at, v->x[i]);
        at = write_number(at, v->z[i]); /* NaN denotes a missing height */
    }
    length = make_xml(v, md5(data, size).text, xml, sizeof xml);
    snprintf(sums, sizeof sums, "%s *main.xml\n",
             md5(xml, (size_t)length).text);
    const ovr_zip_file files[] = {{"main.xml", xml, (size_t)length},
                                  {"bindata/data.bin", data, size},
                                  {"md5checksum.hex", sums, strlen(sums)}};
    out = fopen(path, "wb");
    if (!out)
        return fail_opened(err, path);
    written = ovr_zip_write(out, files, sizeof files / sizeof *files, false,
                            arena);
    return fclose(out) || !written ? fail_written(err, path) : OVR_OK;
}

static bool ends_in(const char *path, const char *ending)
{
    size_t length = strlen(path), end = strlen(ending);
    return length >= end && !strcasecmp(path + length - end, ending);
}

ovr_status ovr_profile_save(const ovr_profile *profile, const char *path,
                            ovr_error *err)
{
    ovr_arena arena = ovr_arena_make(NULL);
    ovr_status status;
    if (!profile || !path)
        return ovr_fail_null(err, __func__);
    bool x3p = ends_in(path, ".x3p"), sdf = ends_in(path, ".sdf");
    if ((x3p || sdf) && (profile->view.scaled_x || profile->view.scaled_z))
        return ovr_fail_at(err, OVR_BAD_INPUT, path, 0,
                           "%s is in metres, but the profile is in b and "
                           "b^2/R; write CSV",
                           x3p ? "X3P" : "SDF");
    status = x3p   ? save_x3p(profile, path, &arena, err)
             : sdf ? save_sdf(profile, path, &arena, err)
                   : save_text(profile, path, err);
    ovr_arena_release(&arena);
    return status;
}
