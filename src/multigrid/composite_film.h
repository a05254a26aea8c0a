/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The film of composite grids.
 *
 * The pressure is linear between the leaves.  So the spaces are nested: a
 * parent's pressure P', continued linearly to the patch as I P', has the same
 * deformation on both grids at common nodes, whatever P' is under the patch.
 * With K_l the kernel of level l (deformation.h) and w' = K P' the parent's
 * whole deformation, that of the patch is
 *
 *     w = o + K_l (P - I P')                           P = I P' at the edges
 *     o_{2I}   = w'_I
 *     o_{2I+1} = sum_{m<5} a_m (w'_{I-m} + w'_{I+1+m})
 *              + sum_{t<18} c_t (P'_{I-t} + P'_{I+1+t})
 *     c_t = k'(t + 1/2) - sum_m a_m [k'(t - m) + k'(t + 1 + m)]
 *
 * a_m Lagrange's weights of the midpoint, k' the parent's kernel; c_t/D' of the
 * logarithm does not depend on the level.  It is exact except for the far terms
 * of c_t, about 1e-13, in every sweep.
 *
 * Outside the patch what it adds to its parent, P - I P' and what still finer
 * patches add, V, counts as pressures V' of the parent's nodes with the same
 * moments up to the fifth (hats of half the width have others of the second):
 *
 *     X = P - I P' + V
 *     Y_I = (X_{2I} + sum_{m<4} a_m (X_{2I+2m+1} + X_{2I-2m-1}))/2
 *     V' = (1 - delta2/16 + delta4/128) Y
 *
 * and the parent's film there is that of P' + V'.
 *
 * Fourth order on the base.  The hats of its leaves have the second moments
 * of D^2/12 P'' too much (fourth_order.h), m being 1 at leaves and 0 under the
 * patch:
 *     g = K (m delta2 P/12) + m C D delta2 P
 * on the base, with C as there; in patches K's part alone, by cubic
 * interpolation of the parent's, which moves the minimum film thickness by less
 * than 1e-6 at M = 20, L = 10, base 8.
 */
#ifndef OVR_MULTIGRID_COMPOSITE_FILM_H
#define OVR_MULTIGRID_COMPOSITE_FILM_H

#include "multigrid/patch.h"

enum { OVR_FILM_MIDDLE = 5, OVR_DETAIL_MIDDLE = 4 };

typedef struct ovr_composite_film {
    double near[OVR_FILM_NEAR];       /* c_t/D', of the logarithm */
    double middle[OVR_FILM_MIDDLE];   /* a_m of w */
    double detail[OVR_DETAIL_MIDDLE]; /* a_m of V */
} ovr_composite_film;

void ovr_composite_film_make(ovr_composite_film *film);

/* c_t/D' of one parent. */
void ovr_composite_film_parent(const ovr_composite_film *film,
                               const ovr_hierarchy *grids,
                               const ovr_patch *parent, double *near);

/* o and I P' for the parent's w and P, which have been read. */
void ovr_patch_outer(const ovr_composite_film *film, const ovr_hierarchy *grids,
                     ovr_patch *patch, ovr_patch *parent);

/* w of the base, or a patch, for patch->P and what it has of its parent; in
 * its level and read. */
void ovr_patch_deform(const ovr_hierarchy *grids, ovr_patch *patch);

/* V' and its deformation for the parent, and the load that the patch adds to
 * it, once the parent's P under the patch is that of the patch. */
void ovr_patch_detail(const ovr_hierarchy *grids,
                      const ovr_composite_film *film, ovr_patch *patch,
                      ovr_patch *parent);

/* g of a base with a patch, for the P it has read, and of a patch by that of
 * its parent; added to the rigid gap. */
void ovr_base_fourth(const ovr_hierarchy *grids, ovr_patch *base,
                     const ovr_patch *patch);
void ovr_patch_fourth(ovr_patch *patch, const ovr_patch *parent);

#endif
