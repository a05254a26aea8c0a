/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Heat in a steady contact (in time: in_time.h): temperatures of film and
 * surfaces by marching along x (cross_film.h, solids.h), and their effect on
 * the Reynolds equation, computed alternately with multigrid cycles until both
 * converge.
 *
 * The departure point of a node is the node upstream, t_j = D/u_j, with u_j at
 * least 0.02. Heat conduction along a slow surface is corrected iteratively
 * from march to march (surfaces.h). At the inlet the lubricant has the
 * supply temperature, and the surfaces have absorbed no heat.
 *
 * With opposite sliding each surface enters at its own end, and layers that
 * move against x start at the other side: marches along x and against x
 * alternate, two of each per outer iteration of film and heat. Each march uses
 * the temperatures of the other surface from the last march in the other
 * direction.  With K the operator from heat to temperature of a surface, which
 * is positive, two marches reduce the error by ((I + K)^-1 K)^2.
 *
 * The default number of points across the film is 5, and 7 if the steady film
 * with 5 points requires them. The criterion is x = max |a_4| divided by the
 * maximum temperature rise, with a_4 the coefficient of the highest Legendre
 * polynomial.  In 15 contacts of Newtonian and Eyring oils (slide-to-roll ratio
 * .01 to 1.5, .3 to .9 MN/m, 3 and 10 m/s) the friction with 5 points is too
 * low by 400 x^2 %, within a factor of 3. The relative error of surface
 * temperatures is up to twice as large; that of film temperatures is larger at
 * high sliding speeds, which x does not show. 7 points are used if x > 0.05 (1
 * % of the friction) and the temperature rise exceeds 20 K. (A rolling contact
 * with 8 K had x = 0.33 from compression heating in the inlet, but temperatures
 * accurate within 0.4 %.) They are also used from the start if time histories
 * or moving features can make the temperature profile less uniform later.
 *
 * If the film moves towards -x (mirror.h), marching starts at the last node.
 *
 *     th = (T0 - 138 K + T_m)^(-S0)/...,  log2(1/eta) <- th log2(1/eta) + shift
 *     shift = (1 - th) C/ln 2 + log2 psi_e      Roelands
 *     shift = beta T_m/ln 2 + log2 psi_e, th = 1    others
 *     rho <- rho swell, where density expands (cross_film.h)
 *
 * These coefficients and the skewed flow (skew.h) are transferred to all
 * grids by injection.
 */
#ifndef OVR_PHYSICS_HEAT_HEATED_H
#define OVR_PHYSICS_HEAT_HEATED_H

#include "physics/heat/columns.h"
#include "physics/heat/solids.h"

extern const struct ovr_companion ovr_heat_companion;

typedef struct ovr_heated {
    ovr_heat numbers;
    bool chooses; /* the number of points (5 or 7) is automatic */
    ovr_cross_film cross_film;
    ovr_memory memory[2];
    double speed[2];                  /* |u_k|/um used in the march */
    int direction[2];                 /* along x: 1; against it: -1 */
    double longest[2];                /* maximum time of a surface's memory */
    double *T[OVR_CROSS_FILM_MAX];    /* temperature rises at the nodes, by
                                       * points */
    double *used[OVR_CROSS_FILM_MAX]; /* under-relaxed temperatures, used in the
                                       * film */
    double *q[2];                     /* T_zeta/H into the surfaces */
    double *mean;                     /* T_m of T */
    double *t;                        /* mean stress at the nodes */
    double *drag;                     /* psi_c */
    double *skewed;                   /* q s (skew.h) */
    double *skew, *skew_by_P;         /* s_0 and s_1 of s = s_0 + s_1 P */
    double *skewed_next, *unused;     /* s q at P + dP; outputs not needed */
    double skew_share;                /* fraction of s in use, below 1 during
                                       * the iteration */
    bool always_falls;                /* as in cross_film.h */
    double *start_P, *start_q, start_H0; /* the isothermal film */
    bool strayed;  /* iterations ended without a film or with large changes */
    bool too_slow; /* a film of order 4 took too much work */
    int cycles;    /* cycles of a steady start, in all attempts */
    double change; /* last change of temperatures, relative to the rise */
    double *th, *shift, *swell; /* as in columns.h, in node order */
    double V, u1; /* sliding speed and speed of surface 1 at the present time */
    ovr_heat_power made; /* power at the last computation of stresses */
    double left;         /* error of the discrete heat balance */
    double balanced;     /* reference power of the reported balance error */
    struct ovr_heat_outer *outer; /* outer.h */
    struct ovr_heat_steps *steps; /* in_time.h */
    double Sigma0, limit;         /* as in cross_film.h; limit of (|t| +
                                   * |G_P|)/P */
    ovr_columns film;
    double *log_eta; /* ln eta at T0 */
    double *apart;   /* fraction of the surface on which fluid shear acts
                      */
    double *all_power, *node_power, *half_power, *factor; /* flow_power.h */
    double *oil, *content; /* H and q of the present lubricant (columns.h) */
    double *departure[OVR_CROSS_FILM_MAX]; /* T at the departure points of a
                                            * step */
} ovr_heated;

/* Sets the speeds of the surfaces at T = 0 and their memories for steps from
 * node to node. */
void ovr_heat_march_begin(ovr_simulation *sim);

/* Sets up the columns as those of a steady film, whose departure points are the
 * neighbouring nodes. Called before the first march too, because a solve may
 * end before it. */
void ovr_heat_march_columns(ovr_simulation *sim);

/* Computes the temperatures of the film last read, with viscosities at the
 * temperatures `used`. */
void ovr_heat_march(ovr_simulation *sim);

/* Changes `used` by this fraction of the difference to the computed
 * temperatures. */
void ovr_heat_relax(ovr_simulation *sim, double share);

/* Computes film properties and F of all grids from the temperatures `used`;
 * sets `used` to the temperatures computed last. */
void ovr_heat_apply(ovr_simulation *sim);
void ovr_heat_give(ovr_simulation *sim);

/* Pressure that separates the film from its end, where temperatures may
 * oscillate without effect: 0.1 p_h, or 0.1 of the maximum P if that is
 * smaller. */
double ovr_heat_pressed(const ovr_simulation *sim);

/* Tolerance of a steady start: temperature change relative to the maximum rise.
 */
#define OVR_HEAT_CHANGE 3e-5

/* Limits a temperature rise to a range that is also used in printed results of
 * diverging iterations. */
double ovr_heat_bounded(const ovr_heated *heated, double rise);

/* Sets V and u1 at time T. */
void ovr_heat_speeds(ovr_simulation *sim, double T);

#endif
