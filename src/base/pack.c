/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Compression of a chunk of numbers: shuffle, then deflate.
 *
 * The low bytes of the mantissas are noise, in which deflate finds nothing but
 * spends most of its time.  Their planes come first, because numbers are
 * little-endian.  They are copied into stored blocks, and the other planes are
 * deflated into the last block of the same stream.
 *
 * Source: RFC 1950 and RFC 1951, section 3.2.4 (stored blocks).
 */
#include "base/pack.h"

#include <limits.h>
#include <string.h>

ovr_status ovr_packer_prepare(ovr_packer *packer, size_t bytes, int level,
                              ovr_arena *arena, ovr_error *err)
{
    packer->deflate = NULL;
    packer->bytes = bytes;
    if (level <= 0)
        return OVR_OK;
    if (bytes > UINT_MAX)
        return ovr_fail(
            err, OVR_BAD_INPUT,
            "a snapshot of %zu bytes is too large for one chunk of the file; "
            "set output.window or output.stride to store fewer nodes",
            bytes);
    packer->shuffled = ovr_arena_take(arena, bytes, 1, err);
    packer->packed = ovr_arena_take(arena, bytes, 1, err);
    if (packer->shuffled && packer->packed)
        packer->deflate = libdeflate_alloc_compressor(level);
    if (!packer->deflate)
        return ovr_fail(err, OVR_NO_MEMORY,
                        "out of memory: compression of %zu bytes", bytes);
    return OVR_OK;
}

/* Copies byte b of element i to position b * count + i, so that bytes of equal
 * significance are contiguous. */
static void shuffle(unsigned char *to, const unsigned char *from, size_t count,
                    size_t size)
{
    for (size_t b = 0; b < size; b++)
        for (size_t i = 0; i < count; i++)
            to[b * count + i] = from[i * size + b];
}

/* True if the bytes are equally frequent, except for one value in at most an
 * eighth of them (zero pressure, for example).  Without it the sum of the
 * squared frequencies is within a tenth of its mean for random bytes,
 * count^2 / 256 + count. */
static bool is_noise(const unsigned char *plane, size_t count)
{
    enum { BYTES = 256, FEW = 128 };
    size_t seen[BYTES] = {0}, most = 0, others;
    double squares = 0, random;
    for (size_t i = 0; i < count; i++)
        seen[plane[i]]++;
    for (size_t k = 0; k < BYTES; k++) {
        squares += (double)(seen[k] * seen[k]);
        most = seen[k] > most ? seen[k] : most;
    }
    others = count - most;
    squares -= (double)(most * most);
    random = (double)others * ((double)others / BYTES + 1);
    return count >= FEW && most <= count / 8 && squares < 1.1 * random;
}

/* Writes bytes as stored blocks, which are not the last.  Returns their end. */
static unsigned char *store(unsigned char *to, const unsigned char *from,
                            size_t bytes)
{
    enum { MOST = 65535 };
    while (bytes > 0) {
        size_t n = bytes < MOST ? bytes : MOST;
        *to++ = 0;
        *to++ = (unsigned char)(n & 255);
        *to++ = (unsigned char)(n >> 8);
        *to++ = (unsigned char)(~n & 255);
        *to++ = (unsigned char)(~n >> 8 & 255);
        memcpy(to, from, n);
        to += n;
        from += n;
        bytes -= n;
    }
    return to;
}

enum { ZLIB_HEAD = 2, ZLIB_TAIL = 4, BLOCK_HEAD = 5 };

/* Packs `bytes` of `shuffled`, of which the first `stored` cannot be
 * compressed. */
static size_t pack_rest(ovr_packer *packer, size_t bytes, size_t stored)
{
    unsigned char *to = packer->packed;
    size_t blocks = stored / 65535 + 1, rest;
    size_t used = ZLIB_HEAD + stored + blocks * BLOCK_HEAD;
    if (used + ZLIB_TAIL + 1 >= bytes)
        return 0;
    *to++ = 0x78;
    *to++ = 0x01;
    to = store(to, packer->shuffled, stored);
    used = (size_t)(to - packer->packed);
    rest = libdeflate_deflate_compress(
        packer->deflate, packer->shuffled + stored, bytes - stored, to,
        bytes - 1 - used - ZLIB_TAIL);
    if (rest == 0)
        return 0;
    to += rest;
    uint32_t sum = libdeflate_adler32(1, packer->shuffled, bytes);
    for (int shift = 24; shift >= 0; shift -= 8)
        *to++ = (unsigned char)(sum >> shift & 255);
    return (size_t)(to - packer->packed);
}

size_t ovr_pack(ovr_packer *packer, const void *values, size_t count,
                size_t size)
{
    size_t bytes = count * size, noise = 0;
    if (!packer->deflate || bytes < 2 || bytes > packer->bytes)
        return 0;
    shuffle(packer->shuffled, values, count, size);
    while (noise < size && is_noise(packer->shuffled + noise * count, count))
        noise++;
    if (noise)
        return pack_rest(packer, bytes, noise * count);
    return libdeflate_zlib_compress(packer->deflate, packer->shuffled, bytes,
                                    packer->packed, bytes - 1);
}

void ovr_packer_release(ovr_packer *packer)
{
    if (packer->deflate) /* older versions do not accept NULL */
        libdeflate_free_compressor(packer->deflate);
    packer->deflate = NULL;
}

/* Inflates a chunk to exactly `bytes` bytes. */
static bool inflate_all(const unsigned char *chunk, size_t bytes,
                        unsigned char *to, size_t target, bool *starved)
{
    struct libdeflate_decompressor *inflate = libdeflate_alloc_decompressor();
    if (!inflate) {
        *starved = true;
        return false;
    }
    bool whole = libdeflate_zlib_decompress(inflate, chunk, bytes, to, target,
                                            NULL) == LIBDEFLATE_SUCCESS;
    libdeflate_free_decompressor(inflate);
    return whole;
}

static void unshuffle(unsigned char *to, const unsigned char *from,
                      size_t count, size_t size)
{
    for (size_t b = 0; b < size; b++)
        for (size_t i = 0; i < count; i++)
            to[i * size + b] = from[b * count + i];
}

unsigned char *ovr_unpack(const unsigned char *chunk, size_t bytes,
                          unsigned left_out, size_t count, size_t size,
                          ovr_arena *arena, bool *starved)
{
    size_t target = count * size;
    unsigned char *packed = ovr_arena_take(arena, target, 1, NULL);
    unsigned char *values = ovr_arena_take(arena, target, 1, NULL);
    bool capacity = packed && values;
    *starved = *starved || !capacity;
    if (!capacity)
        return NULL;
    if (left_out & 2 && bytes == target)
        memcpy(packed, chunk, target);
    else if (left_out & 2 ||
             !inflate_all(chunk, bytes, packed, target, starved))
        return NULL;
    if (left_out & 1)
        return packed;
    unshuffle(values, packed, count, size);
    return values;
}
