/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The contact: operating conditions, their scalings, the lubricant, and how
 * load and speed change in time.
 *
 * Scaling (Hertzian line contact, Venner, ten Napel & Bosma 1990):
 *     b = sqrt(8 w R / (pi E'))   half width        X = x/b
 *     ph = 2 w / (pi b)           Hertzian pressure P = p/ph
 *                                                   H = h R/b^2
 *                                                   T = t um/b
 * with w the load per unit width [N/m], R the reduced radius [m], E' the
 * reduced modulus [Pa], um = (u1 + u2)/2 the entrainment velocity [m/s].
 * With W = w/(E' R), 2U = eta0 us/(E' R), us = u1 + u2, G = alpha E':
 *     M = W (2U)^(-1/2), L = G (2U)^(1/4)           Moes numbers
 *     lambda = 6 eta0 us R^2/(b^3 ph) = 3 pi^2/(8 M^2)
 *     alphabar = alpha ph = L sqrt(M/(2 pi))
 */
#ifndef OVERROLL_CONTACT_H
#define OVERROLL_CONTACT_H

#include <stdbool.h>
#include <stddef.h>

#include "overroll/error.h"
#include "overroll/memory.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ------------------------------------------------- operating conditions */

/*
 * Input of a contact; values that are not given are NAN. Exactly one of these
 * sets must be complete:
 *
 *   Moes      M, L                             (L = 0: isoviscous)
 *   Hertzian  lambda, alphabar
 *   physical  load or hertz_pressure, radius, modulus, viscosity, alpha (not
 *             needed for isoviscous contacts) and the speeds
 *
 * With Moes or Hertzian numbers, alpha alone sets ph = alphabar/alpha. Radius
 * and modulus then set b = 4 R ph/E', and the viscosity sets the speed. The
 * modulus alone, or G, sets b/R, so that friction becomes a coefficient.
 */
typedef struct ovr_conditions {
    double M, L;
    double lambda, alphabar;
    double load;             /* w, N/m */
    double hertz_pressure;   /* ph, Pa */
    double radius;           /* R, m */
    double modulus;          /* E', Pa */
    double viscosity;        /* eta0, Pa s */
    double alpha;            /* 1/Pa */
    double speed_1, speed_2; /* u1, u2, m/s; both or none */
    double mean_speed;       /* um, m/s, instead of the two speeds */
    double slide_to_roll;    /* (u1 - u2)/um; NAN means 0 (pure rolling) */
    double G;                /* alpha E', with M and L: instead of modulus */
    double width;            /* m, for forces; nothing else depends on it */
} ovr_conditions;

/* Returns conditions with all members NAN. */
OVR_API ovr_conditions ovr_conditions_default(void);

/* Resolved contact. Dimensionless numbers are always set; a physical scale that
 * cannot be derived from the given values is NAN. */
typedef struct ovr_contact {
    double M, L, lambda, alphabar;
    double u1_ratio, u2_ratio; /* u1/um, u2/um */
    double ph;                 /* Pa */
    double b;                  /* m: length along x */
    double height;             /* b^2/R, m: film thickness and roughness */
    double time;               /* b/um, s */
    double kappa;              /* b/R = 4 ph/E' = 4 alphabar/G */
    double load;               /* w, N/m */
    double radius, modulus, viscosity, alpha, um; /* m, Pa, Pa s, 1/Pa, m/s */
    double width;                                 /* m */
} ovr_contact;

/* Resolves the conditions; fails with OVR_BAD_INPUT naming the quantity that
 * is missing, contradictory or out of range. */
OVR_API ovr_status ovr_contact_resolve(const ovr_conditions *given,
                                       ovr_contact *contact, ovr_error *err);

/* ---------------------------------------------------------------- kinds */

/* Kind of a quantity, which determines its scale and units. */
typedef enum ovr_unit_kind {
    OVR_KIND_NUMBER,      /* a pure number */
    OVR_KIND_COUNT,       /* a whole number */
    OVR_KIND_FLAG,        /* 0 or 1 */
    OVR_KIND_LENGTH,      /* along x: b */
    OVR_KIND_HEIGHT,      /* film thickness, roughness: b^2/R */
    OVR_KIND_PRESSURE,    /* ph */
    OVR_KIND_TIME,        /* b/um */
    OVR_KIND_VISCOSITY,   /* eta0 */
    OVR_KIND_FLOW,        /* per unit width: um b^2/R */
    OVR_KIND_SHEAR,       /* shear stress: ph b/R */
    OVR_KIND_FORCE,       /* friction per unit width: ph b^2/R */
    OVR_KIND_TEMPERATURE, /* K */
    OVR_KIND_HEAT,        /* a heat flux: um ph b/R */
    OVR_KIND_POWER,       /* per unit width: um ph b^2/R */
    OVR_KIND_AREA,        /* lubricant volume per unit width: b^3/R */
    OVR_KINDS /* number of kinds, and a kind unknown to this version */
} ovr_unit_kind;

typedef struct ovr_kind_info {
    const char *name;     /* "pressure"; in result files */
    const char *si;       /* "Pa" */
    const char *hertzian; /* "ph" */
    const char *suffix;   /* suffix of JSON keys in SI ("_Pa"), or "" */
} ovr_kind_info;
OVR_API const ovr_kind_info *ovr_kind_about(ovr_unit_kind kind);
OVR_API ovr_unit_kind ovr_kind_named(const char *name);

/* Returns the SI value of a dimensionless 1: NAN if it is unknown, and 1 for
 * kinds that are not scaled. */
OVR_API double ovr_kind_scale(ovr_unit_kind kind, const ovr_contact *contact);

/* ------------------------------------------------------------ lubricant */

typedef enum ovr_viscosity_law {
    OVR_ROELANDS,
    OVR_BARUS,
    OVR_ISOVISCOUS,
    OVR_DOOLITTLE,
    OVR_YASUTOMI,
    OVR_VISCOSITY_TABLE
} ovr_viscosity_law;

typedef enum ovr_density_law {
    OVR_DOWSON_HIGGINSON,
    OVR_INCOMPRESSIBLE,
    OVR_TAIT,
    OVR_DENSITY_TABLE
} ovr_density_law;

/* Constants of Yasutomi's relation (overroll-theory(7)). */
typedef struct ovr_yasutomi {
    double C1, C2, Tg0, A1, T; /* C1 bare; the others K */
    double A2, b1, b2;         /* A2, b1 per unit of pressure; b2 bare */
} ovr_yasutomi;

struct ovr_law_table;
/* Rheological model: shear rate gamma = (tau0/eta) f(tau/tau0). */
typedef enum ovr_rheology {
    OVR_NEWTONIAN,
    OVR_EYRING,         /* f = sinh */
    OVR_CARREAU,        /* Carreau-Yasuda: tau = eta gamma
                           (1 + (eta gamma/tau0)^a)^((n - 1)/a) */
    OVR_CARREAU_STRESS, /* f(x) = x (1 + x^a)^((1/n - 1)/a) */
    OVR_FLOW_TABLE      /* table of shear stress against shear rate */
} ovr_rheology;

/* Table of the integrals of a rheological model across the film. */
typedef struct ovr_flow_law ovr_flow_law;

/* A lubricant in the contact's scaling:
 *   Roelands  eta/eta0 = exp(alphabar P0/z [(1 + P/P0)^z - 1]), P0 = p0/ph
 *   Barus     eta/eta0 = exp(alphabar P)
 *   Dowson-Higginson rho/rho0 = (A + 1.34 P)/(A + P), A = 5.9e8 Pa/ph
 *   Tait      rho0/rho = 1 - ln(1 + P (1 + K')/K)/(1 + K'), K = K0/ph
 *   Doolittle eta/eta0 = exp(B R0 (1/(rho0/rho - R0) - 1/(1 - R0))), by Tait
 *   Yasutomi  see ovr_yasutomi
 *   tables    of measured values, by pressure */
typedef struct ovr_lubricant {
    ovr_viscosity_law viscosity_law;
    ovr_density_law density_law;
    double alphabar;
    double P0;
    double z;
    double A;
    double tait_K, tait_K_slope; /* K, K' */
    double doolittle_B, doolittle_R0;
    ovr_yasutomi yasutomi; /* A2, b1 per ph */
    const struct ovr_law_table *viscosity_table, *density_table; /* or NULL */
    double table_ph; /* unit of P in the tables, Pa */
    ovr_rheology rheology;
    double Sigma0;         /* tau0/(p_h b/R) */
    double limiting_shear; /* limiting shear stress coefficient; 0: no limit */
    const ovr_flow_law
        *flow_law; /* for all models except Newtonian and Eyring; borrowed */
} ovr_lubricant;

/* p0 in Pa (paper: 1.98e8); z dimensionless, NAN: 0.68, or from alpha and a
 * physical viscosity by Roelands' relation z = alpha p0/(ln eta0 + 9.67).
 * With L = 0 both laws become isoviscous and incompressible.  Fails if a law
 * needs ph and the contact has none. */
OVR_API ovr_status ovr_lubricant_make(const ovr_contact *contact,
                                      ovr_viscosity_law viscosity_law,
                                      ovr_density_law density_law, double p0,
                                      double z, ovr_lubricant *lubricant,
                                      ovr_error *err);

/* ---------------------------------------------- load and speed histories */

typedef enum ovr_history_kind {
    OVR_HISTORY_CONSTANT,
    OVR_HISTORY_RAMP, /* 1 to `to` over `duration` from `start` */
    OVR_HISTORY_SINE, /* mean + amplitude sin(2 pi (T - start)/period) */
    OVR_HISTORY_STEP, /* like a ramp without smoothing: jumps at `start` */
    OVR_HISTORY_TABLE /* GSL interpolation through given points */
} ovr_history_kind;

typedef struct ovr_history ovr_history;

#ifdef __cplusplus
}
#endif

#endif
