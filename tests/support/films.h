/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Steady film thicknesses of contacts distributed over (M, L), computed by this
 * program. */
#ifndef TESTS_SUPPORT_FILMS_H
#define TESTS_SUPPORT_FILMS_H

#include <stddef.h>

typedef struct test_film {
    double M, L, alpha, ph, density; /* 1/Pa, Pa, at ph */
    double central, minimum;
} test_film;

/* Solves the first `count` points of a Halton sequence in log M, log L and
 * alpha whose ph is below 4 GPa, with a distant inlet. Returns the number of
 * converged solutions. */
size_t test_films(size_t count, int level, test_film *film);

#endif
