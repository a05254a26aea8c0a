/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "results/hdf5read/pieces.h"

#include <string.h>

#include "base/disk.h"

uint64_t ovr_take(ovr_piece *b, size_t size)
{
    uint64_t value = 0;
    if (size > b->left) {
        b->good = false;
        b->left = 0;
    }
    if (!b->good)
        return 0;
    for (size_t k = size; k-- > 0;)
        value = value << 8 | b->at[k];
    b->at += size;
    b->left -= size;
    return value;
}

ovr_piece ovr_cut(ovr_piece *b, uint64_t size)
{
    ovr_piece piece = {b->at, (size_t)size, b->good && size <= b->left};
    if (!piece.good) {
        b->good = false;
        b->left = piece.left = 0;
        return piece;
    }
    b->at += piece.left;
    b->left -= piece.left;
    return piece;
}

/* A file may name the same bytes any number of times. */
static bool is_enough(const ovr_source *s)
{
    enum { BASE = 64 << 20, TIMES = 8 };
    size_t taken = s->arena->bytes;
    return taken > BASE && (taken - BASE) / TIMES > s->bytes;
}

bool ovr_load(ovr_source *s, uint64_t at, uint64_t size, ovr_piece *out)
{
    unsigned char *data;
    *out = (ovr_piece){NULL, 0, false};
    if (at > s->bytes || size > s->bytes - at || size > SIZE_MAX / 2 ||
        is_enough(s))
        return false;
    data = ovr_arena_take(s->arena, (size_t)size, 1, NULL);
    s->starved = s->starved || !data;
    if (!data || ovr_read_all(s->fd, data, (size_t)size, at) != 0)
        return false;
    *out = (ovr_piece){data, (size_t)size, true};
    return true;
}

/* A block that was read and whose checksum holds: an object's header is asked
 * for as often as it has attributes. */
enum { KEPT_BLOCKS = 64 };
struct ovr_kept_block {
    uint64_t at;
    ovr_piece whole; /* of no bytes: none is kept here */
};

/* The place of a block among those that are kept; NULL: there is no memory.
 * They go with the arena's other pieces. */
static struct ovr_kept_block *place_of(ovr_source *s, uint64_t at)
{
    if (!s->kept || s->kept_since != s->arena->releases) {
        s->kept = ovr_arena_take(s->arena, KEPT_BLOCKS, sizeof *s->kept, NULL);
        s->kept_since = s->arena->releases;
    }
    /* Multiplied by 2^64 over the golden ratio, neighbours are far apart. */
    return s->kept ? &s->kept[at * UINT64_C(0x9e3779b97f4a7c15) >> 58] : NULL;
}

enum { LETTERS = 4, SUM = 4 };

/* A whole block, letters and checksum included. */
static bool load_whole(ovr_source *s, uint64_t at, uint64_t size,
                       ovr_piece *whole)
{
    ovr_piece sum;
    if (size < LETTERS + SUM)
        return false;
    struct ovr_kept_block *place = place_of(s, at);
    if (place && place->at == at && place->whole.left == size) {
        *whole = place->whole;
        return true;
    }
    if (!ovr_load(s, at, size, whole))
        return false;
    sum = (ovr_piece){whole->at + whole->left - SUM, SUM, true};
    if (!ovr_checksum_holds(whole->at, whole->left - SUM, ovr_take(&sum, SUM)))
        return false;
    if (place)
        *place = (struct ovr_kept_block){at, *whole};
    return true;
}

bool ovr_load_block(ovr_source *s, uint64_t at, uint64_t size,
                    const char *letters, ovr_piece *out)
{
    if (!load_whole(s, at, size, out) || memcmp(out->at, letters, LETTERS) != 0)
        return false;
    out->at += LETTERS;
    out->left -= LETTERS + SUM;
    return true;
}

/* --------------------------------------------------------------- checksum */

static uint32_t turn(uint32_t x, int bits)
{
    return x << bits | x >> (32 - bits);
}

static void mix(uint32_t w[3])
{
    static const int bits[] = {4, 6, 8, 16, 19, 4};
    for (int k = 0; k < 6; k++) {
        uint32_t *a = &w[k % 3], *b = &w[(k + 1) % 3], *c = &w[(k + 2) % 3];
        *a = (*a - *c) ^ turn(*c, bits[k]);
        *c += *b;
    }
}

static void finish(uint32_t w[3])
{
    static const int bits[] = {14, 11, 25, 16, 4, 14, 24};
    for (int k = 0; k < 7; k++) {
        uint32_t *to = &w[(k + 2) % 3], from = w[(k + 1) % 3];
        *to = (*to ^ from) - turn(from, bits[k]);
    }
}

static uint32_t word(const unsigned char *at)
{
    return (uint32_t)at[0] | (uint32_t)at[1] << 8 | (uint32_t)at[2] << 16 |
           (uint32_t)at[3] << 24;
}

static uint32_t checksum(const unsigned char *data, size_t size)
{
    uint32_t start = 0xdeadbeef + (uint32_t)size, w[3] = {start, start, start};
    unsigned char last[12] = {0};
    for (; size > sizeof last; size -= sizeof last, data += sizeof last) {
        for (size_t k = 0; k < 3; k++)
            w[k] += word(data + 4 * k);
        mix(w);
    }
    memcpy(last, data, size);
    for (size_t k = 0; k < 3; k++)
        w[k] += word(last + 4 * k);
    finish(w);
    return w[2];
}

bool ovr_checksum_holds(const unsigned char *data, size_t size, uint64_t found)
{
#ifdef FUZZING_BUILD_MODE_UNSAFE_FOR_PRODUCTION
    (void)checksum(data, size);
    (void)found;
    return true;
#else
    return checksum(data, size) == found;
#endif
}
