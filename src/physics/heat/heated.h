/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Heat in a steady contact (in time: heat_in_time.h): temperatures of film and
 * surfaces by marching along x (cross_film.h, solids.h), and what Reynolds'
 * equation gets of them, in turn with cycles until neither changes.
 *
 * A node is entered from the one upstream, t_j = D/u_j, u_j at least 0.02. Heat
 * that flows along a slow surface is put right from march to march
 * (heat_surfaces.h).  At the inlet the oil
 * is at the supply's temperature and the surfaces have taken up nothing.
 *
 * With opposite sliding each surface enters at its own end, and layers that
 * move against x start at the other side: marches along x and against it in
 * turn, two of each an outer iteration of film and heat, each with what the
 * other has left of the other surface.  With K the operator from heat to
 * temperature of a surface, which is positive, two marches reduce the error by
 * ((I + K)^-1 K)^2.
 *
 * Where the number of points across is left open they are 5, and 7 from then on
 * where the steady film with 5 asks for them: by Legendre's polynomials, with
 * a_4 the coefficient of the last, x = max |a_4| over the largest rise.  In 15
 * contacts of Newtonian and Eyring oils (slip .01 to 1.5, .3 to .9 MN/m, 3 and
 * 10 m/s) 5 points left friction 400 x^2 % low, within a factor of 3, and
 * surface temperatures off by up to twice that; the film by more where the slip
 * is large, of which x does not know.  7 are used from x = 0.05, 1 % of the
 * friction, on, where the film is 20 K hot: a rolling one of 8 K had x = 0.33
 * of the compression in its inlet, and temperatures accurate within 0.4 %.
 * They are taken from the start, too, if histories or features that pass may
 * make temperatures more uneven in time.
 *
 * A film that begins towards -x (mirror.h) is marched from its last node.
 *
 *     th = (T0 - 138 K + T_m)^(-S0)/...,  log2(1/eta) <- th log2(1/eta) + shift
 *     shift = (1 - th) C/ln 2 + log2 psi_e      Roelands
 *     shift = beta T_m/ln 2 + log2 psi_e, th = 1    others
 *     rho <- rho swell, where density expands (cross_film.h)
 *
 * and the flow that temperatures skew (heat_skew.h) go down to all grids by
 * injection.
 */
#ifndef OVR_PHYSICS_HEAT_HEATED_H
#define OVR_PHYSICS_HEAT_HEATED_H

#include "physics/heat/columns.h"
#include "physics/heat/solids.h"

extern const struct ovr_companion ovr_heat_companion;

typedef struct ovr_heated {
    ovr_heat numbers;
    bool chooses; /* 5 points or 7 */
    ovr_cross_film cross_film;
    ovr_memory memory[2];
    double speed[2];                  /* |u_k|/um of the march */
    int way[2];                       /* along x: 1; against it: -1 */
    double longest[2];                /* time that a surface remembers */
    double *T[OVR_CROSS_FILM_MAX];    /* rises at the nodes, by points */
    double *used[OVR_CROSS_FILM_MAX]; /* under-relaxed: what the film has */
    double *q[2];                     /* T_zeta/H into the surfaces */
    double *mean;                     /* T_m of T */
    double *t;                        /* mean stress at the nodes */
    double *drag;                     /* psi_c */
    double *skewed;                   /* q s (heat_skew.h) */
    double *skew, *skew_by_P;         /* s_0 and s_1 of s = s_0 + s_1 P */
    double *skewed_next, *unused;     /* s q at P + dP; outputs not needed */
    double skew_share;                /* Part of s in use, below 1 on the way */
    bool always_falls;                /* as in cross_film.h */
    double *start_P, *start_q, start_H0; /* the film without temperatures */
    bool strayed;  /* iterations ended without a film or with large changes */
    bool too_slow; /* a film took too much work with order 4 */
    int cycles;    /* of a steady start, in all tries */
    double change; /* last change of temperatures, relative to the rise */
    double *th, *shift, *swell; /* in the order of the nodes */
    double V, u1;               /* now */
    ovr_heat_power made;        /* at the last observation of stresses */
    double left;                /* closure of the discrete balance of heat */
    double balanced; /* power to which the observed defect is relative */
    struct ovr_heat_outer *outer; /* heat_outer.h */
    struct ovr_heat_steps *steps; /* heat_in_time.h */
    double Sigma0, limit;         /* as in cross_film.h; limit over P */
    ovr_columns film;
    double *log_eta;       /* at T0 */
    double *apart;         /* share of the surfaces that the film drags on */
    double *oil, *content; /* H and q of what is there (heat_film.h) */
    double *departure[OVR_CROSS_FILM_MAX]; /* T at those points of a step */
} ovr_heated;

/* Speeds of the surfaces at T = 0, and their memories from node to node. */
void ovr_heat_march_begin(ovr_simulation *sim);

/* The film's columns are those of a steady film, entered from node to node:
 * before the first march too, as a solve may be given up before it. */
void ovr_heat_march_columns(ovr_simulation *sim);

/* Temperatures of the film that was read last, with viscosities by `used`. */
void ovr_heat_march(ovr_simulation *sim);

/* Moves `used` on by this share of the change. */
void ovr_heat_relax(ovr_simulation *sim, double share);

/* Computes film thickness and F of all grids from the temperatures `used` of
 * the film that was read last; the temperatures found last. */
void ovr_heat_apply(ovr_simulation *sim);
void ovr_heat_give(ovr_simulation *sim);

/* The pressure below which a film ends, and where temperatures may swing
 * without being of account: 0.1 of p_h, or of the largest P where that is less.
 */
double ovr_heat_pressed(const ovr_simulation *sim);

/* Tolerance of a steady start: change of temperatures relative to the largest
 * rise. */
#define OVR_HEAT_CHANGE 3e-5

/* Returns a temperature rise within bounds that diverging iterations and their
 * printed results keep. */
double ovr_heat_bounded(const ovr_heated *heated, double rise);

/* Sets V and u1 of the time T. */
void ovr_heat_speeds(ovr_simulation *sim, double T);

#endif
