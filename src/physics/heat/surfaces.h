/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Both surfaces have a memory at the nodes (solids.h, multigrid/modes.h): what
 * it says in a step, what it is a step later, and what it is of a steady
 * contact.
 *
 * Heat flows along a surface too, exactly, where its Peclet number is at most
 * 50; of faster ones it changes the largest temperature by less than 1e-3 under
 * the flux of a smooth contact, and by 1 % at the edges of a flux that jumps.
 *
 * The memories reach beyond both ends of the domain (ovr_solid_beyond): heat
 * absorbed at an end, where a cold surface enters under hot lubricant, is not
 * lost, and changes in time are not reflected.
 *
 * A steady film is marched along x (heat_march.c), which knows upstream alone:
 * without heat along x, at a Peclet number of at least 0.1 and at no other
 * floor (ovr_solid_march_speed).  What T/N lacks by that for the last q is
 * added to the next march:
 *
 *     along = K q - K_march q
 *
 * where K q is what a step of D takes from steady modes, so that a run stays as
 * it began.  That contracts, for |K| <= |K_march| for every wave number,
 * sqrt(pi) over the roots of |i k u + kappa k^2| and |k| u_march, and they are
 * less than a right angle apart.
 */
#ifndef OVR_PHYSICS_HEAT_SURFACES_H
#define OVR_PHYSICS_HEAT_SURFACES_H

#include "multigrid/modes.h"
#include "physics/heat/heated.h"

enum { OVR_HEAT_WORKSPACES = 3 };

typedef struct ovr_heat_surface {
    size_t beyond; /* number of nodes beyond each end whose temperature history
                      is stored */
    double *psi[OVR_BANKS];       /* Psi_m at the nodes and beyond; or NULL */
    double *past;                 /* (h - T_bulk)/N at the nodes */
    double *along;                /* steady: what heat along x adds to it */
    ovr_memory memory;            /* for steps of dT */
    double meshes;                /* that it moves in the step */
    ovr_spread spread[OVR_BANKS]; /* in it */
    double *before; /* q of the step before, carried along and spread */
    double *next, *workspace[OVR_HEAT_WORKSPACES];
    double *none, *bank, *unused; /* of the second bank: no q; what it says */
} ovr_heat_surface;

/* Memory for it, with the rates of its memory: from steps of part of a mesh to
 * two passages of the domain, or further where it is slow: they stay whatever
 * steps and speeds. */
ovr_status ovr_heat_surface_take(ovr_simulation *sim, int k, ovr_error *err);

/* Prepares a step of dT over a number of mesh sizes; contribution of the past
 * of surface k, by its modes and the flux q before the step. */
void ovr_heat_surface_step(ovr_simulation *sim, int k, double dT,
                           double meshes);
void ovr_heat_surface_predict(ovr_simulation *sim, int k, const double *q);

/* Its modes at the end of the step that was looked back from, by q then. */
void ovr_heat_surface_store(ovr_simulation *sim, int k, const double *q);

/* The modes of a surface that has taken up nothing; those to save, each by
 * itself in the order of the nodes. */
void ovr_heat_surface_reset(ovr_simulation *sim, int k);
void ovr_heat_surface_visit(ovr_simulation *sim, int k, ovr_pieces *state);

/* Its steady modes by the flux q, and `along` by them. */
void ovr_heat_surface_steady(ovr_simulation *sim, int k);

/* Keeps what a steady march leaves of a surface at a node. */
void ovr_heat_steps_keep(const ovr_simulation *sim, int surface, size_t i,
                         const double *psi);

#endif
