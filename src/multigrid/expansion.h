/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Thermal expansion of the oil over a number type (base/scalar.h, vector.h):
 * T is the rise above that of the supply, bT the expansion at P = 0 there, and
 * v_0 the volume of a mass by the density law:
 *
 *     v = v_0(P) (1 + bT f T),  f = A^2/((A + P)(A + 1.34 P))
 *     beta = v_T/v = bT f/(1 + bT f T)
 *
 * Density and heat of compression both take it, so that oil that is pressed
 * hot and relieved cold gives as work what it took as heat.  Volume is linear
 * in T because then heat capacity does not depend on pressure: (c_p)_P = -T
 * v_TT.
 *
 * f is the compressibility of Dowson and Higginson's law over that at P = 0.
 * By Tait's equation the expansion of two oils falls to 0.61 and 0.55 of bT at
 * 0.1 GPa, where f = 0.70, and to 0.28 and 0.14 at 0.8 GPa, where f = 0.15: f
 * is about as near to either as they are to each other (overroll-theory(7)).
 *
 * Source: Callen, Thermodynamics and an Introduction to Thermostatistics, 1985,
 * chapter 7, for (c_p)_P; Dowson & Higginson 1966 for f.
 */
#ifndef OVR_MULTIGRID_EXPANSION_H
#define OVR_MULTIGRID_EXPANSION_H

#include "overroll/heat.h"
#ifndef VEC
#include "base/scalar.h"
#endif

/* bT f */
static inline num expansion_at(const ovr_heat *heat, num P)
{
    double A = heat->A;
    num pressed = (A + P) * (A + 1.34 * P);
    return A > 0 ? heat->expansion * (A * A) / pressed : all(heat->expansion);
}

/* Density over that at the temperature of the supply, from bT f; the oil that
 * shrinks to half its volume is none, and none gets that cold. */
static inline num expansion_lightness(const ovr_heat *heat, num bT_f, num T)
{
    return heat->density_expands ? 1 / larger(fused(bT_f, T, all(1)), all(0.5))
                                 : all(1);
}

#endif
