/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Loops that take most of the time of stress fields, stress histories and
 * circles: compiled for each instruction set (loops.kernel.c) and in plain C
 * (loops.plain.c). */
#ifndef OVR_STRESS_LOOPS_H
#define OVR_STRESS_LOOPS_H

#include <stdbool.h>
#include <stddef.h>

/* Real and imaginary parts of a spectrum, bins 0 ... */
typedef struct ovr_bins {
    const float *re, *im;
} ovr_bins;

/* Spectrum of a load and the two tables to multiply it by. */
typedef struct ovr_load_bins {
    ovr_bins P, A, B;
} ovr_load_bins;

/* Constants for computing equivalent stresses from (h, d, tau). */
typedef struct ovr_state_constants {
    float poisson;
    float mean, half; /* mean stress and half difference of the residual
                         stresses: both residual_x / 2 */
    float across;     /* residual_y */
} ovr_state_constants;

/* n values each; see `states`. */
typedef struct ovr_node_states {
    float *d, *tau, *h, *in_plane, *von_mises, *tresca;
} ovr_node_states;

typedef struct ovr_stress_loops {
    const char *name;

    /* Sums over one or two loads with a = A P and b = B P for each bin: wave k
     * is a + i b, wave n - k is conj(a) + i conj(b), for k = 1 ... bins - 1 of
     * n waves (re, im, re, ...) */
    void (*spread)(size_t bins, size_t n, const ovr_load_bins *load,
                   size_t loads, float *waves);

    /* Stresses at n nodes: d, tau, h, and from them the squared maximum shear
     * stress in the plane, the squared von Mises stress and Tresca's shear
     * stress */
    void (*states)(size_t n, const float *shear, const float *mean,
                   const ovr_state_constants *constants,
                   const ovr_node_states *to);

    /* high = max(high, v), low = min(low, v) for v = d cos + tau sin. */
    void (*extents)(size_t n, const float *d, const float *tau, float cosine,
                    float sine, float *high, float *low);
    void (*raise)(size_t n, const float *v, float *high);
    void (*lower)(size_t n, const float *v, float *low);

    float (*largest)(size_t n, const float *v); /* 0 when n = 0 */

    /* Radii of the circles around n paths (circle.h): rows of high_m, then of
     * low_m, `pitch` apart */
    void (*circles)(size_t n, const float *rows, size_t pitch, float *radius);
} ovr_stress_loops;

/* Returns the loops for the kernels of this name (multigrid/kernels.h), NULL:
 * of the best ones for this machine. */
const ovr_stress_loops *ovr_stress_loops_choose(const char *name);

#endif
