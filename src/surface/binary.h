/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Little-endian numbers in files, at any address. */
#ifndef OVR_SURFACE_BINARY_H
#define OVR_SURFACE_BINARY_H

#include <stddef.h>

typedef enum ovr_binary {
    OVR_BINARY_U8,
    OVR_BINARY_U16,
    OVR_BINARY_U32,
    OVR_BINARY_F32,
    OVR_BINARY_I8,
    OVR_BINARY_I16,
    OVR_BINARY_I32,
    OVR_BINARY_F64
} ovr_binary; /* in the order of SDF's DataType */

size_t ovr_binary_size(ovr_binary type);
double ovr_binary_value(const char *at, ovr_binary type);

/* Returns NAN for the code of a missing height in SDF: the lowest value of a
 * signed type. The second function reads a height. */
double ovr_missing_as_nan(double value, int type);
double ovr_binary_height(const char *at, ovr_binary type);

#endif
