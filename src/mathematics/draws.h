/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Random numbers by their index: the i-th draw of a key depends only on the
 * seed, the key's name and i. Any process on any host can therefore compute any
 * draw in any order with the same bits.
 *
 *   plain  splitmix64 (Steele, Lea & Flood 2014) of seed, FNV-1a of the key,
 *          and i; 53 bits and a half, so that no draw is 0 or 1
 *   lhs    (p(i) + u(i))/draws with a permutation p that is evaluated for one
 *          i: each of as many equal strata has one draw (McKay, Beckman &
 *          Conover 1979)
 *   sobol  points of Sobol' (directions of Bratley & Fox 1988, as in GSL; point
 *          0 is the origin, which GSL omits), shifted modulo 1 by a random
 *          vector for each replicate (Cranley & Patterson 1976): replicates
 *          are independent, and their spread is the error of the mean
 */
#ifndef OVR_MATHEMATICS_DRAWS_H
#define OVR_MATHEMATICS_DRAWS_H

#include <stddef.h>
#include <stdint.h>

#include "overroll/error.h"

typedef enum ovr_design { OVR_PLAIN, OVR_LHS, OVR_SOBOL } ovr_design;

enum { OVR_SOBOL_MAX = 40 }; /* dimensions */

typedef struct ovr_sampling {
    ovr_design design;
    uint64_t seed;
    size_t draws;
    const char *const *key; /* names of the keys, one per dimension */
    size_t keys;
    size_t shifts; /* Sobol: draw i is point i/shifts of replicate i%shifts, so
                      that a larger sample contains the smaller one. */
} ovr_sampling;

/* FNV-1a, 64 bits (Fowler, Noll & Vo). */
uint64_t ovr_text_hash(const char *text);

/* Returns the i-th random number of a stream, within (0, 1). */
double ovr_uniform_at(uint64_t seed, uint64_t stream, uint64_t i);

/* Fails if the design has fewer dimensions than there are keys. */
ovr_status ovr_sampling_check(const ovr_sampling *how, ovr_error *err);

/* Returns draw i of key k, within (0, 1). */
double ovr_draw_at(const ovr_sampling *how, size_t k, size_t i);

/* ---------------------------------------------------------- distributions */

typedef enum ovr_law_of_chance {
    OVR_NORMAL,    /* mean, standard deviation */
    OVR_LOGNORMAL, /* mean and standard deviation of the number itself, not of
                    * its logarithm */
    OVR_UNIFORM,   /* ends */
    OVR_TRIANGULAR /* minimum, mode, maximum */
} ovr_law_of_chance;

typedef struct ovr_distribution {
    ovr_law_of_chance law;
    double a, b, c;
    double low, high; /* truncation limits; infinite: none */
} ovr_distribution;

/* Returns a description of the error in the parameters, or NULL. */
const char *ovr_distribution_wrong(const ovr_distribution *d);

/* Returns the quantile at the probability u of the truncated distribution. */
double ovr_distribution_inverse(const ovr_distribution *d, double u);

#endif
