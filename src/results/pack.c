/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "results/pack.h"

#include <limits.h>

static voidpf take(voidpf arena, uInt items, uInt size)
{
    return ovr_arena_take(arena, items, size, NULL);
}

/* The arena frees everything at once. */
static void keep(voidpf arena, voidpf memory)
{
    (void)arena;
    (void)memory;
}

ovr_status ovr_packer_prepare(ovr_packer *packer, size_t bytes, int level,
                              ovr_arena *arena, ovr_error *err)
{
    packer->ready = false;
    packer->bytes = bytes;
    if (level <= 0)
        return OVR_OK;
    if (bytes > UINT_MAX)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "a snapshot of %zu bytes is too "
                        "large for one chunk",
                        bytes);
    packer->shuffled = ovr_arena_take(arena, bytes, 1, err);
    packer->packed = ovr_arena_take(arena, bytes, 1, err);
    packer->stream.zalloc = take;
    packer->stream.zfree = keep;
    packer->stream.opaque = arena;
    if (!packer->shuffled || !packer->packed ||
        deflateInit(&packer->stream, level) != Z_OK)
        return ovr_fail(err, OVR_NO_MEMORY,
                        "out of memory: compression of %zu bytes", bytes);
    packer->ready = true;
    return OVR_OK;
}

/* Byte b of element i to place b * count + i: bytes of like weight together. */
static void shuffle(unsigned char *to, const unsigned char *from, size_t count,
                    size_t size)
{
    for (size_t b = 0; b < size; b++)
        for (size_t i = 0; i < count; i++)
            to[b * count + i] = from[i * size + b];
}

size_t ovr_pack(ovr_packer *packer, const void *values, size_t count,
                size_t size)
{
    z_stream *stream = &packer->stream;
    size_t bytes = count * size;
    if (!packer->ready || bytes < 2 || bytes > packer->bytes)
        return 0;
    shuffle(packer->shuffled, values, count, size);
    deflateReset(stream);
    stream->next_in = packer->shuffled;
    stream->avail_in = (uInt)bytes;
    stream->next_out = packer->packed;
    stream->avail_out = (uInt)bytes - 1;
    return deflate(stream, Z_FINISH) == Z_STREAM_END ? stream->total_out : 0;
}

void ovr_packer_release(ovr_packer *packer)
{
    if (packer->ready)
        deflateEnd(&packer->stream);
    packer->ready = false;
}
