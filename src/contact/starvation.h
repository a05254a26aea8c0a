/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Numerical starvation: loss of film thickness in a domain whose inlet is too
 * close to the contact. */
#ifndef OVR_CONTACT_STARVATION_H
#define OVR_CONTACT_STARVATION_H

/* Default X_a and X_b (those of the paper). Relative loss above which the
 * default inlet is moved upstream; the same if load, speed or radius vary; loss
 * by an automatic inlet. Automatic inlets are at least half a contact width
 * upstream of the contact. */
#define OVR_USUAL_INLET (-4.0)
#define OVR_USUAL_OUTLET 1.5
#define OVR_USUAL_LOSS 5e-3
#define OVR_VARYING_LOSS 3e-4
#define OVR_AUTO_LOSS 1e-4
#define OVR_NEAREST_INLET (-2.0)

/* Hertz's gap outside the contact, at |X| = 1 + d. */
double ovr_hertz_gap(double d);

/* Integral from X_a = 1 + d to infinity of g/(g + H)^3 X^power, power 0 or 1:
 * the pressure, divided by lambda, that the film builds up there, or its load.
 */
double ovr_inlet_integral(double H, double d, int power);

/* Relative loss of central film thickness for a domain that begins at X_a < -1.
 */
double ovr_inlet_loss(double M, double L, double X_a);

/* Relative loss of rolling friction for the same domain, without the friction
 * upstream of X_a. Negative: the friction is too large. */
double ovr_inlet_rolling_loss(double M, double L, double X_a);

/* Maximum ratio of the loss to this estimate, for losses of half a per cent. */
double ovr_inlet_uncertainty(double M);

/* X_a for which the estimated loss has this value, limited by `minimum` (for
 * example -2). */
double ovr_inlet_of_loss(double M, double L, double loss, double minimum);

/* Upper bound of X for the end of a steady film. */
double ovr_film_end_bound(double M, double L);

#endif
