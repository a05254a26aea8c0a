/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Loops over bins, with explicit vectors (real and imaginary parts interleaved,
 * mirrored half in reverse order), and over nodes, for automatic vectorization:
 * passes are independent, and comparisons select values without branches. There
 * are no sums over passes and no fused operations, so that every instruction
 * set gives the same bits.
 */
#include <math.h>

#include "stress/circle.h"
#include "stress/loops.h"

#if defined(__AVX512F__)
#define LANES 16
#define INTERLEAVED(a, b)                                                      \
    TWO(a, b, (0, 16, 1, 17, 2, 18, 3, 19, 4, 20, 5, 21, 6, 22, 7, 23),        \
        (8, 24, 9, 25, 10, 26, 11, 27, 12, 28, 13, 29, 14, 30, 15, 31))
#define BACKWARD(a, b)                                                         \
    TWO(a, b, (15, 31, 14, 30, 13, 29, 12, 28, 11, 27, 10, 26, 9, 25, 8, 24),  \
        (7, 23, 6, 22, 5, 21, 4, 20, 3, 19, 2, 18, 1, 17, 0, 16))
#elif defined(__AVX__)
#define LANES 8
#define INTERLEAVED(a, b)                                                      \
    TWO(a, b, (0, 8, 1, 9, 2, 10, 3, 11), (4, 12, 5, 13, 6, 14, 7, 15))
#define BACKWARD(a, b)                                                         \
    TWO(a, b, (7, 15, 6, 14, 5, 13, 4, 12), (3, 11, 2, 10, 1, 9, 0, 8))
#else
#define LANES 4
#define INTERLEAVED(a, b) TWO(a, b, (0, 4, 1, 5), (2, 6, 3, 7))
#define BACKWARD(a, b) TWO(a, b, (3, 7, 2, 6), (1, 5, 0, 4))
#endif

typedef float vec __attribute__((vector_size(LANES * 4)));
typedef float loose_vec
    __attribute__((vector_size(LANES * 4), aligned(4), may_alias));
typedef int whole_vec __attribute__((vector_size(LANES * 4)));
typedef struct two_vec {
    vec first, second;
} two_vec;

#define LIST(...) __VA_ARGS__
#if defined(__has_builtin)
#if __has_builtin(__builtin_shufflevector)
#define SHUFFLE(a, b, ...) __builtin_shufflevector(a, b, __VA_ARGS__)
#endif
#endif
#ifndef SHUFFLE
#define SHUFFLE(a, b, ...) __builtin_shuffle(a, b, (whole_vec){__VA_ARGS__})
#endif
#define TWO(a, b, low, high)                                                   \
    (two_vec)                                                                  \
    {                                                                          \
        SHUFFLE(a, b, LIST low), SHUFFLE(a, b, LIST high)                      \
    }

static inline vec load_vec(const float *x)
{
    return *(const loose_vec *)x;
}

static inline void store(float *x, two_vec v)
{
    *(loose_vec *)x = v.first;
    *(loose_vec *)(x + LANES) = v.second;
}

/* One bin; `high` is its mirror image. */
static inline void wave(size_t k, const ovr_load_bins *load, size_t loads,
                        float *low, float *high)
{
    float ar = 0, ai = 0, br = 0, bi = 0;
    for (size_t l = 0; l < loads; l++) {
        const ovr_load_bins *v = &load[l];
        ar += v->A.re[k] * v->P.re[k] - v->A.im[k] * v->P.im[k];
        ai += v->A.re[k] * v->P.im[k] + v->A.im[k] * v->P.re[k];
        br += v->B.re[k] * v->P.re[k] - v->B.im[k] * v->P.im[k];
        bi += v->B.re[k] * v->P.im[k] + v->B.im[k] * v->P.re[k];
    }
    low[0] = ar - bi;
    low[1] = ai + br;
    high[0] = ar + bi;
    high[1] = br - ai;
}

/* LANES bins; the mirror images end at high + 2, in reverse order. */
static inline void wave_lanes(size_t k, const ovr_load_bins *load, size_t loads,
                              float *low, float *high)
{
    vec ar = {0}, ai = {0}, br = {0}, bi = {0};
    for (size_t l = 0; l < loads; l++) {
        vec pr = load_vec(load[l].P.re + k), pi = load_vec(load[l].P.im + k);
        vec ur = load_vec(load[l].A.re + k), ui = load_vec(load[l].A.im + k);
        vec vr = load_vec(load[l].B.re + k), vi = load_vec(load[l].B.im + k);
        ar += ur * pr - ui * pi, ai += ur * pi + ui * pr;
        br += vr * pr - vi * pi, bi += vr * pi + vi * pr;
    }
    vec lr = ar - bi, li = ai + br, hr = ar + bi, hi = br - ai;
    two_vec up = INTERLEAVED(lr, li), down = BACKWARD(hr, hi);
    store(low, up);
    store(high - 2 * (LANES - 1), down);
}

static inline void spread_over(size_t bins, size_t n, const ovr_load_bins *load,
                               size_t loads, float *waves)
{
    size_t k = 1;
    for (; k + LANES <= bins; k += LANES)
        wave_lanes(k, load, loads, waves + 2 * k, waves + 2 * (n - k));
    for (; k < bins; k++)
        wave(k, load, loads, waves + 2 * k, waves + 2 * (n - k));
}

static void spread(size_t bins, size_t n, const ovr_load_bins *load,
                   size_t loads, float *waves)
{
    const ovr_load_bins own[2] = {load[0], load[loads - 1]};
    if (loads > 1)
        spread_over(bins, n, own, 2, waves);
    else
        spread_over(bins, n, own, 1, waves);
}

static void states(size_t n, const float *restrict shear,
                   const float *restrict mean, const ovr_state_constants *c,
                   const ovr_node_states *to)
{
    float *restrict d = to->d, *restrict tau = to->tau, *restrict h = to->h;
    float *restrict in_plane = to->in_plane, *restrict tresca = to->tresca;
    float *restrict von_mises = to->von_mises;
    const float nu = c->poisson, m0 = c->mean, d0 = c->half, y0 = c->across;
    for (size_t i = 0; i < n; i++) {
        float di = shear[2 * i], ti = shear[2 * i + 1], hi = mean[2 * i];
        float s = (di + d0) * (di + d0) + ti * ti;
        /* Mean of the plane stresses minus sigma_y */
        float e = (m0 - hi) - (y0 - 2 * nu * hi);
        float shear_in = sqrtf(s), other = (fabsf(e) + shear_in) / 2;
        d[i] = di;
        tau[i] = ti;
        h[i] = hi;
        in_plane[i] = s;
        von_mises[i] = 3 * s + e * e;
        tresca[i] = other > shear_in ? other : shear_in;
    }
}

static void extents(size_t n, const float *restrict d,
                    const float *restrict tau, float cosine, float sine,
                    float *restrict high, float *restrict low)
{
    for (size_t i = 0; i < n; i++) {
        float v = d[i] * cosine + tau[i] * sine;
        high[i] = v > high[i] ? v : high[i];
        low[i] = v < low[i] ? v : low[i];
    }
}

static void raise(size_t n, const float *restrict v, float *restrict high)
{
    for (size_t i = 0; i < n; i++)
        high[i] = v[i] > high[i] ? v[i] : high[i];
}

static void lower(size_t n, const float *restrict v, float *restrict low)
{
    for (size_t i = 0; i < n; i++)
        low[i] = v[i] < low[i] ? v[i] : low[i];
}

static float largest(size_t n, const float *restrict v)
{
    enum { WIDE = 16 };
    float maximum[WIDE] = {0}, all = 0;
    size_t i = 0;
    for (; i + WIDE <= n; i += WIDE)
        for (size_t l = 0; l < WIDE; l++)
            maximum[l] = v[i + l] > maximum[l] ? v[i + l] : maximum[l];
    for (; i < n; i++)
        all = v[i] > all ? v[i] : all;
    for (size_t l = 0; l < WIDE; l++)
        all = maximum[l] > all ? maximum[l] : all;
    return all;
}

/* ------------------------------------------------------------------ circles */

enum { AROUND = 2 * OVR_HALF_DIRECTIONS };

static inline vec larger(vec a, vec b)
{
    whole_vec above = a > b;
    return (vec)(((whole_vec)a & above) | ((whole_vec)b & ~above));
}

/* Extents of LANES paths in all directions; the list is continued periodically.
 */
static void gather(size_t count, const float *rows, size_t pitch, vec *H)
{
    for (size_t m = 0; m < OVR_HALF_DIRECTIONS; m++) {
        const float *high = rows + m * pitch;
        const float *low = high + OVR_HALF_DIRECTIONS * pitch;
        for (size_t l = 0; l < LANES; l++) {
            size_t i = l < count ? l : 0;
            H[m][l] = high[i];
            H[m + OVR_HALF_DIRECTIONS][l] = -low[i];
        }
    }
}

/* All triples of directions a, a + b, a + b + c that span the plane. */
static vec raise_triples(const vec *H, size_t b, size_t c, const float *sine,
                         vec best)
{
    const size_t rest = AROUND - b - c;
    const float sum = sine[b] + sine[c] + sine[rest];
    const float wa = sine[c] / sum, wb = sine[rest] / sum, wc = sine[b] / sum;
    for (size_t a = 0; a < rest; a++)
        best = larger(wa * H[a] + wb * H[a + b] + wc * H[a + b + c], best);
    return best;
}

static vec circles_of(const vec *H, const float *sine)
{
    const size_t half = OVR_HALF_DIRECTIONS;
    vec best = {0};
    for (size_t m = 0; m < half; m++)
        best = larger((H[m] + H[m + half]) / 2, best);
    for (size_t b = 2; b < half; b++)
        for (size_t c = half + 1 - b; c < half; c++)
            best = raise_triples(H, b, c, sine, best);
    return best;
}

static void circles(size_t n, const float *rows, size_t pitch, float *radius)
{
    float sine[OVR_HALF_DIRECTIONS];
    vec H[AROUND];
    for (int g = 0; g < OVR_HALF_DIRECTIONS; g++)
        sine[g] = (float)ovr_direction_sin(g);
    for (size_t i = 0; i < n; i += LANES) {
        size_t count = n - i < LANES ? n - i : LANES;
        gather(count, rows + i, pitch, H);
        vec best = circles_of(H, sine);
        for (size_t l = 0; l < count; l++)
            radius[i + l] = best[l];
    }
}

#define OVR_TEXT(x) #x
#define OVR_NAME(x) OVR_TEXT(x)
#define OVR_JOIN(a, b) a##b
#define OVR_LOOPS(isa) OVR_JOIN(ovr_stress_loops_, isa)

extern const ovr_stress_loops OVR_LOOPS(OVR_ISA);
const ovr_stress_loops OVR_LOOPS(OVR_ISA) = {
    OVR_NAME(OVR_ISA), spread, states, extents, raise, lower, largest, circles};
