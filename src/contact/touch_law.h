/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A touch law gives the pressure that surfaces bear where they touch, by their
 * mean gap H: A(H) in ph, H in b^2/R.  It stands for roughness and layers of
 * boundary lubricant together.
 *
 *     exponential    a1 exp(-H/s)
 *     layer          (exp(h/d) - 1)/(exp(H/d) - 1): ph at H = h, no film
 *                    below zero
 *     table          ln A over H at points, cubic between them, by its slopes
 *                    there (Hermite); beyond its ends it goes on straight
 *
 * Greenwood & Tripp's law is such a table.  Two surfaces of Gaussian heights,
 * of n summits a unit of area of the radius beta, sigma of both together,
 * u = H/sigma (Greenwood & Tripp, Proc. Instn Mech. Engrs 185 (1970) 625):
 *
 *     A      (16 sqrt(2) pi/15) (n beta sigma)^2 sqrt(sigma/beta) E* F_5/2(u)
 *     area   pi^2 (n beta sigma)^2 F_2(u), of all
 *     F_m(u) = int_u^inf (x - u)^m phi(x) dx,  F_m' = -m F_(m-1)
 *
 * phi the normal density; the integrals with x = u + y^2 by the trapezoidal
 * rule, which is exact to rounding for what falls like exp(-y^4).
 */
#ifndef OVR_CONTACT_TOUCH_LAW_H
#define OVR_CONTACT_TOUCH_LAW_H

#include "base/arena.h"

/* Points, H increasing, A falling. */
typedef struct ovr_asperity_table {
    size_t n; /* 0: none */
    double *H, *ln_A, *slope, *area;
} ovr_asperity_table;

typedef struct ovr_asperity_law {
    double amplitude, decay;   /* exponential; 0: none */
    double layer, layer_decay; /* 0: none */
    ovr_asperity_table table;
} ovr_asperity_law;

/* A and -dA/dH; `law` is an ovr_asperity_law. */
void ovr_asperity_law_at(const void *law, double H, double *A, double *slope);

/* The share of the surface that is in contact at H. */
double ovr_asperity_law_area(const ovr_asperity_law *law, double H);

/* Space for n points. */
ovr_status ovr_asperity_table_take(ovr_asperity_table *table, size_t n,
                                   ovr_arena *arena, ovr_error *err);

/* The slopes of what has no known ones: those of the monotone cubic of Fritsch
 * & Butland (SIAM J. Sci. Stat. Comput. 5 (1984) 300); n >= 2. */
void ovr_asperity_table_slopes(ovr_asperity_table *table);

/* Greenwood & Tripp's, n beta sigma and sigma/beta pure numbers; E* in ph. */
ovr_status ovr_asperity_greenwood_tripp(ovr_asperity_table *table, double sigma,
                                        double density, double sharpness,
                                        double modulus, ovr_arena *arena,
                                        ovr_error *err);

#endif
