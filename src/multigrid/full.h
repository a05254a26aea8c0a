/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Full multigrid (FMG): Newton on the coarsest grid from the Hertzian
 * pressure, then on each finer grid cubic interpolation and cycles.
 *
 * A load that the coarsest grid cannot carry, its film being too thin for the
 * mesh, is raised on the way: Newton at the largest fraction of the load that
 * converges, nested iteration to a grid that can, and there continuation in
 * load.
 */
#ifndef OVR_MULTIGRID_FULL_H
#define OVR_MULTIGRID_FULL_H

#include "multigrid/cycle.h"

/* The contact whose solution is asked for, at loads, speeds and curvatures
 * relative to the nominal ones of M and L. */
typedef struct ovr_target {
    double M, L;
    double Cw, Cu; /* load, speed */
    double c;      /* R0/R */
    double force;  /* D sum P */
    ovr_fluid fluid;
} ovr_target;

/* Film thickness by formula, and the fluid, at a fraction of the load. */
double ovr_target_film(const ovr_target *target, double fraction);
/* Reported of each level that carries the whole load. */
typedef enum ovr_full_event {
    OVR_FULL_BEGINS, /* the level below is solved */
    OVR_FULL_CYCLES, /* another cycle follows */
    OVR_FULL_ENDS
} ovr_full_event;

typedef struct ovr_full_status {
    int cycles;    /* on this level */
    double factor; /* of the last one on the residual */
    ovr_defect defect;
} ovr_full_status;

/* Options of full multigrid, with who watches it and judges. */
typedef struct ovr_full {
    ovr_cycling cycling;
    double load_factor; /* largest step of the continuation in load */
    double mesh;        /* of its level: D over H^(2/3), the inlet's rise */
    bool fixed;         /* `max_cycles` on every level, no fewer */
    bool thin_last;     /* Newtonian up to the finest level, and only there
                           stress by stress down to that of the flow law */
    int max_cycles;     /* on the finest level */
    int min_cycles;     /* before a level may be done */
    int trial; /* so many cycles have to gain a third: the largest R of them
                  below 2/3 of that of as many before; 0: they need not */
    /* where a level of this film at X = 0 is done */
    double (*tolerance)(const void *data, const ovr_level *level, double H);
    void (*watch)(void *data, const ovr_level *level, ovr_full_event event,
                  const ovr_full_status *status);
    void *data;
    double *saved; /* space for a field of the finest size */
} ovr_full;

/* Cycles on a level whose film and residual are up to date, to its tolerance;
 * adds to the number of cycles. */
ovr_defect ovr_full_cycles(ovr_hierarchy *grids, ovr_level *level,
                           const ovr_full *how, int *cycles);

/* gap, F and force of every level as if it were the finest. */
void ovr_full_prepare(ovr_hierarchy *grids, double force);

/* Computes the solution on the finest level, whose gap X^2/2 - S is set; adds
 * to the number of cycles. */
ovr_defect ovr_full_multigrid(ovr_hierarchy *grids, const ovr_target *target,
                              ovr_full how, int *cycles);

#endif
