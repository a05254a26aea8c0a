/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Number of cycles per step during the passage of a dent, or of rough surfaces,
 * through a sliding contact. */
#ifndef TESTS_SUPPORT_SLIDING_H
#define TESTS_SUPPORT_SLIDING_H

typedef struct test_slide {
    const char *scheme;
    int level;
    double width, slip; /* slide_to_roll; the dent is on surface 1 */
    double meshes;      /* dT/D */
} test_slide;

/* Sums of several runs. */
typedef struct test_slides {
    int runs;
    double mean, largest; /* cycles per step: mean and maximum of the runs */
    test_slide worst;
    long steps, retries;
} test_slides;

/* Runs M = 20, L = 10 with a dent of depth 0.05 that passes the contact, or
 * is stationary at X = 0, and adds its numbers. */
void test_slides_add(test_slides *all, const test_slide *one);

typedef struct test_rough_slide {
    const char *profile[2]; /* files of profiles/ for surfaces 1 and 2; NULL:
                               smooth */
    double slip;
    int level;
    double meshes; /* dT/D */
    const char *scheme;
    double end;
} test_rough_slide;

/* Runs the contact of profiles/ground.ini with rough surfaces whose fronts are
 * in the contact at the start, and adds its numbers. */
void test_slides_rough(test_slides *all, const test_rough_slide *one);

/* Runs every `every`-th combination of widths 0.02 to 0.5 and slide-to-roll
 * ratios -2 to 2. */
test_slides test_slides_grid(const char *scheme, int level, double meshes,
                             int every);

#endif
