/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "pictures/pack_levels.h"

#include <libdeflate.h>
#include <math.h>

ovr_levels ovr_levels_even(double low, double high)
{
    double span = high > low ? high - low : 1;
    return (ovr_levels){low, span / (OVR_PACKED_LEVELS - 1), 0};
}

ovr_levels ovr_levels_bent(double small, double high)
{
    double bend = small > 0 ? small : 1;
    return (ovr_levels){
        0, asinh(fmax(high / bend, 1)) / (OVR_PACKED_LEVELS - 1), bend};
}

uint16_t ovr_level_of(const ovr_levels *l, double value)
{
    double at = l->bend != 0 ? asinh(value / l->bend) / l->step
                             : (value - l->from) / l->step;
    return (uint16_t)(at > 0 ? fmin(at + 0.5, OVR_PACKED_LEVELS - 1) : 0);
}

/* Goes from the end, so that the neighbours are still themselves. */
static void take_differences(uint16_t *level, size_t n, size_t rows)
{
    for (size_t i = n * rows; i-- > 0;) {
        unsigned left = i % n ? level[i - 1] : 0;
        unsigned before = i >= n ? level[i - n] : 0;
        unsigned both = i % n && i >= n ? level[i - n - 1] : 0;
        int d = (int)level[i] - (int)(left + before) + (int)both;
        level[i] = (uint16_t)((unsigned)(d < 0 ? -2 * d - 1 : 2 * d));
    }
}

ovr_status ovr_pack_levels(ovr_text *to, uint16_t *level, size_t n, size_t rows,
                           ovr_arena *arena, ovr_error *err)
{
    enum { LEVEL = 6 };
    size_t count = n * rows;
    struct libdeflate_compressor *deflate = libdeflate_alloc_compressor(LEVEL);
    size_t bound = libdeflate_zlib_compress_bound(deflate, 2 * count);
    unsigned char *planes = ovr_arena_take(arena, 2 * count, 1, err);
    unsigned char *small = ovr_arena_take(arena, bound, 1, err);
    if (!deflate)
        return ovr_fail(err, OVR_NO_MEMORY, "out of memory (compression)");
    if (!planes || !small) {
        libdeflate_free_compressor(deflate);
        return OVR_NO_MEMORY;
    }
    take_differences(level, n, rows);
    for (size_t i = 0; i < count; i++) {
        planes[i] = (unsigned char)(level[i] & 0xff);
        planes[count + i] = (unsigned char)(level[i] >> 8);
    }
    size_t packed = libdeflate_zlib_compress(deflate, planes, 2 * count, small,
                                             bound);
    libdeflate_free_compressor(deflate);
    ovr_text_base64(to, small, packed);
    return ovr_text_status(to, err);
}

void ovr_text_base64(ovr_text *to, const void *data, size_t bytes)
{
    static const char digit[] =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const unsigned char *b = data;
    for (size_t i = 0; i < bytes; i += 3) {
        unsigned three = (unsigned)b[i] << 16 |
                         (i + 1 < bytes ? (unsigned)b[i + 1] << 8 : 0) |
                         (i + 2 < bytes ? (unsigned)b[i + 2] : 0);
        char four[4] = {digit[three >> 18], digit[three >> 12 & 63],
                        i + 1 < bytes ? digit[three >> 6 & 63] : '=',
                        i + 2 < bytes ? digit[three & 63] : '='};
        ovr_text_add(to, four, 4);
    }
}

void ovr_text_doubles(ovr_text *to, const char *key, const double *values,
                      size_t n)
{
    ovr_text_print(to, "\"%s\":\"", key);
    ovr_text_base64(to, values, n * sizeof *values);
    ovr_text_put(to, "\",");
}
