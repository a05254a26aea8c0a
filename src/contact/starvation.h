/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A domain that begins too close to the contact makes the film thinner; these
 * formulas say by how much. */
#ifndef OVR_CONTACT_STARVATION_H
#define OVR_CONTACT_STARVATION_H

/* Default X_a and X_b (of the paper); a loss above which the usual inlet
 * lies farther out, and one where load, speed or radius vary; the loss by an
 * automatic one.  No inlet that the program chooses lies nearer than half a
 * contact width to the contact. */
#define OVR_USUAL_INLET (-4.0)
#define OVR_USUAL_OUTLET 1.5
#define OVR_USUAL_LOSS 5e-3
#define OVR_VARYING_LOSS 3e-4
#define OVR_AUTO_LOSS 1e-4
#define OVR_NEAREST_INLET (-2.0)

/* Hertz's gap outside the contact, at |X| = 1 + d. */
double ovr_hertz_gap(double d);

/* Integral from X_a = 1 + d to infinity of g/(g + H)^3 X^power, power 0 or 1:
 * the pressure, over lambda, that the film there would build up, and what it
 * carries. */
double ovr_inlet_integral(double H, double d, int power);

/* Share of the central film thickness that a first node at X_a < -1 costs. */
double ovr_inlet_loss(double M, double L, double X_a);

/* Relative loss of rolling friction that the same node causes, without the
 * friction beyond X_a.  Negative: the friction is too large. */
double ovr_inlet_rolling_loss(double M, double L, double X_a);

/* It costs so many times that at most, where that is half a per cent. */
double ovr_inlet_uncertainty(double M);

/* The X_a that costs this share, but not beyond `minimum` (-2, say). */
double ovr_inlet_of_loss(double M, double L, double loss, double minimum);

/* No steady film ends downstream of this X. */
double ovr_film_end_bound(double M, double L);

#endif
