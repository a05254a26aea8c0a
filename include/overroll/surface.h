/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Surfaces: features and profiles riding on the two moving surfaces.
 *
 *     S(X, T) = S1(X - X1(T)) + S2(X - X2(T)),  dXk/dT = Cu(T) u_k/um
 *
 * in units of b^2/R, positive out of the surface (a dent is negative).
 */
#ifndef OVERROLL_SURFACE_H
#define OVERROLL_SURFACE_H

#include <stdbool.h>
#include <stddef.h>

#include "overroll/contact.h"
#include "overroll/error.h"
#include "overroll/memory.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct ovr_surfaces ovr_surfaces;

/* Two smooth surfaces of a contact; `speed` (may be NULL: constant) is
 * borrowed; mesh is the grid's D, for anti-alias filtering of profiles. */
OVR_API ovr_surfaces *ovr_surfaces_create(const ovr_contact *contact,
                                          const ovr_history *speed, double mesh,
                                          const ovr_allocator *allocator,
                                          ovr_error *err);
OVR_API void ovr_surfaces_free(ovr_surfaces *surfaces);

/* S at time T at the n positions X; an ovr_heights of simulation.h with the
 * ovr_surfaces as its data. */
OVR_API void ovr_surfaces_heights(void *surfaces, double T, size_t n,
                                  const double *X, double *S);

#ifdef __cplusplus
}
#endif

#endif
