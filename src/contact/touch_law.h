/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Asperity contact model: the asperity pressure A(H) in p_h as a function of
 * the mean gap H in b^2/R. It represents roughness and boundary lubricant
 * layers together.
 *
 *     exponential    a1 exp(-H/s)
 *     layer          (exp(h/d) - 1)/(exp(H/d) - 1): ph at H = h, no film
 *                    below zero
 *     table          ln A over H at points, cubic Hermite interpolation
 *                    between them; linear beyond its ends
 *
 * Greenwood & Tripp's model is such a table. For two surfaces with Gaussian
 * height distribution, n asperity summits per unit area of radius beta,
 * combined sigma, u = H/sigma (Greenwood & Tripp, Proc. Instn Mech. Engrs 185
 * (1970) 625):
 *
 *     A      (16 sqrt(2) pi/15) (n beta sigma)^2 sqrt(sigma/beta) E* F_5/2(u)
 *     area   pi^2 (n beta sigma)^2 F_2(u), a fraction
 *     F_m(u) = int_u^inf (x - u)^m phi(x) dx,  F_m' = -m F_(m-1)
 *
 * with phi the normal density. The integrals are computed with x = u + y^2 by
 * the trapezoidal rule, which is exact to rounding because the integrand
 * decreases as exp(-y^4).
 */
#ifndef OVR_CONTACT_TOUCH_LAW_H
#define OVR_CONTACT_TOUCH_LAW_H

#include "base/arena.h"

/* Points, with increasing H and decreasing A. */
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

/* Fraction of the surface in asperity contact at H. */
double ovr_asperity_law_area(const ovr_asperity_law *law, double H);

/* Allocates space for n points. */
ovr_status ovr_asperity_table_take(ovr_asperity_table *table, size_t n,
                                   ovr_arena *arena, ovr_error *err);

/* Computes slopes for points without known slopes: those of the monotone cubic
 * of Fritsch & Butland (SIAM J. Sci. Stat. Comput. 5 (1984) 300); n >= 2. */
void ovr_asperity_table_slopes(ovr_asperity_table *table);

/* Computes the table of Greenwood & Tripp's model; n beta sigma and sigma/beta
 * are dimensionless, E* in p_h. */
ovr_status ovr_asperity_greenwood_tripp(ovr_asperity_table *table, double sigma,
                                        double density, double sharpness,
                                        double modulus, ovr_arena *arena,
                                        ovr_error *err);

#endif
