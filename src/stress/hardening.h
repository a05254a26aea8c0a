/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A point of a metal flows by this law: when its stress reaches yield, and
 * where to. */
#ifndef OVR_STRESS_HARDENING_H
#define OVR_STRESS_HARDENING_H

#include <stdbool.h>

typedef enum ovr_hardening_law {
    OVR_HARDENS_NOT,
    OVR_HARDENS_LINEAR,
    OVR_HARDENS_KINEMATIC,
    OVR_HARDENS_SWIFT
} ovr_hardening_law;

/* Stresses in p_h, strains over p_h/E*. */
typedef struct ovr_hardening {
    int law;
    double yield; /* von Mises stress at no plastic strain: Y(0) of all laws */
    double modulus; /* of linear and kinematic hardening, stress per strain */
    double strength, offset, power; /* Swift's B, C (microstrain) and n */
    double microstrain;             /* of a strain of 1: 1e6 p_h/E* */
} ovr_hardening;

/* Plastic strain of a point, with what it has flowed in all. */
typedef struct ovr_strained {
    double x, z, xz, all;
} ovr_strained;

typedef struct ovr_stressed {
    double x, y, z, xz;
} ovr_stressed;

/* Y and its slope, after so much flow. */
double ovr_yield_stress(const ovr_hardening *h, double all, double *slope);

/* The stress beyond yield. */
double ovr_beyond_yield(const ovr_hardening *h, ovr_strained e, ovr_stressed s);

/* True if it is above this share of yield. */
bool ovr_near_yield(const ovr_hardening *h, ovr_strained e, ovr_stressed s,
                    double share);

/* One step of the return: flows by what would bring the stress back where the
 * body held it as stiffly as it can; returns what it flows, 0 within yield, and
 * adds the work done to *work. */
double ovr_plastic_flow(const ovr_hardening *h, double poisson, ovr_stressed s,
                        ovr_strained *e, double *work);

#endif
