/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Temperatures of the surfaces: half-spaces with a moving heat source. At a
 * point of the material that has absorbed the heat flux q(T),
 *
 *     T_s = T_bulk + N int_0^inf q(T - t)/sqrt(t) dt
 *     N = k_film R b^(-3/2)/sqrt(pi k rho c um),  q = T_zeta/H into the solid
 *
 * q is linear in the last step dT. The earlier history is represented by
 * exponentials:
 *
 *     1/sqrt(t) = sum_m w_m e^(-s_m t),  dT <= t <= the longest time
 *     Psi_m = int_0^inf e^(-s_m t) q(T - t) dt
 *     T_s = h + N (4/3) sqrt(dT) q
 *     h = T_bulk + N ((2/3) sqrt(dT) q' + sum_m w_m e^(-s_m dT) Psi_m')
 *     Psi_m = e^(-x) Psi_m' + a q + b q',  x = s_m dT
 *     a = dT (x - 1 + e^-x)/x^2,  b = dT (1 - e^-x (1 + x))/x^2
 *
 * with ' one step ago. If heat conduction along the surface is included, with
 * kappa = k/(rho c um b), the kernel of each wave number k along x is e^(-kappa
 * k^2 t)/sqrt(t): the past q and the Psi_m diffuse in the same way, without
 * further approximation (surfaces.h),
 *
 *     Psi_T + u Psi_X = q - s_m Psi + kappa Psi_XX
 *
 * With layers the kernel is M(t)/sqrt(t), and in the step, t = dT v^2,
 *     4/3 -> 2 int_0^1 (1 - v^2) M dv,  2/3 -> 2 int_0^1 v^2 M dv
 *
 * The rates s_m form a geometric series. The weights minimize the squared
 * relative error, in extended precision: with 16 modes it is below 1e-4 over
 * four decades of time, and 5e-4 over five.
 *
 * Source: Carslaw & Jaeger, Conduction of Heat in Solids, 1959, 2.5 and 10.7.
 */
#ifndef OVR_PHYSICS_HEAT_SOLIDS_H
#define OVR_PHYSICS_HEAT_SOLIDS_H

#include "contact/heat_numbers.h"
#include "multigrid/modes.h"
#include "simulation/physics.h"

/* Modes are stored in banks of OVR_MODES: one bank for a half-space, two with
 * layers. */
enum { OVR_BANKS = 2, OVR_MAX_MODES = OVR_BANKS * OVR_MODES };

/* The kernel for one step length. */
typedef struct ovr_memory {
    double dT;
    int banks;
    ovr_warmth warmth; /* at is NULL: factor 1 */
    double more[2];    /* relative increase of 4/3 and 2/3 sqrt(dT) by layers */
    double rate[OVR_MAX_MODES], weight[OVR_MAX_MODES]; /* s_m; w_m e^-x */
    double fade[OVR_MAX_MODES];                        /* e^-x */
    double now[OVR_MAX_MODES], before[OVR_MAX_MODES];  /* a, b */
} ovr_memory;

/* True if heat conduction along surface k matters at speed u (relative to um).
 * The second function returns the memory time in b/um for it: 20 kappa/u^2,
 * after which the effect is negligible, but at most the time in which heat
 * diffuses over 100 b, and at most OVR_OLDEST. */
enum { OVR_OLDEST = 100000 };
bool ovr_solid_conducts(const ovr_heat *numbers, int k, double u);
double ovr_solid_reach(const ovr_heat *numbers, int k, double u);

/* |u|/um with which a steady march convects surface k of speed u. It has a
 * minimum, given by a Peclet number, and is not larger than needed: the march
 * would otherwise represent long waves less than the surface does, and the
 * iteration of marches would not contract. */
double ovr_solid_march_speed(const ovr_heat *numbers, int k, double u);

/* Length, relative to b, beyond the domain where a surface is stored, for mesh
 * size D: four times the diffusion length sqrt(kappa D) of a step D and, for
 * slow surfaces, the length of upstream diffusion, 2 kappa/u, at most 2 b. */
double ovr_solid_beyond(const ovr_heat *numbers, int k, double u, double D);

/* Sets the rates for times from `shortest` to `longest`, for a half-space or
 * with layers (`warmth`). They are constant during a run. */
void ovr_memory_rates(double shortest, double longest, ovr_memory *memory);
void ovr_memory_layered(double shortest, double longest, ovr_warmth warmth,
                        ovr_memory *memory);

/* Computes the weights for steps dT, fitted from dT to `longest`. */
void ovr_memory_fit(double dT, double longest, ovr_memory *memory);

/* Contribution of a point's past to its temperature: (h - T_bulk)/N. */
double ovr_memory_past(const ovr_memory *memory, const double *psi, double q);

/* Advances Psi and q by a step. */
void ovr_memory_step(const ovr_memory *memory, double q_before, double q,
                     double *psi);

#endif
