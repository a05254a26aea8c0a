/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "surface/binary.h"

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

size_t ovr_binary_size(ovr_binary type)
{
    static const size_t sizes[] = {1, 2, 4, 4, 1, 2, 4, 8};
    return sizes[type];
}

static uint64_t bits(const char *at, size_t bytes)
{
    const unsigned char *p = (const unsigned char *)at;
    uint64_t value = 0;
    for (size_t k = bytes; k--;)
        value = value << 8 | p[k];
    return value;
}

/* Converts a two's-complement number of `width` bits. */
static double as_signed(uint64_t pattern, int width)
{
    double value = (double)pattern, all = ldexp(1, width);
    return value < all / 2 ? value : value - all;
}

double ovr_binary_value(const char *at, ovr_binary type)
{
    uint64_t pattern = bits(at, ovr_binary_size(type));
    float single;
    double value;
    switch (type) {
    case OVR_BINARY_F32:
        memcpy(&single, &(uint32_t){(uint32_t)pattern}, sizeof single);
        return (double)single;
    case OVR_BINARY_F64: memcpy(&value, &pattern, sizeof value); return value;
    case OVR_BINARY_I8: return as_signed(pattern, 8);
    case OVR_BINARY_I16: return as_signed(pattern, 16);
    case OVR_BINARY_I32: return as_signed(pattern, 32);
    default: return (double)pattern;
    }
}

double ovr_missing_as_nan(double value, int type)
{
    double code = type == OVR_BINARY_I8    ? -128.0
                  : type == OVR_BINARY_I16 ? -32768.0
                  : type == OVR_BINARY_I32 ? -2147483648.0
                  : type == OVR_BINARY_F32 ? -(double)FLT_MAX
                  : type == OVR_BINARY_F64 ? -DBL_MAX
                                           : NAN;
    return value == code ? NAN : value;
}

double ovr_binary_height(const char *at, ovr_binary type)
{
    return ovr_missing_as_nan(ovr_binary_value(at, type), (int)type);
}
