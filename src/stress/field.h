/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Internal data of the stress field of a snapshot. */
#ifndef OVR_STRESS_FIELD_H
#define OVR_STRESS_FIELD_H

#include "base/arena.h"
#include "stress/fourier.h"
#include "stress/loops.h"
#include "stress/stress.h"

/* Spectra of the elements at one depth, divided by N. */
typedef struct ovr_depth_table {
    ovr_bins h, d, tau;
} ovr_depth_table;

typedef struct ovr_depth {
    double z;
    int level;
    size_t bins;          /* N_c / 2: bins below are used */
    ovr_depth_table p, q; /* tables of pressure and of traction */
    float *shear;         /* d, tau interleaved: N_c each */
    float *mean;          /* h at every second position */
    float *pair;          /* first of a pair of depths: h, and h of the next
                           * depth */
    size_t other;         /* index of the next depth; its own index if there is
                           * none */
} ovr_depth;

struct ovr_stress {
    ovr_arena arena;
    ovr_stress_options options;
    const ovr_stress_loops *loops;
    ovr_fourier fourier;
    double start;    /* X of the first node of the fields */
    double shift;    /* shift in the last solve, in units of D */
    size_t capacity; /* N */
    size_t seam;     /* number of lags that no field needs */
    size_t depths;
    double *z;
    ovr_depth *depth;
    float *p[2], *q[2]; /* spectra of the present loads, real and imaginary
                         * parts */
    size_t loads;       /* number of present loads: p, or both */
    float *fine[2];     /* d, tau and h of one depth at every node; NULL: not
                         * computed */
};

#endif
