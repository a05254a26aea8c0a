/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Thermal expansion of the lubricant for a number type `num` (base/scalar.h,
 * vector.h). T is the temperature rise above the supply temperature, bT the
 * expansion at P = 0 there, and v_0 the specific volume of the density law:
 *
 *     v = v_0(P) (1 + bT f T),  f = A^2/((A + P)(A + 1.34 P))
 *     beta = v_T/v = bT f/(1 + bT f T)
 *
 * Density and heat of compression use the same expansion, as thermodynamics
 * requires: heat taken up in a cycle of compression and release equals the
 * work.  Volume is linear in T because then heat capacity does not depend on
 * pressure: (c_p)_P = -T v_TT.
 *
 * f is the compressibility of Dowson and Higginson's law relative to its value
 * at P = 0. According to Tait's equation, the expansion coefficients of two
 * oils fall to 0.61 and 0.55 of bT at 0.1 GPa, where f = 0.70, and to 0.28 and
 * 0.14 at 0.8 GPa, where f = 0.15: f differs from either oil about as much as
 * the oils differ from each other (overroll-theory(7)).
 *
 * Source: Callen, Thermodynamics and an Introduction to Thermostatistics, 1985,
 * chapter 7, for (c_p)_P; Dowson & Higginson 1966 for f.
 */
#ifndef OVR_MULTIGRID_EXPANSION_H
#define OVR_MULTIGRID_EXPANSION_H

#include "contact/heat_numbers.h"
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

/* Density relative to that at the supply temperature, from bT f. The volume is
 * bounded below at half the reference volume, which no real temperature
 * reaches. */
static inline num expansion_lightness(const ovr_heat *heat, num bT_f, num T)
{
    return heat->density_expands ? 1 / larger(fused(bT_f, T, all(1)), all(0.5))
                                 : all(1);
}

#endif
