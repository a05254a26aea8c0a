/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Number of cycles per step during the passage of a dent through a sliding
 * contact. */
#ifndef TESTS_SUPPORT_SLIDING_H
#define TESTS_SUPPORT_SLIDING_H

typedef struct test_slide {
    const char *scheme;
    int level;
    double width, slip; /* slide_to_roll; the dent is on surface 1 */
    double meshes;      /* dT/D */
} test_slide;

/* Over runs. */
typedef struct test_slides {
    int runs;
    double mean, largest; /* cycles a step, of the runs */
    test_slide worst;
    long steps, retries;
} test_slides;

/* Runs M = 20, L = 10 with a dent 0.05 deep from before the contact to behind
 * it (or standing in its middle) and counts it in. */
void test_slides_add(test_slides *all, const test_slide *one);

typedef struct test_rough_slide {
    const char *profile[2]; /* of profiles/, on surface 1 and 2; NULL: smooth */
    double slip;
    int level;
    double meshes; /* dT/D */
    const char *scheme;
    double end;
} test_rough_slide;

/* Rough surfaces, their fronts inside the contact at the start, in the contact
 * of profiles/ground.ini. */
void test_slides_rough(test_slides *all, const test_rough_slide *one);

/* Over a grid of widths 0.02 to 0.5 and slips -2 to 2, every `every`-th run. */
test_slides test_slides_grid(const char *scheme, int level, double meshes,
                             int every);

#endif
