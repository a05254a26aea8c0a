/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A snapshot's fields: the insides. */
#ifndef OVR_STRESS_FIELD_H
#define OVR_STRESS_FIELD_H

#include "base/arena.h"
#include "stress/fourier.h"
#include "stress/loops.h"
#include "stress/stress.h"

/* Spectra of one depth's elements, divided by N. */
typedef struct ovr_depth_table {
    ovr_bins h, d, tau;
} ovr_depth_table;

typedef struct ovr_depth {
    double z;
    int level;
    size_t bins;          /* N_c / 2: below them nothing is cut */
    ovr_depth_table p, q; /* of pressure, of traction */
    float *shear;         /* d, tau interleaved: N_c each */
    float *mean;          /* h at every second place */
    float *pair;          /* the first of a pair: h, h of the next depth */
    size_t other;         /* that next depth; itself when there is none */
} ovr_depth;

struct ovr_stress {
    ovr_arena arena;
    ovr_stress_options options;
    const ovr_stress_loops *loops;
    ovr_fourier fourier;
    double start;    /* X of the first node of the fields */
    double shift;    /* of the last solve, D */
    size_t capacity; /* N */
    size_t seam;     /* lags that no field needs */
    size_t depths;
    double *z;
    ovr_depth *depth;
    float *p[2], *q[2]; /* spectra of the moment, re and im */
    size_t loads;       /* of the moment: p, or both */
    float *fine[2];     /* d, tau and h of one depth at every node; NULL yet */
};

#endif
