/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Film thickness formulas: that of Moes, and one fitted to this solver. */
#ifndef OVR_CONTACT_FILM_FORMULA_H
#define OVR_CONTACT_FILM_FORMULA_H

#include "overroll/contact.h"

/* Four asymptotes in the same scaling: rigid-isoviscous, elastic-isoviscous,
 * rigid-piezoviscous, elastic-piezoviscous. */
typedef struct ovr_film_asymptotes {
    double rigid_iso, elastic_iso, rigid_piezo, elastic_piezo;
} ovr_film_asymptotes;
ovr_film_asymptotes ovr_film_asymptotes_moes(double M, double L);

/* Central film thickness of Moes' line-contact formula, as H = h R/b^2
 * (incompressible film; Moes number times pi/(8 M)). */
double ovr_film_central_moes(double M, double L);

/* Returns the largest mesh size on which heavily loaded contacts are solved.
 * The pressure builds up in the inlet within about H^(2/3).  Contacts of
 * M = 3500 to 5000, L = 1.2 to 3 failed at 0.2 of that length and were solved
 * at 0.1. */
double ovr_resolving_mesh(double M, double H);

/* Film thickness of a steady flooded contact with a compressible oil, fitted to
 * this program's solutions to 2.6 % (central) and 1.7 % (minimum).  `density`
 * is the relative density at ph.  NAN outside 2 <= M <= 1000, 0.3 <= L <= 25.
 */
typedef struct ovr_film_fit {
    double central, minimum;
} ovr_film_fit;
ovr_film_fit ovr_film_fitted(double M, double L, double density);

/* Constants of the fit; tests/verify/film_fit_test.c recomputes them. */
typedef struct ovr_film_constants {
    double a[11];
} ovr_film_constants;

extern const ovr_film_constants ovr_central_film, ovr_minimum_film;

/* H from these constants, without the density. */
double ovr_film_blend(const ovr_film_constants *constants, double M, double L);

#endif
