/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Fuzz target: contents of X3P files. libFuzzer cannot produce the checksums of
 * a ZIP archive. Therefore the archive is created here from main.xml, a NUL,
 * the points, a NUL and the mask. */
#include "fuzz/profile.h"

#include "surface/zip.h"

/* The part up to the next NUL, taken off. */
static size_t part(const uint8_t *data, size_t size)
{
    const uint8_t *nul = size ? memchr(data, 0, size) : NULL;
    return nul ? (size_t)(nul - data) : size;
}

/* The bytes of a package of the three parts; *size its length. */
static char *pack(const uint8_t *data, size_t given, size_t *size)
{
    size_t xml = part(data, given), rest = xml < given ? given - xml - 1 : 0;
    const uint8_t *points = data + given - rest;
    const ovr_zip_file files[] = {{"main.xml", data, xml},
                                  {"bindata/data.bin", points, rest},
                                  {"bindata/valid.bin", points, rest}};
    ovr_arena arena = ovr_arena_make(NULL);
    char *bytes = NULL;
    FILE *to = open_memstream(&bytes, size);
    fuzz_fail_unless(to && ovr_zip_write(to, files, 3, false, &arena));
    fuzz_fail_unless(fclose(to) == 0);
    ovr_arena_release(&arena);
    return bytes;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    size_t packed;
    char *bytes = pack(data, size, &packed);
    fuzz_reader(ovr_read_x3p, (uint8_t *)bytes, packed);
    free(bytes);
    return 0;
}
