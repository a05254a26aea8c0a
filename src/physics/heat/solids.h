/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Temperatures of the surfaces: half-spaces under heat that moves over them.
 * At a point of the material, which took up q(T) until now,
 *
 *     T_s = T_bulk + N int_0^inf q(T - t)/sqrt(t) dt
 *     N = k_film R b^(-3/2)/sqrt(pi k rho c um),  q = T_zeta/H into the solid
 *
 * q is linear within the last step dT, and what is older is remembered as
 * exponentials:
 *
 *     1/sqrt(t) = sum_m w_m e^(-s_m t),  dT <= t <= the longest time
 *     Psi_m = int_0^inf e^(-s_m t) q(T - t) dt
 *     T_s = h + N (4/3) sqrt(dT) q
 *     h = T_bulk + N ((2/3) sqrt(dT) q' + sum_m w_m e^(-s_m dT) Psi_m')
 *     Psi_m = e^(-x) Psi_m' + a q + b q',  x = s_m dT
 *     a = dT (x - 1 + e^-x)/x^2,  b = dT (1 - e^-x (1 + x))/x^2
 *
 * with ' a step ago.  Where heat flows along the surface too, with kappa =
 * k/(rho c um b), the kernel of each wave number k along x is e^(-kappa k^2
 * t)/sqrt(t): q of the past spreads, and so do the Psi_m, each alike and
 * exactly (heat_surfaces.h),
 *
 *     Psi_T + u Psi_X = q - s_m Psi + kappa Psi_XX
 *
 * Under layers the kernel is M(t)/sqrt(t), and within the step, t = dT v^2,
 *     4/3 -> 2 int_0^1 (1 - v^2) M dv,  2/3 -> 2 int_0^1 v^2 M dv
 *
 * The rates s_m are geometric, the weights the least
 * squares of the relative error, in extended precision: with 16 modes below
 * 1e-4 over four decades of time, 5e-4 over five.
 *
 * Source: Carslaw & Jaeger, Conduction of Heat in Solids, 1959, 2.5 and 10.7.
 */
#ifndef OVR_PHYSICS_HEAT_SOLIDS_H
#define OVR_PHYSICS_HEAT_SOLIDS_H

#include "multigrid/modes.h"
#include "overroll/heat.h"
#include "simulation/physics.h"

/* Modes are stored in banks of OVR_MODES: one of a half-space, two under
 * layers. */
enum { OVR_BANKS = 2, OVR_MAX_MODES = OVR_BANKS * OVR_MODES };

/* The kernel for one length of step. */
typedef struct ovr_memory {
    double dT;
    int banks;
    ovr_warmth warmth; /* at is NULL: 1 */
    double more[2];    /* by which 4/3 and 2/3 sqrt(dT) are larger, relative */
    double rate[OVR_MAX_MODES], weight[OVR_MAX_MODES]; /* s_m; w_m e^-x */
    double fade[OVR_MAX_MODES];                        /* e^-x */
    double now[OVR_MAX_MODES], before[OVR_MAX_MODES];  /* a, b */
} ovr_memory;

/* True if heat along surface k counts at u, over um; how long, over b/um, it
 * remembers for that: until 20 kappa/u^2, when no more of it is felt, but not
 * longer than heat takes to spread by 100 b and to leave a line contact, nor
 * than OVR_OLDEST. */
enum { OVR_OLDEST = 100000 };
bool ovr_solid_conducts(const ovr_heat *numbers, int k, double u);
double ovr_solid_reach(const ovr_heat *numbers, int k, double u);

/* |u|/um by which a steady march takes surface k along when it moves by u: no
 * slower than its smallest Peclet number, and no faster, for it would remember
 * less than the surface does of long waves, and marches would not contract. */
double ovr_solid_march_speed(const ovr_heat *numbers, int k, double u);

/* The distance, over b, that it remembers beyond the domain, on a mesh of D:
 * four times the length sqrt(kappa D) by which heat spreads in a step of D, and
 * where it is slow so far as it comes against the motion, 2 kappa/u, but at
 * most 2 b. */
double ovr_solid_beyond(const ovr_heat *numbers, int k, double u, double D);

/* Rates for times from `shortest` to `longest`, of a half-space; under layers,
 * warmth not NULL.  They stay for a run. */
void ovr_memory_rates(double shortest, double longest, ovr_memory *memory);
void ovr_memory_layered(double shortest, double longest, ovr_warmth warmth,
                        ovr_memory *memory);

/* Weights for steps of dT; the largest relative error of the kernel then, from
 * dT to `longest`. */
void ovr_memory_fit(double dT, double longest, ovr_memory *memory);
double ovr_memory_error(const ovr_memory *memory, double longest);

/* The share of a point's past: (h - T_bulk)/N. */
double ovr_memory_past(const ovr_memory *memory, const double *psi, double q);

/* Psi and q a step later. */
void ovr_memory_step(const ovr_memory *memory, double q_before, double q,
                     double *psi);

#endif
