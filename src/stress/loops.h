/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The loops that take the time, of snapshots, material histories and their
 * circles: once for each instruction set (loops.kernel.c) and once as they read
 * (loops.plain.c). */
#ifndef OVR_STRESS_LOOPS_H
#define OVR_STRESS_LOOPS_H

#include <stdbool.h>
#include <stddef.h>

/* Real and imaginary parts of a spectrum, bins 0 ... */
typedef struct ovr_bins {
    const float *re, *im;
} ovr_bins;

/* A load's spectrum and the two tables that it meets. */
typedef struct ovr_load_bins {
    ovr_bins P, A, B;
} ovr_load_bins;

/* The constants that turn (h, d, tau) into equivalent stresses. */
typedef struct ovr_state_constants {
    float poisson;
    float mean, half; /* of the residual stresses: residual_x / 2, both */
    float across;     /* residual_y */
} ovr_state_constants;

/* n values each; see `states`. */
typedef struct ovr_node_states {
    float *d, *tau, *h, *in_plane, *von_mises, *tresca;
} ovr_node_states;

typedef struct ovr_stress_loops {
    const char *name;

    /* Sums over one load or two, with a = A P and b = B P bin by bin: wave k is
     * a + i b, wave n - k conj(a) + i conj(b), for k = 1 ... bins - 1 of n
     * waves (re, im, re, ...). */
    void (*spread)(size_t bins, size_t n, const ovr_load_bins *load,
                   size_t loads, float *waves);

    /* The state of n nodes: d and tau apart, h, and by them the largest shear
     * in the plane squared, von Mises squared and Tresca's shear. */
    void (*states)(size_t n, const float *shear, const float *mean,
                   const ovr_state_constants *constants,
                   const ovr_node_states *to);

    /* high = max(high, v), low = min(low, v) for v = d cos + tau sin. */
    void (*extents)(size_t n, const float *d, const float *tau, float cosine,
                    float sine, float *high, float *low);
    void (*raise)(size_t n, const float *v, float *high);
    void (*lower)(size_t n, const float *v, float *low);

    float (*largest)(size_t n, const float *v); /* 0 when n = 0 */

    /* Radii of the circles of n paths (circle.h): rows of high_m, then of
     * low_m, `pitch` apart. */
    void (*circles)(size_t n, const float *rows, size_t pitch, float *radius);
} ovr_stress_loops;

/* Selects the loops of a name ("plain", "base", ...); NULL: the best for this
 * machine. */
const ovr_stress_loops *ovr_stress_loops_choose(const char *name);

#endif
