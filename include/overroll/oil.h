/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * An oil in SI: the constants of its laws, viscosity against temperature as
 * data sheets give it, and tables of measured values.
 *
 * The law of viscosity, and where it is given in the oil's own constants its
 * viscosity eta0 and index alpha too, hold at the case's temperature:
 *   Doolittle alpha = B R0/((1 - R0)^2 K0)
 *   Yasutomi  eta0 and alpha at the temperature T
 *   table     eta0 and alpha of its first point
 * alpha is the slope of ln eta at p = 0.
 */
#ifndef OVERROLL_OIL_H
#define OVERROLL_OIL_H

#include "overroll/contact.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---------------------------------------------------------------- tables */

typedef struct ovr_law_table ovr_law_table;

typedef enum ovr_table_of {
    OVR_TABLE_OF_VISCOSITY, /* Pa s */
    OVR_TABLE_OF_DENSITY    /* kg/m3, or any unit: ratios count */
} ovr_table_of;

/* ------------------------------------------------------------------ oils */

/* NAN: not given. */
typedef struct ovr_oil {
    size_t size; /* of this struct, as its user knows it */
    ovr_viscosity_law viscosity_law;
    ovr_density_law density_law;
    double temperature;            /* K */
    double viscosity;              /* eta0 at that temperature, Pa s */
    double alpha;                  /* 1/Pa */
    double p0, z;                  /* Roelands: Pa; bare */
    double tait_K0, tait_K0_slope; /* at that temperature: Pa; bare */
    double doolittle_B, doolittle_R0;
    ovr_yasutomi yasutomi;  /* A2, b1 in 1/Pa; T is the temperature */
    double glass_viscosity; /* Yasutomi: at the glass transition, Pa s */
    double nu_40, nu_100;   /* kinematic viscosities, m2/s */
    double density_15;      /* kg/m3 at 15 degC */
    double viscosity_index; /* instead of nu_100 */
    const ovr_law_table *viscosity_table, *density_table;
    bool mineral; /* alpha and density_15 that are not given are estimated as
                     those of a mineral oil */
} ovr_oil;

/* Roelands and Dowson-Higginson, all numbers NAN. */
OVR_SIZED(ovr_oil)

/* Blok's reciprocal asymptotic isoviscous pressure coefficient times ph:
 * 1/(integral from 0 to infinity of dP/eta(P)), eta relative; NAN where the
 * viscosity does not rise. */
OVR_API double ovr_asymptotic_alphabar(const ovr_lubricant *lubricant);

/* ------------------------------------------- viscosity and temperature */

#ifdef __cplusplus
}
#endif

#endif
