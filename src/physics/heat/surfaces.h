/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Thermal memory of both surfaces at the nodes (solids.h, multigrid/modes.h):
 * its contribution in a step, its update after the step, and its values in a
 * steady contact.
 *
 * Heat conduction along a surface is included if the Peclet number is at most
 * 50. At higher Peclet numbers it would change the maximum temperature by less
 * than 1e-3 for the heat flux of a smooth contact, and by 1 % at jumps of the
 * flux.
 *
 * The memories reach beyond both ends of the domain (ovr_solid_beyond): heat
 * absorbed at an end, where a cold surface enters under hot lubricant, is not
 * lost, and changes in time are not reflected.
 *
 * A steady film is computed by marching along x (columns.c), which uses
 * upstream values only: without heat conduction along x, and with a Peclet
 * number of at least 0.1 (ovr_solid_march_speed). The resulting error of T/N
 * for the last q is added in the next march:
 *
 *     along = K q - K_march q
 *
 * where K q is the value of steady modes in a step of D, so that a run does not
 * change a steady state. The iteration contracts, because |K| <= |K_march| for
 * every wave number (sqrt(pi) divided by the roots of |i k u + kappa k^2| and
 * |k| u_march), and their phases differ by less than a right angle.
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
    double *along;                /* steady: contribution of heat conduction
                                   * along x */
    ovr_memory memory;            /* heat conduction kernel for steps of dT */
    double meshes;                /* distance moved in the step, in mesh sizes
                                   */
    ovr_spread spread[OVR_BANKS]; /* diffusion in the step */
    double *before; /* q of the previous step, convected and diffused */
    double *next, *workspace[OVR_HEAT_WORKSPACES];
    double *none, *bank, *unused; /* arrays of the second bank: zero flux; its
                                   * contribution */
} ovr_heat_surface;

/* Allocates the memory of surface k and sets its rates, for times from a
 * fraction of D to two passages of the domain, or longer for slow surfaces. The
 * rates do not depend on steps and speeds of the run. */
ovr_status ovr_heat_surface_take(ovr_simulation *sim, int k, ovr_error *err);

/* Prepares a step dT, in which surface k moves by a number of mesh sizes;
 * returns the contribution of the past from its modes and the flux q before the
 * step. */
void ovr_heat_surface_step(ovr_simulation *sim, int k, double dT,
                           double meshes);
void ovr_heat_surface_predict(ovr_simulation *sim, int k, const double *q);

/* Updates the modes to the end of the prepared step, with the flux q at that
 * time. */
void ovr_heat_surface_store(ovr_simulation *sim, int k, const double *q);

/* Resets the modes to a surface that has absorbed no heat; visits the modes to
 * be saved, each as an array in the order of the nodes. */
void ovr_heat_surface_reset(ovr_simulation *sim, int k);
void ovr_heat_surface_visit(ovr_simulation *sim, int k, ovr_pieces *state);

/* Computes the steady modes for the flux q, and `along` from them. */
void ovr_heat_surface_steady(ovr_simulation *sim, int k);

/* Stores the modes of a surface at a node during a steady march. */
void ovr_heat_steps_keep(const ovr_simulation *sim, int surface, size_t i,
                         const double *psi);

#endif
