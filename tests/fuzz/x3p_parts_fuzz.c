/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * X3P from the inside: a ZIP's checksums keep libFuzzer out, so the ZIP is
 * made here from main.xml, a NUL, the points, a NUL and the mask.
 */
#include <zip.h>

#include "fuzz/profile.h"

static int add(zip_t *zip, const char *name, const uint8_t *data, size_t size)
{
    zip_source_t *part = zip_source_buffer(zip, data, size, 0);
    return part && zip_file_add(zip, name, part, 0) >= 0;
}

/* The part up to the next NUL, taken off. */
static size_t part(const uint8_t *data, size_t size)
{
    const uint8_t *nul = size ? memchr(data, 0, size) : NULL;
    return nul ? (size_t)(nul - data) : size;
}

/* The bytes of a package of the three parts; *size its length. */
static uint8_t *pack(const uint8_t *data, size_t given, size_t *size)
{
    zip_source_t *out = zip_source_buffer_create(NULL, 0, 0, NULL);
    zip_t *zip = zip_open_from_source(out, ZIP_TRUNCATE, NULL);
    size_t xml = part(data, given), rest = xml < given ? given - xml - 1 : 0;
    const uint8_t *points = data + given - rest;
    zip_stat_t about;
    uint8_t *bytes;
    zip_source_keep(out);
    fuzz_fail_unless(add(zip, "main.xml", data, xml) &&
                     add(zip, "bindata/data.bin", points, rest) &&
                     add(zip, "bindata/valid.bin", points, rest));
    fuzz_fail_unless(zip_close(zip) == 0);
    zip_source_stat(out, &about);
    bytes = malloc(about.size);
    zip_source_open(out);
    zip_source_read(out, bytes, about.size);
    zip_source_close(out);
    zip_source_free(out);
    *size = about.size;
    return bytes;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    size_t packed;
    uint8_t *bytes = pack(data, size, &packed);
    fuzz_reader(ovr_read_x3p, bytes, packed);
    free(bytes);
    return 0;
}
