/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random rough surfaces in random rolling contacts: film thickness roughness
 * predicted by amplitude reduction and computed by the run. */
#ifndef TESTS_SUPPORT_ROUGH_H
#define TESTS_SUPPORT_ROUGH_H

#include "overroll/run.h"

typedef struct test_rough {
    double M, L, alpha, hurst, slide;
    int level;
    ovr_rough_film said;
    double smooth, film_Rq, H_min; /* the run's */
    ovr_status status;
    ovr_error err;
} test_rough;

/* M 20 to 200, L 4 to 14 (logarithmic), alpha 15 to 25 1/GPa with ph below 4
 * GPa; self-affine, Hurst 0.5 to 1, longest wave 0.5 to 4 b, shortest an
 * eighth of that but at least 0.15 b, 8 b long; its height such that
 * what is left at its highest takes a random share, 0.05 to 0.5, of the smooth
 * minimum film.  On the level, above M = 100 on the next. */
test_rough test_rough_run(uint64_t seed, double slide, int level);

#endif
