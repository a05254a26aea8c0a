/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random rough surfaces in random rolling contacts: film thickness roughness
 * predicted by amplitude reduction and computed by the run. */
#ifndef TESTS_SUPPORT_ROUGH_H
#define TESTS_SUPPORT_ROUGH_H

#include "overroll/run.h"

typedef struct test_rough {
    double M, L, alpha, hurst, slide;
    int level;
    ovr_rough_film predicted;
    double smooth;         /* predicted minimum film thickness if smooth */
    double film_Rq, H_min; /* results of the run */
    ovr_status status;
    ovr_error err;
} test_rough;

/*
 * Runs a random case on a level, or the next one above M = 100.
 *
 *   contact  M 20 to 200, L 4 to 14 (logarithmic), alpha 15 to 25 1/GPa, p_h
 *            below 4 GPa
 *   surface  self-affine, Hurst exponent 0.5 to 1, wavelengths up to 0.5 to 4
 *            b, from an eighth of that but at least 0.15 b; 8 b long
 *   height   such that the predicted reduction of the minimum film thickness is
 *            0.05 to 0.5 of that of smooth surfaces
 */
test_rough test_rough_run(uint64_t seed, double slide, int level);

#endif
