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

/* The first `count` points of a Halton sequence in log M, log L and alpha with
 * ph below 4 GPa, solved with converged inlets; how many converged. */
size_t test_films(size_t count, int level, test_film *film);

#endif
