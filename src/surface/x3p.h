/* SPDX-License-Identifier: GPL-3.0-or-later */
/* main.xml of an X3P file, as far as a profile needs it. */
#ifndef OVR_SURFACE_X3P_H
#define OVR_SURFACE_X3P_H

#include "surface/profile.h"

typedef struct ovr_x3p_axis {
    bool given;
    char kind; /* I: index x increment, A: stored */
    char type; /* I int16, L int32, F f32, D f64 */
    double increment, offset;
} ovr_x3p_axis;

typedef struct ovr_x3p {
    char feature[8]; /* PRF, SUR, ... */
    ovr_x3p_axis axis[3];
    double size[3]; /* MatrixDimension; 0: not given */
    double list;    /* ListDimension; 0: not given */
    char data[256]; /* name of the binary file; "": inline */
    char valid[256];
    char *datum; /* inline: all <Datum> texts, each NUL-ended */
    size_t datum_size, datums;
} ovr_x3p;

/* Parses main.xml; inline data go into the arena. */
ovr_status ovr_x3p_parse(ovr_bytes xml, const char *file, ovr_arena *arena,
                         ovr_x3p *x3p, ovr_error *err);

#endif
