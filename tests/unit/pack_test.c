/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "support/test.h"

#include <math.h>
#include <string.h>
#include <zlib.h>

#include "base/pack.h"

enum { MOST = 40000 };

/* As HDF5 reads a chunk: zlib inflates it, and the elements are gathered from
 * the planes. */
static void assert_unpacks(const ovr_packer *p, size_t packed,
                           const void *values, size_t count, size_t size,
                           ovr_arena *arena)
{
    unsigned char *planes = ovr_arena_take(arena, count, size, NULL);
    const unsigned char *from = values;
    uLongf bytes = (uLongf)(count * size);
    assert_int_equal(uncompress(planes, &bytes, p->packed, (uLong)packed),
                     Z_OK);
    assert_int_equal(bytes, count * size);
    for (size_t i = 0; i < count; i++)
        for (size_t b = 0; b < size; b++)
            assert_int_equal(planes[b * count + i], from[i * size + b]);
}

static ovr_packer packer_for(size_t bytes, ovr_arena *arena)
{
    ovr_packer p;
    assert_int_equal(ovr_packer_prepare(&p, bytes, 1, arena, NULL), OVR_OK);
    return p;
}

/* Smooth numbers, the low bytes of which are noise, in chunks with and without
 * more than the 65,535 bytes that a stored block holds. */
TEST(zlib_reads_what_is_packed)
{
    static const size_t counts[] = {1, 2, 127, 128, 129, 4097, 13107, MOST};
    ovr_arena arena = ovr_arena_make(NULL);
    double *x = ovr_arena_take(&arena, MOST, sizeof *x, NULL);
    float *y = ovr_arena_take(&arena, MOST, sizeof *y, NULL);
    ovr_packer p = packer_for(MOST * sizeof *x, &arena);
    for (size_t i = 0; i < MOST; i++) {
        x[i] = 1e9 * exp(-pow((double)i / MOST - 0.4, 2));
        y[i] = (float)(x[i] * sin((double)i));
    }
    for (size_t k = 0; k < sizeof counts / sizeof *counts; k++) {
        size_t n = counts[k], packed = ovr_pack(&p, x, n, sizeof *x);
        assert_true(n < 128 || packed > 0);
        if (packed)
            assert_unpacks(&p, packed, x, n, sizeof *x, &arena);
        packed = ovr_pack(&p, y, n, sizeof *y);
        if (packed)
            assert_unpacks(&p, packed, y, n, sizeof *y, &arena);
    }
    ovr_packer_release(&p);
    ovr_arena_release(&arena);
}

/* Half of the planes are zero: half the size, and at most a percent larger than
 * libdeflate alone makes it at this level. */
TEST(noise_is_stored_and_the_rest_deflated)
{
    ovr_arena arena = ovr_arena_make(NULL);
    uint64_t *x = ovr_arena_take(&arena, MOST, sizeof *x, NULL), seed = 3;
    ovr_packer p = packer_for(MOST * sizeof *x, &arena);
    for (size_t i = 0; i < MOST; i++)
        x[i] = (uint64_t)test_random(&seed, 0, 4294967296.0);
    size_t packed = ovr_pack(&p, x, MOST, sizeof *x);
    size_t alone = libdeflate_zlib_compress(
        p.deflate, p.shuffled, MOST * sizeof *x, p.packed, MOST * sizeof *x);
    assert_in_range(packed, 4 * MOST, 4 * MOST + 4 * MOST / 100);
    assert_in_range(packed, 1, alone + alone / 100);
    ovr_packer_release(&p);
    ovr_arena_release(&arena);
}

/* Noise alone cannot be packed, and is not written past its memory. */
TEST(noise_alone_is_not_packed)
{
    ovr_arena arena = ovr_arena_make(NULL);
    unsigned char *x = ovr_arena_take(&arena, 8, MOST, NULL);
    uint64_t seed = 5;
    ovr_packer p = packer_for(8 * MOST, &arena);
    for (size_t i = 0; i < 8 * MOST; i++)
        x[i] = (unsigned char)test_random(&seed, 0, 256);
    for (size_t n = 1; n < 300; n++)
        assert_in_range(ovr_pack(&p, x, n, 8), 0, 8 * n - 1);
    assert_int_equal(ovr_pack(&p, x, MOST, 8), 0);
    ovr_packer_release(&p);
    ovr_arena_release(&arena);
}
