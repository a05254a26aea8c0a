/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Plastic flow of a material point: yield condition and flow rule. */
#ifndef OVR_STRESS_HARDENING_H
#define OVR_STRESS_HARDENING_H

#include <stdbool.h>

typedef enum ovr_hardening_law {
    OVR_HARDENS_NOT,
    OVR_HARDENS_LINEAR,
    OVR_HARDENS_KINEMATIC,
    OVR_HARDENS_SWIFT
} ovr_hardening_law;

/* Stresses in p_h, strains in p_h/E*. */
typedef struct ovr_hardening {
    int law;
    double yield; /* von Mises yield stress without plastic strain: Y(0) of all
                   * laws */
    double modulus; /* modulus of linear and kinematic hardening, stress per
                       strain */
    double strength, offset, power; /* Swift's B, C (microstrain) and n */
    double microstrain; /* microstrain in a strain of 1: 1e6 p_h/E* */
} ovr_hardening;

/* Plastic strain of a point; all: accumulated equivalent plastic strain. */
typedef struct ovr_strained {
    double x, z, xz, all;
} ovr_strained;

typedef struct ovr_stressed {
    double x, y, z, xz;
} ovr_stressed;

/* Yield stress Y and its slope at accumulated plastic strain `all`. */
double ovr_yield_stress(const ovr_hardening *h, double all, double *slope);

/* Excess of the von Mises stress over the yield stress. */
double ovr_beyond_yield(const ovr_hardening *h, ovr_strained e, ovr_stressed s);

/* True if the stress exceeds this fraction of the yield stress. */
bool ovr_near_yield(const ovr_hardening *h, ovr_strained e, ovr_stressed s,
                    double share);

/* One step of the return mapping: the plastic strain increment that would
 * return the stress to yield if the surrounding body had the largest possible
 * stiffness. Returns the increment, 0 within yield, and adds the plastic work
 * to *work. */
double ovr_plastic_flow(const ovr_hardening *h, double poisson, ovr_stressed s,
                        ovr_strained *e, double *work);

#endif
