/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Machine elements: the state of the line contact of two gear teeth, of a cam
 * and its follower, or of a roller and its raceway. Surface 1 is gear 1, the
 * cam or the raceway; +x is the direction in which surface 1 moves.
 */
#ifndef OVERROLL_ELEMENTS_H
#define OVERROLL_ELEMENTS_H

#ifdef __cplusplus
extern "C" {
#endif

/* The contact at one time. Radii of concave surfaces are negative; 1/R = 1/R_1
 * + 1/R_2; the radius of a flat surface is INFINITY. */
typedef struct ovr_element_moment {
    double t;           /* s */
    double R, R_1, R_2; /* m */
    double u1, u2;      /* m/s */
    double load;        /* N/m */
} ovr_element_moment;

#ifdef __cplusplus
}
#endif

#endif
